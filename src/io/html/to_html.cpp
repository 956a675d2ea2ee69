#include <algorithm>
#include <cmath>

#include "io/html/page.hpp"
#include "io/json_text.hpp"
#include "io/svg/draw.hpp"
#include "osculo/io.hpp"

namespace osculo::io {
namespace {

using namespace svg;

std::string_view words(EventKind kind) {
    switch (kind) {
        case EventKind::capture: return " falls into ";
        case EventKind::rim_entry: return " rolls over the rim of ";
        case EventKind::rim_exit: return " leaves ";
        default: return " meets ";
    }
}

// More than anyone steps through.
constexpr std::size_t kMostEvents = 5'000;

View view_of(const Run& run, const Outline& outline, double width) {
    Box box = extent(run.scene, &run);
    if (!outline.bed.empty()) box = outline.frame;
    box.thicken();
    return View(box, {0, 0}, width, width * box.height() / box.width());
}

std::string picture_of(const Run& run, const View& view, const Outline& outline) {
    const Look look = look_of(run.scene);
    const std::vector<BallColor> colors = ball_colors(run.scene, look);
    const Picture picture{run.scene, look, colors, view};
    Canvas canvas(view.width, view.height, 1, "osculo replay");
    draw_table(canvas, picture, outline);
    canvas.raw("<g id=\"paths\">\n");
    draw_paths(canvas, picture, run);
    canvas.raw("</g>\n");
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        const Point at = view(run.scene.balls[i].position);
        canvas.raw("<g id=\"ball-" + std::to_string(i) + "\" transform=\"translate(");
        canvas.number(at.x);
        canvas.raw(" ");
        canvas.number(at.y);
        canvas.raw(")\">\n");
        draw_ball(canvas, picture, i, {0, 0}, drawn_radius(picture, i));
        canvas.raw("</g>\n");
    }
    return canvas.take();
}

bool is_finite(Point point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

bool is_quadratic(const Piece& piece) {
    return piece.phase != Phase::resisted && piece.phase != Phase::rim &&
           piece.phase != Phase::tipping;
}

// The page knows quadratics only: another piece is shown as so many of them, which begin where the
// ball is, as fast as it is, and end where it is.
void append_quadratics(std::vector<Piece>& pieces, const Run& run, const Piece& piece) {
    constexpr int kCount = 16;
    if (is_quadratic(piece)) {
        pieces.push_back(piece);
        return;
    }
    const double step = (piece.to - piece.from) / kCount;
    std::vector<double> times;
    for (int k = 0; k <= kCount; ++k) times.push_back(k * step);
    const std::vector<BallState> states = run.along(piece, times);
    for (std::size_t k = 0; k + 1 < states.size() && step > 0; ++k) {
        const BallState& begin = states[k];
        const BallState& end = states[k + 1];
        const auto acceleration = [step](double from, double to, double velocity) {
            return 2 * (to - from - velocity * step) / (step * step);
        };
        Piece part = piece;
        part.from = piece.from + times[k];
        part.to = k + 2 < states.size() ? piece.from + times[k + 1] : piece.to;
        part.position = begin.position;
        part.velocity = begin.velocity;
        part.acceleration = {acceleration(begin.position.x, end.position.x, begin.velocity.x),
                             acceleration(begin.position.y, end.position.y, begin.velocity.y)};
        pieces.push_back(part);
    }
}

// [from, to, x, y, vx, vy, ax, ay]
void write_piece(JsonText& json, const Piece& piece) {
    json.raw("[");
    bool first = true;
    for (const double number :
         {piece.from, piece.to, piece.position.x, piece.position.y, piece.velocity.x,
          piece.velocity.y, piece.acceleration.x, piece.acceleration.y}) {
        if (!first) json.raw(",");
        json.number(number);
        first = false;
    }
    json.raw("]");
}

std::string data_of(const Run& run, const View& view) {
    std::vector<std::vector<Piece>> pieces(run.scene.balls.size());
    for (const Piece& piece : run.pieces) {
        if (!is_finite(piece.position) || !is_finite(piece.velocity)) continue;
        if (!std::isfinite(piece.to)) continue;
        append_quadratics(pieces[piece.ball], run, piece);
    }
    JsonText json;
    json.raw("{\"end\": ");
    json.number(std::isfinite(run.time) ? run.time : 0.0);
    json.raw(", \"scale\": ");
    json.number(view.scale());
    json.raw(", \"centre\": ");
    json.vector(view.center());
    json.raw(", \"origin\": ");
    json.vector(view.origin());
    json.raw(", \"pieces\": ");
    json.lines(pieces, "", [&](const std::vector<Piece>& of_ball) {
        json.raw("[");
        for (const Piece& piece : of_ball) {
            if (&piece != &of_ball.front()) json.raw(",");
            write_piece(json, piece);
        }
        json.raw("]");
    });
    const std::size_t count = std::min(run.events.size(), kMostEvents);
    json.raw(", \"events\": ");
    json.lines(std::span(run.events).first(count), "", [&](const Event& event) {
        const auto [ball, other] = run.ids(event);
        json.raw("[");
        json.number(event.time);
        json.raw(", ");
        json.string(event.kind == EventKind::transition
                        ? ball + ": " + std::string(to_string(event.to))
                        : ball + std::string(words(event.kind)) + other);
        json.raw("]");
    });
    json.raw("}\n");
    // Nothing in a name ends the script that it is in.
    std::string text;
    for (const char c : json.take()) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

std::string to_html(const Run& run, double width) {
    const Outline outline = outline_of(run.scene);
    const View view =
        view_of(run, outline, std::isfinite(width) ? std::clamp(width, 10.0, 1e5) : 1200);
    std::string page(html::kHead);
    page += "<title>osculo: " + std::to_string(run.balls.size()) + " balls, " +
            std::to_string(run.event_count) + " events, " + rounded(run.time, 6) + " s</title>\n";
    page += "<main>\n<figure>\n" + picture_of(run, view, outline) + html::kControls.data();
    page += "<small>1 m = " + rounded(view.scale(), 6) + " px in a picture of " +
            rounded(view.width, 6) + " px; " + std::string(to_string(run.status)) + " at " +
            rounded(run.time, 6) +
            " s. Space plays, arrows step from event to event.</small>\n</figure>\n";
    page += "<aside><b>" + std::to_string(run.event_count) + " events</b>";
    if (run.events.size() > kMostEvents) {
        page += " <small>(the first " + std::to_string(kMostEvents) + " are listed)</small>";
    }
    page += "<ol id=\"events\"></ol></aside>\n</main>\n";
    page += "<script type=\"application/json\" id=\"run\">\n" + data_of(run, view) + "</script>\n";
    page += html::kScript;
    return page;
}

}  // namespace osculo::io
