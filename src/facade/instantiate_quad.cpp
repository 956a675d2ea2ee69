#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one engine for each motion law.

std::span<const ReadyEngine> quad_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<math::Quad, Table, PieceRecorder, CellGrid>>(),
        ready_engine<RollingScene<math::Quad, RollingPieces>>(),
        ready_engine<ResistedScene<math::Quad, ResistedPieces>>(),
        ready_engine<RimsScene<math::Quad, RimsPieces>>(),
        ready_engine<ClothScene<math::Quad, impact::CushionSimple, ClothPieces>>(),
        ready_engine<ClothScene<math::Quad, impact::CushionHan2005, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
