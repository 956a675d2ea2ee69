#include <algorithm>
#include <cmath>

#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

constexpr double kSmallest = 1.2;  // [px]: a ball is never drawn as less than a dot

std::string_view outline_color(const Picture& picture) {
    return picture.look.is_billiards ? "#10261c" : "#33404d";
}

// A white ball with a band of its colour, and a white disc with its number where there is room.
void draw_stripe_and_number(Canvas& canvas, const Picture& picture, std::size_t ball, Point at,
                            double radius) {
    const BallColor& color = picture.colors[ball];
    if (color.striped) {
        const double half_height = 0.58 * radius;
        const double half_width = std::sqrt(radius * radius - half_height * half_height);
        const auto corner = [&](double x, double y) {
            canvas.number(at.x + x);
            canvas.raw(" ");
            canvas.number(at.y + y);
        };
        const auto arc_to = [&](double x, double y) {
            canvas.raw("A");
            canvas.number(radius);
            canvas.raw(" ");
            canvas.number(radius);
            canvas.raw(" 0 0 1 ");
            corner(x, y);
        };
        canvas.raw("<path d=\"M");
        corner(-half_width, -half_height);
        canvas.raw("L");
        corner(half_width, -half_height);
        arc_to(half_width, half_height);
        canvas.raw("L");
        corner(-half_width, half_height);
        arc_to(-half_width, -half_height);
        canvas.raw("Z\" fill=\"" + std::string(color.color) + "\"/>\n");
    }
    constexpr double kRoomForNumber = 9;
    const std::string& id = picture.scene.balls[ball].id;
    if (radius < kRoomForNumber || color.is_light || id.size() > 2) return;
    canvas.circle(at, 0.5 * radius, "fill=\"#ffffff\"");
    canvas.text({at.x, at.y + 0.24 * radius}, 0.68 * radius, id,
                "text-anchor=\"middle\" font-weight=\"bold\" fill=\"#1c1c1c\"");
}

void draw_ghost(Canvas& canvas, const Picture& picture, std::size_t ball, Point at, double radius) {
    const std::string color(picture.colors[ball].color);
    canvas.circle(at, radius,
                  "fill=\"" + color + "\" fill-opacity=\"0.22\" stroke=\"" + color +
                      "\" stroke-width=\"1.2\" stroke-dasharray=\"4 2.5\"");
}

}  // namespace

void draw_ball(Canvas& canvas, const Picture& picture, std::size_t ball, Point at, double radius) {
    const BallColor& color = picture.colors[ball];
    const bool shows_stripe = color.striped && radius > 3;
    std::string style = "fill=\"" + std::string(shows_stripe ? "#f7f4ea" : color.color);
    style += "\" stroke=\"" + std::string(outline_color(picture)) + "\" stroke-width=\"";
    style += radius > 4 ? "1\"" : "0.5\"";
    canvas.circle(at, radius, style);
    if (!picture.look.is_billiards) return;
    if (radius > 3) draw_stripe_and_number(canvas, picture, ball, at, radius);
}

double drawn_radius(const Picture& picture, std::size_t ball, double scale) {
    return std::max(kSmallest, scale * picture.view.length(picture.scene.balls[ball].radius));
}

std::size_t ball_stride(const Scene& scene) {
    constexpr std::size_t kMostBalls = 20'000;
    return 1 + scene.balls.size() / (kMostBalls + 1);
}

void draw_balls_at_start(Canvas& canvas, const Picture& picture, BallStyle style) {
    const std::size_t stride = ball_stride(picture.scene);
    for (std::size_t i = 0; i < picture.scene.balls.size(); i += stride) {
        const Point at = picture.view(picture.scene.balls[i].position);
        (style == BallStyle::solid ? draw_ball : draw_ghost)(canvas, picture, i, at,
                                                             drawn_radius(picture, i));
    }
}

void draw_balls_at_end(Canvas& canvas, const Picture& picture, const Run& run) {
    const std::size_t stride = ball_stride(picture.scene);
    for (std::size_t i = 0; i < run.balls.size(); i += stride) {
        const FinalBall& final = run.balls[i];
        const Point at = picture.view(final.state.position);
        if (!picture.view.shows(at)) continue;
        // A captured ball is smaller: it lies deeper.
        const double scale = final.fate == BallFate::captured ? 0.6 : 1;
        draw_ball(canvas, picture, i, at, drawn_radius(picture, i, scale));
    }
}

void draw_velocities(Canvas& canvas, const Picture& picture) {
    const View& view = picture.view;
    constexpr std::size_t kMostBalls = 200;
    double fastest = 0;
    for (const Ball& ball : picture.scene.balls) {
        fastest = std::max(fastest, std::hypot(ball.velocity.x, ball.velocity.y));
    }
    if (!(fastest > 0) || picture.scene.balls.size() > kMostBalls) return;

    const double longest = std::min(90.0, 0.2 * std::min(view.width, view.height));  // [px]
    canvas.raw("<g stroke=\"" + std::string(picture.look.arrow) + "\" fill=\"" +
               std::string(picture.look.arrow) + "\" stroke-width=\"2\">\n");
    for (const Ball& ball : picture.scene.balls) {
        const double speed = std::hypot(ball.velocity.x, ball.velocity.y);
        const double length = longest * (speed / fastest);
        if (!(length > 4)) continue;
        const Point along{ball.velocity.x / speed, -ball.velocity.y / speed};
        const Point center = view(ball.position);
        const double start = std::min(view.length(ball.radius), 1000.0);
        const double head = std::min(9.0, 0.6 * length);
        const auto at = [&](double forward, double aside) {
            return Point{center.x + along.x * forward - along.y * aside,
                         center.y + along.y * forward + along.x * aside};
        };
        const double end = start + length;
        canvas.line(at(start, 0), at(end - head, 0), "");
        canvas.polygon(
            std::vector{at(end, 0), at(end - head, 0.42 * head), at(end - head, -0.42 * head)},
            "stroke=\"none\"");
    }
    canvas.raw("</g>\n");
}

}  // namespace osculo::io::svg
