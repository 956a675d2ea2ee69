#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_table_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<double, Table, NoRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Table, EventRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Table, PieceRecorder, AllPairs>>(),
        ready_engine<UniformScene<double, Table, NoRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, Table, EventRecorder, CellGrid>>(),
        ready_engine<UniformScene<double, Table, PieceRecorder, CellGrid>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
