#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "osculo/engine/audit/contact.hpp"
#include "osculo/engine/audit/resisted.hpp"
#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/rims.hpp"
#include "osculo/engine/audit/tipping_rims.hpp"

namespace osculo::engine::detail {

/// Checks every event by itself: that its things touch and close in, that it keeps momentum and
/// makes no energy.
template <class Type>
class ImpactAudit {
public:
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;
    using Event = EventOf<Type>;
    using Memory = MemoryOf<Type>;
    using Spin = math::Vec3<S>;

    ImpactAudit(const SceneData<Type>& scene, const std::vector<S>& path,
                const std::vector<PieceOf<Type>>& pieces)
        : scene_(scene), path_(path) {
        if constexpr (Type::Motion::kTransitions) {
            fastest_.resize(scene.bodies.size(), S(0));
            for (const PieceOf<Type>& piece : pieces) {
                S& speed = fastest_[piece.ball];
                speed = std::max<S>(speed, motion_scale<S>(beginning(piece), S(0)));
            }
        }
    }

    /// [events]: one, or all of a cluster.
    void check(std::span<const Event> events, RunAudit& result) const {
        if (events.size() == 1 && events.front().cluster.number == 0) {
            check(events.front(), result);
        } else {
            check_cluster(events, result);
        }
    }

private:
    void check(const Event& event, RunAudit& result) const {
        if (event.kind == kTransition) return;  // changes nothing, which is its ball's history
        check_gap(event, result);
        check_closing(event, result);
        const S speed = largest_speed(event);
        if (!(speed > S(0))) return;
        check_energy(event, speed, result);
        if (event.kind == kBallBall) check_momentum(event, result);
    }
    /// Of its balls, before and after, those of their surfaces included [m/s].
    S largest_speed(const Event& event) const {
        S speed{0};
        for (std::size_t k = 0; k < balls_of(event); ++k) {
            for (const Memory* of : {&event.before[k], &event.after[k]}) {
                speed = std::max<S>(speed, math::norm_max<S>(of->velocity));
                for (const S& turning : turning_of(*of, body(event, k))) {
                    speed = std::max<S>(speed, math::abs<S>(turning));
                }
            }
        }
        return speed;
    }
    static std::size_t balls_of(const Event& event) { return event.kind == kBallBall ? 2 : 1; }
    static BallIndex ball_of(const Event& event, std::size_t k) {
        return k == 0 ? event.first : event.second;
    }
    const Body<Type>& body(const Event& event, std::size_t k) const {
        return scene_.bodies[ball_of(event, k)];
    }

    /// What a ball was before a cluster and is after it.
    struct Part {
        BallIndex ball;
        Memory before, after;
        S speed{0};  // the largest in between
    };
    using Parts = std::vector<Part>;
    /// That of the ball, or the end.
    static typename Parts::iterator part_of(Parts& parts, BallIndex ball) {
        return std::ranges::find(parts, ball, &Part::ball);
    }
    static Parts parts_of(std::span<const Event> events) {
        Parts parts;
        for (const Event& event : events) {
            for (std::size_t k = 0; k < balls_of(event); ++k) {
                const BallIndex ball = ball_of(event, k);
                auto part = part_of(parts, ball);
                if (part == parts.end()) {
                    part = parts.insert(part, Part{ball, event.before[k], event.after[k]});
                }
                part->after = event.after[k];
                part->speed = std::max({part->speed, math::norm<S>(event.before[k].velocity),
                                        math::norm<S>(event.after[k].velocity)});
            }
        }
        return parts;
    }

