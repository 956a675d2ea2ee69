#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionSimple, NoRecorder, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionSimple, ContactRecorder, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionSimple, ClothEvents, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionSimple, ClothPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
