#include "osculo/engine/audit.hpp"
#include "osculo/engine/scenes.hpp"

/// An audit of a run that recorded its events only, unless there is no mistake.
template <osculo::math::Scalar S>
using Recorder = std::conditional_t<OSCULO_MISTAKE, osculo::engine::EventRecorder<S>,
                                    osculo::engine::PieceRecorder<S>>;

using Type =
    osculo::engine::UniformScene<double, osculo::engine::Walls, Recorder, osculo::engine::AllPairs>;

bool clean(const osculo::engine::SceneData<Type>& scene, osculo::engine::Engine<Type>& engine) {
    return osculo::engine::audit<Type>(scene, engine.recorder(), engine.bodies(), engine.time())
        .clean;
}