    /// Its contacts touch; together they make no energy and leave nothing approaching; each keeps
    /// momentum.
    void check_cluster(std::span<const Event> events, RunAudit& result) const {
        S speed{0};
        for (const Event& event : events) {
            check_gap(event, result);
            speed = std::max<S>(speed, largest_speed(event));
        }
        if (!(speed > S(0))) return;
        Parts parts = parts_of(events);
        Gain gain;
        S fastest{0};
        for (const Part& part : parts) {
            add_energy(scene_.bodies[part.ball], part.before, part.after, speed, gain);
            fastest = std::max<S>(fastest, part.speed);
        }
        // A light ball gives heavy ones more, to and fro, than it had.
        S momentum{0};
        for (const Part& part : parts) {
            if (!(fastest > S(0))) break;  // they turn on the spot
            momentum = momentum + scene_.bodies[part.ball].mass * (part.speed / fastest);
        }
        for (const Event& event : events) {
            Event whole = event;
            for (std::size_t k = 0; k < balls_of(event); ++k) {
                const auto part = part_of(parts, ball_of(event, k));
                whole.before[k] = part->before;
                whole.after[k] = part->after;
            }
            gain.gained = gain.gained - gain_in_cluster(event, whole, speed);
            if (event.kind == kBallBall) note_momentum(event, fastest, momentum, result);
            if (still_closes(whole, speed)) ++result.unexplained;
        }
        note_energy(gain, math::kClusterEnergy, result);
    }

    /// By more than the rounding of the cluster's speeds.
    bool still_closes(const Event& whole, const S& speed) const {
        const bool pair = whole.kind == kBallBall;
        const Vec normal =
            pair ? math::difference<S>(whole.before[1].position, whole.before[0].position)
                 : whole.normal;
        Vec v = whole.after[0].velocity;
        if (pair) v -= whole.after[1].velocity;
        return math::accurate_dot<S>(v, normal) >
               (S(math::kClusterClosing) * math::epsilon<S>() * speed + underflow_along(normal)) *
                   math::norm<S>(normal);
    }

    /// What of a speed along that [m] may be rounding where numbers end: it is found from products
    /// with it.
    static S underflow_along(const Vec& normal) {
        const S length = math::norm1<S>(normal);
        return S(math::kUnderflow) * (length + S(1) / length);
    }

    void check_gap(const Event& event, RunAudit& result) const {
        const ContactOf<S> contact = contact_of<Type>(scene_, event);
        S path = path_[event.first];
        S speed = math::norm1<S>(event.before[0].velocity);
        if (event.kind == kBallBall) {
            path = path + path_[event.second];
            speed = speed + math::norm1<S>(event.before[1].velocity);
        }
        const auto& place = event.before[0].position;
        S bound = gap_bound<S>(contact.reach, path) +
                  resolution<S>(place, speed, event.when, contact.from);
        if constexpr (Type::Simultaneous::kGathersCluster) {
            bound = bound + together_gap<S>(math::norm1<S>(place.rounded()) + path, contact.reach);
        }
        result.note(result.largest_contact_error, math::to_double<S>(contact.gap / contact.smaller),
                    contact.gap <= bound);
    }

    /// Approaching before; after it not any more, unless captured.
    void check_closing(const Event& event, RunAudit& result) const {
        const std::size_t balls = balls_of(event);
        const Vec normal =
            balls == 2 ? math::difference<S>(event.before[1].position, event.before[0].position)
                       : event.normal;
        const auto closing = [&](const std::array<Memory, 2>& moments) {
            Vec v = moments[0].velocity;
            if (balls == 2) v -= moments[1].velocity;
            return math::accurate_dot<S>(v, normal);
        };
        S noise{0};
        for (std::size_t k = 0; k < balls; ++k) {
            noise = noise + math::norm1<S>(event.before[k].velocity) +
                    math::norm1<S>(event.after[k].velocity);
        }
        S unresolved{0};
        if constexpr (Type::Motion::kTransitions) {
            // What is left of a speed has the rounding of what it has been, and of when it is.
            for (std::size_t k = 0; k < balls; ++k) {
                noise = noise + fastest_[ball_of(event, k)];
            }
            unresolved = S(math::kContactGap) * math::wide_epsilon<S>() *
                         largest_acceleration<S>(scene_.motion) *
                         math::abs<S>(math::narrow(event.when));
        }
        noise = (noise * S(math::kVelocityNoise) * math::epsilon<S>() + unresolved +
                 underflow_along(normal)) *
                math::norm1<S>(normal);
        if (closing(event.before) < -noise) ++result.unexplained;
        if (has_effect<Type>(event.kind, Effect::capture) ||
            has_effect<Type>(event.kind, Effect::entry)) {
            return;
        }
        if (closing(event.after) > noise) ++result.unexplained;
    }

