#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "osculo/motion/in_rims.hpp"

namespace osculo::motion {

/// A motion law, and rims that pull a ball whose centre is inside of them as in PHYSICS 1.4. There
/// the pull is all that acts: the ball stands on the edge, not on what the law is about, so energy
/// and spin are kept until it leaves.
///
/// [Base]: a law whose paths are parabolas.
template <class Base>
struct WithRims : InRims<Base> {
    static constexpr const char* kName = Base::kNameWithRims;
    using InRims<Base>::kOutside;
    using InRims<Base>::kUnknown;

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

        void follow() {
            const ParabolicPath<S> now = stay->at(since);
            this->position = now.position;
            this->velocity = now.velocity;
            this->half_acceleration = now.half_acceleration;
        }
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
            InRims<Base>::template end<S>(state);
            return;
        }
        if (outcome == RimOutcome::exit) state.rim = kOutside;
        begin(law, state);
    }
};

}  // namespace osculo::motion
