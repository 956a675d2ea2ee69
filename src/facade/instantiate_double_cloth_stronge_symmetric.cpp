#include "cushion_stronge.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_cloth_stronge_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionStronge, NoRecorder, impact::Symmetric>>(),
        ready_engine<
            ClothScene<double, impact::CushionStronge, ContactRecorder, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionStronge, ClothEvents, impact::Symmetric>>(),
        ready_engine<ClothScene<double, impact::CushionStronge, ClothPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
