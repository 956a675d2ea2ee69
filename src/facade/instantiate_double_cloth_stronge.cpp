#include "cushion_stronge.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_stronge_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionStronge, NoRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionStronge, ContactRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionStronge, ClothEvents>>(),
        ready_engine<ClothScene<double, impact::CushionStronge, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
