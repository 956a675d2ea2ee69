#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "compile_cue.hpp"
#include "compile_cushion.hpp"
#include "osculo/engine/engine.hpp"
#include "osculo/engine/scenes.hpp"
#include "osculo/scene.hpp"

namespace osculo::facade {

/// A scene in the terms of an engine. The engine numbers balls and obstacles in the order of their
/// ids, so that ties between events do not depend on the order in which a file lists them.
template <class Type>
struct CompiledScene {
    engine::SceneData<Type> data;
    std::vector<std::uint32_t> balls;  ///< engine's number -> index in the scene
    std::vector<std::uint32_t> segments;
    std::vector<std::uint32_t> arcs;
    std::vector<std::uint32_t> rims;          ///< that capture
    std::vector<std::uint32_t> pulling_rims;  ///< with another law
    std::vector<std::string> points;          ///< names of the end points, by the engine's number
};

/// The indices of things, sorted by id.
template <class Thing>
[[nodiscard]] std::vector<std::uint32_t> order_by_id(const std::vector<Thing>& things) {
    std::vector<std::uint32_t> order(things.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return things[a].id < things[b].id; });
    return order;
}

/// (cos angle, sin angle) in S, of the exact value of the double.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> direction(double angle) {
    if constexpr (std::is_same_v<S, math::Quad>) {
        // No elementary functions for this type: take 50 digits, in three doubles.
        using Wider = boost::multiprecision::cpp_bin_float_50;
        const auto to_quad = [](Wider x) {
            math::Quad sum = 0;
            for (int i = 0; i < 3; ++i) {
                const double part = static_cast<double>(x);
                sum += part;
                x -= part;
            }
            return sum;
        };
        return {to_quad(cos(Wider(angle))), to_quad(sin(Wider(angle)))};
    } else {
        using std::cos;
        using std::sin;
        return {S(cos(S(angle))), S(sin(S(angle)))};
    }
}

template <math::Scalar S>
[[nodiscard]] math::Vec<S> vec(const Point& p) {
    return {S(p.x), S(p.y)};
}

template <math::Scalar S>
[[nodiscard]] geometry::Arc<S> compile_arc(const Arc& arc) {
    geometry::Arc<S> result;
    result.center = vec<S>(arc.center);
    result.radius = S(arc.radius);
    result.start = direction<S>(arc.from_angle);
    result.end = direction<S>(arc.to_angle);
    const double sweep = arc.to_angle - arc.from_angle;
    result.full = sweep >= 2 * std::numbers::pi * (1 - 4 * 0x1p-52);
    result.reflex =
        sweep > 3.5 || (sweep > 3 && math::accurate_cross<S>(result.start, result.end) < S(0));
    return result;
}

/// Gathers end points; one that several things share is one obstacle.
template <math::Scalar S>
class PointCollector {
public:
    void add(const math::Vec<S>& at, std::string name) {
        const auto same = [&](const geometry::Point<S>& p) { return p.at == at; };
        if (std::any_of(points_.begin(), points_.end(), same)) return;
        points_.push_back({at});
        names_.push_back(std::move(name));
    }
    std::vector<geometry::Point<S>> points_;
    std::vector<std::string> names_;
};

/// How a ball slows down: what its motion law says and what a medium does to it.
template <math::Scalar S>
[[nodiscard]] motion::Resistance<S> compile_resistance(const Scene& scene, const Ball& ball) {
    if (const auto* rolling = std::get_if<RollingMotion>(&scene.motion)) {
        return {S(rolling->friction) * S(scene.gravity), S(0), S(0)};
    }
    if (!std::holds_alternative<ResistedMotion>(scene.motion)) return {};
    const auto& law = std::get<ResistedMotion>(scene.motion);
    motion::Resistance<S> result{S(law.constant), S(law.linear), S(law.quadratic)};
    if (law.medium) {
        const S mass(ball.mass);
        const S radius(ball.radius);
        const S pi = S(2) * math::quarter_turn<S>();
        const S share = law.medium->rolling ? S(S(1) / (S(1) + S(ball.inertia))) : S(1);
        result.linear += share * (S(6) * pi * S(law.medium->viscosity) * radius / mass);
        result.quadratic += share * (S(law.medium->density) * S(law.medium->drag_coefficient) * pi *
                                     radius * radius / (S(2) * mass));
    }
    return result;
}

