#pragma once

#include <array>

#include "support/scalars.hpp"

namespace osculo::support {

/// A ball that slides on the edge of a hole around the origin, followed in Cartesian coordinates of
/// space by Taylor series of order 50 in 50 digits. The edge pushes as much as keeps the centre on
/// the torus around it; where that is nothing, contact is lost.
class ExactTipping {
    using R = Digits50;
    static constexpr std::size_t kOrder = 50;
    using Series = std::array<R, kOrder + 1>;

public:
    struct State {
        R x, y, z, vx, vy, vz;
    };

    ExactTipping(const R& rim, const R& radius, const R& gravity, const State& start)
        : rim_(rim), radius_(radius), gravity_(gravity), state_(start) {}

    /// The state at t. To be called with ascending t.
    const State& at(const R& t) {
        while (time_ < t) {
            expand();
            // A third of the radius of convergence, as the last terms tell it.
            const R last = abs(x_[kOrder]) + abs(y_[kOrder]) + abs(z_[kOrder]) +
                           abs(x_[kOrder - 1]) + abs(y_[kOrder - 1]) + abs(z_[kOrder - 1]);
            const R reach = pow(R(rim_ / (last + R("1e-2000"))), R(R(1) / R(kOrder)));
            const R step = std::min<R>(R(t - time_), R(reach / 12));
            const R rest = t - time_;
            state_ = {value(x_, step), value(y_, step), value(z_, step),
                      slope(x_, step), slope(y_, step), slope(z_, step)};
            time_ = step == rest ? t : R(time_ + step);
        }
        return state_;
    }

    /// What the edge pushes with, over the mass, in a state.
    [[nodiscard]] R push(const State& s) const {
        const R d = sqrt(R(s.x * s.x + s.y * s.y));
        const R radial = (s.x * s.vx + s.y * s.vy) / d;
        const R swing = s.vx * s.vx + s.vy * s.vy - radial * radial;
        return gravity_ * s.z / radius_ -
               (radial * radial + s.vz * s.vz + (d - rim_) * swing / d) / radius_;
    }

private:
    static R product(const Series& a, const Series& b, std::size_t n) {
        R sum = 0;
        for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
        return sum;
    }
    static R value(const Series& s, const R& t) {
        R sum = 0;
        for (std::size_t n = kOrder + 1; n-- > 0;) sum = sum * t + s[n];
        return sum;
    }
    static R slope(const Series& s, const R& t) {
        R sum = 0;
        for (std::size_t n = kOrder; n > 0; --n) sum = sum * t + R(n) * s[n];
        return sum;
    }

    void expand() {
        Series vx{}, vy{}, vz{}, dd{}, d{}, inverse{}, radial{}, swing{}, beyond{}, swung{}, push{};
        Series pull{};
        x_[0] = state_.x;
        y_[0] = state_.y;
        z_[0] = state_.z;
        x_[1] = vx[0] = state_.vx;
        y_[1] = vy[0] = state_.vy;
        z_[1] = vz[0] = state_.vz;
        Series inwards{};
        for (std::size_t n = 0; n + 2 <= kOrder; ++n) {
            dd[n] = product(x_, x_, n) + product(y_, y_, n);
            if (n == 0) {
                d[0] = sqrt(dd[0]);
                inverse[0] = 1 / d[0];
            } else {
                R sum = dd[n];
                for (std::size_t i = 1; i < n; ++i) sum -= d[i] * d[n - i];
                d[n] = sum / (2 * d[0]);
                sum = 0;
                for (std::size_t i = 0; i < n; ++i) sum -= inverse[i] * d[n - i];
                inverse[n] = sum / d[0];
            }
            beyond[n] = d[n] - (n == 0 ? rim_ : R(0));
            inwards[n] = product(x_, vx, n) + product(y_, vy, n);
            radial[n] = product(inwards, inverse, n);
            swing[n] = product(vx, vx, n) + product(vy, vy, n) - product(radial, radial, n);
            swung[n] = product(swing, inverse, n);
            push[n] = (gravity_ * z_[n] - product(radial, radial, n) - product(vz, vz, n) -
                       product(beyond, swung, n)) /
                      radius_;
            Series aside{};
            for (std::size_t i = 0; i <= n; ++i) aside[i] = product(beyond, inverse, i) / radius_;
            pull[n] = product(push, aside, n);
            const R factor = R((n + 1) * (n + 2));
            x_[n + 2] = product(pull, x_, n) / factor;
            y_[n + 2] = product(pull, y_, n) / factor;
            z_[n + 2] = (product(push, z_, n) / radius_ - (n == 0 ? gravity_ : R(0))) / factor;
            vx[n + 1] = R(n + 2) * x_[n + 2];
            vy[n + 1] = R(n + 2) * y_[n + 2];
            vz[n + 1] = R(n + 2) * z_[n + 2];
        }
    }

    R rim_, radius_, gravity_;
    R time_ = 0;
    State state_;
    Series x_{}, y_{}, z_{};
};

}  // namespace osculo::support
