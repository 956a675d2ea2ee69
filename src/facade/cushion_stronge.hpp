#pragma once

#include "osculo/impact/cushion_stronge.hpp"
#include "run_engine.hpp"

namespace osculo::facade {

template <math::Scalar S>
struct CushionFrom<impact::CushionStronge<S>> {
    static impact::CushionStronge<S> make(const CushionImpact& c, const ClothMotion&) {
        return {S(c.restitution), S(c.friction), S(c.height), S(c.frequency_ratio)};
    }
};
template <>
inline constexpr CushionLaw kCushionLaw<engine::WithFriction<impact::CushionStronge>> =
    CushionLaw::stronge;

}  // namespace osculo::facade
