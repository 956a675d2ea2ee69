#pragma once

#include "support/exact_curved_obstacles.hpp"
#include "support/obstacle_families.hpp"
#include "support/parabolic_families.hpp"

/// Balls on curved paths to segments and arcs, random and adversarial.
namespace osculo::support {

template <math::Scalar S, class Obstacle>
struct CurvedCase {
    motion::ParabolicPath<S> path;
    S radius;
    Obstacle obstacle;
};

template <math::Scalar S, class Obstacle>
[[nodiscard]] std::string bits(const CurvedCase<S, Obstacle>& a) {
    const motion::LinearPath<S> start{a.path.position, a.path.velocity};
    return bits<S>(ObstacleCase<S, Obstacle>{start, a.radius, a.obstacle}) +
           " half_acceleration=" + bits<S>(a.path.half_acceleration) +
           " end=" + bits<S>(a.path.end);
}

/// What is special about a family.
struct CurvedTraits {
    const char* name;
    bool touching = false;   ///< starts with a gap of 0 or +-10^-16 .. 10^-4 of the radius
    bool grazing = false;    ///< moves along the boundary, +-10^-16 .. 10^-2 of the radius beside
    bool stops = false;      ///< comes to rest +-10^-16 .. 10^-6 of the radius beside
    bool straight = false;   ///< without acceleration, or along the velocity
    bool at_an_end = false;  ///< aims at an end to within 10^-16 .. 10^-1
    bool far = false;        ///< 1e8 m from the origin, in wide coordinates
};

inline constexpr std::array<CurvedTraits, 8> kCurvedFamilies{{
    {.name = "random"},
    {.name = "touching", .touching = true},
    {.name = "grazing", .grazing = true},
    {.name = "touching sideways", .touching = true, .grazing = true},
    {.name = "stops at contact", .stops = true},
    {.name = "straight", .straight = true},
    {.name = "at an end", .at_an_end = true},
    {.name = "1e8 m away", .far = true},
}};

/// A path that at some time is above [target], where the boundary's normal is [normal].
template <math::Scalar S>
[[nodiscard]] motion::ParabolicPath<S> curved_path(Random& r, const CurvedTraits& traits,
                                                   const math::Vec<S>& origin,
                                                   const math::Vec<S>& target,
                                                   const math::Vec<S>& normal, const S& radius,
                                                   const S& size) {
    const math::Vec<S> tangent(-normal.y(), normal.x());
    const S speed = r.magnitude<S>(-5, 5);
    const S duration = size * r.magnitude<S>(-6, 1) / speed;
    const S time = traits.touching ? S(0) : duration;
    math::Vec<S> velocity = (tangent * (r.signed_unit<S>() * S(3)) - normal) * speed;
    S gap(0);
    if (traits.grazing) velocity = tangent * (r.coin() ? speed : S(-speed));
    if (traits.grazing) gap = radius * small_number<S>(r, 2, 16);
    if (traits.grazing && traits.touching) {
        velocity += normal * (speed * small_number<S>(r, 0, 16));
    }
    if (traits.touching) gap = radius * small_number<S>(r, 4, 16);
    if (traits.stops) gap = radius * small_number<S>(r, 6, 16);
    math::Vec<S> pull = r.direction<S>() * (speed / duration * r.magnitude<S>(-6, 1));
    if (traits.straight) pull = velocity * ((r.below(3) - S(1)) * r.unit<S>() / duration);
    if (traits.stops) velocity = {S(0), S(0)};

    motion::ParabolicPath<S> path;
    path.velocity = velocity - pull * (S(2) * time);
    path.half_acceleration = pull;
    const math::Vec<S> place =
        target + normal * (radius + gap) - velocity * time + pull * (time * time);
    path.position = math::WidePoint<S>(math::Vec<S>(origin + place));
    if (traits.far) {
        for (math::Wide<S>* x : {&path.position.x, &path.position.y}) {
            *x = *x + S(size * r.signed_unit<S>() * math::epsilon<S>() * S(1e4));
        }
    }
    path.end = traits.stops ? duration : S(duration * S(2) * (S(1) - r.unit<S>()));
    return path;
}

template <math::Scalar S>
[[nodiscard]] math::Vec<S> curved_somewhere(Random& r, const CurvedTraits& traits) {
    ObstacleTraits same;
    same.far = traits.far;
    return somewhere<S>(r, same);
}

/// Whether the ball starts in the obstacle, where the direction of its motion would decide, not the
/// gap.
template <math::Scalar S>
[[nodiscard]] bool starts_in(const CurvedCase<S, geometry::Segment<S>>& a, const S& tolerance) {
    const math::Vec<S> c = math::difference<S>(a.path.position, a.obstacle.from);
    return math::abs<S>(math::dot<S>(c, a.obstacle.normal)) < a.radius * (S(1) - tolerance);
}
template <math::Scalar S>
[[nodiscard]] bool starts_in(const CurvedCase<S, geometry::Arc<S>>& a, const S& tolerance) {
    const math::Vec<S> c = math::difference<S>(a.path.position, a.obstacle.center);
    return math::abs<S>(math::norm<S>(c) - a.obstacle.radius) < a.radius * (S(1) - tolerance);
}

template <math::Scalar S>
[[nodiscard]] CurvedCase<S, geometry::Segment<S>> curved_segment_case(Random& r,
                                                                      const CurvedTraits& traits) {
    const S size = r.magnitude<S>(-4, 2);
    const math::Vec<S> from = curved_somewhere<S>(r, traits);
    const geometry::Segment<S> segment(from, from + r.direction<S>() * size, r.coin());
    const S radius = size * r.magnitude<S>(-6, 0);
    const S along = traits.at_an_end
                        ? S(segment.length * ((r.coin() ? S(0) : S(1)) + small_number<S>(r, 1, 17)))
                        : S(segment.length * r.uniform<S>(S(-0.2), S(1.2)));
    const math::Vec<S> normal = r.below(4) == 0 ? math::Vec<S>(-segment.normal) : segment.normal;
    CurvedCase<S, geometry::Segment<S>> result{
        curved_path<S>(r, traits, segment.from, segment.tangent * along, normal, radius, size),
        radius, segment};
    return starts_in<S>(result, S(traits.touching ? 2e-4 : 0)) ? curved_segment_case<S>(r, traits)
                                                               : result;
}

/// Full, reflex and other arcs, some smaller than the ball, hit from outside or inside.
template <math::Scalar S>
[[nodiscard]] CurvedCase<S, geometry::Arc<S>> curved_arc_case(Random& r,
                                                              const CurvedTraits& traits) {
    geometry::Arc<S> arc;
    arc.center = curved_somewhere<S>(r, traits);
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
    CurvedCase<S, geometry::Arc<S>> result{
        curved_path<S>(r, traits, arc.center, out * arc.radius, inside ? math::Vec<S>(-out) : out,
                       radius, arc.radius),
        radius, arc};
    return starts_in<S>(result, S(traits.touching ? 2e-4 : 0)) ? curved_arc_case<S>(r, traits)
                                                               : result;
}

}  // namespace osculo::support
