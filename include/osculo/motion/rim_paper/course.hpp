#pragma once

#include <vector>

#include "osculo/math/polynomial.hpp"
#include "osculo/motion/rim_paper/panel.hpp"

namespace osculo::motion {

/// How a stay in a rim's field ends.
enum class RimOutcome {
    exit,      ///< the centre crosses the rim outwards
    capture,   ///< the ball falls in
    turn,      ///< neither: it swings between two distances, and this is its second turning point
    balanced,  ///< where it stands at the saddle, no digit is left that says on which side it falls
};

/// The radial motion of a ball in a rim's field until it leaves, falls in, turns for the second
/// time, or cannot be told.
template <math::Scalar S>
struct RimCourse {
    std::vector<RimPanel<S>> panels;
    RimOutcome outcome = RimOutcome::capture;
};

namespace detail {

/// Where the slope of F vanishes besides the end: q c d^3 = L^2. Its left side has one maximum, so
/// there are two such places or none: a minimum of F, the saddle, and further in a maximum.
template <math::Scalar S>
struct RimExtrema {
    bool exist = false;
    S minimum{0};
    S maximum{1};

    /// q c d^3 - L^2.
    struct Balance {
        S least, moment_square;
        [[nodiscard]] S operator()(const S& z) const {
            const RimPlace<S> p(z, S(S(1) - z), least);
            return p.q * p.c * p.d * p.d * p.d - moment_square;
        }
        [[nodiscard]] S slope(const S& z) const {
            const RimPlace<S> p(z, S(S(1) - z), least);
            return S(2) / (S(1) + z * z) * p.d * p.d *
                   ((S(1) - S(2) * p.q * p.q) * p.d - S(3) * p.q * p.c * p.c);
        }
    };

    RimExtrema(const S& rim, const S& least, const S& moment_square) {
        if (!(moment_square > S(0))) {
            exist = true;
            return;
        }
        const Balance balance{least, moment_square};
        // The maximum of the left side: 5 q^3 - 2 R q^2 - 4 q + R = 0.
        const math::Cubic<S> peak{rim, S(-4), S(S(-2) * rim), S(5)};
        const S q = math::bracketed_root<S>(peak, S(0), S(1), false);
        const S z = q / (S(1) + math::square_root<S>((S(1) - q) * (S(1) + q)));
        if (!(balance(z) > S(0))) return;
        exist = true;
        minimum = math::bracketed_root<S>(balance, S(0), z, true);
        maximum = math::bracketed_root<S>(balance, z, S(1), false);
    }
};

/// F beside a minimum of it, at a distance to one side.
template <math::Scalar S>
struct BesideAnchor {
    const RimAnchor<S>& anchor;
    S side;
    [[nodiscard]] S operator()(const S& y) const { return anchor.value_at(S(side * y)); }
    [[nodiscard]] S slope(const S& y) const {
        const RimPlace<S> p = anchor.at(S(side * y));
        const S by_tilt = S(2) * (p.q * p.c - anchor.moment_square / (p.d * p.d * p.d));
        return side * by_tilt * p.steepness();
    }
};

/// Lays out the panels of a course.
template <math::Scalar S>
class RimSurvey {
    using Wide = math::Wide<S>;

public:
    RimSurvey(const RimField<S>& field, bool inwards)
        : field_(field),
          extrema_(field.rim(), field.least_distance(), field.moment_square()),
          start_(math::narrow(field.start())),
          begins_at_turn_(field.turns_at_start()),
          inwards_(inwards),
          maximum_(polished(extrema_.maximum)),
          outer_(extrema_.exist ? survey_saddle() : Part{}),
          inner_(survey_end()) {}

    /// Follows the ball.
    [[nodiscard]] RimCourse<S> follow() {
        RimCourse<S> course;
        bool inside = !extrema_.exist || maximum_ < field_.start();
        for (;;) {
            const Part& part = inside ? inner_ : outer_;
            RimPanel<S> panel = part.panel;
            const bool over = inside ? cross_inner(panel, course) : cross_outer(panel, course);
            course.panels.push_back(panel);
            if (over) return course;
            inside = !inside;
            at_start_ = false;
        }
    }

private:
    /// The part of the field around a minimum of F.
    struct Part {
        RimPanel<S> panel{};
        Wide origin{};           ///< z of the anchor
        bool uncertain = false;  ///< whether F > 0 at the minimum
    };

