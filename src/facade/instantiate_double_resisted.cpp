#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_resisted_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ResistedScene<double, NoRecorder>>(),
        ready_engine<ResistedScene<double, ResistedEvents>>(),
        ready_engine<ResistedScene<double, ResistedPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
