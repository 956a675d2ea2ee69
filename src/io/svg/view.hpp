#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "osculo/run.hpp"

namespace osculo::io::svg {

/// A rectangle [m], empty until something is added.
struct Box {
    double left = std::numeric_limits<double>::infinity();
    double bottom = std::numeric_limits<double>::infinity();
    double right = -std::numeric_limits<double>::infinity();
    double top = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool is_empty() const { return !(left <= right && bottom <= top); }
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return top - bottom; }
    /// Adds what lies within `radius` of the point, if that is finite.
    void add(Point point, double radius = 0);
    void grow(double margin);
    [[nodiscard]] Box within(const Box& other) const;
    /// Grows until no side is less than a fifth of the other.
    void thicken();
};

/// From metres, y up, to pixels, y down.
class View {
public:
    /// The box, in the middle of a frame of that size whose corner at the top left is at `corner`.
    View(const Box& box, Point corner, double width, double height);

    [[nodiscard]] Point operator()(Point point) const {
        return {origin_.x + (point.x - center_.x) * scale_,
                origin_.y - (point.y - center_.y) * scale_};
    }
    [[nodiscard]] double length(double metres) const { return metres * scale_; }
    [[nodiscard]] double metres(double pixels) const { return pixels / scale_; }
    [[nodiscard]] double scale() const { return scale_; }   ///< [px/m]
    [[nodiscard]] Point center() const { return center_; }  ///< [m], shown at origin()
    [[nodiscard]] Point origin() const { return origin_; }  ///< [px]

    /// The part of a straight line in pixels that is inside the frame.
    [[nodiscard]] std::optional<std::pair<Point, Point>> visible(Point from, Point to) const;
    [[nodiscard]] bool shows(Point pixel) const;

    Point corner;   ///< of the frame [px]
    double width;   ///< [px]
    double height;  ///< [px]

private:
    Point center_;  // [m], shown at origin_
    Point origin_;  // [px]
    double scale_;  // [px/m]
};

/// What the picture must show [m]: cushions, rims, balls and, as far as they stay near, paths.
[[nodiscard]] Box extent(const Scene& scene, const Run* run);

}  // namespace osculo::io::svg
