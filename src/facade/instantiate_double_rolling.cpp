#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_rolling_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<RollingScene<double, NoRecorder>>(),
        ready_engine<RollingScene<double, RollingEvents>>(),
        ready_engine<RollingScene<double, RollingPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
