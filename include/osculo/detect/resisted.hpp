#pragma once

#include <algorithm>

#include "osculo/detect/ball_arc.hpp"
#include "osculo/detect/ball_point.hpp"
#include "osculo/detect/ball_rim.hpp"
#include "osculo/detect/ball_segment.hpp"
#include "osculo/detect/certified_crossing.hpp"
#include "osculo/motion/relative_jerk.hpp"

/// First contacts of balls that slow down along straight lines. What does not move is met where a
/// ball in uniform motion would meet it, only later: the routine for straight paths gives sigma,
/// from which the time follows (NUMERICS 2.2). Two balls that both move, each in its own way, meet
/// on certified paths.
namespace osculo::detect {

namespace detail {

/// When the path has come to sigma, or never() if it does not before it ends.
template <math::Scalar S>
[[nodiscard]] S time_on(const motion::ResistedPath<S>& path, const S& sigma) {
    if (!(sigma < path.longest)) return math::never<S>();
    return path.slowing.time_of(sigma, path.end);
}

/// First contact with what does not move. Times are no less than sigma: a horizon serves for both.
template <math::Scalar S, class Obstacle>
[[nodiscard]] S first_contact_along(const motion::ResistedPath<S>& path, const S& radius,
                                    const Obstacle& obstacle,
                                    const math::ContactHistory<S>& history, const S& horizon) {
    const motion::LinearPath<S> line{path.position, path.velocity};
    return time_on<S>(path,
                      detect::first_contact<S>(line, radius, obstacle, history,
                                               std::min<S>(beyond<S>(horizon), path.longest)));
}

}  // namespace detail

/// First contact of a ball that slows down with a segment, an end point, an arc or a rim before it
/// rests, or never(). Error <= that of uniform motion and 2 math::kPathNoise epsilon of the time
/// over the share of its speed that the ball has left.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ResistedPath<S>& path, const S& radius,
                              const geometry::Segment<S>& segment,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return detail::first_contact_along<S>(path, radius, segment, history, horizon);
}
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ResistedPath<S>& path, const S& radius,
                              const geometry::Point<S>& point,
                              const math::ContactHistory<S>& history, const S& horizon) {
    return detail::first_contact_along<S>(path, radius, point, history, horizon);
}
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ResistedPath<S>& path, const S& radius,
                              const geometry::Arc<S>& arc, const math::ContactHistory<S>& history,
                              const S& horizon) {
    return detail::first_contact_along<S>(path, radius, arc, history, horizon);
}
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ResistedPath<S>& path, const S& radius,
                              const geometry::Rim<S>& rim, const math::ContactHistory<S>& history,
                              const S& horizon) {
    return detail::first_contact_along<S>(path, radius, rim, history, horizon);
}

/// First contact of two such balls until the first of them rests, or never(). If one of them stands
/// or both lose the same share of their speeds, their relative path is straight too.
template <math::Scalar S>
[[nodiscard]] S first_contact(const motion::ResistedPath<S>& first,
                              const motion::ResistedPath<S>& second, const S& reach,
                              const math::ContactHistory<S>& history, const S& horizon) {
    if (first.stands() || second.stands() || first.slowing == second.slowing) {
        const motion::ResistedPath<S>& path = second.stands() ? first : second;
        const S sigma =
            math::first_entry<S>(math::difference<S>(first.position, second.position),
                                 math::Vec<S>(first.velocity - second.velocity), reach, history,
                                 std::min<S>(beyond<S>(horizon), path.longest));
        return detail::time_on<S>(path, sigma);
    }
    using Motion = BetweenPaths<S, motion::ResistedPath<S>, motion::ResistedPath<S>>;
    return detail::first_certified_contact<S>(CircleCrossing<Motion>{{first, second}, reach, false},
                                              std::min<S>(first.end, second.end), history, horizon);
}

}  // namespace osculo::detect
