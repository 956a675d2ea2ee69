#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_disc_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<DiscScene<double, NoRecorder, impact::Symmetric>>(),
        ready_engine<DiscScene<double, DiscPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
