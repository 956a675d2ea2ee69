#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

constexpr std::string_view kDark = "fill=\"#222222\"";
constexpr std::string_view kGrey = "fill=\"#5b6570\"";

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string_view words(Status status) {
    switch (status) {
        case Status::at_rest: return "everything is at rest";
        case Status::time_limit: return "time limit reached";
        case Status::event_limit: return "event limit reached";
        case Status::zeno: return "impacts accumulate";
        case Status::numeric: return "out of numeric range";
    }
    return "";
}

std::string_view words(EventKind kind) {
    switch (kind) {
        case EventKind::capture: return "falls into";
        case EventKind::rim_entry: return "comes to";
        case EventKind::rim_exit: return "leaves";
        case EventKind::ball_ball:
        case EventKind::ball_segment:
        case EventKind::ball_arc:
        case EventKind::ball_point: return "meets";
        case EventKind::transition: break;  // not shown
    }
    return "";
}

// All times with as many decimals as the last one has within seven digits.
std::string time_text(double time, double end) {
    const double digits_before = end > 0 ? std::floor(std::log10(end)) + 1 : 1;
    const double decimals = 7 - std::max(digits_before, 1.0);
    if (!(decimals >= 0) || end < 1e-3) return rounded(time, 7);
    std::array<char, 40> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), time,
                                      std::chars_format::fixed, static_cast<int>(decimals));
    return {buffer.data(), result.ptr};
}

// The largest 1, 2 or 5 times a power of ten [m] that is shorter than so many pixels.
double scale_length(const View& view, double pixels) {
    const double most = view.metres(pixels);
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= most) return factor * power;
    }
    return power;
}

// What comes next goes below what is there.
class Lines {
public:
    Lines(Canvas& canvas, const Panel& panel) : canvas_(canvas), panel_(panel) {}

    void text(double size, std::string_view content, std::string_view style) {
        used_ += 1.45 * size;
        canvas_.text({panel_.corner.x, panel_.corner.y + used_}, size, content, style);
    }
    // On as many lines as it takes; the width of letters is a guess.
    void paragraph(double size, std::string_view words, std::string_view style) {
        const auto most = static_cast<std::size_t>(std::max(20.0, panel_.width / (0.55 * size)));
        while (words.size() > most) {
            const std::size_t end = words.rfind(' ', most);
            if (end == std::string_view::npos) break;
            text(size, words.substr(0, end), style);
            words.remove_prefix(end + 1);
        }
        if (!words.empty()) text(size, words, style);
    }
    void space(double height) { used_ += height; }
    [[nodiscard]] double used() const { return used_; }
    [[nodiscard]] double left() const { return panel_.height - used_; }
    [[nodiscard]] Point at() const { return {panel_.corner.x, panel_.corner.y + used_}; }

private:
    Canvas& canvas_;
    Panel panel_;
    double used_ = 0;
};

std::string key_to_balls(const Scene& scene) {
    const std::size_t stride = ball_stride(scene);
    return stride == 1 ? "" : "One ball in " + std::to_string(stride) + " is drawn.";
}

// A bar, and how the world in metres becomes pixels.
void draw_scale_bar(Canvas& canvas, const View& view, Lines& lines, const Panel& panel) {
    const double metres = scale_length(view, std::min(220.0, 0.4 * panel.width));
    const double length = view.length(metres);
    lines.space(22);
    const Point at = lines.at();
    canvas.raw("<g stroke=\"#222222\" stroke-width=\"1.5\">\n");
    canvas.line(at, {at.x + length, at.y}, "");
    canvas.line({at.x, at.y - 4}, {at.x, at.y + 4}, "");
    canvas.line({at.x + length, at.y - 4}, {at.x + length, at.y + 4}, "");
    canvas.raw("</g>\n");
    canvas.text(
        {at.x + length + 8, at.y + 4.5}, 13,
        rounded(metres, 6) + " m (1 m is " + rounded(panel.shown * view.scale(), 6) + " px)",
        kDark);
    lines.space(10);
}

