#pragma once

#include "osculo/impact/mathavan/step.hpp"

namespace osculo::impact::mathavan {

/// A contact holds until the friction it needs exceeds the limit by this much, relatively, and is
/// held from the beginning if half of it suffices: at the limit itself it would leave with no
/// acceleration, and the series would have no direction. What slip this takes away is the square of
/// it.
template <math::Scalar S>
[[nodiscard]] S hold_margin() {
    // 2^-28; for wider types, smaller ones would only make breaking loose stiffer.
    return S(0x1p-28);
}

/// Direction in which the cushion's slip leaves zero while the cloth slips along [c0]: the d with
/// pull - mu M d = rate d, rate > 0, found by bisection of |(mu M + rate)^-1 pull| = 1, which falls
/// as the rate grows.
template <math::Scalar S>
[[nodiscard]] math::Vec<S> leaving_direction(const Constants<S>& k, const math::Vec<S>& c0) {
    const S& mu = k.cushion_friction;
    const S cm = k.cloth_friction * k.c;
    const math::Vec<S> pull(-k.s * k.c + k.b * k.cloth_friction * k.s * c0.x(),
                            -k.h * k.cloth_friction * k.s * c0.y());
    const auto direction = [&](const S& rate) {
        const S x = pull.x() / (mu * (k.a + k.b * cm * c0.x()) + rate);
        return math::Vec<S>(x, (pull.y() + mu * k.h * cm * c0.y() * x) / (mu * k.d + rate));
    };
    S low(0);
    S high = math::norm<S>(pull) * (S(2) + mu * k.h * cm);
    for (int i = 0; i < math::ScalarTraits<S>::kDigits; ++i) {
        const S middle = (low + high) * S(0.5);
        const math::Vec<S> d = direction(middle);
        (math::dot<S>(d, d) > S(1) ? low : high) = middle;
    }
    const math::Vec<S> d = direction(high);
    return d / math::norm<S>(d);
}

/// Sets the modes of a step from the slips at its beginning, and the directions of what leaves.
/// [cushion_zero], [cloth_zero]: there is no slip.
template <math::Scalar S>
void choose_modes(Step<S>& step, bool cushion_zero, bool cloth_zero) {
    using Vec = math::Vec<S>;
    const Constants<S>& k = step.k;
    const S holds = S(1) + hold_margin<S>() / S(2);
    const S limit = k.cushion_friction * holds;
    const Vec back(S(-1), S(0));
    const auto leave = [](Mode& mode, SlipSeries<S>& series, Mode how, const Vec& d) {
        mode = how;
        series.set_direction(0, d);
    };
    const auto slide_or_lift = [&](const S& fp) {
        step.at_cloth = k.press(fp) > S(0) ? Mode::slipping : Mode::lifted;
    };

    step.at_cushion = Mode::slipping;
    if (cushion_zero && cloth_zero) {
        // Nothing acts along t: all is confined to n and p.
        const Vec held = k.holding_at_cushion(back);
        const bool pressed = k.press(held.x()) > S(0);
        if (!(math::abs<S>(held.x()) > limit)) {
            step.at_cushion = Mode::sticking;
            return leave(step.at_cloth, step.cloth, pressed ? Mode::straight : Mode::lifted, back);
        }
        const Vec d(pressed ? -1 : 1, 0);
        leave(step.at_cushion, step.cushion, Mode::straight, d);
        const S fp = k.cushion_friction * d.x();
        const S needed = k.holding_at_cloth(Vec(fp, S(0))).x();
        if (!(k.press(fp) > S(0))) {
            step.at_cloth = Mode::lifted;
        } else if (!(math::abs<S>(needed) > k.cloth_friction * k.press(fp) * holds)) {
            step.at_cloth = Mode::sticking;
        } else {
            leave(step.at_cloth, step.cloth, Mode::straight, Vec(needed < S(0) ? -1 : 1, 0));
        }
    } else if (cushion_zero) {
        const Vec c0 = step.cloth.slip(0) / math::norm<S>(step.cloth.slip(0));
        const Vec held = k.holding_at_cushion(c0);
        if (!(math::norm<S>(held) > limit)) {
            step.at_cushion = Mode::sticking;
            return slide_or_lift(held.x());
        }
        const Vec d = leaving_direction<S>(k, c0);
        leave(step.at_cushion, step.cushion, Mode::leaving, d);
        slide_or_lift(k.cushion_friction * d.x());
        if (step.at_cloth == Mode::lifted) {
            leave(step.at_cushion, step.cushion, Mode::straight, Vec(k.s < S(0) ? 1 : -1, 0));
        }
    } else {
        const Vec f =
            (k.cushion_friction / math::norm<S>(step.cushion.slip(0))) * step.cushion.slip(0);
        slide_or_lift(f.x());
        if (!cloth_zero || step.at_cloth == Mode::lifted) return;
        const Vec needed = k.holding_at_cloth(f);
        const S size = math::norm<S>(needed);
        if (!(size > k.cloth_friction * k.press(f.x()) * holds)) {
            step.at_cloth = Mode::sticking;
        } else {
            leave(step.at_cloth, step.cloth, Mode::leaving, needed / size);
        }
    }
}

}  // namespace osculo::impact::mathavan
