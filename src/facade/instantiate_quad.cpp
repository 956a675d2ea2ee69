#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one obstacle list and one broad phase will do.

std::span<const ReadyEngine> quad_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<math::Quad, Table, NoRecorder, CellGrid>(),
        ready_engine<math::Quad, Table, EventRecorder, CellGrid>(),
        ready_engine<math::Quad, Table, PieceRecorder, CellGrid>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
