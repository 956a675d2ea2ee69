#include "run_engine.hpp"

namespace osculo::facade {
// The wider types are for checking, not for speed: one engine for each motion law.

std::span<const ReadyEngine> digits100_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<UniformScene<boost::multiprecision::cpp_bin_float_100, Table, PieceRecorder,
                                  CellGrid>>(),
        ready_engine<RollingScene<boost::multiprecision::cpp_bin_float_100, RollingPieces>>(),
        ready_engine<ResistedScene<boost::multiprecision::cpp_bin_float_100, ResistedPieces>>(),
        ready_engine<RimsScene<boost::multiprecision::cpp_bin_float_100, RimsPieces>>(),
        ready_engine<ClothScene<boost::multiprecision::cpp_bin_float_100, impact::CushionSimple,
                                ClothPieces>>(),
        ready_engine<ClothScene<boost::multiprecision::cpp_bin_float_100, impact::CushionHan2005,
                                ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
