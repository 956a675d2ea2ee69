#pragma once

#include "osculo/detect/ball_arc_certified.hpp"
#include "osculo/detect/ball_arc_parabolic.hpp"
#include "osculo/detect/ball_ball.hpp"
#include "osculo/detect/ball_ball_certified.hpp"
#include "osculo/detect/ball_point.hpp"
#include "osculo/detect/ball_point_certified.hpp"
#include "osculo/detect/ball_rim.hpp"
#include "osculo/detect/ball_segment_certified.hpp"
#include "osculo/detect/ball_segment_parabolic.hpp"
#include "osculo/detect/certainly_apart.hpp"
#include "osculo/motion/rim_path.hpp"

/// First contacts of balls that may be in a rim: of parabolas as ever, with a stay in a rim by
/// certified segments.
namespace osculo::detect {

/// Two balls.
template <math::Scalar S, class Stay>
[[nodiscard]] S first_contact(const motion::RimPath<S, Stay>& first,
                              const motion::RimPath<S, Stay>& second, const S& reach,
                              const math::ContactHistory<S>& history, const S& horizon) {
    if (first.stay == nullptr && second.stay == nullptr) {
        return first_contact<S>(first.outside, second.outside, reach, history, horizon);
    }
    if (first.stay == nullptr) {
        return first_contact<S>(motion::QuadraticPath<S>{first.outside}, second.inside(), reach,
                                history, horizon);
    }
    if (second.stay == nullptr) {
        return first_contact<S>(first.inside(), motion::QuadraticPath<S>{second.outside}, reach,
                                history, horizon);
    }
    return first_contact<S>(first.inside(), second.inside(), reach, history, horizon);
}

/// A ball and an obstacle.
template <math::Scalar S, class Stay, class Obstacle>
[[nodiscard]] S first_contact(const motion::RimPath<S, Stay>& path, const S& radius,
                              const Obstacle& obstacle, const math::ContactHistory<S>& history,
                              const S& horizon) {
    if (path.stay == nullptr) {
        return first_contact<S>(path.outside, radius, obstacle, history, horizon);
    }
    return first_contact<S>(path.inside(), radius, obstacle, history, horizon);
}

/// When the centre of a ball enters a rim that pulls, or never(). Such rims do not overlap: a ball
/// in one has to leave it first.
template <math::Scalar S, class Stay>
[[nodiscard]] S first_contact(const motion::RimPath<S, Stay>& path, const S& radius,
                              const geometry::PullingRim<S>& rim,
                              const math::ContactHistory<S>& history, const S& horizon) {
    if (path.stay != nullptr) return math::never<S>();
    return first_contact<S>(path.outside, radius, static_cast<const geometry::Rim<S>&>(rim),
                            history, horizon);
}

/// True only if first_contact() would find nothing before [horizon].
template <math::Scalar S, class Stay>
[[nodiscard]] bool certainly_apart(const motion::RimPath<S, Stay>& first, const S& first_shift,
                                   const motion::RimPath<S, Stay>& second, const S& second_shift,
                                   const S& reach, const S& horizon) {
    return first.stay == nullptr && second.stay == nullptr &&
           certainly_apart<S>(first.outside, first_shift, second.outside, second_shift, reach,
                              horizon);
}
template <math::Scalar S, class Stay, class Obstacle>
[[nodiscard]] bool certainly_apart(const motion::RimPath<S, Stay>& path, const S& radius,
                                   const Obstacle& obstacle, const S& horizon) {
    return path.stay == nullptr && certainly_apart<S>(path.outside, radius, obstacle, horizon);
}

}  // namespace osculo::detect
