#pragma once

#include "osculo/detect/certified_crossing.hpp"
#include "osculo/geometry/segment.hpp"

namespace osculo::detect {

/// First contact of a ball on a certified path with the straight part of a segment before the path
/// ends, or never(): from either side of a two-sided segment, whichever side it starts on, and also
/// after having passed it beside its ends. See first_certified().
template <math::Scalar S, class Path>
requires motion::CertifiedPath<Path, S>
[[nodiscard]] S first_contact(const Path& path, const S& radius,
                              const geometry::Segment<S>& segment,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const FromPoint<S, Path> from{path, segment.from};
    const LocalParabola<S> start = from.parabola(S(0));
    const S side = math::accurate_dot<S>(start.c, segment.normal);
    const S speed = math::norm1<S>(start.b);
    const S last = certified_last<S>(path.end, S(math::norm1<S>(start.c) + radius), speed);
    S best = math::never<S>();
    S until = beyond<S>(horizon);
    for (const bool left : {true, false}) {
        if (!left && segment.one_sided) break;
        const math::Vec<S> normal = left ? segment.normal : math::Vec<S>(-segment.normal);
        const bool starts_here = left ? side >= S(0) : side < S(0);
        const LineCrossing<FromPoint<S, Path>> crossing{from, normal, radius, false};
        const bool touching = starts_here && detail::only_touches(crossing, history);
        const S t = detail::first_accepted(
            crossing, !starts_here, last, until, touching, history.noise, [&](const S& at) {
                const S foot = math::dot<S>(from.at(at).position.rounded(), segment.tangent);
                return foot >= S(0) && foot <= segment.length;
            });
        if (!math::is_finite<S>(t)) continue;
        best = until = t;
    }
    return best;
}

}  // namespace osculo::detect
