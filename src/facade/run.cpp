#include "osculo/run.hpp"

#include "osculo/math/instant.hpp"
#include "osculo/math/vec.hpp"

namespace osculo {

std::array<std::string, 2> Run::ids(const Event& event) const {
    const std::string& ball = scene.balls[event.ball].id;
    switch (event.kind) {
        case EventKind::capture: return {ball, scene.rims[event.other].id};
        case EventKind::ball_ball: return {ball, scene.balls[event.other].id};
        case EventKind::ball_segment: return {ball, scene.segments[event.other].id};
        case EventKind::ball_arc: return {ball, scene.arcs[event.other].id};
        case EventKind::ball_point: return {ball, points[event.other]};
    }
    return {ball, {}};
}

std::optional<BallState> Run::at(std::uint32_t index, double t) const {
    for (const Piece& piece : pieces) {
        if (piece.ball != index || t < piece.from || t > piece.to) continue;
        const math::WidePoint<double> start{math::two_sum(piece.position.x, piece.position_low.x),
                                            math::two_sum(piece.position.y, piece.position_low.y)};
        const double wait = math::duration<double>(math::two_sum(piece.from, piece.from_low),
                                                   math::Instant<double>(t));
        const math::Vec<double> velocity{piece.velocity.x, piece.velocity.y};
        const math::Vec<double> p = math::displaced<double>(start, velocity, wait).rounded();
        return BallState{{p.x(), p.y()}, piece.velocity, piece.spin};
    }
    return std::nullopt;
}

}  // namespace osculo
