#pragma once

#include <optional>
#include <vector>

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Proves that balls are shut in.
///
/// Obstacles and rims are nodes of a graph; two are joined if the way between them is too narrow
/// for a ball of the given radius (a rim lets no centre pass). A closed chain of joined nodes that
/// winds round a ball keeps it in: wherever it left, it would overlap an obstacle or be captured.
/// Distances between obstacles are never underestimated, so what is called closed is closed; but
/// one-sided segments count as walls from both sides.
class Outline {
public:
    /// [radius]: of the smallest ball to be kept in [m].
    Outline(const Scene& scene, double radius);

    /// Whether a closed chain winds round a ball with its centre at p. O(nodes + joints) for the
    /// first ball in each chamber, O(nodes) for the others.
    [[nodiscard]] bool encloses(const Point& p);

private:
    struct Shape {
        enum class Kind { segment, arc, disk } kind;
        Point a, b;  ///< segment: its ends; else a is the centre
        double radius = 0;
        double from_angle = 0, to_angle = 0;
        double reach = 0;  ///< how far it keeps a ball's centre away [m]
        [[nodiscard]] Point nearest(const Point& p) const;
        [[nodiscard]] Point anchor() const;
        /// A circle around the whole shape.
        [[nodiscard]] Point middle() const;
        [[nodiscard]] double extent() const;
        /// Appends the way along the shape from one of its points to another.
        void append_way(const Point& from, const Point& to, double step,
                        std::vector<Point>& way) const;
    };
    struct Joint {
        std::size_t one, other;
        std::vector<Point> way;  ///< from one's anchor to the other's
    };

    void join(std::size_t i, std::size_t j);
    [[nodiscard]] std::optional<std::vector<Point>> find_chain(const Point& p) const;

    double radius_;
    std::vector<Shape> shapes_;
    std::vector<Joint> joints_;
    std::vector<std::vector<Point>> chains_;  ///< closed polygons found so far
};

}  // namespace osculo::facade
