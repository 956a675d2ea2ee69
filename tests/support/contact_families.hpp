#pragma once

#include <array>

#include "support/exact_contact.hpp"
#include "support/random.hpp"

/// Families of cases for the first contact of a point with a circle, random and adversarial.
namespace osculo::support {

/// A point [along] before the closest approach to the centre, which it passes at distance
/// [lateral].
template <math::Scalar S>
[[nodiscard]] PointCase<S> passing(const math::Vec<S>& direction, const S& along, const S& lateral,
                                   const S& radius, const S& speed) {
    const math::Vec<S> left(-direction.y(), direction.x());
    return {direction * -along + left * lateral, direction * speed, radius};
}

template <math::Scalar S>
[[nodiscard]] PointCase<S> anywhere(Random& r) {
    return {{r.signed_unit<S>(), r.signed_unit<S>()},
            {r.signed_unit<S>(), r.signed_unit<S>()},
            r.magnitude<S>(-7, -1)};
}

template <math::Scalar S>
[[nodiscard]] PointCase<S> aimed(Random& r) {
    const S s = r.magnitude<S>(-7, -1);
    return passing<S>(r.direction<S>(), s + r.magnitude<S>(-4, 2), s * r.signed_unit<S>(), s,
                      r.magnitude<S>(-5, 5));
}

/// Impact parameter (1 - 10^-k) s: hits, up to what the rounding of the case itself makes of them.
template <math::Scalar S>
[[nodiscard]] PointCase<S> grazing_hit(Random& r) {
    const S s = r.magnitude<S>(-6, 0);
    const S lateral = s * (S(1) - power_of_ten<S>(-r.between(1, 16)));
    return passing<S>(r.direction<S>(), s * r.magnitude<S>(-3, 6), r.coin() ? lateral : S(-lateral),
                      s, r.magnitude<S>(-5, 5));
}

template <math::Scalar S>
[[nodiscard]] PointCase<S> grazing_miss(Random& r) {
    const S s = r.magnitude<S>(-6, 0);
    const S lateral = s * (S(1) + power_of_ten<S>(-r.between(1, 16)));
    return passing<S>(r.direction<S>(), s * r.magnitude<S>(-3, 6), r.coin() ? lateral : S(-lateral),
                      s, r.magnitude<S>(-5, 5));
}

/// In contact up to a gap of 0 or +-10^-16 .. 10^-4 of the distance, moving any way.
template <math::Scalar S>
[[nodiscard]] PointCase<S> touching(Random& r) {
    const S s = r.magnitude<S>(-6, 0);
    const S size = r.below(8) == 0 ? S(0) : power_of_ten<S>(-r.between(4, 16));
    const math::Vec<S> c = r.direction<S>() * (s * (r.coin() ? S(S(1) + size) : S(S(1) - size)));
    return {c, r.direction<S>() * r.magnitude<S>(-5, 5), s};
}

/// The same, moving along the boundary up to an angle of 0 or +-10^-16 .. 1.
template <math::Scalar S>
[[nodiscard]] PointCase<S> touching_sideways(Random& r) {
    PointCase<S> p = touching<S>(r);
    const S tilt = r.below(8) == 0 ? S(0) : power_of_ten<S>(-r.between(0, 16));
    const math::Vec<S> along(-p.c.y(), p.c.x());
    p.b = (along + p.c * (r.below(4) == 0 ? tilt : S(-tilt))) * r.magnitude<S>(-5, 5);
    return p;
}

/// A circle 10^3 to 10^8 times smaller than the distance.
template <math::Scalar S>
[[nodiscard]] PointCase<S> tiny_circle(Random& r) {
    const S s = power_of_ten<S>(-r.between(3, 8)) * (S(1) + r.unit<S>());
    return passing<S>(r.direction<S>(), S(1) + r.unit<S>(), s * S(1.2) * r.signed_unit<S>(), s,
                      r.magnitude<S>(-5, 5));
}

/// Lengths 1e-9 .. 1e9 m, speeds 1e-150 .. 1e150 m/s.
template <math::Scalar S>
[[nodiscard]] PointCase<S> any_scale(Random& r) {
    PointCase<S> p = r.coin() ? aimed<S>(r) : grazing_hit<S>(r);
    const S length = power_of_ten<S>(r.between(-9, 9));
    const S speed = power_of_ten<S>(r.between(-150, 150));
    return {p.c * length, p.b * speed, p.s * length};
}

/// Relative velocity of two balls that move almost or exactly alike: few digits are left of it.
template <math::Scalar S>
[[nodiscard]] PointCase<S> almost_alike(Random& r) {
    PointCase<S> p = aimed<S>(r);
    const math::Vec<S> v = p.b;
    const int exponent = -r.between(0, math::ScalarTraits<S>::kDigits + 2);
    const math::Vec<S> other = v - p.b * power_of_two<S>(exponent);
    p.b = v - other;
    return p;
}

/// A tangent path without any rounding, from a Pythagorean triple; half of them one unit in the
/// last place beside it.
template <math::Scalar S>
[[nodiscard]] PointCase<S> exactly_tangent(Random& r) {
    const int m = r.between(2, 40);
    const int n = r.between(1, m - 1);
    const math::Vec<S> d(S(m * m - n * n), S(2 * m * n));
    const S h(m * m + n * n);
    const int digits = math::ScalarTraits<S>::kDigits < 64 ? 38 : 49;
    const auto integer = [&](int size) {
        const double bits = 1 + r.below(1 << 20);
        const S large = S(bits) * power_of_two<S>(size > 20 ? size - 20 : 0);
        return S(large + S(1 + r.below(1 << 18)));
    };
    const S s = integer(r.between(1, digits));
    const S along = integer(r.between(1, digits));
    const math::Vec<S> left(-d.y(), d.x());
    PointCase<S> p{left * s - d * along, d * integer(r.between(1, digits)), s * h};
    if (r.coin()) {  // the other side
        p.c = -p.c;
        p.b = -p.b;
    }
    if (r.coin()) {
        const int which = r.below(5);
        const S factor = S(1) + (r.coin() ? math::epsilon<S>() : S(-math::epsilon<S>()));
        if (which < 2) p.c[which] *= factor;
        if (which == 2 || which == 3) p.b[which - 2] *= factor;
        if (which == 4) p.s *= factor;
    }
    return p;
}

/// Beside the boundary, almost tangent: what decides is many orders below the rounding of the
/// squares of the data.
template <math::Scalar S>
[[nodiscard]] PointCase<S> hair_breadth(Random& r) {
    const S s = r.magnitude<S>(0, 0);
    const auto tiny = [&](int low) {
        const S size = r.magnitude<S>(low, -20);
        return r.coin() ? size : S(-size);
    };
    PointCase<S> p{{tiny(-50), s}, {S(1), tiny(-70)}, s};
    if (r.coin()) p.c = {p.c.y(), p.c.x()}, p.b = {p.b.y(), p.b.x()};
    return p;
}

/// Small integers: tangents, touches, equal times and zeros by the dozen.
template <math::Scalar S>
[[nodiscard]] PointCase<S> small_integers(Random& r) {
    const auto integer = [&] { return S(r.between(-6, 6)); };
    return {{integer(), integer()}, {integer(), integer()}, S(r.between(1, 6))};
}

template <math::Scalar S>
[[nodiscard]] PointCase<S> no_relative_motion(Random& r) {
    PointCase<S> p = r.coin() ? anywhere<S>(r) : touching<S>(r);
    p.b = {S(0), r.coin() ? S(0) : S(-S(0))};
    return p;
}

template <math::Scalar S>
struct ContactFamily {
    const char* name;
    bool adversarial;
    PointCase<S> (*make)(Random&);
};

template <math::Scalar S>
inline constexpr std::array<ContactFamily<S>, 13> kContactFamilies{{
    {"random", false, anywhere<S>},
    {"aimed", false, aimed<S>},
    {"graze 1-10^-k", true, grazing_hit<S>},
    {"miss 1+10^-k", true, grazing_miss<S>},
    {"touching", true, touching<S>},
    {"touching sideways", true, touching_sideways<S>},
    {"s/L 1e-8..1e-3", true, tiny_circle<S>},
    {"any scale", true, any_scale<S>},
    {"almost equal velocity", true, almost_alike<S>},
    {"exactly tangent", true, exactly_tangent<S>},
    {"hair's breadth", true, hair_breadth<S>},
    {"small integers", true, small_integers<S>},
    {"no relative motion", true, no_relative_motion<S>},
}};

}  // namespace osculo::support
