#pragma once

#include "osculo/engine/engine.hpp"
#include "osculo/motion/uniform.hpp"

/// The ready-made scene types, narrowest first.
namespace osculo::engine {

using NoObstacles = Obstacles<>;
using Walls = Obstacles<geometry::Segment, geometry::Point>;
using Table = Obstacles<geometry::Rim, geometry::Segment, geometry::Arc, geometry::Point>;

/// Free flight with restitution.
template <math::Scalar S, class ObstacleKinds, template <class> class RecorderKind,
          template <class> class BroadPhaseKind>
using UniformScene = SceneType<S, motion::Uniform, ObstacleKinds, impact::Restitution,
                               impact::Sequential, RecorderKind, BroadPhaseKind>;

}  // namespace osculo::engine
