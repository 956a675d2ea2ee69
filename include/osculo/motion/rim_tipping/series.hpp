#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/vec.hpp"

namespace osculo::motion {

/// p0 + p1 t + ... of a fixed order.
template <math::Scalar S, std::size_t N>
struct PowerSeries {
    std::array<S, N> p;

    [[nodiscard]] S operator()(const S& t) const {
        S sum = p[N - 1];
        for (std::size_t k = N - 1; k-- > 0;) sum = sum * t + p[k];
        return sum;
    }
    [[nodiscard]] S slope(const S& t) const {
        S sum = S(static_cast<int>(N - 1)) * p[N - 1];
        for (std::size_t k = N - 1; k-- > 1;) sum = sum * t + S(static_cast<int>(k)) * p[k];
        return sum;
    }
};

/// A stretch of the motion of a ball that touches the edge, as Taylor series of time in the units
/// of field.hpp, for 0 <= t <= length:
///
///   q' = c w,  c' = -q w,  w' = q - L^2 c i^3,  i' = c w i^2,  e' = L i^2 (-e_y, e_x)
///
/// q, c: sine and cosine of the tilt, w its rate, i = 1 / d, e: from the hole to the ball, unit.
/// They pass turning points like any other place, so time needs no quadrature there. The sums of
/// the terms are in wide precision, so that what is left of a saddle's instability is no more than
/// that of the start.
template <math::Scalar S>
class TippingSeries {
    using Wide = math::Wide<S>;

public:
    /// Three tenths of the digits: what the series lasts for is then about as long for the work as
    /// it can be.
    static constexpr std::size_t kTerms =
        static_cast<std::size_t>(math::ScalarTraits<S>::kDigits * (math::Builtin<S> ? 6 : 3)) / 10;
    using Narrow = PowerSeries<S, kTerms>;

    struct Start {
        Wide q, c, w, i, ex, ey;
    };

    TippingSeries(const Start& start, const Wide& moment) {
        Wides q, c, w, i, ex, ey;
        q[0] = start.q;
        c[0] = start.c;
        w[0] = start.w;
        i[0] = start.i;
        ex[0] = start.ex;
        ey[0] = start.ey;
        Wides cw, ii, rate;
        const Wide moment_square = moment * moment;
        for (std::size_t k = 0; k + 1 < kTerms; ++k) {
            cw[k] = product(c, w, k);
            ii[k] = product(i, i, k);
            rate[k] = moment * ii[k];
            cubes_[k] = product(ii, i, k);
            const Wide n(S(static_cast<int>(k + 1)));
            const auto grow = [&](Wides& x, const Wide& slope) {
                x[k + 1] = math::wide_quotient(slope, n);
            };
            grow(q, cw[k]);
            grow(c, -product(q, w, k));
            grow(w, q[k] - moment_square * product(c, cubes_, k));
            grow(i, product(cw, ii, k));
            grow(ex, -product(ey, rate, k));
            grow(ey, product(ex, rate, k));
        }
        wide_ = {q, c, w, i, ex, ey};
        for (std::size_t n = 0; n < kSeries; ++n) {
            for (std::size_t k = 0; k < kTerms; ++k) narrow_[n].p[k] = math::narrow(wide_[n][k]);
        }
        length_ = resolved_length();
    }

    [[nodiscard]] const S& length() const { return length_; }
    [[nodiscard]] const Narrow& tilt() const { return narrow_[0]; }
    [[nodiscard]] const Narrow& cosine() const { return narrow_[1]; }
    [[nodiscard]] const Narrow& rate() const { return narrow_[2]; }
    [[nodiscard]] const Narrow& inverse() const { return narrow_[3]; }
    [[nodiscard]] math::Vec<S> out(const S& t) const { return {narrow_[4](t), narrow_[5](t)}; }

    /// The sine of the tilt beyond that of the sine [q] and the cosine [c], as a series.
    [[nodiscard]] Narrow beyond(const Wide& q, const Wide& c) const {
        Narrow result;
        for (std::size_t k = 0; k < kTerms; ++k) {
            result.p[k] = math::narrow(Wide(wide_[0][k] * c - wide_[1][k] * q));
        }
        return result;
    }

    /// Everything at t.
    [[nodiscard]] Start at(const S& t) const {
        const auto sum = [&](std::size_t n) {
            Wide value = wide_[n][kTerms - 1];
            for (std::size_t k = kTerms - 1; k-- > 0;) value = value * Wide(t) + wide_[n][k];
            return value;
        };
        return {sum(0), sum(1), sum(2), sum(3), sum(4), sum(5)};
    }

private:
    static constexpr std::size_t kSeries = 6;
    using Wides = std::array<Wide, kTerms>;

    [[nodiscard]] static Wide product(const Wides& a, const Wides& b, std::size_t n) {
        Wide sum = a[0] * b[n];
        for (std::size_t k = 1; k <= n; ++k) sum = sum + a[k] * b[n - k];
        return sum;
    }

    /// Until when the last two terms of every series are less than wide rounding of what tells the
    /// sizes at first: tilt and rate may be tiny, and grow.
    [[nodiscard]] S resolved_length() const {
        constexpr int kMostTrials = 400;
        const auto& [tilt, cosine, rate, inverse, ex, ey] = narrow_;
        S h(1);
        for (int n = 0; n < kMostTrials; ++n, h *= S(0.875)) {
            const S size = math::abs<S>(tilt.p[0]) + math::abs<S>(rate.p[0]) +
                           h * (math::abs<S>(tilt.p[1]) + math::abs<S>(rate.p[1]));
            S power(1);
            for (std::size_t k = 0; k + 2 < kTerms; ++k) power *= h;
            const auto small = [&](const Narrow& x, const S& of) {
                const S last = math::abs<S>(x.p[kTerms - 2]) + h * math::abs<S>(x.p[kTerms - 1]);
                return power * last <= math::wide_epsilon<S>() * of;
            };
            if (small(tilt, size) && small(rate, size) && small(cosine, S(1)) &&
                small(inverse, inverse.p[0]) && small(ex, S(1)) && small(ey, S(1))) {
                break;
            }
        }
        return h;
    }

    std::array<Wides, kSeries> wide_;
    std::array<Narrow, kSeries> narrow_;
    Wides cubes_;
    S length_;
};

}  // namespace osculo::motion
