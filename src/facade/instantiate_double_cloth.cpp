#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionSimple, NoRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionSimple, ContactRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionSimple, ClothEvents>>(),
        ready_engine<ClothScene<double, impact::CushionSimple, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
