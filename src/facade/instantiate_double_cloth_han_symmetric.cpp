#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_han_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionHan2005, NoRecorder, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionHan2005, ContactRecorder, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionHan2005, ClothEvents, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionHan2005, ClothPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
