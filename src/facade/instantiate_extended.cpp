#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one engine for each motion law.

std::span<const ReadyEngine> extended_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<long double, Table, PieceRecorder, CellGrid>>(),
        ready_engine<RollingScene<long double, RollingPieces>>(),
        ready_engine<ResistedScene<long double, ResistedPieces>>(),
        ready_engine<RimsScene<long double, RimsPieces>>(),
        ready_engine<ClothScene<long double, impact::CushionSimple, ClothPieces>>(),
        ready_engine<ClothScene<long double, impact::CushionHan2005, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
