#pragma once

#include <vector>

#include "osculo/math/chebyshev.hpp"
#include "osculo/motion/rim_paper/course.hpp"

namespace osculo::motion {

/// Time and swept angle along a course, as series in the variables of its panels:
/// dt = dq / sqrt(F), dphi = L / d^2 dt (NUMERICS 3.2). Units as in field.hpp, sqrt(r / g) of time.
template <math::Scalar S>
class RimClock {
    using Series = math::ChebyshevSeries<S>;

public:
    /// Where the ball is at a time, and its motion.
    struct Hand {
        RimPlace<S> place;
        S tilt_rate;  ///< dq / dt
        S angle;      ///< swept since the start [rad]
    };

    RimClock(const RimCourse<S>& course, const S& moment)
        : panels_(course.panels), moment_(moment) {
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const RimPanel<S>& panel = panels_[i];
            if (panel.from != panel.to) add(i, panel.from, panel.to, 0);
        }
    }

    [[nodiscard]] S duration() const { return duration_; }
    /// The angle swept in all that time.
    [[nodiscard]] S swept() const { return swept_; }
    /// False if a series could not be made short enough.
    [[nodiscard]] bool sound() const { return sound_; }
    [[nodiscard]] std::size_t stretches() const { return stretches_.size(); }

    /// Requires 0 <= t <= duration() > 0.
    [[nodiscard]] Hand at(const S& t) const {
        const Stretch& stretch = stretch_at(t);
        const S x = when(stretch, S(t - stretch.from));
        const RimAlong<S> along = panels_[stretch.panel].at(S(stretch.middle + x * stretch.half));
        return {along.place, along.tilt_rate,
                S(stretch.angle_from + math::chebyshev_value<S>(stretch.angle, x))};
    }

private:
    /// Times of u = middle + x half, -1 <= x <= 1.
    struct Stretch {
        std::size_t panel;
        S middle, half;
        S from;        ///< time at x = -1
        S angle_from;  ///< and the angle
        Series time;   ///< since then
        Series angle;
    };

    void add(std::size_t index, const S& from, const S& to, int depth) {
        constexpr int kMostHalvings = 30;
        constexpr std::size_t kMostStretches = 1000;
        const RimPanel<S>& panel = panels_[index];
        const S middle = (from + to) / S(2);
        const S half = (to - from) / S(2);
        constexpr std::size_t kCount = math::kChebyshevTerms<S>;
        std::array<S, kCount> times;
        std::array<S, kCount> angles;
        for (std::size_t j = 0; j < kCount; ++j) {
            const S& x = math::ChebyshevNodes<S>::get().at(j);
            const RimAlong<S> along = panel.at(S(middle + x * half));
            times[j] = along.time_rate;
            angles[j] = along.time_rate * (moment_ / (along.place.d * along.place.d));
        }
        const Series time_rate = math::chebyshev_fit<S>(times);
        const Series angle_rate = math::chebyshev_fit<S>(angles);
        // u is rounded, which sinh u multiplies by u.
        const S noise = S(1) + std::max<S>(math::abs<S>(from), math::abs<S>(to));
        if (!math::chebyshev_resolved<S>(time_rate, noise) ||
            !math::chebyshev_resolved<S>(angle_rate, noise)) {
            if (depth < kMostHalvings && stretches_.size() < kMostStretches) {
                add(index, from, middle, depth + 1);
                add(index, middle, to, depth + 1);
                return;
            }
            sound_ = false;
        }
        const S size = math::abs<S>(half);
        stretches_.push_back({index, middle, half, duration_, swept_,
                              math::chebyshev_integral<S>(time_rate, size),
                              math::chebyshev_integral<S>(angle_rate, size)});
        duration_ += math::chebyshev_value<S>(stretches_.back().time, S(1));
        swept_ += math::chebyshev_value<S>(stretches_.back().angle, S(1));
    }

    [[nodiscard]] const Stretch& stretch_at(const S& t) const {
        std::size_t i = stretches_.size() - 1;
        while (i > 0 && t < stretches_[i].from) --i;
        return stretches_[i];
    }

    /// x at a time since the start of the stretch: Newton's iteration in a bracket, for the time
    /// grows with x.
    [[nodiscard]] static S when(const Stretch& stretch, const S& t) {
        S low(-1);
        S high(1);
        S last_step(2);
        S x(0);
        for (int i = 0; i < 2 * math::ScalarTraits<S>::kDigits; ++i) {
            const auto f = math::chebyshev_value_and_slope<S>(stretch.time, x);
            const S late = f.value - t;
            if (late == S(0)) return x;
            (late < S(0) ? low : high) = x;
            S next = x - late / f.slope;
            S step = math::abs<S>(S(next - x));
            if (!(next >= low && next <= high) || S(2) * step > last_step) {
                next = low + (high - low) / S(2);
                step = (high - low) / S(2);
            }
            last_step = step;
            x = next;
            if (step <= math::epsilon<S>()) break;
        }
        return x;
    }

    std::vector<RimPanel<S>> panels_;
    std::vector<Stretch> stretches_;
    S moment_;
    S duration_{0};
    S swept_{0};
    bool sound_ = true;
};

}  // namespace osculo::motion
