#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_rims_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<RimsScene<double, NoRecorder>>(),
        ready_engine<RimsScene<double, RimsEvents>>(),
        ready_engine<RimsScene<double, RimsPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
