#pragma once

#include <Eigen/Core>

#include "osculo/math/floating_point.hpp"
#include "osculo/math/wide.hpp"

namespace Eigen {
/// Lets Eigen compute with __float128, for which the standard library has no numeric_limits.
template <>
struct NumTraits<osculo::math::Quad> : GenericNumTraits<double> {
    using Real = osculo::math::Quad;
    using NonInteger = osculo::math::Quad;
    using Nested = osculo::math::Quad;
    using Literal = osculo::math::Quad;
    static Real epsilon() { return osculo::math::epsilon<Real>(); }
    static Real dummy_precision() { return Real(0x1p-100); }
};
}  // namespace Eigen

namespace osculo::math {

/// A vector in the plane.
template <Scalar S>
using Vec = Eigen::Matrix<S, 2, 1>;

/// A vector in space, z up.
template <Scalar S>
using Vec3 = Eigen::Matrix<S, 3, 1>;

/// a b - c d with an error of at most 1.5 ulp of the result, whatever cancels (after W. Kahan; two
/// exact products instead of two fused operations, so that it serves types without fma). Its sign
/// is exact.
template <Scalar S>
[[nodiscard]] S difference_of_products(const S& a, const S& b, const S& c, const S& d) {
    if constexpr (Builtin<S>) {
        const auto p = two_product(a, b);
        const auto q = two_product(c, d);
        return (p.hi - q.hi) + (p.lo - q.lo);
    } else {
        return a * b - c * d;
    }
}

/// a . b, to rounding of each term.
template <Scalar S>
[[nodiscard]] S dot(const Vec<S>& a, const Vec<S>& b) {
    return a.x() * b.x() + a.y() * b.y();
}
/// The z component of a x b, to rounding of each term.
template <Scalar S>
[[nodiscard]] S cross(const Vec<S>& a, const Vec<S>& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// a . b and a x b to 1.5 ulp of the result, sign exact.
template <Scalar S>
[[nodiscard]] S accurate_dot(const Vec<S>& a, const Vec<S>& b) {
    return difference_of_products<S>(a.x(), b.x(), -a.y(), b.y());
}
template <Scalar S>
[[nodiscard]] S accurate_cross(const Vec<S>& a, const Vec<S>& b) {
    return difference_of_products<S>(a.x(), b.y(), a.y(), b.x());
}

/// a . b and a x b in wide precision.
template <Scalar S>
[[nodiscard]] Wide<S> wide_dot(const Vec<S>& a, const Vec<S>& b) {
    return wide_product<S>(a.x(), b.x()) + wide_product<S>(a.y(), b.y());
}
template <Scalar S>
[[nodiscard]] Wide<S> wide_cross(const Vec<S>& a, const Vec<S>& b) {
    return wide_product<S>(a.x(), b.y()) - wide_product<S>(a.y(), b.x());
}

/// |x| + |y|.
template <Scalar S>
[[nodiscard]] S norm1(const Vec<S>& a) {
    return abs<S>(a.x()) + abs<S>(a.y());
}
template <Scalar S>
[[nodiscard]] S norm_max(const Vec<S>& a) {
    const S x = abs<S>(a.x());
    const S y = abs<S>(a.y());
    return x < y ? y : x;
}
/// Length, safe from overflow and underflow. Error <= 4 ulp: at most 3.25 roundings (components 1,
/// squares and sum 1.25 of what the root halves, root and product 1 each), 4.25 for Quad's root.
template <Scalar S>
[[nodiscard]] S norm(const Vec<S>& a) {
    const S scale = norm_max<S>(a);
    if (!(scale > S(0))) return scale;
    const Vec<S> b = a / scale;
    return scale * square_root<S>(dot<S>(b, b));
}

/// A point kept in wide coordinates: what moves is never rounded to the grid of S, so a table far
/// from the origin is as exact as one around it.
template <Scalar S>
struct WidePoint {
    Wide<S> x{};
    Wide<S> y{};

    WidePoint() = default;
    explicit WidePoint(const Vec<S>& p) : x(p.x()), y(p.y()) {}
    WidePoint(const Wide<S>& px, const Wide<S>& py) : x(px), y(py) {}

    /// The nearest point in S.
    [[nodiscard]] Vec<S> rounded() const { return {narrow(x), narrow(y)}; }
    /// What rounded() takes away.
    [[nodiscard]] Vec<S> remainder() const { return {low_part(x), low_part(y)}; }
};

/// a - b, to 1/2 ulp of the difference.
template <Scalar S>
[[nodiscard]] Vec<S> difference(const WidePoint<S>& a, const WidePoint<S>& b) {
    return {narrow(Wide<S>(a.x - b.x)), narrow(Wide<S>(a.y - b.y))};
}
template <Scalar S>
[[nodiscard]] Vec<S> difference(const WidePoint<S>& a, const Vec<S>& b) {
    return {narrow(Wide<S>(a.x - b.x())), narrow(Wide<S>(a.y - b.y()))};
}

/// a - b, in wide precision.
template <Scalar S>
[[nodiscard]] WidePoint<S> wide_difference(const WidePoint<S>& a, const Vec<S>& b) {
    return {a.x - b.x(), a.y - b.y()};
}

/// p + v t in wide precision.
template <Scalar S>
[[nodiscard]] WidePoint<S> displaced(const WidePoint<S>& p, const Vec<S>& v, const S& t) {
    return {p.x + wide_product<S>(v.x(), t), p.y + wide_product<S>(v.y(), t)};
}

/// p + v t + a t^2 in wide precision; a is half the acceleration.
template <Scalar S>
[[nodiscard]] WidePoint<S> displaced(const WidePoint<S>& p, const Vec<S>& v, const Vec<S>& a,
                                     const S& t) {
    const auto moved = [&t](const Wide<S>& x, const S& speed, const S& half_acceleration) {
        const Wide<S> mean_speed = wide_product<S>(half_acceleration, t) + speed;
        return Wide<S>(x + mean_speed * Wide<S>(t));
    };
    return {moved(p.x, v.x(), a.x()), moved(p.y, v.y(), a.y())};
}

}  // namespace osculo::math
