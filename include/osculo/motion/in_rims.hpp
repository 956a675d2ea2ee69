#pragma once

#include <cstdint>
#include <type_traits>
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

/// What laws with rims share, whatever happens to a ball in them. Their states are those of [Base],
/// a law whose paths are parabolas, and have
///
///     state.rim     its number; kOutside or, before begin() has looked for it, kUnknown
///     state.stay    what happens there (a pointer), or none
///     state.since   in the stay [s]
///     state.follow()  takes place, velocity and acceleration from the stay
template <class Base>
struct InRims {
    static constexpr bool kTransitions = true;
    static constexpr bool kSpin = Base::kSpin;
    static constexpr bool kRims = true;

    static constexpr std::uint32_t kOutside = kOutsideOfRims;
    static constexpr std::uint32_t kUnknown = kOutside - 1;

    /// The ball has come to a rim.
    template <math::Scalar S, class State>
    static void enter(State& state, std::uint32_t rim) {
        state.rim = rim;
    }

    template <math::Scalar S, class State>
    [[nodiscard]] static auto path(const State& state) {
        using Stay = std::remove_cvref_t<decltype(*state.stay)>;
        return RimPath<S, Stay>{Base::template path<S>(state), state.stay.get(), state.since};
    }

    /// Moves the state on by t [s], 0 <= t <= remaining.
    template <math::Scalar S, class State>
    static void advance(State& state, const S& t) {
        if (!state.stay) {
            Base::template advance<S>(state, t);
            return;
        }
        state.since += t;
        state.follow();
        state.remaining -= t;
    }

    /// At least the length of the way that the state goes in t [s]; places in a rim are uncertain
    /// as if it had gone so far.
    template <math::Scalar S, class State>
    [[nodiscard]] static S travel(const State& state, const S& t) {
        if (!state.stay) return Base::template travel<S>(state, t);
        return t * state.stay->most_speed() + state.stay->rim().radius;
    }

    template <math::Scalar S, class State>
    [[nodiscard]] static bool at_rest(const State& state) {
        return !state.stay && Base::template at_rest<S>(state);
    }

protected:
    /// It has fallen, or no number says whether: nothing follows.
    template <math::Scalar S, class State>
    static void end(State& state) {
        state.half_acceleration = {S(0), S(0)};
        state.remaining = math::never<S>();
    }
};

}  // namespace osculo::motion
