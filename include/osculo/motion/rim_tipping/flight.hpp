#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "osculo/math/polynomial.hpp"
#include "osculo/math/vec.hpp"
#include "osculo/motion/rim_tipping/series.hpp"

namespace osculo::motion {

/// How a ball's flight off the edge of a hole ends.
enum class FlightEnd {
    edge,  ///< it hits the edge again, anywhere on it
    down,  ///< its centre is level with the edge, which can only push it down from there
    exit,  ///< its centre is over the rim on the way out, above the table
};

/// The flight of a ball off the edge of a hole: uniform in the plane, a parabola in height. Lengths
/// in r, speeds in sqrt(g r), time in sqrt(r / g).
///
/// The distance from the edge, a circle of radius R at height 0, is r where
/// (x^2 + h^2 + R^2 - 1)^2 = 4 R^2 x^2, a polynomial p of degree 8 that has the sign of the
/// distance beyond r all the way. Its first fall to zero is isolated between the zeros of its
/// derivatives, so none is missed, and told in wide precision.
template <math::Scalar S>
class TippingFlight {
    using Wide = math::Wide<S>;
    static constexpr std::size_t kDegree = 8;
    using Poly = std::array<Wide, kDegree + 1>;

public:
    struct Start {
        Wide rim;            ///< R
        Wide x, y;           ///< from the hole's centre
        Wide height;         ///< > 0
        Wide vx, vy, climb;  ///< velocity
        /// Of p at the start, as many of the first coefficients as are 0 but for rounding: 0 if it
        /// is off the edge, 1 if it touches, 3 if it has just lost contact with it.
        int zeros;
    };

    explicit TippingFlight(const Start& start) : start_(start) {
        const Wide v2 = start.vx * start.vx + start.vy * start.vy;
        const Wide xv = start.x * start.vx + start.y * start.vy;
        const Wide x2 = start.x * start.x + start.y * start.y;
        // Level with the edge: climb t - t^2 / 2 = -h, in the form that does not cancel.
        const Wide root = math::wide_square_root<S>(
            Wide(start.climb * start.climb + start.height + start.height));
        const Wide fall =
            start.climb < Wide(S(0))
                ? math::wide_quotient(Wide(start.height + start.height), Wide(root - start.climb))
                : Wide(start.climb + root);
        duration_ = math::narrow(fall);
        // Over the rim, from inside.
        if (math::narrow(v2) > S(0)) {
            const Wide room = std::max<Wide>(start.rim * start.rim - x2, Wide(S(0)));
            const Wide reach = math::wide_square_root<S>(Wide(xv * xv + room * v2));
            const Wide out = xv < Wide(S(0)) ? math::wide_quotient(Wide(reach - xv), v2)
                                             : math::wide_quotient(room, Wide(reach + xv));
            if (math::is_finite<S>(math::narrow(out)) && math::narrow(out) < duration_) {
                duration_ = math::narrow(out);
                end_ = FlightEnd::exit;
            }
        }
        find_edge(v2, xv, x2);
    }

