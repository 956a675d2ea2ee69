#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/svg/canvas.hpp"
#include "io/svg/look.hpp"
#include "io/svg/outline.hpp"
#include "io/svg/view.hpp"

// The layers of a picture, from the bottom up.
namespace osculo::io::svg {

/// What every layer needs to know.
struct Picture {
    const Scene& scene;
    const Look& look;
    const std::vector<BallColor>& colors;
    const View& view;
};

void draw_table(Canvas& canvas, const Picture& picture, const Outline& outline);

/// The path of every ball, unless there are too many pieces to tell anything apart: then false.
bool draw_paths(Canvas& canvas, const Picture& picture, const Run& run);
/// Whether there are so many pieces that later ones are drawn fainter.
[[nodiscard]] bool paths_fade(const Run& run);

/// One ball out of so many is drawn: 1, unless there are more than a picture has room for.
[[nodiscard]] std::size_t ball_stride(const Scene& scene);

enum class BallStyle { solid, ghost };
/// A ball of that radius [px] at that place.
void draw_ball(Canvas& canvas, const Picture& picture, std::size_t ball, Point at, double radius);
/// The radius it is drawn with [px]: never less than a dot.
[[nodiscard]] double drawn_radius(const Picture& picture, std::size_t ball, double scale = 1);
void draw_balls_at_start(Canvas& canvas, const Picture& picture, BallStyle style);
void draw_balls_at_end(Canvas& canvas, const Picture& picture, const Run& run);
void draw_velocities(Canvas& canvas, const Picture& picture);

struct DrawnContacts {
    std::size_t dots = 0;      ///< of the first events of the run
    std::size_t numbered = 0;  ///< the events with numbers are among the first this many
    std::size_t skipped = 0;   ///< of these, without number for want of room
};
DrawnContacts draw_contacts(Canvas& canvas, const Picture& picture, const Run& run, bool numbers);

/// A run's words: what the picture shows, how the run ended, and its first events if there is room.
struct Panel {
    Point corner;
    double width;
    double height;
    double shown;  ///< size of a pixel of the drawing on the page [px]
};
/// A number for people, with so many digits.
[[nodiscard]] std::string rounded(double value, int digits);
struct PathsAndContacts {
    bool paths;
    DrawnContacts contacts;
};
void draw_panel(Canvas& canvas, const Picture& picture, const Panel& panel, const Run* run,
                const PathsAndContacts& drawn);

}  // namespace osculo::io::svg
