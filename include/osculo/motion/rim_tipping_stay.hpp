#pragma once

#include <algorithm>
#include <optional>

#include "osculo/geometry/rim.hpp"
#include "osculo/motion/path.hpp"
#include "osculo/motion/rim_tipping/contact.hpp"
#include "osculo/motion/rim_tipping/flight.hpp"

namespace osculo::motion {

/// A ball over a hole, as it is in space: its centre's place, the height of that over the table's
/// plane, and how fast they change.
template <math::Scalar S>
struct Hovering {
    math::WidePoint<S> position;  ///< [m]
    math::Vec<S> velocity;        ///< [m/s]
    S height;                     ///< [m], the radius on the table, 0 level with the edge
    S climb;                      ///< [m/s]
};

/// What a ball in a rim with the law `tipping` does next.
enum class TippingStart {
    touches,    ///< it is on the edge, if that pushes it
    lifts_off,  ///< it has just lost contact
    presses,    ///< it touches the edge and moves against it, or no more than rests on it
    leaves,     ///< it parts from the edge that it touches
    flies,      ///< it is off the edge
};

/// How a stretch of such a motion ends.
enum class TippingEnd {
    exit,      ///< the centre crosses the rim outwards
    capture,   ///< the centre comes to be level with the edge: nothing can lift the ball any more
    lift_off,  ///< the edge pushes no more
    edge,      ///< it hits the edge again
    turn,      ///< it swings on the edge between two tilts, and this is its second turn
    balanced,  ///< no digit is left that says whether it tips over
};

/// One stretch of the motion of a ball in a rim with the law `tipping`: on the edge or in flight,
/// until one of the two gives way to the other, or it leaves or falls. Exact but for rounding, see
/// rim_tipping/contact.hpp and flight.hpp. Seen from above it is a disc, whatever its height.
template <math::Scalar S>
class RimTippingStay {
    using Wide = math::Wide<S>;
    using Vec = math::Vec<S>;

public:
    /// [heaviness]: 1 + k of a ball of inertia k m r^2 that rolls on the edge, 1 of one that
    /// slides. Requires gravity > 0, rim.radius > radius > 0; on the edge, a place within the rim
    /// but for rounding.
    RimTippingStay(const geometry::Rim<S>& rim, const S& gravity, const S& radius,
                   const S& heaviness, const Hovering<S>& ball, TippingStart begins)
        : rim_(rim),
          gravity_(gravity),
          radius_(radius),
          heaviness_(heaviness),
          ball_(ball),
          begins_(begins) {
        const math::WidePoint<S> x = math::wide_difference<S>(ball.position, rim.center);
        const Wide d = math::wide_square_root<S>(Wide(x.x * x.x + x.y * x.y));
        out_ = x.rounded() / math::narrow(d);
        if (begins == TippingStart::touches && !(ball.height > S(0))) {
            end_ = TippingEnd::capture;
            return;
        }
        if (begins == TippingStart::presses) {
            end_ = TippingEnd::edge;
            return;
        }
        if (begins == TippingStart::touches && try_contact(x, d)) return;
        fly(x, begins == TippingStart::touches     ? 2
               : begins == TippingStart::lifts_off ? 3
               : begins == TippingStart::leaves    ? 1
                                                   : 0);
    }

    [[nodiscard]] TippingEnd end() const { return end_; }
    /// How long it lasts [s].
    [[nodiscard]] const S& duration() const { return duration_; }
    /// False if the numbers cannot follow it.
    [[nodiscard]] bool sound() const {
        return (!contact_ || contact_->sound()) && math::is_finite<S>(duration_);
    }
    /// Whether it is on the edge, at the time t [s].
    [[nodiscard]] bool touches(const S& t) const {
        return contact_ || (begins_ != TippingStart::flies && !(t > S(0)));
    }
    [[nodiscard]] bool on_edge() const { return contact_.has_value(); }