std::string key_to_picture(const Run& run, const PathsAndContacts& drawn) {
    std::string key = "Dashed: start. Solid: end. Arrows: velocity at the start.";
    if (!drawn.paths) {
        key += " Paths left out: too many.";
    } else if (paths_fade(run)) {
        key += " Paths fade with time.";
    }
    if (run.events.empty() && run.event_count > 0) return key + " Contacts were not recorded.";
    if (drawn.contacts.dots < run.event_count) {
        key += " Dots: the first " + counted(drawn.contacts.dots, "contact") + '.';
    } else if (drawn.contacts.dots > 0) {
        key += " Dots: contacts.";
    }
    return key;
}

std::string key_to_numbers(const Run& run, const DrawnContacts& contacts) {
    if (contacts.numbered == 0) return {};
    std::string key = "Numbers: ";
    key += contacts.numbered < run.event_count
               ? "the first " + std::to_string(contacts.numbered) + " contacts in order of time"
               : "contacts in order of time";
    if (contacts.skipped > 0) {
        key += " (" + std::to_string(contacts.skipped) + " left out for want of room)";
    }
    return key + '.';
}

double speed_before(const Event& event, std::size_t which) {
    const Point& velocity = event.before[which].velocity;
    return std::hypot(velocity.x, velocity.y);
}

// "1   0.0512 s   cue meets 1", as many as have numbers and fit.
void draw_events(Canvas& canvas, Lines& lines, const Run& run, std::size_t numbered) {
    constexpr double kSize = 12;
    constexpr double kLine = 1.45 * kSize;
    const auto room = static_cast<std::size_t>(std::max(0.0, (lines.left() - 12) / kLine));
    constexpr std::size_t kFewest = 3;
    if (room < kFewest) return;
    lines.space(8);
    for (std::size_t i = 0; i < std::min(numbered, room); ++i) {
        const Event& event = run.events[i];
        auto [ball, other] = run.ids(event);
        // Of two balls, the faster one is said to meet the other.
        if (event.kind == EventKind::ball_ball && speed_before(event, 1) > speed_before(event, 0)) {
            std::swap(ball, other);
        }
        lines.space(kLine);
        const Point at = lines.at();
        canvas.text({at.x + 18, at.y}, kSize, std::to_string(i + 1),
                    "fill=\"#222222\" font-weight=\"bold\" text-anchor=\"end\"");
        canvas.text({at.x + 104, at.y}, kSize, time_text(event.time, run.time) + " s",
                    "fill=\"#5b6570\" text-anchor=\"end\"");
        canvas.text({at.x + 118, at.y}, kSize,
                    ball + ' ' + std::string(words(event.kind)) + ' ' + other, kDark);
    }
}

}  // namespace

std::string rounded(double value, int digits) {
    std::array<char, 40> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

void draw_panel(Canvas& canvas, const Picture& picture, const Panel& panel, const Run* run,
                const PathsAndContacts& drawn) {
    Lines lines(canvas, panel);
    const std::string balls = key_to_balls(picture.scene);
    if (run == nullptr) {
        lines.text(18, counted(picture.scene.balls.size(), "ball") + " at the start",
                   "fill=\"#222222\" font-weight=\"bold\"");
        lines.paragraph(12, balls, kGrey);
        draw_scale_bar(canvas, picture.view, lines, panel);
        return;
    }
    lines.text(18,
               rounded(run->time, 6) + " s, " + counted(run->event_count, "event") + ": " +
                   std::string(words(run->status)),
               "fill=\"#222222\" font-weight=\"bold\"");
    for (const std::string& key :
         {key_to_picture(*run, drawn), key_to_numbers(*run, drawn.contacts), balls}) {
        lines.paragraph(12, key, kGrey);
    }
    draw_scale_bar(canvas, picture.view, lines, panel);
    draw_events(canvas, lines, *run, drawn.contacts.numbered);
}

}  // namespace osculo::io::svg
