#pragma once

#include "osculo/impact/cushion_mathavan_2010.hpp"
#include "run_engine.hpp"

namespace osculo::facade {

template <math::Scalar S>
struct CushionFrom<impact::CushionMathavan2010<S>> {
    static impact::CushionMathavan2010<S> make(const CushionImpact& c, const ClothMotion& cloth) {
        return {S(c.restitution), S(c.friction), S(c.height),
                S(c.cloth_friction.value_or(cloth.sliding_friction))};
    }
};
template <>
inline constexpr CushionLaw kCushionLaw<engine::WithFriction<impact::CushionMathavan2010>> =
    CushionLaw::mathavan_2010;

}  // namespace osculo::facade