    /// e of a minimum with F > 0, from F'' / 2; where that says nothing, one that changes nothing.
    [[nodiscard]] static S width(const S& value, const S& half_bend) {
        const S ratio = half_bend > S(0) ? S(value / half_bend) : S(1);
        return ratio < S(1) ? math::square_root<S>(ratio) : S(1);
    }

    /// A place where the slope vanishes, to all digits: the ball may be very close to it.
    [[nodiscard]] Wide polished(const S& extremum) const {
        Wide z(extremum);
        if (!(extremum > S(0) && extremum < S(1))) return z;
        const S least = field_.least_distance();
        const S d = RimPlace<S>(extremum, S(S(1) - extremum), least).d;
        const typename RimExtrema<S>::Balance balance{least, field_.moment_square()};
        const S bend = balance.slope(extremum);
        for (int i = 0; i < 2; ++i) z = z - math::narrow(field_.half_slope(z)) * d * d * d / bend;
        return z;
    }

    /// F at a maximum so small that the motion is a circle but for rounding: taken as so much.
    [[nodiscard]] S least_swing() const {
        return S(1024) * field_.value(field_.start()).noise +
               math::wide_epsilon<S>() * field_.moment_square();
    }

    /// Anchors the part at its minimum.
    void set_minimum(Part& part, const Wide& z) const {
        part.origin = z;
        part.panel.anchor = field_.anchor(part.origin);
        part.panel.turns = false;
    }

    /// Anchors the part at the turn between its minimum, where F < 0, and [high], where F > 0.
    void set_turn(Part& part, int side, const Wide& high) const {
        RimPanel<S>& panel = part.panel;
        const Wide minimum = part.origin;
        const S most = math::abs<S>(math::narrow(Wide(high - minimum)));
        // To be told from where F is closest to 0, for there it is known to the most digits.
        RimAnchor<S> top = field_.anchor(high);
        top.value = std::max<S>(top.value, least_swing());
        const bool low = -panel.anchor.value < top.value;
        const BesideAnchor<S> f{low ? panel.anchor : top, S(low ? side : -side)};
        const S distance =
            (f(most) > S(0)) == low ? math::bracketed_root<S>(f, S(0), most, low) : most;
        // Newton's steps with all digits: F from the start, whatever cancels here.
        Wide turn = low ? minimum + S(side) * distance : high + S(-side) * distance;
        for (int i = 0; i < 3; ++i) {
            const S step = math::narrow(field_.value(turn).value) /
                           (S(2) * math::narrow(field_.half_slope(turn)) *
                            RimPlace<S>(math::narrow(turn), math::narrow(Wide(Wide(S(1)) - turn)),
                                        field_.least_distance())
                                .steepness());
            if (!(math::abs<S>(step) < distance / S(8))) break;  // a circle, to rounding
            turn = turn - step;
        }
        part.origin = turn;
        panel.turns = true;
        panel.side = side;
        panel.e = math::abs<S>(math::narrow(Wide(turn - minimum)));
        panel.anchor = field_.anchor(turn);
        panel.anchor.value = S(0);
    }

    [[nodiscard]] Part survey_saddle() const {
        Part part;
        set_minimum(part, polished(extrema_.minimum));
        RimPanel<S>& panel = part.panel;
        panel.side = 1;
        S& value = panel.anchor.value;
        const S noise = field_.value(part.origin).noise;
        part.uncertain = math::abs<S>(value) <= noise;
        if (part.uncertain) value = noise;
        if (value < S(0)) {
            const bool kept_outside = field_.start() < part.origin;
            set_turn(part, kept_outside ? -1 : 1, kept_outside ? field_.start() : maximum_);
            return part;
        }
        const RimPlace<S>& p = panel.anchor.place;
        const S slope = p.steepness();
        const S dd = p.d * p.d;
        const S half_bend =
            ((S(1) - S(2) * p.q * p.q) / p.c - S(3) * field_.moment_square() / (dd * dd)) *
            (slope * slope);
        panel.e = std::max<S>(width(value, half_bend), math::wide_epsilon<S>());
        return part;
    }