    /// Spin times radius [m/s].
    static Spin turning_of(const Memory& memory, const Body<Type>& body) {
        if constexpr (Type::Motion::kSpin) {
            return body.radius * memory.spin;
        } else {
            return Spin(S(0), S(0), S(0));
        }
    }
    static S inertia_of(const Body<Type>& body) {
        if constexpr (Type::Motion::kSpin) {
            return body.state.inertia;
        } else {
            return S(0);
        }
    }

    /// Twice an energy, in units of speed^2 of some speed.
    struct Gain {
        S gained{0}, before{0};
        S underflow{0};  ///< what of the gain comes from where numbers end
    };

    /// From the changes of velocity and spin, so that nothing cancels but what the event exchanges.
    void check_energy(const Event& event, const S& speed, RunAudit& result) const {
        Gain gain;
        gain.gained = -gain_of_pressing(event, speed);
        for (std::size_t k = 0; k < balls_of(event); ++k) {
            add_energy(body(event, k), event.before[k], event.after[k], speed, gain);
        }
        note_energy(gain, math::kImpactEnergy, result);
    }
    static void note_energy(const Gain& gain, int bound, RunAudit& result) {
        const S share = gain.gained == S(0) ? gain.gained : S(gain.gained / gain.before);
        result.note(result.largest_energy_gain, math::to_double<S>(share),
                    gain.gained <= S(bound) * (math::epsilon<S>() * gain.before + gain.underflow));
    }

    /// Adds that of a ball.
    static void add_energy(const Body<Type>& ball, const Memory& was, const Memory& is,
                           const S& speed, Gain& gain) {
        const Vec v = was.velocity / speed;
        const Vec change = (is.velocity - was.velocity) / speed;
        const Spin w = turning_of(was, ball) / speed;
        const Spin twist = turning_of(is, ball) / speed - w;
        const S inertia = inertia_of(ball);
        gain.gained = gain.gained + ball.mass * (math::dot<S>(change, Vec(change + S(2) * v)) +
                                                 inertia * twist.dot(Spin(twist + S(2) * w)));
        gain.before = gain.before + ball.mass * (math::dot<S>(v, v) + inertia * w.dot(w));
        gain.underflow = gain.underflow + ball.mass * (underflow<S>(ball) / speed);
    }

    /// What an impact of balls pressed together may make, if this was one (impact/pressing.hpp), as
    /// Gain::gained. It shows in how slowly they part.
    S gain_of_pressing(const Event& event, const S& speed) const {
        if constexpr (Type::Motion::kTransitions) {
            const S least = least_parting(event);
            const S mass =
                event.kind != kBallBall
                    ? body(event, 0).mass
                    : S(body(event, 0).mass *
                        (body(event, 1).mass / (body(event, 0).mass + body(event, 1).mass)));
            return parts_slowly(event, least) ? S(mass * (least / speed) * (least / speed)) : S(0);
        } else {
            return S(0);
        }
    }
    /// The same of a contact of a cluster, given as what it did itself and with what its balls were
    /// before the cluster and are after it. Parting things that meet no more takes
    /// J (u + u') / 2 with the impulse J, where u and u' are the speeds at which they part before
    /// and after that: no more than J u' with all the impulse there was (the masses of other balls
    /// are in it).
    S gain_in_cluster(const Event& event, const Event& whole, const S& speed) const {
        if constexpr (Type::Motion::kTransitions) {
            if (!parts_slowly(whole, least_parting(whole))) return S(0);
            const std::size_t light =
                event.kind == kBallBall && body(event, 1).mass < body(event, 0).mass ? 1 : 0;
            const Vec unit = event.normal / math::norm<S>(event.normal);
            const Vec change = (event.after[light].velocity - event.before[light].velocity) / speed;
            const S impulse = body(event, light).mass * math::abs<S>(math::dot<S>(change, unit));
            const S parting = parting_speed(whole, unit) / speed;
            return parting > S(0) ? S(S(2) * impulse * parting) : S(0);
        } else {
            return S(0);
        }
    }