    [[nodiscard]] FlightEnd end() const { return end_; }
    [[nodiscard]] const S& duration() const { return duration_; }

private:
    /// p of the time in units of the duration so far, so that what counts is between 0 and 1.
    void find_edge(const Wide& v2, const Wide& xv, const Wide& x2) {
        const Wide t(duration_);
        const Wide two(S(2));
        const std::array<Wide, 3> plan{x2, two * xv * t, v2 * t * t};
        const std::array<Wide, 3> height{start_.height, start_.climb * t, Wide(S(-0.5)) * t * t};
        const Wide rim_square = start_.rim * start_.rim;
        std::array<Wide, 5> sum{};
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] = sum[i] + plan[i];
            for (std::size_t j = 0; j < 3; ++j) sum[i + j] = sum[i + j] + height[i] * height[j];
        }
        sum[0] = sum[0] + (rim_square - S(1));
        Poly p{};
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t j = 0; j < 5; ++j) p[i + j] = p[i + j] + sum[i] * sum[j];
        }
        for (std::size_t i = 0; i < 3; ++i) p[i] = p[i] - Wide(S(4)) * rim_square * plan[i];

        // What is known to be 0, or is beyond the edge by rounding, is divided out to find where it
        // comes down again, but not from what tells that place: it would add up over many hops.
        std::size_t known = static_cast<std::size_t>(start_.zeros);
        if (known == 0 && !(p[0] > Wide(S(0)))) known = 1;
        Poly q{};
        for (std::size_t i = known; i <= kDegree; ++i) q[i - known] = p[i];
        if (start_.zeros == 0 && known == 1 && q[0] < Wide(S(0))) {
            duration_ = S(0);
            end_ = FlightEnd::edge;
            return;
        }
        if (q[0] < Wide(S(0))) q[0] = S(0);  // by rounding
        const S hit = first_fall(q);
        if (!(hit <= S(1))) return;
        duration_ = duration_ * polished(p, hit);
        end_ = FlightEnd::edge;
    }

    using Narrow = PowerSeries<S, kDegree + 1>;

    /// The first fall of p to zero in (0, 1], or 2. p(0) >= 0.
    [[nodiscard]] static S first_fall(const Poly& wide) {
        const Narrow p = narrowed(wide);
        // The derivatives, from the highest down: where each changes its sign.
        std::array<S, kDegree + 2> turns{S(0), S(1)};
        std::size_t count = 2;
        for (std::size_t order = kDegree - 1; order > 0; --order) {
            const Narrow f = derivative(p, order);
            std::array<S, kDegree + 2> zeros{S(0)};
            std::size_t found = 1;
            for (std::size_t i = 0; i + 1 < count; ++i) {
                const bool rising = f(turns[i]) < S(0);
                if (rising == (f(turns[i + 1]) < S(0))) continue;
                zeros[found++] = math::bracketed_root<S>(f, turns[i], turns[i + 1], rising);
            }
            zeros[found++] = S(1);
            turns = zeros;
            count = found;
        }
        for (std::size_t i = 0; i + 1 < count; ++i) {
            if (math::narrow(value(wide, turns[i + 1])) > S(0)) continue;
            const S start = turns[i];
            if (!(p(turns[i + 1]) < S(0)) || !(p(start) > S(0) || i == 0)) return turns[i + 1];
            return math::bracketed_root<S>(p, start, turns[i + 1], false);
        }
        return S(2);
    }
    [[nodiscard]] static Narrow derivative(const Narrow& p, std::size_t order) {
        Narrow result;
        result.p.fill(S(0));
        for (std::size_t k = order; k <= kDegree; ++k) {
            S factor(1);
            for (std::size_t n = 0; n < order; ++n) factor *= S(static_cast<int>(k - n));
            result.p[k - order] = factor * p.p[k];
        }
        return result;
    }
    [[nodiscard]] static Wide value(const Poly& p, const S& t) {
        Wide sum = p[kDegree];
        for (std::size_t k = kDegree; k-- > 0;) sum = sum * Wide(t) + p[k];
        return sum;
    }
    /// Newton's steps with the value in wide precision.
    [[nodiscard]] static S polished(const Poly& p, S t) {
        const Narrow slopes = derivative(narrowed(p), 1);
        for (int i = 0; i < 3; ++i) {
            const S slope = slopes(t);
            if (!(slope < S(0))) break;
            const S step = math::narrow(value(p, t)) / slope;
            if (!(math::abs<S>(step) < S(0x1p-10) * t)) break;  // a graze
            t -= step;
        }
        return std::clamp<S>(t, S(0), S(1));
    }
    [[nodiscard]] static Narrow narrowed(const Poly& p) {
        Narrow result;
        for (std::size_t k = 0; k <= kDegree; ++k) result.p[k] = math::narrow(p[k]);
        return result;
    }

    Start start_;
    FlightEnd end_ = FlightEnd::down;
    S duration_{0};
};

}  // namespace osculo::motion
