#pragma once

#include "osculo/impact/mathavan/choose_modes.hpp"
#include "osculo/impact/mathavan/stiff_step.hpp"

namespace osculo::impact::mathavan {

/// An impact in progress, in units of the approach at its beginning and the ball's mass.
template <math::Scalar S>
struct Impact {
    math::Vec<S> slip_at_cushion;
    math::Vec<S> slip_at_cloth;
    S approach{1};
    math::Vec<S> at_cushion{S(0), S(0)};  ///< impulse of friction, so far, along p and t
    math::Vec<S> at_cloth{S(0), S(0)};    ///< along n and t
    int steps = 0;
};

/// Steps an impact may take. Most take 10 to 100; of 43,000 random ones with frictions up to 0.6
/// six took more than 300, none 500.
inline constexpr int kMostSteps = 4000;

/// Error of a stiff step, for every scalar type: few impacts have any, and few of those many.
inline constexpr double kStiffError = 0x1p-43;

/// After this many steps without an attempt at a stiff one the wait grows no more.
inline constexpr int kMostWait = 15;

/// Slips below this many epsilon of max(1, their first size) and on the decrease are none.
inline constexpr int kNoSlip = 8;

/// Carries an impact through compression and restitution, until the work the cushion gives back is
/// e^2 times what it took.
///
/// Each step ends where a slip vanishes, a held contact breaks loose, the cloth starts or ceases to
/// bear the ball, or a phase of the impact ends, whichever is first; the polynomials are bisected
/// for it. If friction jams the ball, so that its approach no longer decreases (which takes
/// c <= s mu + mu' (s + c mu)), the impact is over and what is left of the approach is lost. Were
/// kMostSteps not enough, the rest would be without friction.
template <math::Scalar S>
class Integration {
    using Vec = math::Vec<S>;

public:
    Integration(const Constants<S>& constants, const S& e, Impact<S>& state)
        : k_(constants), e_(e), state_(state) {
        cushion_.none_below = none_below(state.slip_at_cushion);
        cloth_.none_below = none_below(state.slip_at_cloth);
    }

    void run() {
        cushion_.zero = math::norm<S>(state_.slip_at_cushion) <= cushion_.none_below;
        cloth_.zero = math::norm<S>(state_.slip_at_cloth) <= cloth_.none_below;
        while (state_.steps < kMostSteps) {
            ++state_.steps;
            if (!advance()) return;
        }
        finish_without_friction();
    }

private:
    struct Contact {
        bool zero = false;
        S none_below;
    };

    static S none_below(const Vec& slip) {
        const S size = math::norm<S>(slip);
        return S(kNoSlip) * math::epsilon<S>() * (size > S(1) ? size : S(1));
    }

    /// Shortens [length] to where [holds] first fails.
    template <class Condition>
    static bool shorten(S& length, const Condition& holds) {
        S low(0);
        S high = length * S(0.5);
        if (holds(high)) {
            low = high;
            high = length;
            if (holds(high)) return false;
        }
        for (int i = 0; i < math::ScalarTraits<S>::kDigits + 4; ++i) {
            const S middle = (low + high) * S(0.5);
            (holds(middle) ? low : high) = middle;
        }
        length = high;
        return true;
    }

    static S integral(const Series<S>& a, const S& p) {
        S sum(0);
        for (std::size_t i = kOrder<S> + 1; i-- > 0;) {
            sum = sum * p + a[i] / S(static_cast<double>(i + 1));
        }
        return sum * p;
    }

