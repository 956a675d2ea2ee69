#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/builder.hpp"
#include "support/random.hpp"

/// Random tables with everything on them, for property tests. The same seed gives the same scene in
/// every scalar type up to rounding.
namespace osculo::support {

struct Spot {
    double x, y;
};

/// Distance of p from the straight line between a and b.
[[nodiscard]] inline double distance_to_edge(const Spot& p, const Spot& a, const Spot& b) {
    const double ux = b.x - a.x, uy = b.y - a.y;
    const double along = ((p.x - a.x) * ux + (p.y - a.y) * uy) / (ux * ux + uy * uy);
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * ux, p.y - a.y - t * uy);
}

[[nodiscard]] inline bool inside(const Spot& p, const std::vector<Spot>& corners) {
    bool odd = false;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Spot& a = corners[k];
        const Spot& b = corners[(k + 1) % corners.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            odd = !odd;
        }
    }
    return odd;
}

/// A closed outline around the origin, counter-clockwise, of 3 to 12 corners: on a circle, hence
/// convex, or at random distances, hence with corners that point inwards.
[[nodiscard]] inline std::vector<Spot> random_outline(Random& random) {
    const int corners = random.between(3, 12);
    const bool convex = random.coin();
    const double turned = random.uniform<double>(0, 6.28);
    std::vector<Spot> outline;
    for (int k = 0; k < corners; ++k) {
        const double jitter = corners > 4 ? random.uniform<double>(-0.3, 0.3) : 0.0;
        const double angle = turned + (k + jitter) * 6.283185307179586 / corners;
        const double distance = convex ? 1.0 : random.uniform<double>(0.5, 1.5);
        outline.push_back({distance * std::cos(angle), distance * std::sin(angle)});
    }
    return outline;
}

struct TableOptions {
    int most_balls = 12;
    bool arcs = true;
    bool inner_walls = true;
    bool rims = true;
    double restitution = 1;
};

/// An outline with posts, walls, arcs, holes and balls inside, nothing overlapping.
template <class Type>
[[nodiscard]] Builder<Type> random_table(std::uint64_t seed, const TableOptions& options) {
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;
    Random random(seed);
    Builder<Type> builder;
    const std::vector<Spot> outline = random_outline(random);
    std::vector<Vec> corners;
    for (const Spot& corner : outline) corners.push_back(Vec(S(corner.x), S(corner.y)));
    builder.outline(corners, random.coin());

    struct Taken {
        Spot at;
        double radius;
    };
    std::vector<Taken> taken;
    // A free disk inside the outline, or none.
    const auto find_place = [&](double radius, Spot& place) {
        for (int attempt = 0; attempt < 60; ++attempt) {
            place = {random.uniform<double>(-1.5, 1.5), random.uniform<double>(-1.5, 1.5)};
            if (!inside(place, outline)) continue;
            bool free = true;
            for (std::size_t k = 0; k < outline.size(); ++k) {
                free = free && distance_to_edge(place, outline[k],
                                                outline[(k + 1) % outline.size()]) > radius;
            }
            for (const Taken& other : taken) {
                free = free && std::hypot(place.x - other.at.x, place.y - other.at.y) >
                                   radius + other.radius;
            }
            if (!free) continue;
            taken.push_back({place, radius * (1 + 1e-12)});
            return true;
        }
        return false;
    };
    const auto vec = [](const Spot& p) { return Vec(S(p.x), S(p.y)); };
    const auto turned = [](double angle) { return Vec(S(std::cos(angle)), S(std::sin(angle))); };

    Spot place{};
    if constexpr (Type::ObstacleList::template kContains<S, geometry::Arc<S>>) {
        for (int k = options.arcs ? random.below(3) : 0; k > 0; --k) {
            const double radius = random.uniform<double>(0.02, 0.4);
            if (!find_place(radius, place)) continue;
            if (random.below(3) == 0) {
                builder.circle(vec(place), S(radius));
                continue;
            }
            const double start = random.uniform<double>(0, 6.28);
            const double sweep = random.uniform<double>(0.3, 6.0);
            builder.arc(vec(place), S(radius), turned(start), turned(start + sweep),
                        sweep > 3.141592653589793);
        }
    }
    for (int k = options.inner_walls ? random.below(3) : 0; k > 0; --k) {
        const double half = random.uniform<double>(0.02, 0.3);
        if (!find_place(half, place)) continue;
        const double angle = random.uniform<double>(0, 6.28);
        const Spot tip{half * std::cos(angle), half * std::sin(angle)};
        builder.wall(vec({place.x - tip.x, place.y - tip.y}),
                     vec({place.x + tip.x, place.y + tip.y}));
    }
    if constexpr (Type::ObstacleList::template kContains<S, geometry::Rim<S>>) {
        for (int k = options.rims ? random.below(3) : 0; k > 0; --k) {
            const double radius = random.uniform<double>(0.01, 0.15);
            if (find_place(radius, place)) builder.rim(vec(place), S(radius));
        }
    }
    const bool alike = random.coin();
    const double radius = random.uniform<double>(0.01, 0.12);
    for (int k = random.between(1, options.most_balls); k > 0; --k) {
        const double own = alike ? radius : random.uniform<double>(0.01, 0.15);
        if (!find_place(own, place)) continue;
        const bool moves = random.below(4) != 0;
        const double speed = moves ? std::pow(10.0, random.uniform<double>(-3, 1)) : 0.0;
        const double angle = random.uniform<double>(0, 6.28);
        builder.ball(vec(place), S(speed) * turned(angle), S(own),
                     S(alike ? 1.0 : std::pow(10.0, random.uniform<double>(-2, 2))));
    }
    return builder.restitution(S(options.restitution), S(options.restitution));
}

}  // namespace osculo::support
