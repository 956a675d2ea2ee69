#pragma once

#include "osculo/geometry/rim.hpp"
#include "osculo/motion/path.hpp"
#include "osculo/motion/rim_paper/clock.hpp"

namespace osculo::motion {

/// The motion of a ball whose centre is inside a rim that pulls it as in PHYSICS 1.4, until it
/// leaves, falls in, or swings back for the second time: exact but for rounding.
///
/// Energy and angular momentum about the hole are those of the start; the time is a quadrature
/// (NUMERICS 3.2), here of series that are told at every upper limit, so that the place at a time
/// is the inverse of one. Relative error of time and swept angle <= 1e-13 of those of the stored
/// start, also beside the separatrix, for what cancels is formed in wide precision. Some
/// allocations in the constructor, none elsewhere.
template <math::Scalar S>
class RimPaperMotion {
    using Wide = math::Wide<S>;
    using Vec = math::Vec<S>;

public:
    /// A ball of the radius [radius] at [position], at most at the rim but for rounding. Requires
    /// gravity > 0, rim.radius > radius.
    RimPaperMotion(const geometry::Rim<S>& rim, const S& gravity, const S& radius,
                   const math::WidePoint<S>& position, const Vec& velocity)
        : RimPaperMotion(Start(rim, gravity, radius, position, velocity)) {}

    [[nodiscard]] RimOutcome outcome() const { return outcome_; }
    /// How long the stay is [s].
    [[nodiscard]] S duration() const { return duration_; }
    /// The angle that it sweeps about the hole, counter-clockwise [rad].
    [[nodiscard]] S swept() const { return clock_.swept(); }
    /// False if the numbers cannot follow it.
    [[nodiscard]] bool sound() const { return clock_.sound() && math::is_finite<S>(duration_); }
    /// Series that it takes.
    [[nodiscard]] std::size_t stretches() const { return clock_.stretches(); }

    /// Place, velocity and half the acceleration at t [s], 0 <= t <= duration(), until the end.
    [[nodiscard]] ParabolicPath<S> at(const S& t) const {
        const Start& s = start_;
        if (!(t > S(0)) || !(duration_ > S(0))) {
            return {s.position, s.velocity, half_acceleration(s.tilt(), s.out), duration_};
        }
        const auto hand = clock_.at(std::min<S>(S(t / s.unit_time), clock_.duration()));
        const math::SinCos<S> turn = math::sin_cos<S>(hand.angle);
        const Vec out(turn.cos * s.out.x() - turn.sin * s.out.y(),
                      turn.cos * s.out.y() + turn.sin * s.out.x());
        const Vec along(-out.y(), out.x());
        const S d = hand.place.d * s.radius;
        const S radial = -hand.tilt_rate * s.unit_speed;
        const S tangential = (s.moment / hand.place.d) * s.unit_speed;
        return {math::WidePoint<S>(Wide(math::wide_sum<S>(s.rim.center.x(), S(d * out.x()))),
                                   Wide(math::wide_sum<S>(s.rim.center.y(), S(d * out.y())))),
                radial * out + tangential * along, half_acceleration(hand.place, out),
                S(duration_ - t)};
    }

    /// At least the change of the acceleration from t on, per time, for h [s]: |third derivative|
    /// but for the end of a fall, where that grows like one over the root of the time left and the
    /// change of a root is at most its argument's over the root. [m/s^3]
    [[nodiscard]] S jerk_bound(const S& t, const S& h) const {
        const RimPlace<S> p =
            t > S(0) && duration_ > S(0)
                ? clock_.at(std::min<S>(S(t / start_.unit_time), clock_.duration())).place
                : start_.tilt();
        // The pull is g sin(2 tilt) / 2; the tilt is a convex function of its sine q, which changes
        // by at most so much:
        const S change = most_speed_ * h / start_.radius;
        const S highest = p.q + change;
        // From where 1 - q is less than rounding to the fall, nothing is left to change.
        const S least = math::square_root<S>(math::epsilon<S>());
        const S steepest = highest < S(1) ? S(S(1) / math::square_root<S>(S(1) - highest * highest))
                                          : S(S(4) / std::max<S>(p.c, least));
        const S nearest = std::max<S>(p.d - change, start_.field.least_distance());
        const S turning = math::abs<S>(start_.moment) / (nearest * nearest) / start_.unit_time;
        return start_.gravity * (most_speed_ / start_.radius * steepest + turning / S(2));
    }
    /// At least the speed, and at least half the acceleration.
    [[nodiscard]] const S& most_speed() const { return most_speed_; }
    [[nodiscard]] const geometry::Rim<S>& rim() const { return start_.rim; }
    [[nodiscard]] const S& gravity() const { return start_.gravity; }
    /// That of the ball.
    [[nodiscard]] const S& radius() const { return start_.radius; }

private:
    /// What is known before anything is integrated.
    struct Start {
        geometry::Rim<S> rim;
        S gravity;
        S radius;
        math::WidePoint<S> position;
        Vec velocity;
        Vec out;       ///< from the hole to the ball, unit
        S unit_time;   ///< sqrt(r / g) [s]
        S unit_speed;  ///< sqrt(g r) [m/s]
        S moment;      ///< L [r unit_speed]
        bool inwards;
        bool fallen;  ///< it is where balls fall in
        RimField<S> field;

