#include "io/svg/draw.hpp"

namespace osculo::io::svg {
namespace {

// More pieces than this only fill the picture.
constexpr std::size_t kMostPieces = 3'000;
constexpr std::size_t kManyPieces = 400;

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
        const Point from = view(piece.position);
        const Point to = view({piece.position.x + piece.velocity.x * duration,
                               piece.position.y + piece.velocity.y * duration});
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
    flush();
}

}  // namespace

bool draw_paths(Canvas& canvas, const Picture& picture, const Run& run) {
    if (run.pieces.size() > kMostPieces) return false;
    std::vector<std::vector<std::size_t>> pieces_of(picture.scene.balls.size());
    for (std::size_t i = 0; i < run.pieces.size(); ++i) {
        const Piece& piece = run.pieces[i];
        if (piece.velocity != Point{}) pieces_of[piece.ball].push_back(i);
    }
    canvas.raw("<g fill=\"none\" stroke-linejoin=\"round\" ");
    canvas.raw(run.pieces.size() > kManyPieces ? "stroke-width=\"1\" stroke-opacity=\"0.5\">\n"
                                               : "stroke-width=\"1.8\" stroke-opacity=\"0.85\">\n");
    for (std::size_t ball = 0; ball < pieces_of.size(); ++ball) {
        if (pieces_of[ball].empty()) continue;
        canvas.raw("<path stroke=\"");
        canvas.raw(picture.colors[ball].color);
        canvas.raw("\" d=\"");
        draw_path(canvas, picture.view, run, pieces_of[ball]);
        canvas.raw("\"/>\n");
    }
    canvas.raw("</g>\n");
    return true;
}

}  // namespace osculo::io::svg
