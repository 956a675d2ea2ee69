#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "osculo/motion/rim_path.hpp"

namespace osculo::motion {

/// Of a ball's rim, instead of its number.
inline constexpr std::uint32_t kOutsideOfRims = ~std::uint32_t(0);

/// The number of the rim that the place is in.
template <math::Scalar S>
[[nodiscard]] std::uint32_t rim_around(const std::vector<geometry::PullingRim<S>>& rims,
                                       const math::WidePoint<S>& position) {
    using Wide = math::Wide<S>;
    for (std::size_t k = 0; k < rims.size(); ++k) {
        const auto x = math::wide_difference<S>(position, rims[k].center);
        const Wide square = x.x * x.x + x.y * x.y;
        if (square < math::wide_product<S>(rims[k].radius, rims[k].radius)) {
            return static_cast<std::uint32_t>(k);
        }
    }
    return kOutsideOfRims;
}

/// A motion law, and rims that pull a ball whose centre is inside of them as in PHYSICS 1.4. There
/// the pull is all that acts: the ball stands on the edge, not on what the law is about, so energy
/// and spin are kept until it leaves.
///
/// [Base]: a law whose paths are parabolas.
template <class Base>
struct WithRims {
    static constexpr const char* kName = Base::kNameWithRims;
    static constexpr bool kTransitions = true;
    static constexpr bool kSpin = Base::kSpin;
    static constexpr bool kRims = true;

    /// Of State::rim, instead of the number of a rim.
    static constexpr std::uint32_t kOutside = kOutsideOfRims;
    static constexpr std::uint32_t kUnknown = kOutside - 1;  ///< begin() looks for it

    template <math::Scalar S>
    struct Parameters : Base::template Parameters<S> {
        std::vector<geometry::PullingRim<S>> rims;  ///< no two overlap
        S gravity{0};                               ///< [m/s^2], > 0 if there are rims
    };

    template <math::Scalar S>
    struct State : Base::template State<S> {
        S ball_radius{1};  ///< [m]
        std::uint32_t rim = kUnknown;
        bool fallen = false;  ///< into the rim
        bool lost = false;    ///< no number says what happens next
        S since{0};           ///< in the stay [s]
        std::shared_ptr<const RimPaperMotion<S>> stay{};
    };

    /// Sets what follows from place, velocity and the rim it is in. To be called whenever the
    /// velocity changes. Allocates in a rim.
    template <math::Scalar S>
    static void begin(const Parameters<S>& law, State<S>& state) {
        if (state.rim == kUnknown) state.rim = rim_around<S>(law.rims, state.position);
        state.stay = nullptr;
        state.since = S(0);
        if (state.rim == kOutside) {
            Base::template begin<S>(law, state);
            return;
        }
        state.stay = std::make_shared<const RimPaperMotion<S>>(
            law.rims[state.rim], law.gravity, state.ball_radius, state.position, state.velocity);
        state.half_acceleration = state.stay->at(S(0)).half_acceleration;
        state.remaining = state.stay->duration();
    }

    /// The ball has come to a rim.
    template <math::Scalar S>
    static void enter(State<S>& state, std::uint32_t rim) {
        state.rim = rim;
    }

    /// What happens after `remaining`.
    template <math::Scalar S>
    static void transition(const Parameters<S>& law, State<S>& state) {
        if (!state.stay) {
            Base::template transition<S>(law, state);
            return;
        }
        const RimOutcome outcome = state.stay->outcome();
        state.lost = !state.stay->sound() || outcome == RimOutcome::balanced;
        state.fallen = !state.lost && outcome == RimOutcome::capture;
        if (state.lost || state.fallen) {
            state.half_acceleration = {S(0), S(0)};
            state.remaining = math::never<S>();
            return;
        }
        if (outcome == RimOutcome::exit) state.rim = kOutside;
        begin(law, state);
    }

    template <math::Scalar S>
    [[nodiscard]] static RimPath<S> path(const State<S>& state) {
        return {Base::template path<S>(state), state.stay.get(), state.since};
    }

    /// Moves the state on by t [s], 0 <= t <= remaining.
    template <math::Scalar S>
    static void advance(State<S>& state, const S& t) {
        if (!state.stay) {
            Base::template advance<S>(state, t);
            return;
        }
        state.since += t;
        const ParabolicPath<S> now = state.stay->at(state.since);
        state.position = now.position;
        state.velocity = now.velocity;
        state.half_acceleration = now.half_acceleration;
        state.remaining -= t;
    }

    /// At least the length of the way that the state goes in t [s]; places in a rim are uncertain
    /// as if it had gone so far.
    template <math::Scalar S>
    [[nodiscard]] static S travel(const State<S>& state, const S& t) {
        if (!state.stay) return Base::template travel<S>(state, t);
        return t * state.stay->most_speed() + state.stay->rim().radius;
    }

    template <math::Scalar S>
    [[nodiscard]] static bool at_rest(const State<S>& state) {
        return !state.stay && Base::template at_rest<S>(state);
    }
};

}  // namespace osculo::motion
