#pragma once

#include <algorithm>
#include <array>

#include "osculo/geometry/arc.hpp"
#include "osculo/geometry/point.hpp"
#include "osculo/geometry/rim.hpp"
#include "osculo/geometry/segment.hpp"
#include "osculo/math/error_bounds.hpp"
#include "osculo/math/instant.hpp"
#include "osculo/math/vec.hpp"

/// How near a ball on a straight piece comes to something: in closed form, and sharing nothing with
/// detection, whose faults it is there to find. Everything is wide, so that what is measured is the
/// trajectory and not the measurement.
namespace osculo::engine {

/// Straight motion seen from something else: start + velocity t for 0 <= t <= time.
template <math::Scalar S>
struct RelativePath {
    math::WidePoint<S> start;     ///< [m]
    math::WidePoint<S> velocity;  ///< [m/s]
    math::Wide<S> time;           ///< [s]

    [[nodiscard]] math::WidePoint<S> at(const math::Wide<S>& t) const {
        return {start.x + velocity.x * t, start.y + velocity.y * t};
    }
};

/// A gap [m] and when it was reached, counted from the start of the path. never() if the path has
/// no such gap.
template <math::Scalar S>
struct GapAt {
    S gap = math::never<S>();
    math::Wide<S> t{S(0)};

    void keep_smaller(const S& other_gap, const math::Wide<S>& other_t) {
        if (other_gap < gap) *this = {other_gap, other_t};
    }
};

/// a - b.
template <math::Scalar S>
[[nodiscard]] math::WidePoint<S> seen_from(const math::WidePoint<S>& a,
                                           const math::WidePoint<S>& b) {
    return {a.x - b.x, a.y - b.y};
}
template <math::Scalar S>
[[nodiscard]] math::WidePoint<S> seen_from(const math::WidePoint<S>& a, const math::Vec<S>& b) {
    return seen_from<S>(a, math::WidePoint<S>(b));
}

/// a . b of wide vectors.
template <math::Scalar S>
[[nodiscard]] math::Wide<S> inner(const math::WidePoint<S>& a, const math::WidePoint<S>& b) {
    return a.x * b.x + a.y * b.y;
}

/// |x| - s with an error below 4 epsilon times the result plus the wide rounding of |x| + s.
template <math::Scalar S>
[[nodiscard]] S length_beyond(const math::WidePoint<S>& x, const math::Wide<S>& s) {
    const S length = math::norm<S>(x.rounded());
    if (length > S(4) * math::narrow(s))
        return math::narrow(math::Wide<S>(math::Wide<S>(length) - s));
    const math::Wide<S> difference_of_squares = inner<S>(x, x) - s * s;
    return math::narrow(difference_of_squares) / (length + math::narrow(s));
}

/// When the path is closest to the origin.
template <math::Scalar S>
[[nodiscard]] math::Wide<S> closest_approach(const RelativePath<S>& path) {
    const math::Wide<S> zero{S(0)};
    const S speed = math::norm_max<S>(path.velocity.rounded());
    if (!(speed > S(0)) || !(zero < path.time)) return zero;
    // The direction only: rounding it moves the minimum in second order. Taken twice, the second
    // time from the first result, it leaves the rounding of a rounding.
    const math::Vec<S> along = path.velocity.rounded() / speed;
    const math::WidePoint<S> direction{along};
    const S square = math::dot<S>(along, along);
    math::Wide<S> t = zero;
    for (int i = 0; i < 2; ++i) {
        t = t - math::Wide<S>(math::narrow(math::Wide<S>(inner<S>(path.at(t), direction))) /
                              square / speed);
        if (!(zero < t)) return zero;
        if (!(t < path.time)) return path.time;
    }
    return t;
}

/// Two balls, or a ball and a point: smallest |x| - reach.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_distance_beyond(const RelativePath<S>& path,
                                                const math::Wide<S>& reach) {
    const math::Wide<S> t = closest_approach<S>(path);
    return {length_beyond<S>(path.at(t), reach), t};
}

