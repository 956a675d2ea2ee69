#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_open_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<double, NoObstacles, NoRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, NoObstacles, EventRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, NoObstacles, PieceRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, NoObstacles, NoRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, NoObstacles, EventRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, NoObstacles, PieceRecorder, CellGrid>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
