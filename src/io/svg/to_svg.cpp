#include <algorithm>
#include <cmath>

#include "io/svg/draw.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

using namespace svg;

constexpr double kWidth = 1200;       // [px] in which everything is drawn, then scaled
constexpr double kMargin = 24;        // [px] around everything
constexpr double kPanelHeight = 130;  // [px] below a wide picture
constexpr double kPanelShare = 0.4;   // of the width, beside a tall picture

// Where things go on the page.
struct Layout {
    double height;
    View view;
    Panel panel;
};

Layout layout_of(Box box, double shown) {
    box.thicken();  // nothing is so thin that it cannot be seen
    const double inner = kWidth - 2 * kMargin;
    const double aspect = box.height() / box.width();
    constexpr double kTall = 1.2;
    if (aspect > kTall) {  // words to the right
        const double frame_height = std::min(inner, (1 - kPanelShare) * inner * aspect);
        const double frame_width = frame_height / aspect;
        const double panel_left = 2 * kMargin + frame_width;
        return {frame_height + 2 * kMargin,
                View(box, {kMargin, kMargin}, frame_width, frame_height),
                {{panel_left, kMargin}, kWidth - panel_left - kMargin, frame_height, shown}};
    }
    const double frame_height = inner * aspect;
    return {frame_height + kPanelHeight + 2 * kMargin,
            View(box, {kMargin, kMargin}, inner, frame_height),
            {{kMargin, kMargin + frame_height + 6}, inner, kPanelHeight, shown}};
}

std::string draw(const Scene& scene, const Run* run, const SvgOptions& options) {
    const Outline outline = outline_of(scene);
    Box box = extent(scene, run);
    if (!outline.bed.empty()) box = outline.frame;
    const double width =
        std::isfinite(options.width) ? std::clamp(options.width, 10.0, 1e5) : kWidth;
    const Layout layout = layout_of(box, width / kWidth);
    const Look look = look_of(scene);
    const std::vector<BallColor> colors = ball_colors(scene, look);
    const Picture picture{scene, look, colors, layout.view};

    Canvas canvas(kWidth, layout.height, width / kWidth,
                  run == nullptr ? "osculo scene" : "osculo run");
    canvas.rectangle({0, 0}, kWidth, layout.height, "fill=\"#ffffff\"");
    draw_table(canvas, picture, outline);
    PathsAndContacts drawn{};
    if (run == nullptr) {
        draw_balls_at_start(canvas, picture, BallStyle::solid);
        draw_velocities(canvas, picture);
    } else {
        drawn.paths = draw_paths(canvas, picture, *run);
        draw_balls_at_start(canvas, picture, BallStyle::ghost);
        draw_velocities(canvas, picture);
        draw_balls_at_end(canvas, picture, *run);
        drawn.contacts = draw_contacts(canvas, picture, *run, options.numbers);
    }
    draw_panel(canvas, picture, layout.panel, run, drawn);
    return canvas.take();
}

}  // namespace

std::string to_svg(const Scene& scene, const SvgOptions& options) {
    return draw(scene, nullptr, options);
}

std::string to_svg(const Run& run, const SvgOptions& options) {
    const auto is_transition = [](const Event& event) {
        return event.kind == EventKind::transition;
    };
    if (std::ranges::none_of(run.events, is_transition)) return draw(run.scene, &run, options);
    Run contacts = run;  // what is numbered and listed
    std::erase_if(contacts.events, is_transition);
    return draw(contacts.scene, &contacts, options);
}

}  // namespace osculo::io
