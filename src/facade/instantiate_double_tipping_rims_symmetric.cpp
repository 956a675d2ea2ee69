#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_tipping_rims_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<TippingRimsScene<double, NoRecorder, impact::Symmetric>>(),
        ready_engine<TippingRimsScene<double, TippingRimsEvents, impact::Symmetric>>(),
        ready_engine<TippingRimsScene<double, TippingRimsPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
