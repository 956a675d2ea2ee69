#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_han_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionHan2005, NoRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionHan2005, ContactRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionHan2005, ClothEvents>>(),
        ready_engine<ClothScene<double, impact::CushionHan2005, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
