#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_tipping_rims_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<TippingRimsScene<double, NoRecorder>>(),
        ready_engine<TippingRimsScene<double, TippingRimsEvents>>(),
        ready_engine<TippingRimsScene<double, TippingRimsPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
