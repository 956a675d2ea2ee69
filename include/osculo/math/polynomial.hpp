#pragma once

#include <algorithm>
#include <array>

#include "osculo/math/vec.hpp"

namespace osculo::math {

/// p0 + p1 t + p2 t^2 + p3 t^3.
template <Scalar S>
struct Cubic {
    S p0, p1, p2, p3;

    [[nodiscard]] S operator()(const S& t) const { return p0 + t * (p1 + t * (p2 + t * p3)); }
    [[nodiscard]] S slope(const S& t) const { return p1 + t * (S(2) * p2 + S(3) * t * p3); }

    /// The sum of the terms' sizes at t >= 0, of which the value is uncertain by some epsilon.
    [[nodiscard]] S size(const S& t) const {
        return abs<S>(p0) + t * (abs<S>(p1) + t * (abs<S>(p2) + t * abs<S>(p3)));
    }

    /// Where the slope vanishes, in ascending order; false if it has no two real zeros, in which
    /// case the cubic is monotone.
    [[nodiscard]] bool extrema(S& first, S& last) const {
        const S a = S(3) * p3;
        if (!(a != S(0))) return false;
        const S disc = difference_of_products<S>(p2, p2, a, p1);
        if (!(disc > S(0))) return false;
        const S w = p2 < S(0) ? S(square_root<S>(disc) - p2) : S(-(square_root<S>(disc) + p2));
        first = w / a;
        last = p1 / w;  // w != 0, since |w| >= sqrt(disc)
        if (last < first) std::swap(first, last);
        return true;
    }
};

/// The zero of f in [low, high], where its sign changes once; [rising]: f(low) < 0 < f(high).
/// Newton's iteration kept within a shrinking bracket; f must have slope(). Error: that of the
/// sign of f.
template <Scalar S, class Function>
[[nodiscard]] S bracketed_root(const Function& f, S low, S high, bool rising) {
    S x = low + (high - low) / S(2);
    S last_step = high - low;
    for (int i = 0; i < 4 * ScalarTraits<S>::kDigits; ++i) {
        const S value = f(x);
        if (value == S(0)) return x;
        ((value < S(0)) == rising ? low : high) = x;
        const S step = value / f.slope(x);
        S next = x - step;
        S size = abs<S>(step);
        // Outside of the bracket, or too slow: bisect.
        if (!(next > low && next < high) || S(2) * size > last_step) {
            next = low + (high - low) / S(2);
            size = (high - low) / S(2);
            if (!(next > low && next < high)) return rising ? high : low;
        }
        last_step = size;
        x = next;
        if (size <= S(2) * epsilon<S>() * abs<S>(x)) return x;
    }
    return x;
}

}  // namespace osculo::math