    /// Place, velocity and half the acceleration at t [s], 0 <= t <= duration(), until the end.
    [[nodiscard]] ParabolicPath<S> at(const S& t) const {
        if (!contact_) {
            return {math::displaced<S>(ball_.position, ball_.velocity, t), ball_.velocity,
                    Vec(S(0), S(0)), S(duration_ - t)};
        }
        const auto hand = contact_->at(units_of(t));
        const Vec along(-hand.out.y(), hand.out.x());
        const S d = math::narrow(Wide(rim_ratio_ - hand.q));
        const S half = -(gravity_ / heaviness_) * hand.q * push(hand) / S(2);
        const math::WidePoint<S> place =
            t > S(0) ? math::WidePoint<S>(
                           Wide(math::wide_sum<S>(rim_.center.x(), S(d * radius_ * hand.out.x()))),
                           Wide(math::wide_sum<S>(rim_.center.y(), S(d * radius_ * hand.out.y()))))
                     : ball_.position;
        const Vec velocity = (-hand.c * hand.rate * unit_speed_) * hand.out +
                             (contact_->moment() * hand.inverse * unit_speed_) * along;
        return {place, velocity, half * hand.out, S(duration_ - t)};
    }
    /// Height and climb at t.
    [[nodiscard]] Hovering<S> in_space(const S& t) const {
        const ParabolicPath<S> now = at(t);
        if (!contact_) {
            const Wide g(gravity_);
            const Wide time(t);
            const Wide fallen = g * time;
            return {now.position, now.velocity,
                    math::narrow(Wide(Wide(ball_.height) +
                                      (Wide(ball_.climb) - Wide(S(0.5)) * fallen) * time)),
                    math::narrow(Wide(Wide(ball_.climb) - fallen))};
        }
        const auto hand = contact_->at(units_of(t));
        return {now.position, now.velocity, S(radius_ * hand.c),
                S(-hand.q * hand.rate * unit_speed_)};
    }

    /// At least |third derivative of the place|, at any time [m/s^3].
    [[nodiscard]] const S& jerk_bound(const S& /*t*/, const S& /*h*/) const { return jerk_; }
    /// At least the speed in the plane.
    [[nodiscard]] const S& most_speed() const { return most_speed_; }
    [[nodiscard]] const geometry::Rim<S>& rim() const { return rim_; }
    [[nodiscard]] const S& gravity() const { return gravity_; }
    /// 1 + k as long as it rolls on the edge, 1 otherwise.
    [[nodiscard]] S heaviness() const { return contact_ ? heaviness_ : S(1); }

    /// What it was made of, besides rim() and gravity().
    [[nodiscard]] const S& ball_radius() const { return radius_; }
    [[nodiscard]] const S& given_heaviness() const { return heaviness_; }
    [[nodiscard]] const Hovering<S>& start() const { return ball_; }
    [[nodiscard]] TippingStart begins() const { return begins_; }

private:
    [[nodiscard]] S units_of(const S& t) const {
        return std::clamp<S>(S(t / unit_time_), S(0), contact_->duration());
    }
    /// Of the edge, over m g / n.
    [[nodiscard]] S push(const typename TippingContact<S>::Hand& hand) const {
        const S swing = contact_->moment() * hand.inverse;
        return hand.c - hand.rate * hand.rate + swing * swing * hand.inverse * hand.q;
    }

