#include "io/svg/canvas.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/utf8.hpp"

namespace osculo::io::svg {

Canvas::Canvas(double width, double height, double scale, std::string_view title) {
    raw("<svg xmlns=\"http://www.w3.org/2000/svg\"");
    attribute("width", scale * width);
    attribute("height", scale * height);
    raw(" viewBox=\"0 0 ");
    number(width);
    raw(" ");
    number(height);
    raw("\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<title>");
    escaped(title);
    raw("</title>\n");
}

void Canvas::circle(Point center, double radius, std::string_view style) {
    raw("<circle");
    attribute("cx", center.x);
    attribute("cy", center.y);
    attribute("r", radius);
    raw(" ");
    raw(style);
    raw("/>\n");
}

void Canvas::line(Point from, Point to, std::string_view style) {
    raw("<line");
    attribute("x1", from.x);
    attribute("y1", from.y);
    attribute("x2", to.x);
    attribute("y2", to.y);
    raw(" ");
    raw(style);
    raw("/>\n");
}

void Canvas::polyline(std::span<const Point> points, std::string_view style) {
    raw("<path d=\"");
    path_data(points);
    raw("\" ");
    raw(style);
    raw("/>\n");
}

void Canvas::polygon(std::span<const Point> points, std::string_view style) {
    raw("<path d=\"");
    path_data(points);
    raw("Z\" ");
    raw(style);
    raw("/>\n");
}

void Canvas::rectangle(Point corner, double width, double height, std::string_view style) {
    raw("<rect");
    attribute("x", corner.x);
    attribute("y", corner.y);
    attribute("width", width);
    attribute("height", height);
    raw(" ");
    raw(style);
    raw("/>\n");
}

void Canvas::text(Point at, double size, std::string_view content, std::string_view style) {
    raw("<text");
    attribute("x", at.x);
    attribute("y", at.y);
    attribute("font-size", size);
    raw(" ");
    raw(style);
    raw(">");
    escaped(content);
    raw("</text>\n");
}

void Canvas::number(double value) {
    // Far beyond any picture; keeps the conversion defined for whatever comes.
    constexpr double kFarthest = 1e9;
    const double limited = std::isnan(value) ? 0 : std::clamp(value, -kFarthest, kFarthest);
    long long hundredths = std::llround(limited * 100);
    if (hundredths < 0) {
        raw("-");
        hundredths = -hundredths;
    }
    char buffer[24];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, hundredths / 100);
    raw({buffer, result.ptr});
    if (const auto rest = hundredths % 100; rest != 0) {
        const char digits[]{'.', static_cast<char>('0' + rest / 10),
                            static_cast<char>('0' + rest % 10)};
        raw({digits, rest % 10 == 0 ? 2U : 3U});
    }
}

void Canvas::path_data(std::span<const Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        raw(i == 0 ? "M" : i == 1 ? "L" : " ");
        number(points[i].x);
        raw(" ");
        number(points[i].y);
    }
}

std::string Canvas::take() {
    raw("</svg>\n");
    return std::move(text_);
}

void Canvas::attribute(std::string_view name, double value) {
    raw(" ");
    raw(name);
    raw("=\"");
    number(value);
    raw("\"");
}

void Canvas::escaped(std::string_view content) {
    for (std::size_t at = 0; at < content.size();) {
        const std::size_t length = utf8_length(content, at);
        const std::string_view character = content.substr(at, length);
        if (length == 0 || (length == 1 && static_cast<unsigned char>(content[at]) < 0x20) ||
            character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF") {
            raw(kReplacement);
        } else if (character == "&") {
            raw("&amp;");
        } else if (character == "<") {
            raw("&lt;");
        } else if (character == ">") {
            raw("&gt;");
        } else {
            raw(character);
        }
        at += std::max<std::size_t>(length, 1);
    }
}

}  // namespace osculo::io::svg
