#pragma once

#include <concepts>
#include <tuple>
#include <type_traits>
#include <vector>

#include "osculo/detect/ball_arc.hpp"
#include "osculo/detect/ball_arc_parabolic.hpp"
#include "osculo/detect/ball_ball.hpp"
#include "osculo/detect/ball_point.hpp"
#include "osculo/detect/ball_rim.hpp"
#include "osculo/detect/ball_segment.hpp"
#include "osculo/detect/ball_segment_parabolic.hpp"
#include "osculo/detect/certainly_apart.hpp"
#include "osculo/detect/on_rims.hpp"
#include "osculo/detect/resisted.hpp"
#include "osculo/impact/restitution.hpp"
#include "osculo/impact/simultaneous.hpp"

namespace osculo::engine {

// Contacts are looked up here and, by their arguments, where an obstacle or a path comes from:
// kinds defined outside of osculo bring their overloads along.
using detect::contact_normal;
using detect::first_contact;

/// What happens when a ball meets an obstacle of a kind. Specialise for kinds that take the ball or
/// that it gets into.
enum class Effect { impact, capture, entry };
template <class Obstacle>
inline constexpr Effect kEffect = Effect::impact;
template <math::Scalar S>
inline constexpr Effect kEffect<geometry::Rim<S>> = Effect::capture;
template <math::Scalar S>
inline constexpr Effect kEffect<geometry::PullingRim<S>> = Effect::entry;

/// Whether a motion law has rims that pull (motion/with_rims.hpp).
template <class Motion>
inline constexpr bool kHasRims = requires {
    Motion::kRims;
};

/// True of kinds so long that most paths that meet anything end at them.
template <class Obstacle>
inline constexpr bool kEndsMostPaths = false;
template <math::Scalar S>
inline constexpr bool kEndsMostPaths<geometry::Segment<S>> = true;

/// The kinds of obstacles of a scene type, each a template over the scalar, in the order in which
/// they come at one instant.
template <template <class> class... Kinds>
struct Obstacles {
    static constexpr std::size_t kCount = sizeof...(Kinds);
    template <class S, class Obstacle>
    static constexpr bool kContains = (std::is_same_v<Kinds<S>, Obstacle> || ...);
    template <class S>
    using Storage = std::tuple<std::vector<Kinds<S>>...>;
};

/// True if there is an overload of first_contact for balls on paths of that kind.
template <class S, class Path, class Obstacle>
concept Detectable = requires(const Path& path, const S& s, const Obstacle& obstacle,
                              const math::ContactHistory<S>& history,
                              const math::WidePoint<S>& position) {
    { first_contact(path, s, obstacle, history, s) } -> std::convertible_to<S>;
    { contact_normal(position, obstacle) } -> std::convertible_to<math::Vec<S>>;
};

/// A scene type: everything about a scene that is known when the engine is compiled, the engine's
/// only parameter. What is not listed leaves neither state nor code.
template <math::Scalar S, class MotionLaw, class ObstacleKinds, class ImpactLaw,
          class SimultaneousLaw, template <class> class RecorderKind,
          template <class> class BroadPhaseKind>
struct SceneType {
    using Scalar = S;
    using Motion = MotionLaw;
    using State = typename MotionLaw::template State<S>;
    using ObstacleList = ObstacleKinds;
    using ObstacleStorage = typename ObstacleKinds::template Storage<S>;
    using Impact = ImpactLaw;
    using MotionParameters = typename MotionLaw::template Parameters<S>;
    using Simultaneous = SimultaneousLaw;
    using Recorder = RecorderKind<S>;
    using BroadPhase = BroadPhaseKind<S>;
};

}  // namespace osculo::engine
