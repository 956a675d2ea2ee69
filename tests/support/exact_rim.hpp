#pragma once

#include <array>
#include <vector>

#include "support/scalars.hpp"

namespace osculo::support {

/// A ball in the field of a rim around the origin (PHYSICS 1.4), followed in Cartesian coordinates
/// by Taylor series of order 50 in 50 digits: nothing in common with the quadrature.
class ExactRim {
    using R = Digits50;
    static constexpr std::size_t kOrder = 50;
    using Series = std::array<R, kOrder + 1>;

public:
    struct State {
        R x, y, vx, vy;
    };

    ExactRim(const R& rim, const R& radius, const R& gravity, const State& start)
        : rim_(rim), radius_(radius), gravity_(gravity), state_(start) {}

    /// The state at t. To be called with ascending t, before the ball falls in.
    const State& at(const R& t) {
        while (time_ < t) {
            Series x{}, y{};
            expand(x, y);
            // A third of the radius of convergence, as the last terms tell it.
            const R last =
                abs(x[kOrder]) + abs(y[kOrder]) + abs(x[kOrder - 1]) + abs(y[kOrder - 1]);
            const R reach = pow(R(rim_ / (last + R("1e-2000"))), R(R(1) / R(kOrder)));
            const R step = std::min<R>(R(t - time_), R(reach / 12));
            advance(x, y, step);
            time_ = step == t - time_ ? t : R(time_ + step);
        }
        return state_;
    }

private:
    void expand(Series& x, Series& y) const {
        Series dd{}, d{}, q{}, w{}, s{}, qs{}, pull{};
        x[0] = state_.x;
        y[0] = state_.y;
        x[1] = state_.vx;
        y[1] = state_.vy;
        const auto product = [](const Series& a, const Series& b, std::size_t n) {
            R sum = 0;
            for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
            return sum;
        };
        const auto root = [](const Series& square, const Series& a, std::size_t n) {
            if (n == 0) return R(sqrt(square[0]));
            R sum = square[n];
            for (std::size_t i = 1; i < n; ++i) sum -= a[i] * a[n - i];
            return R(sum / (2 * a[0]));
        };
        for (std::size_t n = 0; n + 2 <= kOrder; ++n) {
            dd[n] = product(x, x, n) + product(y, y, n);
            d[n] = root(dd, d, n);
            q[n] = ((n == 0 ? rim_ : R(0)) - d[n]) / radius_;
            w[n] = (n == 0 ? R(1) : R(0)) - product(q, q, n);
            s[n] = root(w, s, n);
            qs[n] = product(q, s, n);
            R rest = gravity_ * qs[n];  // pull d = g q s
            for (std::size_t i = 0; i < n; ++i) rest -= pull[i] * d[n - i];
            pull[n] = rest / d[0];
            const R factor = R((n + 1) * (n + 2));
            x[n + 2] = -product(pull, x, n) / factor;
            y[n + 2] = -product(pull, y, n) / factor;
        }
    }
    void advance(const Series& x, const Series& y, const R& h) {
        State next{0, 0, 0, 0};
        for (std::size_t n = kOrder + 1; n-- > 0;) {
            next.vx = next.vx * h + next.x;
            next.vy = next.vy * h + next.y;
            next.x = next.x * h + x[n];
            next.y = next.y * h + y[n];
        }
        state_ = next;
    }

    R rim_, radius_, gravity_;
    R time_ = 0;
    State state_;
};

}  // namespace osculo::support