/// Whether balls tip over the edges of rims.
template <class Type>
inline constexpr bool kTips = requires(typename Type::MotionParameters law) {
    law.restitutions;
};

/// The ball at the start, struck if the scene's cue strikes it.
template <class Type>
[[nodiscard]] engine::Body<Type> compile_ball(const Scene& scene, const Ball& ball) {
    using S = typename Type::Scalar;
    engine::Body<Type> body;
    body.state.position = math::WidePoint<S>(vec<S>(ball.position));
    body.state.velocity = vec<S>(ball.velocity);
    body.mass = S(ball.mass);
    body.radius = S(ball.radius);
    if constexpr (std::is_base_of_v<motion::Resisted, typename Type::Motion>) {
        body.state.law = compile_resistance<S>(scene, ball);
    }
    if constexpr (engine::kHasRims<typename Type::Motion>) body.state.ball_radius = S(ball.radius);
    if constexpr (kTips<Type>) {  // what rolls on the table does so on the edge
        const bool rolls = std::holds_alternative<RollingMotion>(scene.motion);
        body.state.inertia = rolls ? S(ball.inertia) : S(0);
    }
    if constexpr (Type::Motion::kSpin) {
        body.state.spin = {S(ball.spin[0]), S(ball.spin[1]), S(ball.spin[2])};
        body.state.radius = S(ball.radius);
        body.state.inertia = S(ball.inertia);
        if (scene.cue && scene.cue->ball == ball.id) {
            auto struck = impact::spinning_ball<S>(body);
            compile_cue<S>(*scene.cue).resolve(struck);
            impact::take<S>(struck, body);
        }
    }
    return body;
}

template <class Type>
void compile_laws(const Scene& scene, engine::SceneData<Type>& data) {
    using S = typename Type::Scalar;
    const BallBallImpact& balls = scene.impacts.ball_ball;
    const CushionImpact& cushion = scene.impacts.ball_cushion;
    data.ball_ball_restitution = S(balls.restitution);
    data.ball_cushion_restitution = S(cushion.restitution);
    const S g(scene.gravity);
    if constexpr (std::is_same_v<typename Type::Motion, motion::Rolling>) {
        data.motion.deceleration = S(std::get<RollingMotion>(scene.motion).friction) * g;
    }
    if constexpr (engine::kHasRims<typename Type::Motion>) {
        if (const auto* rolling = std::get_if<RollingMotion>(&scene.motion)) {
            data.motion.deceleration = S(rolling->friction) * g;
        }
        data.motion.gravity = g;
    }
    if constexpr (kTips<Type>) data.motion.contact_time = S(scene.impacts.contact_time);
    if constexpr (std::is_same_v<typename Type::Motion, motion::Cloth>) {
        const auto& cloth = std::get<ClothMotion>(scene.motion);
        data.motion = {S(cloth.sliding_friction) * g, S(cloth.rolling_friction) * g,
                       S(cloth.spinning_friction) * g};
        data.friction.ball_ball = {
            S(balls.restitution),
            {S(balls.friction[0]), S(balls.friction[1]), S(balls.friction[2])}};
        data.friction.ball_cushion =
            compile_cushion<decltype(data.friction.ball_cushion)>(cushion, cloth);
    }
    if constexpr (std::is_same_v<typename Type::Motion, motion::Disc>) {
        const bool frictional = cushion.law == CushionLaw::frictional;
        data.friction.ball_ball = {
            S(balls.restitution),
            {S(balls.friction[0]), S(balls.friction[1]), S(balls.friction[2])}};
        data.friction.ball_cushion = {S(cushion.restitution),
                                      frictional ? S(cushion.friction) : S(0)};
    }
    if constexpr (std::is_base_of_v<motion::Resisted, typename Type::Motion>) {
        // As fast as a ball is that has all the energy there is.
        S energy(0);
        for (const auto& body : data.bodies) {
            energy += body.mass * math::dot<S>(body.state.velocity, body.state.velocity) / S(2);
        }
        for (const auto& body : data.bodies) {
            const S speed = math::square_root<S>(S(2) * energy / body.mass);
            const auto& [constant, linear, quadratic] = body.state.law;
            data.motion.largest =
                std::max<S>(data.motion.largest, constant + speed * (linear + speed * quadratic));
        }
    }
    if constexpr (Type::Motion::kTransitions) data.contact_time = S(scene.impacts.contact_time);
}

