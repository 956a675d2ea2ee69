#pragma once

#include <array>

#include "support/exact_parabolic.hpp"
#include "support/random.hpp"

/// Families of cases for the first contact of a point on a parabola with a circle, as two balls on
/// a cloth have it (NUMERICS 1.4), and the extremes of all they can be.
namespace osculo::support {

/// A ball on a cloth: its place and path until it stops sliding or rolling.
template <math::Scalar S>
struct ClothBall {
    math::Vec<S> place, velocity, half_acceleration;
    S end;
};

/// 10^low .. 10^high.
template <math::Scalar S>
[[nodiscard]] S decades(Random& r, int low, int high) {
    return power_of_ten<S>(r.between(low, high - 1)) * (S(1) + S(9) * r.unit<S>());
}
template <math::Scalar S>
[[nodiscard]] S either_sign(Random& r, const S& x) {
    return r.coin() ? x : S(-x);
}

inline constexpr double kGravity = 9.81;
inline constexpr double kRolling = 0.01;
inline constexpr double kSliding = 0.2;
inline constexpr double kReach = 0.05715;  ///< two balls [m]

template <math::Scalar S>
[[nodiscard]] ClothBall<S> rolling_ball(Random& r, const math::Vec<S>& direction) {
    const S speed = decades<S>(r, -2, 1);
    const math::Vec<S> place(S(2.54) * r.unit<S>(), S(1.27) * r.unit<S>());
    const S slow = S(kRolling * kGravity);
    return {place, direction * speed, direction * (-slow / S(2)), speed / slow};
}
template <math::Scalar S>
[[nodiscard]] ClothBall<S> table_ball(Random& r) {
    ClothBall<S> ball = rolling_ball<S>(r, r.direction<S>());
    const int kind = r.below(4);
    if (kind == 0) {  // rests
        ball.velocity = ball.half_acceleration = {S(0), S(0)};
        ball.end = math::never<S>();
    } else if (kind > 1) {  // slides
        ball.half_acceleration = r.direction<S>() * S(-kSliding * kGravity / 2);
        ball.end = math::norm<S>(ball.velocity) * S(2) * r.unit<S>() / S(3.5 * kSliding * kGravity);
    }
    return ball;
}

template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> relative(const ClothBall<S>& one, const ClothBall<S>& other) {
    ParabolicCase<S> p{one.place - other.place, one.velocity - other.velocity,
                       one.half_acceleration - other.half_acceleration, S(kReach),
                       std::min<S>(one.end, other.end)};
    if (!math::is_finite<S>(p.end)) p.end = S(10);
    return p;
}

/// Two balls anywhere on a table, but not in one another (where the direction of their motion would
/// decide, not the gap).
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> table_pair(Random& r) {
    for (;;) {
        const ParabolicCase<S> p = relative<S>(table_ball<S>(r), table_ball<S>(r));
        if (math::norm<S>(p.c) > p.s) return p;
    }
}

/// The case moved such that the point is at [place] at the time [t].
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> placed(ParabolicCase<S> p, const math::Vec<S>& place, const S& t) {
    p.c = place - t * (p.b + t * p.a);
    return p;
}

/// The same such that it moves square to its direction from the centre at the time [t], at the
/// distance (1 + [excess]) s.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> passing(const ParabolicCase<S>& p, const S& excess, const S& t,
                                       bool left) {
    const math::Vec<S> v = p.b + (S(2) * t) * p.a;
    const S speed = math::norm<S>(v);
    if (!(speed > S(0))) return p;
    const math::Vec<S> side = math::Vec<S>(-v.y(), v.x()) / (left ? speed : S(-speed));
    return placed<S>(p, side * (p.s * (S(1) + excess)), t);
}

/// In contact up to a gap of 0 or +-10^-16 .. 10^-high.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> contact_place(Random& r, const S& s, int high) {
    const S size = r.below(4) == 0 ? S(0) : decades<S>(r, -16, high);
    return r.direction<S>() * (s * (S(1) + either_sign<S>(r, size)));
}

