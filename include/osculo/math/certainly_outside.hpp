#pragma once

#include <algorithm>

#include "osculo/math/vec.hpp"

namespace osculo::math {

/// True only if c + b t + a t^2 stays farther than s from the origin for 0 <= t <= end, told
/// without a root: across its first direction or along its first place, in which its distance is a
/// linear function of t^2 and a quadratic one of t (NUMERICS 1.5, R3 and R2).
///
/// [place] and [speed] are at least |c|_1 and |b|_1: bounds of the absolute terms that c and b are
/// sums of. [slack]: rounding of a sum over its absolute terms. Requires finite end >= 0.
template <Scalar S>
[[nodiscard]] bool certainly_outside(const Vec<S>& c, const Vec<S>& b, const Vec<S>& a, const S& s,
                                     const S& end, const S& place, const S& speed, const S& slack) {
    const S ss = s * s;
    const S curve = norm1<S>(a) * end * end;
    const S across = cross<S>(b, c);
    const S across_end = across + cross<S>(b, a) * end * end;
    if ((across > S(0)) == (across_end > S(0))) {
        const S least =
            std::min<S>(abs<S>(across), abs<S>(across_end)) - slack * (speed * (place + curve));
        const S bb = dot<S>(b, b) + (slack * speed) * speed;
        if (least > S(0) && least * least > ss * bb * (S(1) + slack)) return true;
    }
    const S cc = dot<S>(c, c);
    const S cb = dot<S>(c, b);
    const S ca = dot<S>(c, a);
    S least = std::min<S>(cc, cc + end * (cb + end * ca));
    if (ca > S(0) && cb < S(0) && -cb < S(2) * ca * end) {
        least = std::min<S>(least, cc - cb * cb / (S(4) * ca));
    }
    least -= slack * (norm1<S>(c) * (place + speed * end + curve));
    return least > S(0) && least * least > ss * cc * (S(1) + slack);
}

}  // namespace osculo::math
