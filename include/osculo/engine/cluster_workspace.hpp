#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "osculo/engine/event.hpp"
#include "osculo/impact/symmetric.hpp"
#include "osculo/math/error_bounds.hpp"

namespace osculo::engine {

/// A contact by what takes part: a ball, and a ball or the index of an obstacle of that kind.
struct ContactId {
    Kind kind;
    BallIndex first;
    std::uint32_t second;
};

/// Largest gap [m] of what has been resolved together, and so counts as touching from then on: the
/// tolerances of two balls (Engine::add_member), the other one at most [reach] from this [place],
/// and both where they come from.
template <math::Scalar S>
[[nodiscard]] S together_gap(const S& place, const S& reach) {
    return S(4 * math::kTogether) * math::epsilon<S>() * (place + reach);
}

/// What an engine keeps to resolve contacts of one instant together; nothing if it does not.
template <class Type, bool = Type::Simultaneous::kGathersCluster>
struct ClusterWorkspace {};
template <class Type>
struct ClusterWorkspace<Type, true> {
    using S = typename Type::Scalar;
    using Law =
        std::conditional_t<Type::Motion::kSpin, impact::SpinningCluster<S>, impact::Cluster<S>>;

    struct Member {
        BallIndex ball;
        typename Type::State state;  ///< now
        typename Type::State after;  ///< what the law makes of it, to see what presses
        S tolerance;                 ///< how well its place is known [m]
        std::uint32_t impacts = 0;   ///< contacts that act on it
        std::uint32_t recorded = 0;  ///< of these
    };

    struct Found : ContactId {
        math::Vec<S> normal;  ///< from the first one towards the other, any length
    };

    std::vector<Member> members;
    std::vector<Found> contacts;
    Law law;               ///< the same, in the same order
    std::vector<S> least;  ///< speeds at which they have to part
    impact::SymmetricSolver<S> solver;
    std::uint32_t number = 0;   ///< of clusters recorded so far
    std::uint64_t settled = 0;  ///< impacts so far that were too slow to bounce
    bool endless = false;       ///< the last one had more reflections than can be followed
};

}  // namespace osculo::engine