    /// One step; false if it ends the impact.
    bool advance() {
        Step<S> step{k_};
        if (!cushion_.zero) step.cushion.set_slip(0, state_.slip_at_cushion);
        if (!cloth_.zero) step.cloth.set_slip(0, state_.slip_at_cloth);
        step.approach[0] = state_.approach;
        choose_modes<S>(step, cushion_.zero, cloth_.zero);
        // At the crossing itself the sign is noise: what the last step ended with counts.
        if (toggled_ && !cushion_.zero && !cloth_.zero) step.at_cloth = next_at_cloth_;
        toggled_ = false;
        step.build();
        if (!(step.approach[1] < S(0))) return jam();
        if (step.at_cushion == Mode::leaving || step.at_cloth == Mode::leaving) longest_ = S(4);
        S length = step.length(longest_ / step.unit);  // in the step's unit, as all of its series
        if (is_stiff(step, length) && advance_stiffly(step, S(length * step.unit))) return true;
        stiff_length_ = S(0);
        longest_ = S(8) * length * step.unit;

        const bool phase_ends = shorten(length, [&](const S& p) {
            return restitution_ ? target_ + k_.c * step.unit * integral(step.approach, p) > S(0)
                                : value<S>(step.approach, p) > S(0);
        });
        bool earlier = false;
        for (const auto* series : {&step.cushion, &step.cloth}) {
            const Mode mode = series == &step.cushion ? step.at_cushion : step.at_cloth;
            if (mode != Mode::slipping) continue;
            const Vec d = series->direction(0);
            earlier |= shorten(
                length, [&](const S& p) { return math::dot<S>(d, slip(*series, p)) > S(0); });
        }
        const S margin = S(1) + hold_margin<S>();
        const S margin_squared = margin * margin;
        if (step.at_cushion == Mode::sticking) {
            const S limit = k_.cushion_friction * k_.cushion_friction * margin_squared;
            earlier |= shorten(length, [&](const S& p) { return square(step.f, p) <= limit; });
        }
        if (step.at_cloth == Mode::sticking) {
            const S limit = k_.cloth_friction * k_.cloth_friction * margin_squared;
            earlier |= shorten(length, [&](const S& p) {
                const S q = value<S>(step.press, p);
                return square(step.g, p) <= limit * q * q;
            });
        }
        const bool lifted = step.at_cloth == Mode::lifted;
        if (shorten(length, [&](const S& p) {
                const S q = value<S>(step.press, p);
                return lifted ? q <= S(0) : q >= S(0);
            })) {
            earlier = true;
            toggled_ = true;
            next_at_cloth_ = lifted ? Mode::slipping : Mode::lifted;
        }
        const bool jams = shorten(length, [&](const S& p) {
            return k_.approach_rate(value<S>(step.f[0], p), value<S>(step.g[0], p)) < S(0);
        });
        take(step, length);
        if (jams) return jam();
        return !phase_ends || earlier || next_phase();
    }

    /// Whether a slip keeps the step short although it changes far more slowly itself.
    static bool is_stiff(const Step<S>& step, const S& length) {
        const auto slow = [&](Mode mode, const SlipSeries<S>& series) {
            return mode == Mode::slipping && series.n[0] < S(20) * length * step.unit &&
                   S(10) * length * math::norm<S>(series.slip(1)) < series.n[0];
        };
        if (step.at_cushion == Mode::leaving || step.at_cushion == Mode::straight ||
            step.at_cloth == Mode::leaving || step.at_cloth == Mode::straight) {
            return false;
        }
        return slow(step.at_cushion, step.cushion) || slow(step.at_cloth, step.cloth);
    }

    /// A stiff step well beyond [length], if there is one without event.
    bool advance_stiffly(const Step<S>& step, const S& length) {
        if (stiff_wait_ > 0) {
            --stiff_wait_;
            return false;
        }
        const StiffStep<S> stiff(k_, step.at_cushion, step.at_cloth);
        Motion<S> start;
        start.set_pair(Motion<S>::kCushionSlip, step.cushion.slip(0));
        start.set_pair(Motion<S>::kClothSlip, step.cloth.slip(0));
        start.approach() = state_.approach;
        const S bound(kStiffError);
        S tried = S(32) * length;
        if (tried < S(2) * stiff_length_) tried = S(2) * stiff_length_;
        for (int i = 0; i < 2 && tried > S(4) * length; ++i, tried *= S(0.375)) {
            Motion<S> end = start;
            if (!(stiff.advance(end, tried) <= bound) || has_event(step, stiff, start, end))
                continue;
            stiff_length_ = tried;
            stiff_failures_ = 0;
            longest_ = tried;
            target_ += end.work();
            state_.approach = end.approach();
            state_.slip_at_cushion = end.pair(Motion<S>::kCushionSlip);
            state_.slip_at_cloth = end.pair(Motion<S>::kClothSlip);
            state_.at_cushion += end.pair(Motion<S>::kF);
            state_.at_cloth += end.pair(Motion<S>::kG);
            cushion_.zero = step.at_cushion == Mode::sticking;
            cloth_.zero = step.at_cloth == Mode::sticking;
            return true;
        }
        // Most that look stiff are not, and trying costs as much as ten other steps.
        if (stiff_failures_ < kMostWait) stiff_failures_ = 2 * stiff_failures_ + 1;
        stiff_wait_ = stiff_failures_;
        return false;
    }

