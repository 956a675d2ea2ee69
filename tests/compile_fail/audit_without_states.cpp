#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"

/// An audit of curved pieces that recorded places and velocities only, unless there is no mistake.
template <osculo::math::Scalar S>
using Recorder = std::conditional_t<OSCULO_MISTAKE, osculo::engine::PieceRecorder<S>,
                                    osculo::engine::RollingPieces<S>>;

using Type = osculo::engine::RollingScene<double, Recorder>;

bool clean(const osculo::engine::SceneData<Type>& scene, osculo::engine::Engine<Type>& engine) {
    return osculo::engine::audit<Type>(scene, engine.recorder(), engine.bodies(), engine.time())
        .clean;
}