/// The same for a path of either kind.
template <template <class> class Path, math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const Path<S>& path, const S& radius,
                                    const geometry::Point<S>&) {
    return smallest_distance_beyond<S>(path, math::Wide<S>(radius));
}

/// A stretch of time in which a ball goes steadily from one distance to another from the line of a
/// segment, with the foot of the perpendicular between its ends: the smallest distance - radius.
/// Past the centre line the ball has gone through: the gap is then -radius or less. Behind a
/// one-sided segment, and on the way out from behind it, a ball has no gap.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap_of_stretch(const math::Wide<S>& first,
                                               const math::Wide<S>& last, const math::Wide<S>& from,
                                               const math::Wide<S>& to, const S& radius,
                                               bool one_sided) {
    using Wide = math::Wide<S>;
    const Wide zero{S(0)};
    const auto gap = [&](const Wide& distance) {
        return math::narrow(Wide(distance - Wide(radius)));
    };
    if (one_sided) {
        if (!(zero < first)) return {};
        // Whatever goes in is noticed when it does. Where it comes to rest on the way out, rounding
        // may take it back, and so may an approach that is mere rounding.
        const bool deep = gap(first) < -S(2 * math::kStartOverlap) * radius;
        const S slack = S(math::kContactGap + math::kTouch) * math::epsilon<S>();
        const S rounding = deep ? S(slack * radius) : S(0);
        if (gap(first) < S(0) && math::narrow(Wide(first - last)) <= rounding) return {};
        if (last < first) return {gap(last), to};
        return {gap(first), from};
    }
    if ((first < zero) != (last < zero)) {
        const Wide share{math::narrow(first) / math::narrow(Wide(first - last))};
        return {-radius, from + (to - from) * share};
    }
    GapAt<S> smallest{gap(first < zero ? Wide(-first) : first), from};
    smallest.keep_smaller(gap(last < zero ? Wide(-last) : last), to);
    return smallest;
}

/// A ball and the straight part of a segment.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativePath<S>& path, const S& radius,
                                    const geometry::Segment<S>& segment) {
    using Wide = math::Wide<S>;
    const Wide zero{S(0)};
    const math::WidePoint<S> tangent{segment.tangent};
    const math::WidePoint<S> normal{segment.normal};

    // The stretch of the path that faces the segment.
    Wide from = zero;
    Wide to = path.time;
    const Wide foot = inner<S>(path.start, tangent);
    const S foot_speed = math::narrow(Wide(inner<S>(path.velocity, tangent)));
    if (foot_speed != S(0)) {
        const auto when_at = [&](const S& place) {
            return Wide(math::narrow(Wide(Wide(place) - foot)) / foot_speed);
        };
        const Wide one = when_at(S(0));
        const Wide other = when_at(segment.length);
        from = std::max<Wide>(from, std::min<Wide>(one, other));
        to = std::min<Wide>(to, std::max<Wide>(one, other));
        if (to < from) return {};
    } else if (foot < zero || Wide(segment.length) < foot) {
        return {};
    }

    const Wide first = inner<S>(path.at(from), normal);
    const Wide last = inner<S>(path.at(to), normal);
    return smallest_gap_of_stretch<S>(first, last, from, to, radius, segment.one_sided);
}

/// Keeps the gap of a ball and the circular part of an arc at t, | |x| - arc radius | - radius, if
/// the direction is within the arc's angles; on a [border] of these rounding would decide, were it
/// asked whether the arc covers it.
template <template <class> class Path, math::Scalar S>
void consider_arc(const Path<S>& path, const S& radius, const geometry::Arc<S>& arc,
                  const math::Wide<S>& t, const math::Vec<S>* border, GapAt<S>& smallest) {
    const math::WidePoint<S> x = path.at(t);
    const math::Vec<S> direction = x.rounded();
    const bool counts = border ? math::dot<S>(*border, direction) > S(0) : arc.covers(direction);
    if (!counts) return;
    smallest.keep_smaller(math::abs<S>(length_beyond<S>(x, math::Wide<S>(arc.radius))) - radius, t);
}

