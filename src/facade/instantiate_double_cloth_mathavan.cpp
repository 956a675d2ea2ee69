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

std::span<const ReadyEngine> double_cloth_mathavan_engines() {
    using namespace engine;
    static const std::array kEngines{
        ready_engine<ClothScene<double, impact::CushionMathavan2010, NoRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ContactRecorder>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ClothEvents>>(),
        ready_engine<ClothScene<double, impact::CushionMathavan2010, ClothPieces>>(),
    };
    return kEngines;
}

}  // namespace osculo::facade
