#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one obstacle list and one broad phase will do.

std::span<const ReadyEngine> digits100_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<boost::multiprecision::cpp_bin_float_100, Table, NoRecorder, CellGrid>(),
        ready_engine<boost::multiprecision::cpp_bin_float_100, Table, EventRecorder, CellGrid>(),
        ready_engine<boost::multiprecision::cpp_bin_float_100, Table, PieceRecorder, CellGrid>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
