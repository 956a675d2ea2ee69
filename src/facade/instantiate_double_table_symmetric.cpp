#include "run_engine.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> double_table_symmetric_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<double, Table, NoRecorder, AllPairs, impact::Symmetric>>(),
        ready_engine<UniformScene<double, Table, EventRecorder, AllPairs, impact::Symmetric>>(),
        ready_engine<UniformScene<double, Table, PieceRecorder, AllPairs, impact::Symmetric>>(),
        ready_engine<UniformScene<double, Table, NoRecorder, CellGrid, impact::Symmetric>>(),
        ready_engine<UniformScene<double, Table, EventRecorder, CellGrid, impact::Symmetric>>(),
        ready_engine<UniformScene<double, Table, PieceRecorder, CellGrid, impact::Symmetric>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
