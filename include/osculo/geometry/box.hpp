#pragma once

#include <algorithm>

#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/rim.hpp"
#include "osculo/geometry/segment.hpp"
#include "osculo/math/error_bounds.hpp"

namespace osculo::geometry {

/// A rectangle along the axes [m]; sides may be infinite. A side that is not a number is never
/// beyond another: what is not known is not ruled out.
template <math::Scalar S>
struct Box {
    S low_x, high_x, low_y, high_y;

    [[nodiscard]] static Box everything() {
        return {-math::never<S>(), math::never<S>(), -math::never<S>(), math::never<S>()};
    }
    /// The smallest box around two points.
    [[nodiscard]] static Box around(const math::Vec<S>& a, const math::Vec<S>& b) {
        return {std::min<S>(a.x(), b.x()), std::max<S>(a.x(), b.x()), std::min<S>(a.y(), b.y()),
                std::max<S>(a.y(), b.y())};
    }
    [[nodiscard]] Box grown(const S& by) const {
        return {S(low_x - by), S(high_x + by), S(low_y - by), S(high_y + by)};
    }
    [[nodiscard]] bool apart(const Box& other) const {
        return low_x > other.high_x || other.low_x > high_x || low_y > other.high_y ||
               other.low_y > high_y;
    }
    [[nodiscard]] bool encloses(const Box& other) const {
        return low_x < other.low_x && other.high_x < high_x && low_y < other.low_y &&
               other.high_y < high_y;
    }
    [[nodiscard]] bool encloses(const math::Vec<S>& p) const {
        return low_x < p.x() && p.x() < high_x && low_y < p.y() && p.y() < high_y;
    }
};

/// A box around everything of an obstacle, on the safe side of rounding.
template <math::Scalar S>
[[nodiscard]] Box<S> bounding_box(const Point<S>& point) {
    return Box<S>::around(point.at, point.at);
}
template <math::Scalar S>
[[nodiscard]] Box<S> bounding_box(const Segment<S>& segment) {
    const S blur = S(math::kRejectionSlack) * math::epsilon<S>() *
                   (math::norm1<S>(segment.from) + segment.length);
    return Box<S>::around(segment.from, segment.from + segment.length * segment.tangent)
        .grown(blur);
}
template <math::Scalar S>
[[nodiscard]] Box<S> bounding_box(const Rim<S>& rim) {
    const S blur =
        S(math::kRejectionSlack) * math::epsilon<S>() * (math::norm1<S>(rim.center) + rim.radius);
    return Box<S>::around(rim.center, rim.center).grown(S(rim.radius + blur));
}
template <math::Scalar S>
[[nodiscard]] Box<S> bounding_box(const Arc<S>& arc) {
    return bounding_box(Rim<S>{arc.center, arc.radius});  // its whole circle
}

}  // namespace osculo::geometry
