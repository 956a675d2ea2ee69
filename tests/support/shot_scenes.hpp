#pragma once

#include <algorithm>
#include <cmath>

#include "osculo/engine/scenes.hpp"
#include "osculo/impact/cushion_stronge.hpp"
#include "support/builder.hpp"
#include "support/pool_shots.hpp"

/// The recorded pool shots as scenes of ours, with the recorder's laws as they are, quirks
/// included.
namespace osculo::support::pool_shots {

/// What the recorder puts between things that meet [m].
inline constexpr double kSpacer = 1e-10;

/// The recorder's cushion laws but Mathavan's.
template <math::Scalar S>
struct RecordedCushion {
    static constexpr const char* kName = "recorded";
    enum class Law { han_2005, impulse, stronge, unrealistic };

    Law law{};
    S restitution{};
    S friction{};
    S height{};

    /// [normal]: of length 1 from a segment, of the distance between the centres from a jaw.
    void resolve(const math::Vec<S>& normal, impact::SpinningBall<S>& ball) const {
        const S r = ball.radius;
        const S rise = height - r;
        // Two laws take the direction from the ball's centre to the nose, at its full horizontal
        // distance, for the normal; of a jaw, to the centre of its circle. All that after the ball
        // has been moved away by the spacer.
        const S length = math::norm<S>(normal);
        const S distance = (math::abs<S>(length - S(1)) < S(1e-9) ? r : length) + S(kSpacer);
        const S steeper = r + r * rise / math::norm<S>(math::Vec<S>(distance, rise));
        switch (law) {
            case Law::han_2005:
                impact::CushionHan2005<S>{restitution, friction, height}.resolve(normal, ball);
                break;
            case Law::impulse:
                impact::CushionHan2005<S>{restitution, friction, steeper}.resolve(normal, ball);
                break;
            case Law::stronge:
                impact::CushionStronge<S>{restitution, friction, steeper}.resolve(normal, ball);
                break;
            case Law::unrealistic:
                impact::CushionSimple<S>{restitution, S(0)}.resolve(normal, ball);
                break;
        }
    }
};

using ShotScene = engine::ClothScene<double, RecordedCushion, engine::ClothPieces>;

/// The kinds of obstacles in the order of engine::Table, for the indices of events.
inline constexpr engine::Kind kPocket = engine::kFirstObstacle;
inline constexpr engine::Kind kCushion = engine::kFirstObstacle + 1;
inline constexpr engine::Kind kJaw = engine::kFirstObstacle + 2;

[[nodiscard]] inline math::Vec<double> vec(const std::array<double, 2>& a) {
    return {a[0], a[1]};
}

/// The scene right after the strike; balls and obstacles numbered as in the record.
[[nodiscard]] inline engine::SceneData<ShotScene> shot_scene(const Record& record,
                                                             const Shot& shot) {
    using Law = RecordedCushion<double>::Law;
    const Balls& kind = record.balls.at(shot.balls);
    const Table& table = record.tables.at(shot.table);
    Builder<ShotScene> builder;
    for (const Segment& s : table.segments) {
        std::get<std::vector<geometry::Segment<double>>>(builder.scene.obstacles)
            .push_back(geometry::Segment<double>(vec(s.from), vec(s.to), false));
    }
    for (const Circle& jaw : table.arcs) builder.circle(vec(jaw.center), jaw.radius);
    for (const Circle& pocket : table.pockets) builder.rim(vec(pocket.center), pocket.radius);
    for (const State& state : shot.initial) {
        builder.ball(vec(state.position), vec(state.velocity), kind.radius, kind.mass);
        auto& body = builder.scene.bodies.back();
        body.state.radius = kind.radius;
        body.state.spin = {state.spin[0], state.spin[1], state.spin[2]};
    }
    auto& scene = builder.scene;
    scene.motion = {kind.sliding * kind.gravity, kind.rolling * kind.gravity,
                    kind.spinning * kind.gravity};

    scene.friction.ball_ball = {1, {}};
    if (shot.ball_law != "frictionless_elastic") {
        // The recorder's Coulomb limit is mu e dv instead of mu (1 + e) dv / 2.
        const double e = kind.ball_restitution;
        const double quirk = 2 * e / (1 + e);
        scene.friction.ball_ball = {e, {quirk * kind.ball_friction, 0, 0}};
        if (shot.ball_law == "frictional_inelastic") {
            scene.friction.ball_ball.friction = {quirk * 0.009951, quirk * 0.108, 1.088};
        }
    }
    const std::string& law = shot.cushion_law;
    scene.friction.ball_cushion = {law == "han_2005"                       ? Law::han_2005
                                   : law == "impulse_frictional_inelastic" ? Law::impulse
                                   : law == "stronge_compliant"            ? Law::stronge
                                                                           : Law::unrealistic,
                                   kind.cushion_restitution, kind.cushion_friction,
                                   table.segments[0].height};
    return scene;
}

/// "ball_segment cue 12", as the record has it; balls of a pair in the order of their ids.
[[nodiscard]] inline std::string event_text(std::string type, std::vector<std::string> ids) {
    if (type == "ball_ball") std::sort(ids.begin(), ids.end());
    for (const std::string& id : ids) type += " " + id;
    return type;
}

[[nodiscard]] inline const char* phase_name(motion::ClothPhase phase) {
    switch (phase) {
        case motion::ClothPhase::rest: return "stationary";
        case motion::ClothPhase::spinning: return "spinning";
        case motion::ClothPhase::rolling: return "rolling";
        case motion::ClothPhase::sliding: return "sliding";
    }
    return "";
}

/// An event of ours in the same words.
[[nodiscard]] inline std::string event_text(const Table& table, const Shot& shot,
                                            const engine::EventOf<ShotScene>& event) {
    const std::string& ball = shot.initial[event.first].ball;
    switch (event.kind) {
        case engine::kTransition:
            return event_text(std::string(phase_name(event.before[0].phase)) + "_" +
                                  phase_name(event.after[0].phase),
                              {ball});
        case engine::kBallBall:
            return event_text("ball_ball", {ball, shot.initial[event.second].ball});
        case kPocket: return event_text("ball_pocket", {ball, table.pockets[event.second].id});
        case kCushion: return event_text("ball_segment", {ball, table.segments[event.second].id});
        case kJaw: return event_text("ball_arc", {ball, table.arcs[event.second].id});
        default: return "unknown";
    }
}

}  // namespace osculo::support::pool_shots
