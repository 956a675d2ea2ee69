#include "cushion_mathavan.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_mathavan_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionMathavan2010, NoRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ContactRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ClothEvents>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