        Start(const geometry::Rim<S>& hole, const S& g, const S& r, const math::WidePoint<S>& at,
              const Vec& v)
            : Start(hole, g, r, at, v, math::wide_difference<S>(at, hole.center)) {}
        Start(const geometry::Rim<S>& hole, const S& g, const S& r, const math::WidePoint<S>& at,
              const Vec& v, const math::WidePoint<S>& x)
            : Start(hole, g, r, at, v, x, math::wide_square_root<S>(Wide(x.x * x.x + x.y * x.y)),
                    math::wide_square_root<S>(math::wide_product<S>(g, r))) {}
        Start(const geometry::Rim<S>& hole, const S& g, const S& r, const math::WidePoint<S>& at,
              const Vec& v, const math::WidePoint<S>& x, const Wide& d, const Wide& speed)
            : rim(hole),
              gravity(g),
              radius(r),
              position(at),
              velocity(v),
              out(x.rounded() / math::narrow(d)),
              unit_time(r / math::narrow(speed)),
              unit_speed(math::narrow(speed)),
              moment(math::narrow(moment_of(x, v, speed, r))),
              inwards(math::narrow(radial_of(x, v, d, speed)) <= S(0)),
              fallen(math::narrow(tilt_of(hole, d, r)) >= S(1)),
              field(math::wide_quotient(Wide(hole.radius), Wide(r)), tilt_of(hole, d, r),
                    radial_of(x, v, d, speed), moment_of(x, v, speed, r)) {}

        [[nodiscard]] RimPlace<S> tilt() const {
            const S z = math::narrow(field.start());
            return {z, S(S(1) - z), field.least_distance()};
        }
        [[nodiscard]] static Wide tilt_of(const geometry::Rim<S>& hole, const Wide& d, const S& r) {
            return math::wide_quotient(Wide(Wide(hole.radius) - d), Wide(r));
        }
        [[nodiscard]] static Wide radial_of(const math::WidePoint<S>& x, const Vec& v,
                                            const Wide& d, const Wide& speed) {
            const Wide product = x.x * Wide(v.x()) + x.y * Wide(v.y());
            return math::wide_quotient(product, Wide(d * speed));
        }
        [[nodiscard]] static Wide moment_of(const math::WidePoint<S>& x, const Vec& v,
                                            const Wide& speed, const S& r) {
            const Wide product = x.x * Wide(v.y()) - x.y * Wide(v.x());
            return math::wide_quotient(product, Wide(Wide(r) * speed));
        }
    };

    explicit RimPaperMotion(const Start& start)
        : RimPaperMotion(
              start, start.fallen ? RimCourse<S>{} : rim_course<S>(start.field, start.inwards)) {}
    RimPaperMotion(const Start& start, const RimCourse<S>& course)
        : start_(start),
          outcome_(course.outcome),
          clock_(course, start.moment),
          duration_(clock_.duration() * start.unit_time),
          // All that the field can give, and the rounding of the sum.
          most_speed_(S(1.001) * (math::norm<S>(start.velocity) + start.unit_speed)) {}

    [[nodiscard]] Vec half_acceleration(const RimPlace<S>& place, const Vec& out) const {
        return (-start_.gravity * place.q * place.c / S(2)) * out;
    }

    Start start_;
    RimOutcome outcome_;
    RimClock<S> clock_;
    S duration_;
    S most_speed_;
};

}  // namespace osculo::motion
