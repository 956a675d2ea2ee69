#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_walls_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<double, Walls, NoRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Walls, EventRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Walls, PieceRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Walls, NoRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, Walls, EventRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, Walls, PieceRecorder, CellGrid>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
