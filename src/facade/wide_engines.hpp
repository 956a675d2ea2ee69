#pragma once

#include "run_engine.hpp"

namespace osculo::facade {

/// The engines of a type wider than double. They are for checking, not for speed: one for each
/// motion law and elementary cushion, which keeps everything.
template <math::Scalar S, class Simultaneous>
[[nodiscard]] std::span<const ReadyEngine> wide_engines() {
    using namespace engine;
    using impact::CushionHan2005;
    using impact::CushionSimple;
    static const std::array kEngines{
        ready_engine<UniformScene<S, Table, PieceRecorder, CellGrid, Simultaneous>>(),
        ready_engine<RollingScene<S, RollingPieces, Simultaneous>>(),
        ready_engine<ResistedScene<S, ResistedPieces, Simultaneous>>(),
        ready_engine<RimsScene<S, RimsPieces, Simultaneous>>(),
        ready_engine<TippingRimsScene<S, TippingRimsPieces, Simultaneous>>(),
        ready_engine<ClothScene<S, CushionSimple, ClothPieces, Simultaneous>>(),
        ready_engine<ClothScene<S, CushionHan2005, ClothPieces, Simultaneous>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
