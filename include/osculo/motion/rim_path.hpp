#pragma once

#include "osculo/motion/certified_path.hpp"
#include "osculo/motion/rim_paper.hpp"
#include "osculo/motion/swept_box.hpp"

namespace osculo::motion {

/// What is ahead of a ball in a rim, as a certified path. Refers to the motion. [Stay]: what a
/// rim's law makes of it.
template <math::Scalar S, class Stay>
struct RimStayPath {
    const Stay* motion;
    S since;                      ///< since the motion's start [s]
    math::WidePoint<S> position;  ///< [m]
    S end;                        ///< [s]
    S size;                       ///< of the rim [m]

    RimStayPath(const Stay& of, const S& from)
        : motion(&of),
          since(from),
          position(of.at(from).position),
          end(std::max<S>(of.duration() - from, S(0))),
          size(of.rim().radius) {}

    [[nodiscard]] PathPoint<S> at(const S& t) const {
        const ParabolicPath<S> now = quadratic(t);
        return {now.position, now.velocity};
    }
    [[nodiscard]] ParabolicPath<S> quadratic(const S& t) const { return motion->at(S(since + t)); }
    [[nodiscard]] S jerk_bound(const S& t, const S& h) const {
        return motion->jerk_bound(S(since + t), h);
    }
};

/// The path of a ball where there are rims: a parabola, or a stay in a rim.
template <math::Scalar S, class Stay = RimPaperMotion<S>>
struct RimPath {
    ParabolicPath<S> outside;
    const Stay* stay = nullptr;
    S since{0};  ///< in the stay [s]

    /// Moves the start of the path on by t [s].
    void shift(const S& t) {
        if (stay != nullptr) {
            since += t;
        } else {
            outside.shift(t);
        }
    }
    [[nodiscard]] bool stands() const { return stay == nullptr && outside.stands(); }
    [[nodiscard]] RimStayPath<S, Stay> inside() const { return {*stay, since}; }
};

/// In a rim, a ball does not leave the rim.
template <math::Scalar S, class Stay>
[[nodiscard]] geometry::Box<S> swept_box(const RimPath<S, Stay>& path, const S& until) {
    if (path.stay == nullptr) return swept_box<S>(path.outside, until);
    const geometry::Rim<S>& rim = path.stay->rim();
    const math::Vec<S> reach(rim.radius, rim.radius);
    return detail::with_blur<S>(geometry::Box<S>::around(math::Vec<S>(rim.center - reach),
                                                         math::Vec<S>(rim.center + reach)),
                                S(math::norm1<S>(rim.center) + S(16) * rim.radius));
}

}  // namespace osculo::motion
