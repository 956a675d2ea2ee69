#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "support/exact.hpp"

/// First contacts on curved paths from their definition alone (NUMERICS 1.1): where a polynomial is
/// not positive and falls. Its zeros are isolated by Descartes' rule in the Bernstein basis,
/// halving the interval until it holds one (or is too small to matter): no derivative cascade, no
/// case analysis, nothing in common with the library but the definition.
namespace osculo::support {

template <math::Scalar S>
struct ParabolicCase {
    math::Vec<S> c;  ///< where the point is at t = 0, seen from the centre of the circle
    math::Vec<S> b;  ///< its velocity then
    math::Vec<S> a;  ///< half its acceleration
    S s;             ///< radius of the circle
    S end;           ///< of the path
};

template <math::Scalar S>
[[nodiscard]] std::string bits(const ParabolicCase<S>& p) {
    return std::string(name_of<S>()) + " c=" + bits<S>(p.c) + " b=" + bits<S>(p.b) +
           " a=" + bits<S>(p.a) + " s=" + bits<S>(p.s) + " end=" + bits<S>(p.end);
}

/// p[0] + p[1] t + ...
template <class R, std::size_t N>
using Polynomial = std::array<R, N>;

template <class R, std::size_t N>
[[nodiscard]] R value(const Polynomial<R, N>& p, const R& t) {
    R sum = p[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) sum = sum * t + p[k];
    return sum;
}

template <class R, std::size_t N>
[[nodiscard]] Polynomial<R, N - 1> derivative(const Polynomial<R, N>& p) {
    Polynomial<R, N - 1> d;
    for (std::size_t k = 1; k < N; ++k) d[k - 1] = p[k] * static_cast<int>(k);
    return d;
}

namespace detail {

/// More halvings than this, and what is left is a double zero to all digits.
inline constexpr int kHalvings = 150;

/// Coefficients in the Bernstein basis of [0, end].
template <class R, std::size_t N>
[[nodiscard]] std::array<R, N> bernstein(const Polynomial<R, N>& p, const R& end) {
    // b[i] = sum over k <= i of C(i, k) / C(n, k) p[k] end^k.
    std::array<R, N> b;
    b.fill(R(0));
    R power(1);
    for (std::size_t k = 0; k < N; ++k) {
        const R term = p[k] * power;
        R share(1);  // C(i, k) / C(n, k), from i = n down
        for (std::size_t i = N; i-- > k;) {
            b[i] += term * share;
            if (i > 0) share = share * static_cast<int>(i - k) / static_cast<int>(i);
        }
        power *= end;
    }
    return b;
}

/// Changes of sign, zeros left out: the number of zeros inside the interval, or more by an even
/// number.
template <class R, std::size_t N>
[[nodiscard]] int variations(const std::array<R, N>& b) {
    int changes = 0;
    int last = 0;
    for (const R& x : b) {
        const int sign = x > 0 ? 1 : x < 0 ? -1 : 0;
        if (sign != 0 && last != 0 && sign != last) ++changes;
        if (sign != 0) last = sign;
    }
    return changes;
}

/// The polynomial and its slope at x in [0, 1], by de Casteljau's scheme.
template <class T, std::size_t N>
[[nodiscard]] std::array<T, 2> casteljau(std::array<T, N> b, const T& x) {
    for (std::size_t level = N - 1; level > 1; --level) {
        for (std::size_t i = 0; i < level; ++i) b[i] += (b[i + 1] - b[i]) * x;
    }
    const T slope = b[1] - b[0];
    return {T(b[0] + slope * x), T(slope * static_cast<int>(N - 1))};
}

/// The only zero inside (0, 1): bisection in double, then bracketed Newton steps in R.
template <class R, std::size_t N>
[[nodiscard]] R polish(const std::array<R, N>& b) {
    R size(0);
    for (const R& x : b) size = std::max<R>(size, abs(x));
    std::array<double, N> rough;
    std::transform(b.begin(), b.end(), rough.begin(),
                   [&](const R& x) { return static_cast<double>(R(x / size)); });
    bool rising = false;  // from the last sign there is
    for (const R& x : b) {
        if (x != 0) rising = x > 0;
    }
    double near = 0;
    double far = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = near + (far - near) / 2;
        ((casteljau<double, N>(rough, middle)[0] < 0) == rising ? near : far) = middle;
    }
    R low(0);
    R high(1);
    R x(near + (far - near) / 2);
    R last = high - low;
    for (int i = 0; i < 1000; ++i) {
        const auto [f, slope] = casteljau<R, N>(b, x);
        if (f == 0) return x;
        ((f < 0) == rising ? low : high) = x;
        const R next = slope == 0 ? R(-1) : R(x - f / slope);
        const R step = abs(R(next - x));
        if (!(next > low && next < high) || 2 * step > last) {
            last = high - low;
            x = low + last / 2;
            continue;
        }
        if (step < R(1e-45) * next) return next;  // the next step is of its square
        last = step;
        x = next;
    }
    return x;
}

template <class R, std::size_t N>
void isolate(const std::array<R, N>& b, const R& low, const R& width, int halvings,
             std::vector<R>& zeros) {
    const int count = variations<R, N>(b);
    if (count == 0) return;
    if (count == 1) {
        zeros.push_back(low + width * polish<R, N>(b));
        return;
    }
    if (halvings == kHalvings) {
        zeros.push_back(low + width / 2);
        return;
    }
    std::array<R, N> left = b;
    std::array<R, N> right = b;
    for (std::size_t level = 1; level < N; ++level) {
        for (std::size_t i = 0; i + level < N; ++i) right[i] = (right[i] + right[i + 1]) / 2;
        left[level] = right[0];
    }
    const R half = width / 2;
    isolate<R, N>(left, low, half, halvings + 1, zeros);
    if (right[0] == 0) zeros.push_back(low + half);
    isolate<R, N>(right, R(low + half), half, halvings + 1, zeros);
}

}  // namespace detail

