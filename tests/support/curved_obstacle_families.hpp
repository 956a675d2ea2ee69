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

/// The first case of those that [make_target](r, traits) leads to in which the ball starts outside.
template <math::Scalar S, class MakeTarget>
[[nodiscard]] auto curved_case(Random& r, const CurvedTraits& traits, MakeTarget make_target) {
    for (;;) {
        const auto to = make_target(r, traits);
        const CurvedCase<S, std::decay_t<decltype(to.obstacle)>> result{
            curved_path<S>(r, traits, to.origin, to.target, to.normal, to.radius, to.size),
            to.radius, to.obstacle};
        if (!starts_in<S>(result, S(traits.touching ? 2e-4 : 0))) return result;
    }
}

template <math::Scalar S>
[[nodiscard]] CurvedCase<S, geometry::Segment<S>> curved_segment_case(Random& r,
                                                                      const CurvedTraits& traits) {
    return curved_case<S>(r, traits, segment_target<S, CurvedTraits>);
}
template <math::Scalar S>
[[nodiscard]] CurvedCase<S, geometry::Arc<S>> curved_arc_case(Random& r,
                                                              const CurvedTraits& traits) {
    return curved_case<S>(r, traits, arc_target<S, CurvedTraits>);
}

}  // namespace osculo::support
