#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_walls_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<double, Walls, NoRecorder, AllPairs>(),
        ready_engine<double, Walls, EventRecorder, AllPairs>(),
        ready_engine<double, Walls, PieceRecorder, AllPairs>(),
        ready_engine<double, Walls, NoRecorder, CellGrid>(),
        ready_engine<double, Walls, EventRecorder, CellGrid>(),
        ready_engine<double, Walls, PieceRecorder, CellGrid>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
