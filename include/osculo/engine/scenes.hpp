#pragma once

#include "osculo/engine/engine.hpp"
#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/impact/disc_friction.hpp"
#include "osculo/impact/frictional.hpp"
#include "osculo/motion/cloth.hpp"
#include "osculo/motion/disc.hpp"
#include "osculo/motion/rolling.hpp"
#include "osculo/motion/uniform.hpp"
#include "osculo/motion/with_rims.hpp"
#include "osculo/motion/with_tipping_rims.hpp"

/// The ready-made scene types, narrowest first.
namespace osculo::engine {

using NoObstacles = Obstacles<>;
using Walls = Obstacles<geometry::Segment, geometry::Point>;
using Table = Obstacles<geometry::Rim, geometry::Segment, geometry::Arc, geometry::Point>;
/// A table with rims that pull.
using PullingTable = Obstacles<geometry::PullingRim, geometry::Rim, geometry::Segment,
                               geometry::Arc, geometry::Point>;

// Contacts of one instant are resolved pair by pair unless the scene type says impact::Symmetric,
// which is what scenes of the facade say unless they choose otherwise.

/// Free flight with restitution.
template <math::Scalar S, class ObstacleKinds, template <class> class RecorderKind,
          template <class> class BroadPhaseKind, class Simultaneous = impact::Sequential>
using UniformScene = SceneType<S, motion::Uniform, ObstacleKinds, impact::Restitution, Simultaneous,
                               RecorderKind, BroadPhaseKind>;

/// Rolling to rest, with restitution.
template <math::Scalar S, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using RollingScene =
    SceneType<S, motion::Rolling, Table, impact::Restitution, Simultaneous, RecorderKind, AllPairs>;

/// Slowing down by drag, with restitution.
template <math::Scalar S, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using ResistedScene = SceneType<S, motion::Resisted, Table, impact::Restitution, Simultaneous,
                                RecorderKind, AllPairs>;

/// Discs that turn about the vertical, with friction between boundaries. Without drag they are in
/// free flight, with a constant deceleration alone they slide to rest.
template <math::Scalar S, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using DiscScene =
    SceneType<S, motion::Disc, Table, impact::DiscFriction, Simultaneous, RecorderKind, AllPairs>;

/// Rims that pull; rolling to rest, or free flight if nothing slows balls down.
template <math::Scalar S, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using RimsScene = SceneType<S, motion::WithRims<motion::Rolling>, PullingTable, impact::Restitution,
                            Simultaneous, RecorderKind, AllPairs>;

/// Rims over whose edge balls tip, likewise.
template <math::Scalar S, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using TippingRimsScene = SceneType<S, motion::WithTippingRims<motion::Rolling>, PullingTable,
                                   impact::Restitution, Simultaneous, RecorderKind, AllPairs>;

/// Impact laws of balls with spin: friction between balls, and a cushion law.
template <template <class> class Cushion>
struct WithFriction {
    static constexpr const char* kName = Cushion<double>::kName;

    template <math::Scalar S>
    struct Laws {
        impact::Frictional<S> ball_ball;
        Cushion<S> ball_cushion;
    };
};

/// A cloth, with friction everywhere.
template <math::Scalar S, template <class> class Cushion, template <class> class RecorderKind,
          class Simultaneous = impact::Sequential>
using ClothScene =
    SceneType<S, motion::Cloth, Table, WithFriction<Cushion>, Simultaneous, RecorderKind, AllPairs>;

template <math::Scalar S>
using RollingEvents = StateRecorder<S, motion::Rolling::State<S>, false>;
template <math::Scalar S>
using RollingPieces = StateRecorder<S, motion::Rolling::State<S>, true>;
template <math::Scalar S>
using ResistedEvents = StateRecorder<S, motion::Resisted::State<S>, false>;
template <math::Scalar S>
using ResistedPieces = StateRecorder<S, motion::Resisted::State<S>, true>;
template <math::Scalar S>
using DiscPieces = StateRecorder<S, motion::Disc::State<S>, true>;
template <math::Scalar S>
using RimsEvents = StateRecorder<S, motion::WithRims<motion::Rolling>::State<S>, false>;
template <math::Scalar S>
using RimsPieces = StateRecorder<S, motion::WithRims<motion::Rolling>::State<S>, true>;
template <math::Scalar S>
using TippingRimsEvents =
    StateRecorder<S, motion::WithTippingRims<motion::Rolling>::State<S>, false>;
template <math::Scalar S>
using TippingRimsPieces =
    StateRecorder<S, motion::WithTippingRims<motion::Rolling>::State<S>, true>;
template <math::Scalar S>
using ClothEvents = StateRecorder<S, motion::Cloth::State<S>, false>;
template <math::Scalar S>
using ClothPieces = StateRecorder<S, motion::Cloth::State<S>, true>;

}  // namespace osculo::engine
