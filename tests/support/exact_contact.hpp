#pragma once

#include <optional>

#include "support/exact.hpp"

/// First contacts from their definition alone (NUMERICS 1.1): the first t >= 0 at which the gap
/// function is not positive and falls. Textbook quadratics; the digits pay for the cancellation.
namespace osculo::support {

template <math::Scalar S>
struct PointCase {
    math::Vec<S> c;  ///< where the point is, seen from the centre of the circle
    math::Vec<S> b;  ///< its velocity
    S s;             ///< radius of the circle
};

template <math::Scalar S>
[[nodiscard]] std::string bits(const PointCase<S>& p) {
    return std::string(name_of<S>()) + " c=" + bits<S>(p.c) + " b=" + bits<S>(p.b) +
           " s=" + bits<S>(p.s);
}

/// |c + b t|^2 - s^2 = quadratic t^2 + 2 slope t + gap.
template <class R>
struct GapFunction {
    R quadratic;
    R slope;
    R gap;
    R discriminant;

    template <math::Scalar S>
    explicit GapFunction(const PointCase<S>& p) {
        const R cx = exact<R>(S(p.c.x()));
        const R cy = exact<R>(S(p.c.y()));
        const R bx = exact<R>(S(p.b.x()));
        const R by = exact<R>(S(p.b.y()));
        const R s = exact<R>(p.s);
        quadratic = bx * bx + by * by;
        slope = bx * cx + by * cy;
        gap = cx * cx + cy * cy - s * s;
        discriminant = slope * slope - quadratic * gap;
    }
};

template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] std::optional<R> exact_entry(const PointCase<S>& p) {
    const GapFunction<R> f(p);
    if (f.slope >= 0) return std::nullopt;  // and the slope only grows
    if (f.gap <= 0) return R(0);
    if (f.discriminant <= 0) return std::nullopt;
    return R((-f.slope - sqrt(f.discriminant)) / f.quadratic);
}

/// The same with the gap function turned round, for a circle that holds the point: the first t >= 0
/// at which it is not negative and grows, after (or at the start of) a time inside.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] std::optional<R> exact_exit(const PointCase<S>& p) {
    const GapFunction<R> f(p);
    if (f.quadratic == 0) return std::nullopt;
    if (f.slope >= 0 && f.gap >= 0) return R(0);
    if (f.gap >= 0 && f.discriminant <= 0) return std::nullopt;
    return R((-f.slope + sqrt(f.discriminant)) / f.quadratic);
}

}  // namespace osculo::support
