#include "io/svg/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace osculo::io::svg {
namespace {

struct Curve {
    std::vector<Point> points;
    std::size_t segment = SIZE_MAX;  // or
    std::size_t arc = SIZE_MAX;
    bool used = false;
};

double distance(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

double signed_area(const std::vector<Point>& polygon) {
    double doubled = 0;
    Point last = polygon.back();
    for (const Point& point : polygon) {
        doubled += last.x * point.y - point.x * last.y;
        last = point;
    }
    return doubled / 2;
}

std::vector<Curve> curves_of(const Scene& scene) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        curves.push_back({.points = {scene.segments[i].from, scene.segments[i].to}, .segment = i});
    }
    for (std::size_t i = 0; i < scene.arcs.size(); ++i) {
        if (!is_full_circle(scene.arcs[i])) {
            curves.push_back({.points = points_along(scene.arcs[i]), .arc = i});
        }
    }
    return curves;
}

// The unused curve that starts (turned round if need be) nearest to the point.
Curve* nearest_curve(std::vector<Curve>& curves, Point end) {
    Curve* nearest = nullptr;
    bool turn = false;
    double least = INFINITY;
    for (Curve& curve : curves) {
        if (curve.used) continue;
        const double to_front = distance(end, curve.points.front());
        const double to_back = distance(end, curve.points.back());
        if (std::min(to_front, to_back) < least) {
            least = std::min(to_front, to_back);
            nearest = &curve;
            turn = to_back < to_front;
        }
    }
    if (turn) std::ranges::reverse(nearest->points);
    return nearest;
}

// How deep the cushions are: from the middle of each long segment straight back to the rectangle
// around the outline. The smaller side of that rectangle sets what is long.
double depth_of(const Scene& scene, const Outline& outline) {
    const double long_enough = 0.2 * std::min(outline.back.width(), outline.back.height());
    double depth = 0;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        const Segment& segment = scene.segments[i];
        if (!outline.has_segment[i] || distance(segment.from, segment.to) < long_enough) continue;
        const Point middle{(segment.from.x + segment.to.x) / 2,
                           (segment.from.y + segment.to.y) / 2};
        depth = std::max(depth,
                         std::min({middle.x - outline.back.left, outline.back.right - middle.x,
                                   middle.y - outline.back.bottom, outline.back.top - middle.y}));
    }
    return depth;
}

}  // namespace

bool is_full_circle(const Arc& arc) {
    return arc.to_angle - arc.from_angle > 2 * std::numbers::pi - 1e-12;
}

std::vector<Point> points_along(const Arc& arc) {
    constexpr double kStep = 0.05;  // [rad]
    const double angle = arc.to_angle - arc.from_angle;
    const int steps = std::max(2, static_cast<int>(std::ceil(angle / kStep)));
    std::vector<Point> points;
    for (int i = 0; i <= steps; ++i) {
        const double at = arc.from_angle + angle * i / steps;
        points.push_back(
            {arc.center.x + arc.radius * std::cos(at), arc.center.y + arc.radius * std::sin(at)});
    }
    return points;
}

Outline outline_of(const Scene& scene) {
    Outline outline;
    constexpr std::size_t kMostCurves = 2000;  // the search below is quadratic
    if (!scene.closed || scene.segments.size() + scene.arcs.size() > kMostCurves) return outline;
    std::vector<Curve> curves = curves_of(scene);
    if (curves.size() < 2) return outline;

    // From the longest on, always to the nearest one, until the start is nearer.
    const auto longest = std::ranges::max_element(curves, {}, [](const Curve& curve) {
        return distance(curve.points.front(), curve.points.back());
    });
    outline.has_segment.resize(scene.segments.size());
    outline.has_arc.resize(scene.arcs.size());
    const double joined = 1e-6 * distance(longest->points.front(), longest->points.back());
    const Point start = longest->points.front();
    for (Curve* curve = &*longest; curve != nullptr;) {
        curve->used = true;
        if (curve->segment != SIZE_MAX) outline.has_segment[curve->segment] = true;
        if (curve->arc != SIZE_MAX) outline.has_arc[curve->arc] = true;
        const bool joins =
            !outline.bed.empty() && distance(outline.bed.back(), curve->points.front()) <= joined;
        if (!joins) outline.cushions.emplace_back();
        std::vector<Point>& cushion = outline.cushions.back();
        cushion.insert(cushion.end(), curve->points.begin(), curve->points.end());
        outline.bed.insert(outline.bed.end(), curve->points.begin(), curve->points.end());

        const Point end = curve->points.back();
        Curve* const next = nearest_curve(curves, end);
        const bool at_start =
            next == nullptr || distance(end, start) <= distance(end, next->points.front());
        curve = at_start ? nullptr : next;
    }
    // The start was in the middle of a cushion, if the last one ends there.
    if (outline.cushions.size() > 1 && distance(outline.bed.back(), start) <= joined) {
        std::vector<Point>& last = outline.cushions.back();
        const std::vector<Point>& first = outline.cushions.front();
        last.insert(last.end(), first.begin(), first.end());
        outline.cushions.erase(outline.cushions.begin());
    }
    for (const Point& point : outline.bed) outline.back.add(point);
    if (!(std::abs(signed_area(outline.bed)) > 0)) return {};

    outline.depth = depth_of(scene, outline);
    Box rims;
    for (const Rim& rim : scene.rims) rims.add(rim.center, rim.radius);
    const double smaller_side = std::min(outline.back.width(), outline.back.height());
    if (!(outline.depth > 0.005 * smaller_side)) {  // the noses themselves are the rectangle
        outline.depth = 0.03 * smaller_side;
        outline.back.grow(outline.depth);
    }
    const double beyond_back = std::max(
        {outline.back.left - rims.left, rims.right - outline.back.right,
         outline.back.bottom - rims.bottom, rims.top - outline.back.top});  // -inf without rims
    outline.frame = outline.back;
    outline.frame.grow(std::max(1.2 * outline.depth, beyond_back + 0.3 * outline.depth));
    return outline;
}

}  // namespace osculo::io::svg
