#pragma once

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/vec.hpp"

/// The field of a rim with the law `paper` (PHYSICS 1.4): a ball of radius r with its centre at the
/// distance d from that of a hole of radius R is pulled towards it by g q sqrt(1 - q^2), where
/// q = (R - d) / r = sin(tilt) is the tilt of the line from the rim to the ball's centre.
///
/// Here lengths are in units of r and speeds in those of sqrt(g r). The radial motion is
/// d'^2 = F = F0 + 2/3 (c0^3 - c^3) - L^2 (1/d^2 - 1/d0^2), c = cos(tilt), and is told in
/// z = tan(tilt / 2), in which everything is rational: q = 2z / (1 + z^2), c = (1 - z^2) /
/// (1 + z^2). z is 0 on the rim and 1 where the ball falls in.
namespace osculo::motion {

/// A place in the field.
template <math::Scalar S>
struct RimPlace {
    S z;
    S to_end;  ///< 1 - z, where it counts to more digits than z has
    S q, c, d;

    RimPlace() = default;
    /// [least]: d where balls fall in, R - r.
    RimPlace(const S& at, const S& before_end, const S& least) : z(at), to_end(before_end) {
        const S norm = S(1) + z * z;
        q = S(2) * z / norm;
        c = to_end * (S(1) + z) / norm;
        d = least + to_end * to_end / norm;
    }
    /// dq / dz.
    [[nodiscard]] S steepness() const { return S(2) * c / (S(1) + z * z); }
};

/// (q - q') / (z - z').
template <math::Scalar S>
[[nodiscard]] S mean_steepness(const RimPlace<S>& p, const RimPlace<S>& from) {
    const S norms = (S(1) + p.z * p.z) * (S(1) + from.z * from.z);
    return S(2) * (p.to_end + p.z * from.to_end) / norms;
}

/// F around a place where it and its slope are known to all digits of S, however much cancels in
/// them: at distances y = z - z_anchor it is formed from differences that do not cancel.
template <math::Scalar S>
struct RimAnchor {
    S least;          ///< R - r
    S moment_square;  ///< L^2
    RimPlace<S> place;
    S value;  ///< F
    S slope;  ///< dF / dq

    [[nodiscard]] RimPlace<S> at(const S& y) const {
        return {S(place.z + y), S(place.to_end - y), least};
    }

    /// (F(p) - value) / (q_p - q) for p = at(y), not at z = 1 if the anchor is there.
    [[nodiscard]] S mean_slope(const RimPlace<S>& p, const S& y) const {
        const S tilt = y * mean_steepness<S>(p, place);  // q_p - q
        const S tangent = (p.q + place.q) / (p.c + place.c);
        const S change = -tilt * tangent;  // c_p - c
        const S pull =
            place.c * (tilt + tangent * change) + S(2) / S(3) * tangent * (change * change);
        const S& d = place.d;
        const S swing = tilt * (S(3) * d - S(2) * tilt) / (p.d * p.d * d * d * d);
        return slope + (pull - moment_square * swing);
    }

    [[nodiscard]] S value_at(const S& y) const {
        if (y == S(0)) return value;
        const RimPlace<S> p = at(y);
        return value + y * mean_steepness<S>(p, place) * mean_slope(p, y);
    }
};

/// The field as a ball with a given motion sees it, in wide precision.
template <math::Scalar S>
class RimField {
    using Wide = math::Wide<S>;

public:
    /// [tilt_sine], [radial], [moment]: q, d' and L at the start. Requires 0 <= q < 1, up to
    /// rounding.
    RimField(const Wide& rim, const Wide& tilt_sine, const Wide& radial, const Wide& moment)
        : rim_(rim), moment_square_(moment * moment), start_value_(radial * radial) {
        const Wide one{S(1)};
        q_ = tilt_sine;
        c_ = math::wide_square_root<S>(Wide((one - q_) * (one + q_)));
        d_ = rim_ - q_;
        z_ = math::wide_quotient(q_, Wide(one + c_));
    }

    [[nodiscard]] const Wide& start() const { return z_; }  ///< z
    /// Whether it starts at a turn: its radial speed is no more than rounding of its velocity.
    [[nodiscard]] bool turns_at_start() const {
        const S noise = S(math::kVelocityNoise) * math::epsilon<S>();
        const S d = math::narrow(d_);
        const S radial = math::narrow(start_value_);
        return radial <= noise * noise * (radial + moment_square() / (d * d));
    }
    [[nodiscard]] S rim() const { return math::narrow(rim_); }
    /// R - r.
    [[nodiscard]] S least_distance() const { return math::narrow(Wide(rim_ - Wide(S(1)))); }
    [[nodiscard]] S moment_square() const { return math::narrow(moment_square_); }

    /// F at z >= 0, and how much of it may be rounding.
    struct Value {
        Wide value;
        S noise;
    };
    [[nodiscard]] Value value(const Wide& z) const {
        const Place p = place(z);
        const Wide way = p.q - q_;
        const Wide dd = p.d * d_;
        const Wide pull = Wide(S(2)) * (c_ * c_ + c_ * p.c + p.c * p.c) * (p.q + q_);
        const Wide pulled = math::wide_quotient(pull, Wide(Wide(S(3)) * (c_ + p.c)));
        const Wide swung = math::wide_quotient(Wide(moment_square_ * (p.d + d_)), Wide(dd * dd));
        const S terms =
            math::narrow(start_value_) +
            math::abs<S>(math::narrow(way)) * (math::narrow(pulled) + math::narrow(swung));
        return {start_value_ + way * (pulled - swung),
                S(S(math::kRimBalance) * math::wide_epsilon<S>() * terms)};
    }
    /// dF / dq / 2.
    [[nodiscard]] Wide half_slope(const Wide& z) const {
        const Place p = place(z);
        return p.q * p.c - math::wide_quotient(moment_square_, Wide(p.d * p.d * p.d));
    }

    [[nodiscard]] RimAnchor<S> anchor(const Wide& z) const {
        return {least_distance(), moment_square(),
                RimPlace<S>(math::narrow(z), math::narrow(Wide(Wide(S(1)) - z)), least_distance()),
                math::narrow(value(z).value), S(S(2) * math::narrow(half_slope(z)))};
    }

private:
    struct Place {
        Wide q, c, d;
    };
    [[nodiscard]] Place place(const Wide& z) const {
        const Wide one{S(1)};
        const Wide norm = one + z * z;
        const Wide q = math::wide_quotient(Wide(Wide(S(2)) * z), norm);
        return {q, math::wide_quotient(Wide((one - z) * (one + z)), norm), rim_ - q};
    }

    Wide rim_;
    Wide moment_square_;
    Wide start_value_;
    Wide q_, c_, d_, z_;
};

}  // namespace osculo::motion
