#pragma once

#include <span>
#include <string>
#include <string_view>

#include "osculo/scene.hpp"

namespace osculo::io::svg {

/// SVG being written. Places and lengths are in pixels, x to the right, y down; numbers are rounded
/// to 0.01 px. `style` is a list of attributes as in SVG.
class Canvas {
public:
    /// Drawn in width x height, shown `scale` times as large.
    Canvas(double width, double height, double scale, std::string_view title);

    void circle(Point center, double radius, std::string_view style);
    void line(Point from, Point to, std::string_view style);
    void polyline(std::span<const Point> points, std::string_view style);
    void polygon(std::span<const Point> points, std::string_view style);
    void rectangle(Point corner, double width, double height, std::string_view style);
    /// `at` is on the base line. Characters that XML cannot hold are replaced.
    void text(Point at, double size, std::string_view content, std::string_view style);

    void raw(std::string_view text) { text_ += text; }
    void number(double value);
    /// "M x y L x y ..." for use in `raw`.
    void path_data(std::span<const Point> points);

    /// Ends the picture.
    [[nodiscard]] std::string take();

private:
    void attribute(std::string_view name, double value);
    void escaped(std::string_view content);

    std::string text_;
};

}  // namespace osculo::io::svg
