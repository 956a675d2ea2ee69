#pragma once

#include "osculo/detect/certified_crossing.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/rim.hpp"

namespace osculo::detect {

/// First contact of a ball on a certified path with a point before the path ends, |x - p| = r while
/// approaching, or never(). See first_certified().
template <math::Scalar S, class Path>
requires motion::CertifiedPath<Path, S>
[[nodiscard]] S first_contact(const Path& path, const S& radius, const geometry::Point<S>& point,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const CircleCrossing<FromPoint<S, Path>> crossing{{path, point.at}, radius, false};
    return detail::first_certified_contact<S>(crossing, S(path.end), history, horizon);
}

/// When the centre of a ball on a certified path enters the rim's circle, or never().
template <math::Scalar S, class Path>
requires motion::CertifiedPath<Path, S>
[[nodiscard]] S first_contact(const Path& path, const S& /*radius*/, const geometry::Rim<S>& rim,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const CircleCrossing<FromPoint<S, Path>> crossing{{path, rim.center}, rim.radius, false};
    return detail::first_certified_contact<S>(crossing, S(path.end), history, horizon);
}

}  // namespace osculo::detect