/// As the scene says, or else by how fast its balls are at the start [m/s].
template <class Type>
[[nodiscard]] typename Type::Scalar rest_speed(const Scene& scene,
                                               const std::vector<engine::Body<Type>>& bodies) {
    using S = typename Type::Scalar;
    if (scene.impacts.rest_speed) return S(*scene.impacts.rest_speed);
    S fastest(0);
    for (const auto& body : bodies) {
        fastest = std::max<S>(fastest, math::norm<S>(body.state.velocity));
    }
    return S(Impacts::kRestShare) * fastest;
}

template <class Type>
[[nodiscard]] CompiledScene<Type> compile_scene(const Scene& scene) {
    using S = typename Type::Scalar;
    CompiledScene<Type> result;
    result.balls = order_by_id(scene.balls);
    for (const std::uint32_t i : result.balls) {
        result.data.bodies.push_back(compile_ball<Type>(scene, scene.balls[i]));
    }
    compile_laws(scene, result.data);
    if constexpr (Type::Simultaneous::kGathersCluster) {
        result.data.rest_speed = rest_speed<Type>(scene, result.data.bodies);
    }

    using List = typename Type::ObstacleList;
    constexpr bool kWalls = List::template kContains<S, geometry::Segment<S>>;
    constexpr bool kTable = List::template kContains<S, geometry::Arc<S>>;
    PointCollector<S> points;
    if constexpr (kWalls) {
        result.segments = order_by_id(scene.segments);
        auto& segments = std::get<std::vector<geometry::Segment<S>>>(result.data.obstacles);
        for (const std::uint32_t k : result.segments) {
            const Segment& s = scene.segments[k];
            segments.emplace_back(vec<S>(s.from), vec<S>(s.to), s.side == Side::left);
            points.add(vec<S>(s.from), s.id + ".from");
            points.add(vec<S>(s.to), s.id + ".to");
        }
    }
    if constexpr (kTable) {
        result.arcs = order_by_id(scene.arcs);
        auto& arcs = std::get<std::vector<geometry::Arc<S>>>(result.data.obstacles);
        for (const std::uint32_t k : result.arcs) {
            arcs.push_back(compile_arc<S>(scene.arcs[k]));
            if (arcs.back().full) continue;
            points.add(arcs.back().start_point(), scene.arcs[k].id + ".from");
            points.add(arcs.back().end_point(), scene.arcs[k].id + ".to");
        }
        const auto pulls = [&](std::uint32_t k) { return scene.rims[k].law != RimLaw::capture; };
        result.rims = order_by_id(scene.rims);
        std::copy_if(result.rims.begin(), result.rims.end(),
                     std::back_inserter(result.pulling_rims), pulls);
        std::erase_if(result.rims, pulls);
        const auto rim = [&](std::uint32_t k) {
            return geometry::Rim<S>{vec<S>(scene.rims[k].center), S(scene.rims[k].radius)};
        };
        auto& rims = std::get<std::vector<geometry::Rim<S>>>(result.data.obstacles);
        for (const std::uint32_t k : result.rims) rims.push_back(rim(k));
        if constexpr (engine::kHasRims<typename Type::Motion>) {
            for (const std::uint32_t k : result.pulling_rims) {
                result.data.motion.rims.push_back({rim(k)});
                if constexpr (kTips<Type>) {
                    result.data.motion.restitutions.push_back(S(scene.rims[k].restitution.value_or(
                        scene.impacts.ball_cushion.restitution)));
                }
            }
            std::get<std::vector<geometry::PullingRim<S>>>(result.data.obstacles) =
                result.data.motion.rims;
        }
    }
    if constexpr (kWalls) {
        std::get<std::vector<geometry::Point<S>>>(result.data.obstacles) =
            std::move(points.points_);
        result.points = std::move(points.names_);
    }
    return result;
}

}  // namespace osculo::facade
