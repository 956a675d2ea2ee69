#pragma once

#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/segment.hpp"

/// Whether a ball touches an obstacle where it is: its boundary is within [tolerance] of it, or
/// overlaps it by rounding.
namespace osculo::detect {

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Point<S>& point, const S& tolerance) {
    return math::norm<S>(math::difference<S>(position, point.at)) <= radius + tolerance;
}

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Segment<S>& segment, const S& tolerance) {
    const math::Vec<S> c = math::difference<S>(position, segment.from);
    const S distance = math::dot<S>(c, segment.normal);
    const S foot = math::dot<S>(c, segment.tangent);
    return foot >= S(0) && foot <= segment.length && math::abs<S>(distance) <= radius + tolerance &&
           (!segment.one_sided || distance >= S(0));
}

template <math::Scalar S>
[[nodiscard]] bool touches(const math::WidePoint<S>& position, const S& radius,
                           const geometry::Arc<S>& arc, const S& tolerance) {
    const math::Vec<S> c = math::difference<S>(position, arc.center);
    return math::abs<S>(math::norm<S>(c) - arc.radius) <= radius + tolerance && arc.covers(c);
}

}  // namespace osculo::detect