template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> aimed_pair(Random& r) {
    const ParabolicCase<S> p = table_pair<S>(r);
    return placed<S>(p, r.direction<S>() * p.s, p.end * r.unit<S>());
}
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> extreme_graze(Random& r) {
    const ParabolicCase<S> p = table_pair<S>(r);
    return passing<S>(p, either_sign<S>(r, decades<S>(r, -16, -10)), p.end * r.unit<S>(), r.coin());
}
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> graze(Random& r) {
    const ParabolicCase<S> p = table_pair<S>(r);
    return passing<S>(p, either_sign<S>(r, decades<S>(r, -10, -2)), p.end * r.unit<S>(), r.coin());
}

/// In contact, with a closing (< 0) or separating speed of 1e-9 .. 1 m/s.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> in_contact(Random& r, bool closing, const S& gap) {
    ParabolicCase<S> p = table_pair<S>(r);
    const math::Vec<S> n = r.direction<S>();
    const math::Vec<S> along(-n.y(), n.x());
    const S speed = decades<S>(r, -9, 0);
    p.c = n * (p.s * (S(1) + gap));
    p.b = n * (closing ? S(-speed) : speed) + along * (r.coin() ? S(0) : math::dot<S>(p.b, along));
    return p;
}
template <math::Scalar S>
[[nodiscard]] S rounding_gap(Random& r) {
    return r.below(4) == 0 ? S(0) : either_sign<S>(r, decades<S>(r, -17, -15));
}
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> separating(Random& r) {
    return in_contact<S>(r, false, rounding_gap<S>(r));
}
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> approaching(Random& r) {
    return in_contact<S>(r, true, rounding_gap<S>(r));
}

/// Almost the same motion, as in a cradle.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> cradle(Random& r) {
    ClothBall<S> one = table_ball<S>(r);
    ClothBall<S> other = one;
    other.place = {S(0), S(0)};
    one.place = r.direction<S>() * (S(kReach) * (S(1) + decades<S>(r, -16, -6)));
    const S difference = decades<S>(r, -16, -6);
    one.velocity += r.direction<S>() * difference;
    one.half_acceleration += r.direction<S>() * (difference * r.unit<S>());
    return relative<S>(one, other);
}

template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> tiny_acceleration(Random& r) {
    ParabolicCase<S> p = table_pair<S>(r);
    p.a *= decades<S>(r, -18, -4);
    return r.coin() ? placed<S>(p, r.direction<S>() * p.s, p.end * r.unit<S>())
                    : passing<S>(p, either_sign<S>(r, decades<S>(r, -16, -2)), p.end * r.unit<S>(),
                                 r.coin());
}

/// Two balls that slide alike, or roll in one direction: a straight relative path.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> equal_accelerations(Random& r) {
    ClothBall<S> one = table_ball<S>(r);
    const ClothBall<S> other = table_ball<S>(r);
    one.half_acceleration = other.half_acceleration;
    const ParabolicCase<S> p = relative<S>(one, other);
    return r.coin() ? placed<S>(p, r.direction<S>() * p.s, p.end * r.unit<S>())
                    : passing<S>(p, either_sign<S>(r, decades<S>(r, -16, -2)), p.end * r.unit<S>(),
                                 r.coin());
}

/// A ball that rolls to rest within +-1e-16 .. 1e-6 of a ball at rest, not in it at the start.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> stops_at_contact(Random& r) {
    for (;;) {
        const math::Vec<S> direction = r.direction<S>();
        const ClothBall<S> ball = rolling_ball<S>(r, direction);
        const ParabolicCase<S> p{ball.place, ball.velocity, ball.half_acceleration, S(kReach),
                                 ball.end};
        const math::Vec<S> n = r.below(3) == 0 ? math::Vec<S>(-direction) : r.direction<S>();
        const S excess = either_sign<S>(r, decades<S>(r, -16, -6));
        const ParabolicCase<S> q = placed<S>(p, n * (p.s * (S(1) + excess)), p.end);
        if (math::norm<S>(q.c) > q.s) return q;
    }
}

template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> any_units(Random& r) {
    ParabolicCase<S> p = r.coin() ? aimed_pair<S>(r) : extreme_graze<S>(r);
    const S length = power_of_ten<S>(r.coin() ? 8 : -8);
    const S time = power_of_ten<S>(r.coin() ? 8 : -8);
    return {p.c * length, p.b * (length / time), p.a * (length / (time * time)), p.s * length,
            p.end * time};
}

