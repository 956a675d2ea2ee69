#pragma once

#include "osculo/motion/certified_path.hpp"
#include "support/exact_parabolic.hpp"

/// Motion with a constant third derivative: the simplest that no parabola is, with first contacts
/// from polynomials.
namespace osculo::support {

/// position + velocity t + square t^2 + cube t^3.
template <math::Scalar S>
struct CubicPath {
    math::WidePoint<S> position;
    math::Vec<S> velocity;
    math::Vec<S> square;
    math::Vec<S> cube;
    S end;

    [[nodiscard]] motion::PathPoint<S> at(const S& t) const {
        return {math::displaced<S>(position, math::Vec<S>(velocity + (t * t) * cube), square, t),
                velocity + t * (S(2) * square + (S(3) * t) * cube)};
    }
    [[nodiscard]] motion::ParabolicPath<S> quadratic(const S& t) const {
        const auto now = at(t);
        return {now.position, now.velocity, square + (S(3) * t) * cube, end - t};
    }
    [[nodiscard]] S jerk_bound(const S& /*t*/, const S& /*h*/) const {
        return S(6) * math::norm1<S>(cube);
    }
};

/// One coordinate (or the part along a direction) of a place as a polynomial in t.
template <class R>
using CubicCoordinate = Polynomial<R, 4>;

/// Coordinate i of a path, seen from a point.
template <class R, math::Scalar S>
[[nodiscard]] CubicCoordinate<R> coordinate(const CubicPath<S>& path, const math::Vec<S>& point,
                                            int i) {
    const R start = exact<R>(i == 0 ? path.position.x : path.position.y) - exact<R>(S(point[i]));
    return {start, exact<R>(S(path.velocity[i])), exact<R>(S(path.square[i])),
            exact<R>(S(path.cube[i]))};
}

/// x^2 + y^2 - s^2.
template <class R>
[[nodiscard]] Polynomial<R, 7> circle_gap(const CubicCoordinate<R>& x, const CubicCoordinate<R>& y,
                                          const R& s) {
    Polynomial<R, 7> q;
    q.fill(R(0));
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t k = 0; k < 4; ++k) q[j + k] += x[j] * x[k] + y[j] * y[k];
    }
    q[0] -= s * s;
    return q;
}

template <class R>
[[nodiscard]] CubicCoordinate<R> difference(const CubicCoordinate<R>& a,
                                            const CubicCoordinate<R>& b) {
    CubicCoordinate<R> result;
    for (std::size_t k = 0; k < 4; ++k) result[k] = a[k] - b[k];
    return result;
}

/// The least value of f on [0, end].
template <class R, std::size_t N>
[[nodiscard]] R least_value(const Polynomial<R, N>& f, const R& end) {
    R least = std::min<R>(f[0], value<R, N>(f, end));
    for (const R& t : zeros<R, N - 1>(derivative<R, N>(f), end)) {
        least = std::min<R>(least, value<R, N>(f, t));
    }
    return least;
}

}  // namespace osculo::support
