#pragma once

#include "osculo/engine/audit/relative_parabola.hpp"

/// The smallest gaps of smallest_gap.hpp for curved pieces: at the ends of the path and wherever
/// the distance may turn.
namespace osculo::engine {

/// Two balls, or a ball and a point: smallest |x| - reach.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_distance_beyond(const RelativeParabola<S>& path,
                                                const math::Wide<S>& reach) {
    GapAt<S> smallest{length_beyond<S>(path.start, reach), S(0)};
    smallest.keep_smaller(length_beyond<S>(path.at(path.time), reach), path.time);
    for (const math::Wide<S>& t : turning_times<S>(path)) {
        smallest.keep_smaller(length_beyond<S>(path.at(t), reach), t);
    }
    return smallest;
}

/// A ball and the straight part of a segment: the path falls into stretches in which the foot of
/// the perpendicular stays between the ends or beside them, and the distance grows or shrinks.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativeParabola<S>& path, const S& radius,
                                    const geometry::Segment<S>& segment) {
    using Wide = math::Wide<S>;
    Few<Wide, 7> borders;
    borders.insert(Wide(S(0)));
    for (const Wide& t : crossing_times<S>(path, segment.tangent, S(0))) borders.insert(t);
    for (const Wide& t : crossing_times<S>(path, segment.tangent, segment.length))
        borders.insert(t);
    const std::array<S, 3> distance = SharedOut<S>(path).along(segment.normal, S(0));
    const S turn = -distance[1] / (S(2) * distance[2]);
    if (S(0) < turn && turn < S(1)) borders.insert(Wide(path.time * Wide(turn)));
    borders.insert(path.time);

    const auto along = [&](const Wide& t, const math::Vec<S>& direction) {
        return Wide(inner<S>(path.at(t), math::WidePoint<S>(direction)));
    };
    GapAt<S> smallest;
    if (segment.one_sided && S(0) < turn && turn < S(1)) {
        // From behind it may turn before it is out, and is let back.
        const Wide first = along(Wide(S(0)), segment.normal);
        const Wide top = along(Wide(path.time * Wide(turn)), segment.normal);
        if (first < Wide(S(0)) && first < top && top < Wide(radius)) return smallest;
    }
    for (const Wide* from = borders.begin(); from + 1 != borders.end(); ++from) {
        const Wide& to = *(from + 1);
        const S foot =
            math::narrow(along(*from + (to - *from) * Wide(S(1) / S(2)), segment.tangent));
        if (!(foot >= S(0) && foot <= segment.length)) continue;
        const GapAt<S> gap =
            smallest_gap_of_stretch<S>(along(*from, segment.normal), along(to, segment.normal),
                                       *from, to, radius, segment.one_sided);
        smallest.keep_smaller(gap.gap, gap.t);
    }
    return smallest;
}

/// A ball and the circular part of an arc: at the ends of the path, at the points closest to and
/// farthest from the centre, on the circle, or where the angles begin or end.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativeParabola<S>& path, const S& radius,
                                    const geometry::Arc<S>& arc) {
    using Wide = math::Wide<S>;
    GapAt<S> smallest;
    const auto consider = [&](const Wide& t, const math::Vec<S>* border = nullptr) {
        consider_arc(path, radius, arc, t, border, smallest);
    };
    consider(Wide(S(0)));
    consider(path.time);
    for (const Wide& t : turning_times<S>(path)) consider(t);

    const SharedOut<S> x(path);
    const std::array<S, 5> beyond_circle{
        math::narrow(
            Wide(math::wide_dot<S>(x.c, x.c) - math::wide_product(arc.radius, arc.radius))),
        S(2) * math::dot<S>(x.c, x.v), math::dot<S>(x.v, x.v) + S(2) * math::dot<S>(x.c, x.a),
        S(2) * math::dot<S>(x.v, x.a), math::dot<S>(x.a, x.a)};
    for (const S& share : zeros_between_0_and_1<S, 5>(beyond_circle)) {
        consider(Wide(path.time * Wide(share)));
    }
    if (!arc.full) {
        for (const math::Vec<S>* border : {&arc.start, &arc.end}) {
            const math::Vec<S> across(-border->y(), border->x());
            for (const Wide& t : crossing_times<S>(path, across, S(0))) consider(t, border);
        }
    }
    return smallest;
}

/// A ball and a rim it should have been captured by: how far its centre went inwards after it had
/// been outside, or beyond its own start if it started inside. Never positive: nothing keeps a ball
/// away from a rim.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativeParabola<S>& path, const S&,
                                    const geometry::Rim<S>& rim) {
    using Wide = math::Wide<S>;
    const auto beyond = [&](const Wide& t) {
        return length_beyond<S>(path.at(t), Wide(rim.radius));
    };
    S allowed = std::min<S>(beyond(Wide(S(0))), S(0));
    GapAt<S> smallest;
    const auto follow = [&](const Wide& t) {
        const S gap = beyond(t);
        if (!(gap < S(0))) {
            allowed = S(0);
        } else if (gap < allowed) {
            smallest.keep_smaller(S(gap - allowed), t);
        }
    };
    for (const Wide& t : turning_times<S>(path)) follow(t);
    follow(path.time);
    return smallest;
}

/// A box around the path grown to all its sides, told by the corners of its control polygon.
template <math::Scalar S>
[[nodiscard]] Box box_around(const RelativeParabola<S>& path) {
    const SharedOut<S> x(path);
    const math::Vec<S> middle = x.c + x.v / S(2);
    const math::Vec<S> end = x.c + (x.v + x.a);
    const Box first = box_around<S>(x.c, middle);
    const Box last = box_around<S>(middle, end);
    return {std::min(first.low_x, last.low_x), std::max(first.high_x, last.high_x),
            std::min(first.low_y, last.low_y), std::max(first.high_y, last.high_y)};
}
template <math::Scalar S>
[[nodiscard]] Box box_around(const RelativePath<S>& path) {
    return box_around<S>(path.start.rounded(), path.at(path.time).rounded());
}

}  // namespace osculo::engine