    [[nodiscard]] bool has_event(const Step<S>& step, const StiffStep<S>& stiff,
                                 const Motion<S>& start, const Motion<S>& end) const {
        if (!((restitution_ ? S(target_ + end.work()) : end.approach()) > S(0))) return true;
        const auto friction =
            stiff.friction(end.pair(Motion<S>::kCushionSlip), end.pair(Motion<S>::kClothSlip));
        const S press = k_.press(friction.f.x());
        if ((press > S(0)) == (step.at_cloth == Mode::lifted)) return true;
        if (!(k_.approach_rate(friction.f.x(), friction.g.x()) < S(0))) return true;
        const auto stays = [&](Mode mode, int part, const Vec& force, const S& limit) {
            if (mode == Mode::sticking) return math::norm<S>(force) <= limit;
            return mode == Mode::lifted || math::dot<S>(start.pair(part), end.pair(part)) > S(0);
        };
        return !stays(step.at_cushion, Motion<S>::kCushionSlip, friction.f, k_.cushion_friction) ||
               !stays(step.at_cloth, Motion<S>::kClothSlip, friction.g, k_.cloth_friction * press);
    }

    static Vec slip(const SlipSeries<S>& series, const S& p) {
        return {value<S>(series.u[0], p), value<S>(series.u[1], p)};
    }
    static S square(const Series<S> (&f)[2], const S& p) {
        const S x = value<S>(f[0], p);
        const S y = value<S>(f[1], p);
        return x * x + y * y;
    }

    void take(const Step<S>& step, const S& length) {
        const S work = k_.c * step.unit * integral(step.approach, length);
        target_ += work;  // in the compression, the work so far
        state_.approach = value<S>(step.approach, length);
        state_.at_cushion +=
            step.unit * Vec(integral(step.f[0], length), integral(step.f[1], length));
        state_.at_cloth +=
            step.unit * Vec(integral(step.g[0], length), integral(step.g[1], length));
        move(cushion_, state_.slip_at_cushion, step.cushion, step.at_cushion, length);
        move(cloth_, state_.slip_at_cloth, step.cloth, step.at_cloth, length);
    }
    static void move(Contact& contact, Vec& state, const SlipSeries<S>& series, Mode mode,
                     const S& length) {
        contact.zero = mode == Mode::sticking;
        state = slip(series, length);
        if (contact.zero || !(math::norm<S>(state) <= contact.none_below)) return;
        const Vec before = series.slip(0);
        contact.zero = math::dot<S>(before, before) > math::dot<S>(state, state) ||
                       (state.x() == S(0) && state.y() == S(0));
    }

    bool jam() {
        if (!restitution_) state_.approach = S(0);
        return false;
    }

    /// False if the impact is over.
    bool next_phase() {
        if (restitution_) return false;
        restitution_ = true;
        state_.approach = S(0);
        target_ *= e_ * e_;
        return target_ > S(0);
    }

    void finish_without_friction() {
        if (!restitution_) {
            target_ = (target_ + state_.approach * state_.approach / S(2)) * e_ * e_;
            state_.approach = S(0);
        }
        state_.approach = -math::square_root<S>(state_.approach * state_.approach + S(2) * target_);
    }

    const Constants<S>& k_;
    const S& e_;
    Impact<S>& state_;
    Contact cushion_{};
    Contact cloth_{};
    bool restitution_ = false;
    bool toggled_ = false;
    Mode next_at_cloth_ = Mode::slipping;
    S target_{0};  ///< work taken in the compression, then what is still to be given back
    S longest_{4};
    S stiff_length_{0};
    int stiff_failures_ = 0;  ///< in a row: 2^n - 1 for n of them
    int stiff_wait_ = 0;      ///< steps until the next attempt
};

}  // namespace osculo::impact::mathavan