/// The zeros inside (0, end), in ascending order.
template <class R, std::size_t N>
[[nodiscard]] std::vector<R> zeros(const Polynomial<R, N>& p, const R& end) {
    std::vector<R> result;
    detail::isolate<R, N>(detail::bernstein<R, N>(p, end), R(0), end, 0, result);
    return result;
}

/// The beginning of a time in which two things are in contact and approach.
template <class R>
struct Meeting {
    R time;
    bool crossing;  ///< they come into contact here; else they are in contact already
};

/// All of them in [0, end], in order, for the gap function f.
template <class R, std::size_t N>
[[nodiscard]] std::vector<Meeting<R>> meetings(const Polynomial<R, N>& f, const R& end) {
    std::vector<R> times = zeros<R, N>(f, end);
    if (times.empty() && f[0] > 0 && value<R, N>(f, end) > 0) return {};
    const auto slope = derivative<R, N>(f);
    const std::vector<R> turns = zeros<R, N - 1>(slope, end);
    times.insert(times.end(), turns.begin(), turns.end());
    times.push_back(R(0));
    times.push_back(end);
    std::sort(times.begin(), times.end());
    std::vector<Meeting<R>> result;
    bool outside = f[0] > 0;
    bool meeting = false;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
        if (times[k + 1] - times[k] < R(1e-35) * end) continue;  // one time, computed twice
        const R middle = (times[k] + times[k + 1]) / 2;
        const bool in_contact = value<R, N>(f, middle) < 0;
        const bool meets = in_contact && value<R, N - 1>(slope, middle) < 0;
        if (meets && !meeting) result.push_back({times[k], outside});
        meeting = meets;
        outside = !in_contact;
    }
    if (outside && value<R, N>(f, end) == 0 && value<R, N - 1>(slope, end) < 0) {
        result.push_back({end, true});
    }
    return result;
}

/// |c + b t + a t^2|^2 - s^2.
template <class R, math::Scalar S>
[[nodiscard]] Polynomial<R, 5> gap_function(const ParabolicCase<S>& p) {
    Polynomial<R, 5> q;
    q.fill(R(0));
    for (int i = 0; i < 2; ++i) {
        const std::array<R, 3> x{exact<R>(S(p.c[i])), exact<R>(S(p.b[i])), exact<R>(S(p.a[i]))};
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) q[j + k] += x[j] * x[k];
        }
    }
    q[0] -= exact<R>(p.s) * exact<R>(p.s);
    return q;
}

/// Whether p(t) is zero but for a part [relative] of its terms, t >= 0.
template <class R, std::size_t N>
[[nodiscard]] bool vanishes(const Polynomial<R, N>& p, const R& t, double relative) {
    Polynomial<R, N> sizes;
    std::transform(p.begin(), p.end(), sizes.begin(), [](const R& x) { return R(abs(x)); });
    return abs(value<R, N>(p, t)) <= R(relative) * value<R, N>(sizes, t);
}

/// Whether the circle is crossed at t > 0 without speed, as an inflection: a triple zero, whose
/// time is as uncertain as the cube root of the rounding of the gap. It takes data like small
/// integers.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] bool crosses_without_speed(const ParabolicCase<S>& p, const R& t) {
    const auto gap = gap_function<R>(p);
    return t > 0 && vanishes<R, 5>(gap, t, 1e-40) &&
           vanishes<R, 4>(derivative<R, 5>(gap), t, 1e-20);
}

template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] std::optional<R> exact_entry(const ParabolicCase<S>& p) {
    const auto all = meetings<R, 5>(gap_function<R>(p), exact<R>(p.end));
    return all.empty() ? std::optional<R>() : all.front().time;
}

/// All meetings with the circle from inside, where the gap function is not negative and grows.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] std::vector<Meeting<R>> exact_exits(const ParabolicCase<S>& p) {
    Polynomial<R, 5> f = gap_function<R>(p);
    for (R& x : f) x = -x;
    return meetings<R, 5>(f, exact<R>(p.end));
}

/// The first of them. A point that is [inside] is so up to rounding.
template <math::Scalar S, class R = ExactFor<S>>
[[nodiscard]] std::optional<R> exact_exit(const ParabolicCase<S>& p, bool inside) {
    for (const auto& m : exact_exits<S, R>(p)) {
        if (inside || m.crossing) return m.time;
    }
    return std::nullopt;
}

}  // namespace osculo::support
