#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "osculo/scene.hpp"

/// Cushions for the contenders that are written out here: points on them nearest to a ball.
namespace osculo::bench {

struct Foot {
    double distance;  ///< from the centre of the ball; negative behind a one-sided segment
    double nx;        ///< unit vector from the cushion to the ball
    double ny;
};

struct Line {
    double x, y;    ///< one end
    double tx, ty;  ///< unit vector to the other end
    double length;
    double middle_x, middle_y;
    bool one_sided;

    explicit Line(const Segment& segment)
        : x(segment.from.x), y(segment.from.y), one_sided(segment.side == Side::left) {
        const double dx = segment.to.x - x;
        const double dy = segment.to.y - y;
        length = std::hypot(dx, dy);
        tx = dx / length;
        ty = dy / length;
        middle_x = x + dx / 2;
        middle_y = y + dy / 2;
    }

    /// False only if no point of it is within that distance.
    [[nodiscard]] bool near(double px, double py, double distance) const {
        const double half = length / 2;
        return std::abs(px - middle_x) <= distance + half * std::abs(tx) &&
               std::abs(py - middle_y) <= distance + half * std::abs(ty);
    }

    [[nodiscard]] Foot foot(double px, double py) const {
        const double along = (px - x) * tx + (py - y) * ty;
        if (along >= 0 && along <= length) {
            const double d = (py - y) * tx - (px - x) * ty;
            if (d >= 0 || one_sided) return {d, -ty, tx};
            return {-d, ty, -tx};
        }
        const double end = along < 0 ? 0 : length;
        const double dx = px - (x + end * tx);
        const double dy = py - (y + end * ty);
        const double d = std::sqrt(dx * dx + dy * dy);
        return {d, dx / d, dy / d};
    }
};

struct Curve {
    double x, y, radius;
    double from, sweep;  ///< [rad]

    explicit Curve(const Arc& arc)
        : x(arc.center.x),
          y(arc.center.y),
          radius(arc.radius),
          from(arc.from_angle),
          sweep(arc.to_angle - arc.from_angle) {}

    /// False only if no point of it is within that distance.
    [[nodiscard]] bool near(double px, double py, double distance) const {
        return std::abs(px - x) <= distance + radius && std::abs(py - y) <= distance + radius;
    }

    /// Whether a direction from the centre goes through the arc.
    [[nodiscard]] bool spans(double dx, double dy) const {
        constexpr double kTurn = 2 * std::numbers::pi;
        double angle = std::fmod(std::atan2(dy, dx) - from, kTurn);
        if (angle < 0) angle += kTurn;
        return angle <= sweep;
    }

    /// The ends of an arc are not looked at: on a table they are ends of segments too.
    [[nodiscard]] Foot foot(double px, double py) const {
        const double dx = px - x;
        const double dy = py - y;
        const double d = std::sqrt(dx * dx + dy * dy);
        if (!spans(dx, dy)) return {1e300, 0, 0};
        if (d >= radius) return {d - radius, dx / d, dy / d};
        return {radius - d, -dx / d, -dy / d};
    }
};

struct Outline {
    std::vector<Line> lines;
    std::vector<Curve> curves;

    explicit Outline(const Scene& scene)
        : lines(scene.segments.begin(), scene.segments.end()),
          curves(scene.arcs.begin(), scene.arcs.end()) {}
};

}  // namespace osculo::bench
