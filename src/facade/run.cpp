#include "osculo/run.hpp"

#include "osculo/math/instant.hpp"
#include "osculo/math/vec.hpp"
#include "osculo/motion/rim_paper.hpp"
#include "osculo/motion/rim_tipping_stay.hpp"
#include "osculo/motion/slowing.hpp"

namespace osculo {
namespace {

double decayed(double w, double loss) {
    return w > loss ? w - loss : w < -loss ? w + loss : 0.0;
}

math::WidePoint<double> start_of(const Piece& piece) {
    return {math::two_sum(piece.position.x, piece.position_low.x),
            math::two_sum(piece.position.y, piece.position_low.y)};
}

BallState resisted_state_in(const Piece& piece, double wait) {
    const math::Vec<double> velocity{piece.velocity.x, piece.velocity.y};
    const double speed = math::norm<double>(velocity);
    if (!(speed > 0)) return {piece.position, piece.velocity, piece.spin};
    const auto& [constant, linear, quadratic] = piece.resistance;
    const motion::Slowed<double> now =
        motion::Slowing<double>::of({constant, linear, quadratic}, speed).after(wait);
    const math::Vec<double> p =
        math::displaced<double>(start_of(piece), velocity, now.sigma).rounded();
    return {{p.x(), p.y()}, {now.q * velocity.x(), now.q * velocity.y()}, piece.spin};
}

geometry::Rim<double> rim_of(const Scene& scene, const Piece& piece) {
    const Rim& rim = scene.rims[piece.rim];
    return {{rim.center.x, rim.center.y}, rim.radius};
}

/// The motion of a piece on the edge of a rim.
motion::RimTippingStay<double> edge_motion(const Scene& scene, const Piece& piece) {
    return {rim_of(scene, piece),
            scene.gravity,
            scene.balls[piece.ball].radius,
            1 + piece.inertia,
            {start_of(piece), {piece.velocity.x, piece.velocity.y}, piece.height, piece.climb},
            motion::TippingStart::touches};
}

/// The motion of a piece in a rim.
motion::RimPaperMotion<double> rim_motion(const Scene& scene, const Piece& piece) {
    return {rim_of(scene, piece),
            scene.gravity,
            scene.balls[piece.ball].radius,
            start_of(piece),
            {piece.velocity.x, piece.velocity.y}};
}

}  // namespace

BallState state_in(const Piece& piece, double radius, double wait) {
    if (piece.phase == Phase::resisted) return resisted_state_in(piece, wait);
    const math::Vec<double> velocity{piece.velocity.x, piece.velocity.y};
    const math::Vec<double> half_acceleration{piece.acceleration.x / 2, piece.acceleration.y / 2};
    const math::Vec<double> p =
        math::displaced<double>(start_of(piece), velocity, half_acceleration, wait).rounded();
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
        return at(piece, t);
    }
    return std::nullopt;
}

BallState Run::at(const Piece& piece, double t) const {
    const double wait =
        math::duration<double>(math::two_sum(piece.from, piece.from_low), math::Instant<double>(t));
    return along(piece, {wait}).front();
}

std::vector<BallState> Run::along(const Piece& piece, const std::vector<double>& times) const {
    std::vector<BallState> states;
    states.reserve(times.size());
    const auto follow = [&](const auto& motion) {
        for (const double t : times) {
            const auto now = motion.at(t);
            const math::Vec<double> p = now.position.rounded();
            states.push_back({{p.x(), p.y()}, {now.velocity.x(), now.velocity.y()}, piece.spin});
        }
    };
    if (piece.phase == Phase::rim) {
        follow(rim_motion(scene, piece));
    } else if (piece.phase == Phase::tipping) {
        follow(edge_motion(scene, piece));
    } else {
        const double radius = scene.balls[piece.ball].radius;
        for (const double t : times) states.push_back(state_in(piece, radius, t));
    }
    return states;
}

}  // namespace osculo