    /// The least speed at which the law of pressed balls lets them part [m/s], at the most.
    S least_parting(const Event& event) const {
        S least(0);
        for (std::size_t k = 0; k < balls_of(event); ++k) {
            least = least + pressing_acceleration(event, k) * scene_.contact_time / S(2);
        }
        return least;
    }
    static bool parts_slowly(const Event& event, const S& least) {
        S noise = least;
        for (std::size_t k = 0; k < balls_of(event); ++k) {
            noise = noise + math::norm1<S>(event.after[k].velocity);
        }
        const Vec unit = event.normal / math::norm<S>(event.normal);
        return parting_speed(event, unit) <= least + motion_slack<S>() * noise;
    }
    static S parting_speed(const Event& event, const Vec& unit) {
        Vec apart = -event.after[0].velocity;
        if (event.kind == kBallBall) apart += event.after[1].velocity;
        return math::dot<S>(apart, unit);
    }

    /// What a ball of that impact can be pressed with [m/s^2]: at twice the sum of all speeds there
    /// are, for that is the most that a light ball gets from a heavy one.
    S pressing_acceleration(const Event& event, std::size_t of) const {
        S result = largest_acceleration<S>(scene_.motion);
        if constexpr (ResistedState<std::decay_t<decltype(scene_.bodies[0].state)>, S>) {
            S speed(0);
            for (std::size_t k = 0; k < balls_of(event); ++k) {
                for (const Memory* memory : {&event.before[k], &event.after[k]}) {
                    const Spin turning = turning_of(*memory, body(event, k));
                    speed = speed + math::norm<S>(memory->velocity) +
                            math::square_root<S>(turning.dot(turning));
                }
            }
            result = std::min<S>(result, acceleration_at<S>(body(event, of).state, S(2) * speed));
        }
        return result;
    }

    void check_momentum(const Event& event, RunAudit& result) const {
        S speed{0};
        for (std::size_t k = 0; k < 2; ++k) {
            speed = std::max({speed, math::norm_max<S>(event.before[k].velocity),
                              math::norm_max<S>(event.after[k].velocity)});
        }
        if (!(speed > S(0))) return;
        S before{0};
        for (std::size_t k = 0; k < 2; ++k) {
            before = before + momentum_of(body(event, k), event.before[k], event.after[k], speed);
        }
        note_momentum(event, speed, before, result);
    }
    /// What the rounding of a ball's momentum is measured by, over [speed]: that before, or where
    /// things that are pressed together part faster than they met, that after.
    static S momentum_of(const Body<Type>& ball, const Memory& was, const Memory& is,
                         const S& speed) {
        S fastest = math::norm<S>(was.velocity);
        if constexpr (Type::Motion::kTransitions) {
            fastest = std::max<S>(fastest, math::norm<S>(is.velocity));
        }
        return ball.mass * (fastest / speed);
    }
    /// Two balls: what one gets the other gives. [scale]: momentum that this is measured by.
    void note_momentum(const Event& event, const S& speed, const S& scale, RunAudit& result) const {
        if (!(speed > S(0))) return;
        Vec change(S(0), S(0));
        S least(0);  // what of it comes from where numbers end
        for (std::size_t k = 0; k < 2; ++k) {
            least = least + body(event, k).mass * (S(math::kUnderflow) / speed);
            change += body(event, k).mass *
                      Vec((event.after[k].velocity - event.before[k].velocity) / speed);
        }
        const S error = math::norm<S>(change);
        const S share = error == S(0) ? error : S(error / scale);
        const int bound = event.cluster.number != 0 ? math::kClusterMomentum
                          : Type::Motion::kSpin     ? math::kFrictionMomentum
                                                    : math::kImpactMomentum;
        result.note(result.largest_momentum_error, math::to_double<S>(share),
                    error <= S(bound) * (math::epsilon<S>() * scale + least));
    }

    const SceneData<Type>& scene_;
    const std::vector<S>& path_;
    std::vector<S> fastest_;  // each ball at its fastest, where what moves slows down [m/s]
};

}  // namespace osculo::engine::detail
