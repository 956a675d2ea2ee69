#pragma once

#include "osculo/impact/cushion_han_2005.hpp"
#include "osculo/impact/cushion_simple.hpp"
#include "osculo/scene.hpp"

namespace osculo::facade {

/// Reads a scene's cushion as one of the laws. Laws that only one file knows are specialised there.
template <class Law>
struct CushionFrom;

template <math::Scalar S>
struct CushionFrom<impact::CushionSimple<S>> {
    static impact::CushionSimple<S> make(const CushionImpact& c, const ClothMotion&) {
        return {S(c.restitution), S(0)};
    }
};
template <math::Scalar S>
struct CushionFrom<impact::CushionHan2005<S>> {
    static impact::CushionHan2005<S> make(const CushionImpact& c, const ClothMotion&) {
        return {S(c.restitution), S(c.friction), S(c.height)};
    }
};

template <class Law>
[[nodiscard]] Law compile_cushion(const CushionImpact& cushion, const ClothMotion& cloth) {
    return CushionFrom<Law>::make(cushion, cloth);
}

}  // namespace osculo::facade