template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> tiny_balls(Random& r) {
    ParabolicCase<S> p = table_pair<S>(r);
    p.s /= decades<S>(r, 1, 6);
    return r.coin() ? placed<S>(p, r.direction<S>() * p.s, p.end * r.unit<S>())
                    : passing<S>(p, either_sign<S>(r, decades<S>(r, -10, 0)), p.end * r.unit<S>(),
                                 r.coin());
}

/// In contact, separating, and pulled together again.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> pulled_back(Random& r) {
    ParabolicCase<S> p = in_contact<S>(r, false, rounding_gap<S>(r));
    const math::Vec<S> n = p.c / math::norm<S>(p.c);
    const S out = math::dot<S>(p.b, n);
    p.a = n * -decades<S>(r, -2, 1) + math::Vec<S>(-n.y(), n.x()) * r.signed_unit<S>();
    p.end = -out / math::dot<S>(p.a, n) * (S(0.5) + S(4) * r.unit<S>());
    return p;
}

/// All on one line: a central or an eccentric one.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> parallel(Random& r) {
    const math::Vec<S> n = r.direction<S>();
    const ClothBall<S> one = rolling_ball<S>(r, n);
    const ClothBall<S> other = rolling_ball<S>(r, r.coin() ? n : math::Vec<S>(-n));
    const ParabolicCase<S> p = relative<S>(one, other);
    const S side = r.coin() ? S(0) : S(p.s * r.signed_unit<S>() * S(1.2));
    return {n * (S(2) * r.signed_unit<S>()) + math::Vec<S>(-n.y(), n.x()) * side, p.b, p.a, p.s,
            p.end};
}

/// Into a ball at rest, or past it.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> one_at_rest(Random& r) {
    ClothBall<S> rests = table_ball<S>(r);
    rests.velocity = rests.half_acceleration = {S(0), S(0)};
    rests.end = math::never<S>();
    const ParabolicCase<S> p = relative<S>(table_ball<S>(r), rests);
    const S t = p.end * r.unit<S>();
    return r.coin() ? placed<S>(p, r.direction<S>() * p.s, t)
                    : passing<S>(p, either_sign<S>(r, decades<S>(r, -16, -2)), t, r.coin());
}

/// Tangents, touches and zeros by the dozen.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> small_integer_parabola(Random& r) {
    const auto integer = [&] { return S(r.between(-4, 4)); };
    return {{integer(), integer()},
            {integer(), integer()},
            {integer() / S(2), integer() / S(2)},
            S(r.between(1, 5)),
            S(r.between(1, 6))};
}

/// In contact, moving almost or exactly along the boundary, to be pulled in or away.
template <math::Scalar S>
[[nodiscard]] ParabolicCase<S> touching_sideways_curved(Random& r) {
    ParabolicCase<S> p = table_pair<S>(r);
    p.c = contact_place<S>(r, p.s, -2);
    const S tilt = r.below(4) == 0 ? S(0) : either_sign<S>(r, decades<S>(r, -16, 0));
    const math::Vec<S> along(-p.c.y(), p.c.x());
    p.b = (along + p.c * tilt) * decades<S>(r, -1, 2);
    return p;
}

template <math::Scalar S>
struct ParabolicFamily {
    const char* name;
    ParabolicCase<S> (*make)(Random&);
};

template <math::Scalar S>
inline constexpr std::array<ParabolicFamily<S>, 17> kParabolicFamilies{{
    {"F1 random table pairs", table_pair<S>},
    {"F2 aimed", aimed_pair<S>},
    {"F3 graze 1e-16..1e-10", extreme_graze<S>},
    {"F4 graze 1e-10..1e-2", graze<S>},
    {"F5 separating contact", separating<S>},
    {"F6 approaching contact", approaching<S>},
    {"F7 cradle", cradle<S>},
    {"F8 tiny acceleration", tiny_acceleration<S>},
    {"F9 equal accelerations", equal_accelerations<S>},
    {"F10 stops at contact", stops_at_contact<S>},
    {"F11 units 1e+-8", any_units<S>},
    {"F12 tiny balls", tiny_balls<S>},
    {"F13 pulled back", pulled_back<S>},
    {"parallel", parallel<S>},
    {"one at rest", one_at_rest<S>},
    {"touching sideways", touching_sideways_curved<S>},
    {"small integers", small_integer_parabola<S>},
}};

}  // namespace osculo::support