    /// False if the edge does not push.
    [[nodiscard]] bool try_contact(const math::WidePoint<S>& x, const Wide& d) {
        const Wide r(radius_);
        // The tilt from place and height together: each tells it badly where the other tells it
        // well.
        const Wide inside = Wide(rim_.radius) - d;
        const Wide height(ball_.height);
        const Wide distance = math::wide_square_root<S>(Wide(inside * inside + height * height));
        const Wide sine = math::wide_quotient(inside, distance);
        const Wide cosine = math::wide_quotient(height, distance);
        const Wide speed = math::wide_square_root<S>(
            math::wide_quotient(math::wide_product<S>(gravity_, radius_), Wide(heaviness_)));
        const Vec& v = ball_.velocity;
        const Wide radial = math::wide_quotient(Wide(x.x * Wide(v.x()) + x.y * Wide(v.y())), d);
        // Around the edge: inwards times cosine, down times sine.
        const Wide around = -(radial * cosine + Wide(ball_.climb) * sine);
        const Wide moment = x.x * Wide(v.y()) - x.y * Wide(v.x());
        rim_ratio_ = math::wide_quotient(Wide(rim_.radius), r);
        contact_.emplace(typename TippingContact<S>::Start{
            rim_ratio_, sine, cosine, math::wide_quotient(around, speed),
            math::wide_quotient(moment, Wide(r * speed)), out_, heaviness_});
        if (!contact_->pushes()) {
            contact_.reset();
            return false;
        }
        unit_speed_ = math::narrow(speed);
        unit_time_ = radius_ / unit_speed_;
        duration_ = contact_->duration() * unit_time_;
        switch (contact_->end()) {
            case ContactEnd::lift_off: end_ = TippingEnd::lift_off; break;
            case ContactEnd::exit: end_ = TippingEnd::exit; break;
            case ContactEnd::down: end_ = TippingEnd::capture; break;
            case ContactEnd::turn: end_ = TippingEnd::turn; break;
            case ContactEnd::balanced: end_ = TippingEnd::balanced; break;
        }
        bound_motion(math::narrow(math::wide_quotient(around, speed)));
        return true;
    }

    /// The speed is at most what the whole height gives; with it, what the place is at most
    /// differentiated thrice: the acceleration is -q N out, N the push, which depends on the tilt.
    void bound_motion(const S& rate) {
        const S& moment = contact_->moment();
        const S ratio = math::narrow(rim_ratio_);
        const S nearest = ratio - contact_->highest();
        const S d = math::norm<S>(math::difference<S>(ball_.position, rim_.center)) / radius_;
        const S swing = moment / d;
        const S speed = S(1.001) * math::square_root<S>(rate * rate + swing * swing + S(2));
        const S square = moment * moment;
        const S cube = nearest * nearest * nearest;
        const S most_push = S(1) + speed * speed + square / cube;
        const S steepness = S(3) + S(3) * square * ratio / (cube * nearest);
        const S turning = math::abs<S>(moment) / (nearest * nearest);
        most_speed_ = speed * unit_speed_;
        jerk_ = S(1.001) * gravity_ / heaviness_ / unit_time_ *
                (speed * (most_push + steepness) + most_push * turning);
    }

    void fly(const math::WidePoint<S>& x, int zeros) {
        const Wide r(radius_);
        const Wide speed = math::wide_square_root<S>(math::wide_product<S>(gravity_, radius_));
        const auto length = [&](const Wide& a) { return math::wide_quotient(a, r); };
        const auto pace = [&](const S& a) { return math::wide_quotient(Wide(a), speed); };
        const TippingFlight<S> flight(typename TippingFlight<S>::Start{
            length(Wide(rim_.radius)), length(x.x), length(x.y), length(Wide(ball_.height)),
            pace(ball_.velocity.x()), pace(ball_.velocity.y()), pace(ball_.climb), zeros});
        duration_ = flight.duration() * (radius_ / math::narrow(speed));
        switch (flight.end()) {
            case FlightEnd::edge: end_ = TippingEnd::edge; break;
            case FlightEnd::down: end_ = TippingEnd::capture; break;
            case FlightEnd::exit: end_ = TippingEnd::exit; break;
        }
        most_speed_ = math::norm<S>(ball_.velocity) * (S(1) + S(16) * math::epsilon<S>());
    }

    geometry::Rim<S> rim_;
    S gravity_;
    S radius_;
    S heaviness_;
    Hovering<S> ball_;
    TippingStart begins_;
    Vec out_{S(0), S(0)};
    Wide rim_ratio_{};
    S unit_speed_{1};
    S unit_time_{1};
    std::optional<TippingContact<S>> contact_;
    TippingEnd end_ = TippingEnd::capture;
    S duration_{0};
    S most_speed_{0};
    S jerk_{0};
};

}  // namespace osculo::motion
