#include <algorithm>

#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

// More pieces than this only fill the picture.
constexpr std::size_t kMostPieces = 3'000;
constexpr std::size_t kThinPieces = 400;
// A curve is drawn as so many chords.
constexpr int kChords = 24;

// Whether a ball is in a rim that bends its path.
bool bends(const Piece& piece) {
    return piece.phase == Phase::rim || piece.phase == Phase::tipping;
}

// Path data of one ball's visible pieces; pieces that follow each other share their points.
void draw_path(Canvas& canvas, const View& view, const Run& run,
               const std::vector<std::size_t>& pieces) {
    std::vector<Point> stretch;
    const auto flush = [&] {
        if (stretch.size() > 1) canvas.path_data(stretch);
        stretch.clear();
    };
    for (const std::size_t index : pieces) {
        const Piece& piece = run.pieces[index];
        const double duration = piece.to - piece.from;
        const bool straight =
            piece.phase == Phase::resisted || (!bends(piece) && piece.acceleration == Point{});
        const int chords = straight ? 1 : kChords;
        std::vector<double> times;
        for (int k = 0; k <= chords; ++k) times.push_back(duration * k / chords);
        const std::vector<BallState> places = run.along(piece, times);
        for (std::size_t k = 0; k + 1 < places.size(); ++k) {
            const Point from = view(places[k].position);
            const Point to = view(places[k + 1].position);
            const auto visible = view.visible(from, to);
            if (!visible) {
                flush();
                continue;
            }
            if (stretch.empty() || visible->first != from) {
                flush();
                stretch.push_back(visible->first);
            }
            stretch.push_back(visible->second);
            if (visible->second != to) flush();
        }
    }
    flush();
}

// One path per ball, of the pieces that begin in that part of the time.
void draw_stage(Canvas& canvas, const Picture& picture, const Run& run, std::size_t stage,
                std::size_t stages) {
    std::vector<std::vector<std::size_t>> pieces_of(picture.scene.balls.size());
    for (std::size_t i = 0; i < run.pieces.size(); ++i) {
        const Piece& piece = run.pieces[i];
        const double share = run.time > 0 ? piece.from / run.time : 0;  // of the time gone by
        const auto begins_in =
            std::min(static_cast<std::size_t>(share * static_cast<double>(stages)), stages - 1);
        const bool moves = piece.velocity != Point{} || bends(piece);
        if (begins_in == stage && moves) pieces_of[piece.ball].push_back(i);
    }
    for (std::size_t ball = 0; ball < pieces_of.size(); ++ball) {
        if (pieces_of[ball].empty()) continue;
        canvas.raw("<path stroke=\"");
        canvas.raw(picture.colors[ball].color);
        canvas.raw("\" d=\"");
        draw_path(canvas, picture.view, run, pieces_of[ball]);
        canvas.raw("\"/>\n");
    }
}

}  // namespace

bool paths_fade(const Run& run) {
    constexpr std::size_t kManyPieces = 100;
    return run.pieces.size() > kManyPieces;
}

bool draw_paths(Canvas& canvas, const Picture& picture, const Run& run) {
    if (run.pieces.size() > kMostPieces) return false;
    const std::size_t stages = paths_fade(run) ? 5 : 1;
    const double width = run.pieces.size() > kThinPieces ? 1 : 1.8;  // [px]
    // The earliest last: they lie on top.
    for (std::size_t stage = stages; stage-- > 0;) {
        canvas.raw("<g fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"");
        canvas.number(width);
        canvas.raw("\" stroke-opacity=\"");
        canvas.number(0.9 - 0.14 * static_cast<double>(stage));
        canvas.raw("\">\n");
        draw_stage(canvas, picture, run, stage, stages);
        canvas.raw("</g>\n");
    }
    return true;
}

}  // namespace osculo::io::svg
