#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one obstacle list and one broad phase will do.

std::span<const ReadyEngine> extended_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<long double, Table, NoRecorder, CellGrid>(),
        ready_engine<long double, Table, EventRecorder, CellGrid>(),
        ready_engine<long double, Table, PieceRecorder, CellGrid>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
