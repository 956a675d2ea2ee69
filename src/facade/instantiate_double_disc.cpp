#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_disc_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<DiscScene<double, NoRecorder>>(),
        ready_engine<DiscScene<double, DiscPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
