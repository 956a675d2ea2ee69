#include "osculo/run.hpp"

#include "osculo/math/instant.hpp"
#include "osculo/math/vec.hpp"
#include "osculo/motion/rim_paper.hpp"

namespace osculo {

namespace {

double decayed(double w, double loss) {
    return w > loss ? w - loss : w < -loss ? w + loss : 0.0;
}

BallState state_in(const Piece& piece, double radius, const math::WidePoint<double>& start,
                   double wait) {
    const math::Vec<double> velocity{piece.velocity.x, piece.velocity.y};
    const math::Vec<double> half_acceleration{piece.acceleration.x / 2, piece.acceleration.y / 2};
    const math::Vec<double> p =
        math::displaced<double>(start, velocity, half_acceleration, wait).rounded();
    const math::Vec<double> v = velocity + 2 * wait * half_acceleration;
    BallState state{{p.x(), p.y()}, {v.x(), v.y()}, piece.spin};
    if (piece.phase == Phase::rolling) {
        state.spin = {-v.y() / radius, v.x() / radius, piece.spin[2]};
    } else {
        state.spin[0] += piece.spin_rate[0] * wait;
        state.spin[1] += piece.spin_rate[1] * wait;
    }
    state.spin[2] = decayed(piece.spin[2], piece.spin_rate[2] * wait);
    return state;
}

/// The motion of a piece in a rim.
motion::RimPaperMotion<double> rim_motion(const Scene& scene, const Piece& piece,
                                          const math::WidePoint<double>& start) {
    const Rim& rim = scene.rims[piece.rim];
    return {{{rim.center.x, rim.center.y}, rim.radius},
            scene.gravity,
            scene.balls[piece.ball].radius,
            start,
            {piece.velocity.x, piece.velocity.y}};
}

}  // namespace

std::array<std::string, 2> Run::ids(const Event& event) const {
    const std::string& ball = scene.balls[event.ball].id;
    switch (event.kind) {
        case EventKind::capture:
        case EventKind::rim_entry:
        case EventKind::rim_exit: return {ball, scene.rims[event.other].id};
        case EventKind::ball_ball: return {ball, scene.balls[event.other].id};
        case EventKind::ball_segment: return {ball, scene.segments[event.other].id};
        case EventKind::ball_arc: return {ball, scene.arcs[event.other].id};
        case EventKind::ball_point: return {ball, points[event.other]};
        case EventKind::transition: return {ball, {}};
    }
    return {ball, {}};
}

std::optional<BallState> Run::at(std::uint32_t index, double t) const {
    for (const Piece& piece : pieces) {
        if (piece.ball != index || t < piece.from || t > piece.to) continue;
        const double wait = math::duration<double>(math::two_sum(piece.from, piece.from_low),
                                                   math::Instant<double>(t));
        return along(piece, {wait}).front();
    }
    return std::nullopt;
}

std::vector<BallState> Run::along(const Piece& piece, const std::vector<double>& times) const {
    const math::WidePoint<double> start{math::two_sum(piece.position.x, piece.position_low.x),
                                        math::two_sum(piece.position.y, piece.position_low.y)};
    std::vector<BallState> states;
    states.reserve(times.size());
    if (piece.phase != Phase::rim) {
        const double radius = scene.balls[piece.ball].radius;
        for (const double t : times) states.push_back(state_in(piece, radius, start, t));
        return states;
    }
    const auto motion = rim_motion(scene, piece, start);
    for (const double t : times) {
        const auto now = motion.at(t);
        const math::Vec<double> p = now.position.rounded();
        states.push_back({{p.x(), p.y()}, {now.velocity.x(), now.velocity.y()}, piece.spin});
    }
    return states;
}

}  // namespace osculo
