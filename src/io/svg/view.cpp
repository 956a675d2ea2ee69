#include "io/svg/view.hpp"

#include <algorithm>
#include <cmath>

namespace osculo::io::svg {

void Box::add(Point point, double radius) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(radius)) return;
    left = std::min(left, point.x - radius);
    right = std::max(right, point.x + radius);
    bottom = std::min(bottom, point.y - radius);
    top = std::max(top, point.y + radius);
}

void Box::grow(double margin) {
    left -= margin;
    right += margin;
    bottom -= margin;
    top += margin;
}

Box Box::within(const Box& other) const {
    return {std::max(left, other.left), std::max(bottom, other.bottom),
            std::min(right, other.right), std::min(top, other.top)};
}

void Box::thicken() {
    constexpr double kThinnest = 0.2;
    const double least = kThinnest * std::max(width(), height());
    const double up = std::max(0.0, (least - height()) / 2);
    const double aside = std::max(0.0, (least - width()) / 2);
    bottom -= up;
    top += up;
    left -= aside;
    right += aside;
}

View::View(const Box& box, Point frame_corner, double frame_width, double frame_height)
    : corner(frame_corner), width(frame_width), height(frame_height) {
    center_ = {box.left / 2 + box.right / 2, box.bottom / 2 + box.top / 2};
    origin_ = {corner.x + width / 2, corner.y + height / 2};
    scale_ = std::min(width / box.width(), height / box.height());
    if (!std::isfinite(scale_) || !(scale_ > 0)) scale_ = 1;
}

std::optional<std::pair<Point, Point>> View::visible(Point from, Point to) const {
    // The stretch [enter, leave] of from + t (to - from) that is between each pair of sides.
    double enter = 0;
    double leave = 1;
    const auto cut = [&](double start, double change, double low, double high) {
        if (change == 0) return start >= low && start <= high;
        const double a = (low - start) / change;
        const double b = (high - start) / change;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
        return enter <= leave;
    };
    const Point change{to.x - from.x, to.y - from.y};
    if (!std::isfinite(change.x) || !std::isfinite(change.y)) return std::nullopt;
    if (!cut(from.x, change.x, corner.x, corner.x + width)) return std::nullopt;
    if (!cut(from.y, change.y, corner.y, corner.y + height)) return std::nullopt;
    const auto at = [&](double t) { return Point{from.x + t * change.x, from.y + t * change.y}; };
    return std::pair{enter > 0 ? at(enter) : from, leave < 1 ? at(leave) : to};
}

bool View::shows(Point pixel) const {
    return pixel.x >= corner.x && pixel.x <= corner.x + width && pixel.y >= corner.y &&
           pixel.y <= corner.y + height;
}

Box extent(const Scene& scene, const Run* run) {
    Box fixed;
    for (const Segment& segment : scene.segments) {
        fixed.add(segment.from);
        fixed.add(segment.to);
    }
    for (const Arc& arc : scene.arcs) fixed.add(arc.center, arc.radius);
    for (const Rim& rim : scene.rims) fixed.add(rim.center, rim.radius);
    for (const Ball& ball : scene.balls) fixed.add(ball.position, ball.radius);
    if (fixed.is_empty()) fixed.add({0, 0}, 1);

    Box all = fixed;
    if (run != nullptr) {
        for (std::size_t i = 0; i < run->balls.size(); ++i) {
            all.add(run->balls[i].state.position, scene.balls[i].radius);
        }
        for (const Piece& piece : run->pieces) {
            all.add(piece.position, scene.balls[piece.ball].radius);
        }
        // Balls that fly off must not shrink everything else to a dot.
        Box near = fixed;
        near.grow(0.75 * std::max(fixed.width(), fixed.height()));
        all = all.within(near);
    }
    // Where coordinates are so large that their rounding shows, the picture is of that size.
    const double rounding = 1e-13 * std::max({std::abs(all.left), std::abs(all.right),
                                              std::abs(all.bottom), std::abs(all.top)});
    all.grow(0.02 * std::max(all.width(), all.height()) + rounding);
    return all;
}

}  // namespace osculo::io::svg
