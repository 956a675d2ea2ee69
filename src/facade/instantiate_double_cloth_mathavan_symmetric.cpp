#include "cushion_mathavan.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_mathavan_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<
            ClothScene<double, impact::CushionMathavan2010, NoRecorder, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionMathavan2010, ContactRecorder, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionMathavan2010, ClothEvents, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionMathavan2010, ClothPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
