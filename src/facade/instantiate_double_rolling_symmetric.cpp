#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_rolling_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<RollingScene<double, NoRecorder, impact::Symmetric>>(),
        ready_engine<RollingScene<double, RollingEvents, impact::Symmetric>>(),
        ready_engine<RollingScene<double, RollingPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