/// A ball and the circular part of an arc. The gap is smallest at an end of the path, at the point
/// closest to the centre, on the circle, or where the angles begin or end.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativePath<S>& path, const S& radius,
                                    const geometry::Arc<S>& arc) {
    using Wide = math::Wide<S>;
    const Wide zero{S(0)};
    GapAt<S> smallest;
    const auto consider = [&](const Wide& t, const math::Vec<S>* border = nullptr) {
        if (t < zero || path.time < t) return;
        consider_arc(path, radius, arc, t, border, smallest);
    };
    consider(zero);
    consider(path.time);
    const math::Vec<S> velocity = path.velocity.rounded();
    const S speed = math::norm<S>(velocity);
    if (!(speed > S(0))) return smallest;

    const Wide closest = closest_approach<S>(path);
    consider(closest);
    const math::Vec<S> along = velocity / speed;
    const S before_foot = math::dot<S>(path.start.rounded(), along);
    const S moment = math::cross<S>(path.start.rounded(), along);
    const S half_chord_square = (arc.radius - moment) * (arc.radius + moment);
    if (half_chord_square >= S(0)) {
        const S half_chord = math::square_root<S>(half_chord_square);
        consider(Wide((-before_foot - half_chord) / speed));
        consider(Wide((-before_foot + half_chord) / speed));
    }
    if (!arc.full) {
        for (const math::Vec<S>* border : {&arc.start, &arc.end}) {
            const S turn_rate = math::accurate_cross<S>(*border, velocity);
            if (turn_rate == S(0)) continue;
            const S turn = math::accurate_cross<S>(*border, path.start.rounded());
            consider(Wide(-turn / turn_rate), border);
        }
    }
    return smallest;
}

/// A ball and a rim it should have been captured by: how far its centre went inwards beyond the
/// rim, or beyond its own start if it started inside. Never positive: nothing keeps a ball away
/// from a rim.
template <math::Scalar S>
[[nodiscard]] GapAt<S> smallest_gap(const RelativePath<S>& path, const S&,
                                    const geometry::Rim<S>& rim) {
    using Wide = math::Wide<S>;
    const Wide t = closest_approach<S>(path);
    if (!(Wide(S(0)) < t)) return {};
    const S inside = length_beyond<S>(path.at(t), Wide(rim.radius));
    if (!(inside < S(0))) return {};
    const S at_start = length_beyond<S>(path.start, Wide(rim.radius));
    return {at_start < S(0) ? S(inside - at_start) : inside, t};
}

/// Distance between the boundaries of a ball at [x] and an obstacle, ends included.
template <math::Scalar S>
[[nodiscard]] S contact_gap(const math::WidePoint<S>& x, const S& radius,
                            const geometry::Point<S>&) {
    return length_beyond<S>(x, math::Wide<S>(radius));
}
template <math::Scalar S>
[[nodiscard]] S contact_gap(const math::WidePoint<S>& x, const S& radius,
                            const geometry::Segment<S>& segment) {
    using Wide = math::Wide<S>;
    const auto along = [&](const math::Vec<S>& direction) {
        return Wide(inner<S>(x, math::WidePoint<S>(direction)));
    };
    const S foot = math::narrow(along(segment.tangent));
    if (foot < S(0)) return length_beyond<S>(x, Wide(radius));
    if (segment.length < foot) {
        const math::WidePoint<S> end{math::Vec<S>(segment.length * segment.tangent)};
        return length_beyond<S>(seen_from<S>(x, end), Wide(radius));
    }
    const Wide distance = along(segment.normal);
    return math::narrow(Wide((distance < Wide(S(0)) ? Wide(-distance) : distance) - Wide(radius)));
}
template <math::Scalar S>
[[nodiscard]] S contact_gap(const math::WidePoint<S>& x, const S& radius,
                            const geometry::Arc<S>& arc) {
    using Wide = math::Wide<S>;
    if (arc.covers(x.rounded())) {
        return math::abs<S>(length_beyond<S>(x, Wide(arc.radius))) - radius;
    }
    const auto beyond = [&](const math::Vec<S>& direction) {
        const math::WidePoint<S> end{math::Vec<S>(arc.radius * direction)};
        return length_beyond<S>(seen_from<S>(x, end), Wide(radius));
    };
    return std::min<S>(beyond(arc.start), beyond(arc.end));
}
/// Of a rim: the distance of the ball's centre.
template <math::Scalar S>
[[nodiscard]] S contact_gap(const math::WidePoint<S>& x, const S&, const geometry::Rim<S>& rim) {
    return length_beyond<S>(x, math::Wide<S>(rim.radius));
}

