#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one engine for each motion law.

std::span<const ReadyEngine> extended_symmetric_engines() {
    using namespace engine;
    using S = long double;
    static const std::array kEngines{
        ready_engine<UniformScene<S, Table, PieceRecorder, CellGrid, impact::Symmetric>>(),
        ready_engine<RollingScene<S, RollingPieces, impact::Symmetric>>(),
        ready_engine<ResistedScene<S, ResistedPieces, impact::Symmetric>>(),
        ready_engine<RimsScene<S, RimsPieces, impact::Symmetric>>(),
        ready_engine<ClothScene<S, impact::CushionSimple, ClothPieces, impact::Symmetric>>(),
        ready_engine<ClothScene<S, impact::CushionHan2005, ClothPieces, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