    [[nodiscard]] Part survey_end() const {
        Part part;
        set_minimum(part, Wide(S(1)));
        RimPanel<S>& panel = part.panel;
        panel.side = -1;
        if (panel.anchor.value < S(0)) {
            set_turn(part, -1, extrema_.exist ? maximum_ : field_.start());
        } else {
            const S& d = panel.anchor.place.d;
            panel.e =
                std::max<S>(width(panel.anchor.value, S(field_.moment_square() / (d * d * d))),
                            math::epsilon<S>());
        }
        return part;
    }

    /// z of a place as a panel measures it: from its anchor, or how far it is from its turn.
    [[nodiscard]] static S measure(const Part& part, const Wide& z) {
        const S y = math::narrow(Wide(z - part.origin));
        return part.panel.turns ? S(S(part.panel.side) * y) : y;
    }
    [[nodiscard]] S variable(const Part& part, const Wide& z) const {
        return part.panel.variable(measure(part, z));
    }
    /// |u| where the panel begins: at the start of all or where the parts meet.
    [[nodiscard]] S begin(const Part& part) const {
        if (!at_start_) return variable(part, maximum_);
        return begins_here(part) ? S(0) : variable(part, field_.start());
    }
    [[nodiscard]] bool begins_here(const Part& part) const {
        return at_start_ && begins_at_turn_ && part.panel.turns;
    }
    /// u where the ball leaves: on the rim, or where it started if that is outside by rounding.
    [[nodiscard]] S leave(const Part& part) const {
        return variable(part, start_ < S(0) ? field_.start() : Wide(S(0)));
    }

    /// A panel that passes its turn, from -u to [end], unless it is the second one.
    [[nodiscard]] bool pass_turn(RimPanel<S>& panel, RimCourse<S>& course, const S& end) {
        panel.from = -panel.from;
        if (++turns_ == 2) {
            panel.to = S(0);
            course.outcome = RimOutcome::turn;
            return true;
        }
        panel.to = end;
        inwards_ = panel.side > 0;
        return false;
    }

    /// Around the saddle. True if the course ends there.
    bool cross_outer(RimPanel<S>& panel, RimCourse<S>& course) {
        panel.from = begin(outer_);
        const bool turns_at_once = begins_here(outer_);
        if (panel.turns && panel.side < 0) {  // kept outside
            if (inwards_ || turns_at_once) panel.from = -panel.from;
            panel.to = leave(outer_);
            course.outcome = RimOutcome::exit;
            return true;
        }
        const S meeting = variable(outer_, maximum_);
        if (panel.turns) {  // kept inside
            if (!inwards_ || turns_at_once) return pass_turn(panel, course, meeting);
            panel.to = meeting;
            return false;
        }
        if (outer_.uncertain && (inwards_ ? panel.from <= S(0) : panel.from >= S(0))) {
            panel.to = S(0);
            course.outcome = RimOutcome::balanced;
            return true;
        }
        panel.to = inwards_ ? meeting : leave(outer_);
        course.outcome = inwards_ ? RimOutcome::capture : RimOutcome::exit;
        return !inwards_ || extrema_.maximum == S(1);
    }

    /// Between the maximum of F, or the rim, and the end.
    bool cross_inner(RimPanel<S>& panel, RimCourse<S>& course) {
        panel.from = begin(inner_);
        if (inwards_ && !panel.turns) {
            course.outcome = RimOutcome::capture;
            return true;
        }
        const S outwards = extrema_.exist ? variable(inner_, maximum_) : leave(inner_);
        course.outcome = RimOutcome::exit;
        if (inwards_ || begins_here(inner_)) {
            return pass_turn(panel, course, outwards) || !extrema_.exist;
        }
        panel.to = outwards;
        return !extrema_.exist;
    }

    const RimField<S>& field_;
    RimExtrema<S> extrema_;
    S start_;
    bool begins_at_turn_;
    bool inwards_;
    Wide maximum_;  ///< z where F is largest between saddle and end; 1 without a moment
    bool at_start_ = true;
    int turns_ = 0;
    Part outer_;
    Part inner_;
};

}  // namespace detail

/// The course of a ball that moves inwards or outwards at first.
template <math::Scalar S>
[[nodiscard]] RimCourse<S> rim_course(const RimField<S>& field, bool inwards) {
    return detail::RimSurvey<S>(field, inwards).follow();
}

}  // namespace osculo::motion
