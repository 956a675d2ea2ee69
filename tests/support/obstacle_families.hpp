#pragma once

#include "support/contact_families.hpp"
#include "support/exact_obstacles.hpp"

/// Balls on their way to segments and arcs, random and adversarial.
namespace osculo::support {

template <math::Scalar S, class Obstacle>
struct ObstacleCase {
    motion::LinearPath<S> path;
    S radius;
    Obstacle obstacle;
};

template <math::Scalar S>
[[nodiscard]] std::string bits(const motion::LinearPath<S>& path, const S& radius) {
    return std::string(name_of<S>()) + " position=" + bits<S>(path.position.rounded()) +
           " velocity=" + bits<S>(path.velocity) + " radius=" + bits<S>(radius);
}
template <math::Scalar S>
[[nodiscard]] std::string bits(const ObstacleCase<S, geometry::Segment<S>>& s) {
    return bits<S>(s.path, s.radius) + " segment from=" + bits<S>(s.obstacle.from) +
           " tangent=" + bits<S>(s.obstacle.tangent) + " length=" + bits<S>(s.obstacle.length) +
           (s.obstacle.one_sided ? " one-sided" : " two-sided");
}
template <math::Scalar S>
[[nodiscard]] std::string bits(const ObstacleCase<S, geometry::Arc<S>>& a) {
    return bits<S>(a.path, a.radius) + " arc center=" + bits<S>(a.obstacle.center) +
           " radius=" + bits<S>(a.obstacle.radius) + " start=" + bits<S>(a.obstacle.start) +
           " end=" + bits<S>(a.obstacle.end) + (a.obstacle.reflex ? " reflex" : "") +
           (a.obstacle.full ? " full" : "");
}

/// What is special about a family.
struct ObstacleTraits {
    const char* name;
    bool adversarial = true;
    bool touching = false;   ///< starts with a gap of 0 or +-10^-16 .. 10^-4 of the radius
    bool sideways = false;   ///< moves along the boundary to within 10^-16 .. 10^-1
    bool at_an_end = false;  ///< aims at an end to within 10^-16 .. 10^-1
    bool far = false;        ///< 1e8 m from the origin, in wide coordinates
};

inline constexpr std::array<ObstacleTraits, 6> kObstacleFamilies{{
    {.name = "random", .adversarial = false},
    {.name = "touching", .touching = true},
    {.name = "almost parallel", .sideways = true},
    {.name = "touching, parallel", .touching = true, .sideways = true},
    {.name = "at an end", .at_an_end = true},
    {.name = "1e8 m away", .far = true},
}};

/// 0 or +-10^-low .. +-10^-high.
template <math::Scalar S>
[[nodiscard]] S small_number(Random& r, int low, int high) {
    if (r.below(8) == 0) return S(0);
    const S size = power_of_ten<S>(-r.between(low, high));
    return r.coin() ? size : S(-size);
}

/// A ball at [place] + (left of [normal] direction) that will be [lateral] along [tangent] when it
/// has come [height] towards the boundary.
template <math::Scalar S>
[[nodiscard]] motion::LinearPath<S> path_towards(Random& r, const ObstacleTraits& traits,
                                                 const math::Vec<S>& origin,
                                                 const math::Vec<S>& target,
                                                 const math::Vec<S>& normal, const S& radius,
                                                 const S& size) {
    const math::Vec<S> tangent(-normal.y(), normal.x());
    const S gap =
        traits.touching ? S(radius * small_number<S>(r, 4, 16)) : S(size * r.magnitude<S>(-8, 1));
    const S slide = traits.sideways
                        ? S(S(1) / (math::abs<S>(small_number<S>(r, 1, 16)) + power_of_ten<S>(-17)))
                        : S(r.signed_unit<S>() * S(3));
    const math::Vec<S> way = tangent * slide - normal;  // for one unit of height
    const S speed = r.magnitude<S>(-5, 5) / math::norm<S>(way);
    const math::Vec<S> touch = target + normal * radius;
    const S height = math::abs<S>(gap) / (traits.sideways ? math::abs<S>(slide) : S(1));
    const math::Vec<S> place =
        traits.touching ? math::Vec<S>(touch + normal * gap) : math::Vec<S>(touch - way * height);
    motion::LinearPath<S> path{math::WidePoint<S>(origin + place), way * speed};
    if (traits.far) {
        path.position.x =
            path.position.x + S(size * r.signed_unit<S>() * math::epsilon<S>() * S(1e4));
        path.position.y =
            path.position.y + S(size * r.signed_unit<S>() * math::epsilon<S>() * S(1e4));
    }
    if (r.below(16) == 0) path.velocity = -path.velocity;  // away
    return path;
}

template <math::Scalar S>
[[nodiscard]] math::Vec<S> somewhere(Random& r, bool is_far) {
    const S far = is_far ? S(1e8) : S(0);
    return {far + r.signed_unit<S>(), r.signed_unit<S>() - far};
}

/// An obstacle, and where a ball is to touch it: at origin + target, on the side of the normal.
template <math::Scalar S, class Obstacle>
struct Target {
    Obstacle obstacle;
    S radius;  ///< of the ball
    math::Vec<S> origin, target, normal;
    S size;  ///< of the obstacle
};

/// [Traits]: of a family, straight or curved.
template <math::Scalar S, class Traits>
[[nodiscard]] Target<S, geometry::Segment<S>> segment_target(Random& r, const Traits& traits) {
    const S size = r.magnitude<S>(-4, 2);
    const math::Vec<S> from = somewhere<S>(r, traits.far);
    const geometry::Segment<S> segment(from, from + r.direction<S>() * size, r.coin());
    const S radius = size * r.magnitude<S>(-6, 0);
    const S along = traits.at_an_end
                        ? S(segment.length * ((r.coin() ? S(0) : S(1)) + small_number<S>(r, 1, 17)))
                        : S(segment.length * r.uniform<S>(S(-0.2), S(1.2)));
    const math::Vec<S> normal = r.below(4) == 0 ? math::Vec<S>(-segment.normal) : segment.normal;
    return {segment, radius, segment.from, segment.tangent * along, normal, size};
}

/// Full, reflex and other arcs, some smaller than the ball, hit from outside or inside.
template <math::Scalar S, class Traits>
[[nodiscard]] Target<S, geometry::Arc<S>> arc_target(Random& r, const Traits& traits) {
    geometry::Arc<S> arc;
    arc.center = somewhere<S>(r, traits.far);
    arc.radius = r.magnitude<S>(-4, 2);
    arc.start = r.direction<S>();
    arc.end = r.direction<S>();
    arc.full = r.below(8) == 0;
    arc.reflex = math::accurate_cross<S>(arc.start, arc.end) < S(0);
    const S radius = arc.radius * r.magnitude<S>(-5, 0);
    math::Vec<S> out = r.direction<S>();
    if (traits.at_an_end) {
        const math::Vec<S>& end = r.coin() ? arc.start : arc.end;
        out = end + math::Vec<S>(-end.y(), end.x()) * small_number<S>(r, 1, 17);
        out /= math::norm<S>(out);
    }
    // From inside only where the ball has room there.
    const bool inside = radius < arc.radius && r.coin();
    return {arc,       radius, arc.center, out * arc.radius, inside ? math::Vec<S>(-out) : out,
            arc.radius};
}

template <math::Scalar S, class Obstacle>
[[nodiscard]] ObstacleCase<S, Obstacle> straight_case(Random& r, const ObstacleTraits& traits,
                                                      const Target<S, Obstacle>& to) {
    return {path_towards<S>(r, traits, to.origin, to.target, to.normal, to.radius, to.size),
            to.radius, to.obstacle};
}
template <math::Scalar S>
[[nodiscard]] ObstacleCase<S, geometry::Segment<S>> segment_case(Random& r,
                                                                 const ObstacleTraits& traits) {
    return straight_case<S>(r, traits, segment_target<S>(r, traits));
}
template <math::Scalar S>
[[nodiscard]] ObstacleCase<S, geometry::Arc<S>> arc_case(Random& r, const ObstacleTraits& traits) {
    return straight_case<S>(r, traits, arc_target<S>(r, traits));
}

}  // namespace osculo::support
