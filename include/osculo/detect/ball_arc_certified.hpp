#pragma once

#include "osculo/detect/ball_arc.hpp"
#include "osculo/detect/certified_crossing.hpp"

namespace osculo::detect {

/// First contact of a ball on a certified path with the circular part of an arc before the path
/// ends, from outside or from inside, or never(). Crossings of its circles through its opening are
/// none; what comes after them is looked at. See first_certified().
template <math::Scalar S, class Path>
requires motion::CertifiedPath<Path, S>
[[nodiscard]] S first_contact(const Path& path, const S& radius, const geometry::Arc<S>& arc,
                              const math::ContactHistory<S>& history, const S& horizon) {
    const FromPoint<S, Path> from{path, arc.center};
    const LocalParabola<S> start = from.parabola(S(0));
    const bool starts_outside = detail::is_outside<S>(start.c, arc.radius);
    const S last = certified_last<S>(path.end, S(math::norm1<S>(start.c) + arc.radius + radius),
                                     math::norm1<S>(start.b));
    const auto covered = [&](const S& t) { return arc.covers(from.at(t).position.rounded()); };
    const auto first = [&](const S& circle, bool outwards, const S& until) {
        const CircleCrossing<FromPoint<S, Path>> crossing{from, circle, outwards};
        const bool past = starts_outside == outwards;
        const bool touching = !past && detail::only_touches(crossing, history);
        return detail::first_accepted(crossing, past, last, until, touching, history.noise,
                                      covered);
    };
    const S best = first(S(arc.radius + radius), false, beyond<S>(horizon));
    const S room = arc.radius - radius;
    if (!(room > S(0)) || (arc.full && starts_outside)) return best;
    const S t = first(room, true, std::min<S>(beyond<S>(horizon), best));
    return math::is_finite<S>(t) ? t : best;
}

}  // namespace osculo::detect