/// A box in plain numbers, for rejections: what it encloses may be smaller, never larger.
struct Box {
    double low_x, high_x, low_y, high_y;

    [[nodiscard]] Box grown(double by) const {
        return {low_x - by, high_x + by, low_y - by, high_y + by};
    }
    [[nodiscard]] bool apart(const Box& other) const {
        return other.high_x < low_x || high_x < other.low_x || other.high_y < low_y ||
               high_y < other.low_y;
    }
};

/// The box around two points, with room for their rounding to double.
template <math::Scalar S>
[[nodiscard]] Box box_around(const math::Vec<S>& a, const math::Vec<S>& b) {
    const double ax = math::to_double<S>(a.x()), ay = math::to_double<S>(a.y());
    const double bx = math::to_double<S>(b.x()), by = math::to_double<S>(b.y());
    const double coordinate = std::max({std::abs(ax), std::abs(ay), std::abs(bx), std::abs(by)});
    return Box{std::min(ax, bx), std::max(ax, bx), std::min(ay, by), std::max(ay, by)}.grown(
        8 * math::epsilon<double>() * coordinate);
}

/// What a kind of obstacle has to tell so that its gaps can be audited, besides smallest_gap() and
/// contact_gap(): the point that paths are measured from, how far a contact may be from there
/// besides the ball's radius, and a box around it.
template <math::Scalar S>
[[nodiscard]] const math::Vec<S>& origin(const geometry::Segment<S>& segment) {
    return segment.from;
}
template <math::Scalar S>
[[nodiscard]] const math::Vec<S>& origin(const geometry::Point<S>& point) {
    return point.at;
}
template <math::Scalar S>
[[nodiscard]] const math::Vec<S>& origin(const geometry::Arc<S>& arc) {
    return arc.center;
}
template <math::Scalar S>
[[nodiscard]] const math::Vec<S>& origin(const geometry::Rim<S>& rim) {
    return rim.center;
}

/// Of straight things and points 0: only the distance across counts.
template <class Obstacle>
[[nodiscard]] auto contact_reach(const Obstacle& obstacle) {
    using S = std::decay_t<decltype(origin(obstacle).x())>;
    if constexpr (requires { obstacle.radius; }) {
        return S(obstacle.radius);
    } else {
        return S(0);
    }
}

template <math::Scalar S>
[[nodiscard]] Box box_around(const geometry::Segment<S>& segment) {
    return box_around<S>(segment.from, segment.from + segment.length * segment.tangent);
}
template <math::Scalar S>
[[nodiscard]] Box box_around(const geometry::Point<S>& point) {
    return box_around<S>(point.at, point.at);
}
template <math::Scalar S>
[[nodiscard]] Box box_around(const geometry::Arc<S>& arc) {
    const math::Vec<S> reach(arc.radius, arc.radius);
    return box_around<S>(arc.center - reach, arc.center + reach);
}
template <math::Scalar S>
[[nodiscard]] Box box_around(const geometry::Rim<S>& rim) {
    const math::Vec<S> reach(rim.radius, rim.radius);
    return box_around<S>(rim.center - reach, rim.center + reach);
}

}  // namespace osculo::engine
