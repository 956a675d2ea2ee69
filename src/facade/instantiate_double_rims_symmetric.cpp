#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_rims_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<RimsScene<double, NoRecorder, impact::Symmetric>>(),
        ready_engine<RimsScene<double, RimsEvents, impact::Symmetric>>(),
        ready_engine<RimsScene<double, RimsPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
