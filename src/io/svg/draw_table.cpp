#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

std::vector<Point> in_pixels(const View& view, const std::vector<Point>& points) {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Point& point : points) result.push_back(view(point));
    return result;
}

std::string style(std::initializer_list<std::pair<std::string_view, std::string_view>> attributes) {
    std::string result;
    for (const auto& [name, value] : attributes) {
        result += std::string(name) + "=\"" + std::string(value) + "\" ";
    }
    return result;
}

void draw_rims(Canvas& canvas, const Picture& picture) {
    for (const Rim& rim : picture.scene.rims) {
        const Point center = picture.view(rim.center);
        const double radius = picture.view.length(rim.radius);
        canvas.circle(center, radius, "fill=\"#0c0c0c\" stroke=\"#3a2a1c\" stroke-width=\"1.5\"");
        canvas.circle(center, 0.72 * radius, "fill=\"#000000\"");
    }
}

// A box of the scene as path data, for clipping.
void box_data(Canvas& canvas, const View& view, const Box& box) {
    canvas.path_data(std::vector{view({box.left, box.bottom}), view({box.right, box.bottom}),
                                 view({box.right, box.top}), view({box.left, box.top})});
    canvas.raw("Z");
}

void draw_box(Canvas& canvas, const View& view, const Box& box, double round, std::string style) {
    const Point corner = view({box.left, box.top});
    style += "rx=\"" + std::to_string(static_cast<int>(round)) + "\"";
    canvas.rectangle(corner, view.length(box.width()), view.length(box.height()), style);
}

// The marks by which players aim: at the eighths of the long sides and quarters of the short ones,
// halfway between the backs of the cushions and the edge of the frame.
void draw_sights(Canvas& canvas, const View& view, const Outline& outline) {
    Box bed = outline.back;
    bed.grow(-outline.depth);
    const double out = outline.depth + (outline.frame.right - outline.back.right) / 2;
    const double radius = std::max(1.0, view.length(0.07 * outline.depth));
    const auto dot = [&](Point at) { canvas.circle(view(at), radius, "fill=\"#e8dcc0\""); };
    const int across = bed.width() > bed.height() ? 8 : 4;
    const int along = 12 - across;
    for (int i = 1; i < across; ++i) {
        const double x = bed.left + bed.width() * i / across;
        dot({x, bed.bottom - out});
        dot({x, bed.top + out});
    }
    for (int i = 1; i < along; ++i) {
        const double y = bed.bottom + bed.height() * i / along;
        dot({bed.left - out, y});
        dot({bed.right + out, y});
    }
}

// The cushions are thick strokes along their noses; the half on the bed and what lies behind their
// backs is clipped away.
void draw_cushions(Canvas& canvas, const Picture& picture, const Outline& outline) {
    const View& view = picture.view;
    canvas.raw("<clipPath id=\"cushions\"><path clip-rule=\"evenodd\" d=\"");
    box_data(canvas, view, outline.back);
    canvas.path_data(in_pixels(view, outline.bed));
    canvas.raw("Z\"/></clipPath>\n<g clip-path=\"url(#cushions)\" fill=\"none\" stroke=\"");
    canvas.raw(picture.look.cushion);
    canvas.raw("\" stroke-width=\"");
    canvas.number(view.length(2.02 * outline.depth));
    canvas.raw("\">\n");
    const bool is_loop = outline.cushions.size() == 1;
    const auto draw_all = [&](std::string_view attributes) {
        for (const std::vector<Point>& cushion : outline.cushions) {
            const std::vector<Point> points = in_pixels(view, cushion);
            if (is_loop) {
                canvas.polygon(points, attributes);
            } else {
                canvas.polyline(points, attributes);
            }
        }
    };
    draw_all("");
    canvas.raw("</g>\n");
    draw_all(style({{"fill", "none"}, {"stroke", picture.look.nose}, {"stroke-width", "1.5"}}));
}

// Segments and arcs that stand free: a line, and for a one-sided one a band behind it.
void draw_obstacles(Canvas& canvas, const Picture& picture, const Outline& outline) {
    const View& view = picture.view;
    const std::string line = style({{"fill", "none"},
                                    {"stroke", picture.look.nose},
                                    {"stroke-width", "3"},
                                    {"stroke-linecap", "round"}});
    const auto is_drawn = [](const std::vector<bool>& has, std::size_t i) {
        return i < has.size() && has[i];
    };
    for (std::size_t i = 0; i < picture.scene.segments.size(); ++i) {
        if (is_drawn(outline.has_segment, i)) continue;
        const Segment& segment = picture.scene.segments[i];
        const Point from = view(segment.from);
        const Point to = view(segment.to);
        if (segment.side == Side::left) {
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            const double band = 8 / std::max(length, 1e-9);
            const Point back{-band * (to.y - from.y), band * (to.x - from.x)};
            canvas.polygon(
                std::vector<Point>{
                    from, to, {to.x + back.x, to.y + back.y}, {from.x + back.x, from.y + back.y}},
                style({{"fill", picture.look.frame}}));
        }
        canvas.line(from, to, line);
    }
    for (std::size_t i = 0; i < picture.scene.arcs.size(); ++i) {
        if (is_drawn(outline.has_arc, i)) continue;
        const Arc& arc = picture.scene.arcs[i];
        if (is_full_circle(arc)) {
            canvas.circle(view(arc.center), view.length(arc.radius), line);
        } else {
            canvas.polyline(in_pixels(view, points_along(arc)), line);
        }
    }
}

}  // namespace

void draw_table(Canvas& canvas, const Picture& picture, const Outline& outline) {
    const View& view = picture.view;
    if (outline.bed.empty()) {
        canvas.rectangle(view.corner, view.width, view.height,
                         "fill=\"#fbfbf9\" stroke=\"#d8dce1\"");
        draw_rims(canvas, picture);
    } else {
        draw_box(canvas, view, outline.frame, 14, style({{"fill", picture.look.frame}}));
        if (picture.look.is_billiards) draw_sights(canvas, view, outline);
        canvas.polygon(in_pixels(view, outline.bed), style({{"fill", picture.look.bed}}));
        draw_rims(canvas, picture);
        draw_cushions(canvas, picture, outline);
    }
    draw_obstacles(canvas, picture, outline);
}

}  // namespace osculo::io::svg
