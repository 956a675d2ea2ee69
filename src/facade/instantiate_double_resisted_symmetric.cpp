#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_resisted_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ResistedScene<double, NoRecorder, impact::Symmetric>>(),
        ready_engine<ResistedScene<double, ResistedEvents, impact::Symmetric>>(),
        ready_engine<ResistedScene<double, ResistedPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
