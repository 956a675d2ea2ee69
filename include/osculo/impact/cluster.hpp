#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "osculo/impact/friction.hpp"
#include "osculo/impact/spinning_ball.hpp"

/// Contacts of one instant that share balls, as the laws for simultaneous impacts take them.
namespace osculo::impact {

/// In place of a ball: something that does not move.
inline constexpr std::size_t kFixed = std::numeric_limits<std::size_t>::max();

/// A ball without spin.
template <math::Scalar S>
struct ClusterBall {
    S mass;                 ///< [kg]
    math::Vec<S> velocity;  ///< [m/s]
};

/// A contact without friction.
template <math::Scalar S>
struct ClusterContact {
    std::size_t one;      ///< index of a ball
    std::size_t other;    ///< index of another ball, or kFixed
    math::Vec<S> normal;  ///< from one to other, any length > 0
    S restitution;        ///< e in [0, 1]
    S impulse{0};         ///< result: normal impulse in the plane [kg m/s], >= 0
};

/// A contact with friction, whose normal may be tilted up by theta (the nose of a cushion).
template <math::Scalar S>
struct SpinningContact {
    std::size_t one;      ///< index of a ball
    std::size_t other;    ///< index of another ball, or kFixed
    math::Vec<S> normal;  ///< in the plane, from one to other, any length > 0
    S restitution;        ///< e in [0, 1], in space
    Friction<S> friction{};
    S tilt{0};     ///< sin theta; 0 between balls
    S impulse{0};  ///< result: normal impulse in the plane [kg m/s], >= 0
    /// Result: impulse of friction on the other one [kg m/s], along t = z x n and along the
    /// steepest way down, p = (sin theta n, -cos theta).
    math::Vec<S> friction_impulse{S(0), S(0)};
};

/// Balls of positive masses and their contacts. The owner keeps it from one event to the next, so
/// that its memory is reused.
template <class BallType, class ContactType>
struct BasicCluster {
    using Ball = BallType;
    using Contact = ContactType;

    std::vector<Ball> balls;
    std::vector<Contact> contacts;

    void clear() {
        balls.clear();
        contacts.clear();
    }
};

template <math::Scalar S>
using Cluster = BasicCluster<ClusterBall<S>, ClusterContact<S>>;
template <math::Scalar S>
using SpinningCluster = BasicCluster<SpinningBall<S>, SpinningContact<S>>;

}  // namespace osculo::impact
