#pragma once

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

    explicit ImpactAudit(const SceneData<Type>& scene, const std::vector<S>& path)
        : scene_(scene), path_(path) {}

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
        const std::size_t balls = event.kind == kBallBall ? 2 : 1;
        S speed{0};
        for (std::size_t k = 0; k < balls; ++k) {
            for (const Memory* of : {&event.before[k], &event.after[k]}) {
                speed = std::max<S>(speed, math::norm_max<S>(of->velocity));
                for (const S& turning : turning_of(*of, body(event, k))) {
                    speed = std::max<S>(speed, math::abs<S>(turning));
                }
            }
        }
        check_gap(event, result);
        check_closing(event, balls, result);
        if (!(speed > S(0))) return;
        check_energy(event, balls, speed, result);
        if (balls == 2) check_momentum(event, speed, result);
    }

    /// What a ball was before a cluster and is after it.
    struct Part {
        BallIndex ball;
        Memory before, after;
        S speed{0};  // the largest in between
    };

    /// Its contacts touch; together they make no energy and leave nothing approaching; each keeps
    /// momentum.
    void check_cluster(std::span<const Event> events, RunAudit& result) const {
        std::vector<Part> parts;
        S speed{0}, gain{0};
        for (const Event& event : events) {
            check_gap(event, result);
            for (std::size_t k = 0; k < (event.kind == kBallBall ? 2U : 1U); ++k) {
                const BallIndex ball = k == 0 ? event.first : event.second;
                auto part = std::find_if(parts.begin(), parts.end(),
                                         [ball](const Part& p) { return p.ball == ball; });
                if (part == parts.end()) {
                    parts.push_back({ball, event.before[k], event.after[k]});
                    part = parts.end() - 1;
                }
                part->after = event.after[k];
                for (const Memory* of : {&event.before[k], &event.after[k]}) {
                    part->speed = std::max<S>(part->speed, math::norm<S>(of->velocity));
                    speed = std::max<S>(speed, math::norm_max<S>(of->velocity));
                    for (const S& turning : turning_of(*of, scene_.bodies[ball])) {
                        speed = std::max<S>(speed, math::abs<S>(turning));
                    }
                }
            }
        }
        if (!(speed > S(0))) return;
        S before{0}, momentum{0};
        for (const Part& part : parts) {
            add_energy(scene_.bodies[part.ball], part.before, part.after, speed, gain, before);
            // A light ball gives heavy ones more, to and fro, than it had.
            momentum = momentum + scene_.bodies[part.ball].mass * (part.speed / speed);
        }
        for (const Event& event : events) {
            Event whole = event;
            for (std::size_t k = 0; k < (event.kind == kBallBall ? 2U : 1U); ++k) {
                const BallIndex ball = k == 0 ? event.first : event.second;
                const auto part = std::find_if(parts.begin(), parts.end(),
                                               [ball](const Part& p) { return p.ball == ball; });
                whole.before[k] = part->before;
                whole.after[k] = part->after;
            }
            gain = gain - gain_in_cluster(event, whole) / speed / speed;
            if (event.kind == kBallBall) note_momentum(event, speed, momentum, result);
            if (still_closes(whole, speed)) ++result.unexplained;
        }
        const S share = gain == S(0) ? gain : S(gain / before);
        result.note(result.largest_energy_gain, math::to_double<S>(share),
                    share <= S(math::kClusterEnergy) * math::epsilon<S>());
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
               S(math::kClusterClosing) * math::epsilon<S>() * speed * math::norm<S>(normal);
    }

    const Body<Type>& body(const Event& event, std::size_t k) const {
        return scene_.bodies[k == 0 ? event.first : event.second];
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
    void check_closing(const Event& event, std::size_t balls, RunAudit& result) const {
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
            const S most = largest_acceleration<S>(scene_.motion);
            S path = path_[event.first];
            if (balls == 2) path = path + path_[event.second];
            noise = noise + math::square_root<S>(S(2) * most * path);
            unresolved = S(math::kContactGap) * math::wide_epsilon<S>() * most *
                         math::abs<S>(math::narrow(event.when));
        }
        noise = (noise * S(math::kVelocityNoise) * math::epsilon<S>() + unresolved) *
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

    /// From the changes of velocity and spin, so that nothing cancels but what the event exchanges.
    void check_energy(const Event& event, std::size_t balls, const S& speed,
                      RunAudit& result) const {
        S gain = -gain_of_pressing(event, balls) / speed / speed;
        S before{0};
        for (std::size_t k = 0; k < balls; ++k) {
            add_energy(body(event, k), event.before[k], event.after[k], speed, gain, before);
        }
        const S share = gain == S(0) ? gain : S(gain / before);
        result.note(result.largest_energy_gain, math::to_double<S>(share),
                    share <= S(math::kImpactEnergy) * math::epsilon<S>());
    }

    /// Adds twice the ball's gain of energy and its energy before, in units of speed^2.
    static void add_energy(const Body<Type>& ball, const Memory& was, const Memory& is,
                           const S& speed, S& gain, S& before) {
        const Vec v = was.velocity / speed;
        const Vec change = (is.velocity - was.velocity) / speed;
        const Spin w = turning_of(was, ball) / speed;
        const Spin twist = turning_of(is, ball) / speed - w;
        const S inertia = inertia_of(ball);
        gain = gain + ball.mass * (math::dot<S>(change, Vec(change + S(2) * v)) +
                                   inertia * twist.dot(Spin(twist + S(2) * w)));
        before = before + ball.mass * (math::dot<S>(v, v) + inertia * w.dot(w));
    }

    /// Twice the energy that an impact of balls pressed together may make, if this was one: see
    /// impact/pressing.hpp. It shows in how slowly they part.
    S gain_of_pressing(const Event& event, std::size_t balls) const {
        if constexpr (Type::Motion::kTransitions) {
            const S least = least_parting(event, balls);
            const S mass =
                balls == 1 ? body(event, 0).mass
                           : S(body(event, 0).mass *
                               (body(event, 1).mass / (body(event, 0).mass + body(event, 1).mass)));
            return parts_slowly(event, balls, least) ? S(mass * least * least) : S(0);
        } else {
            return S(0);
        }
    }
    /// The same of a contact of a cluster, given as what it did itself and with what its balls were
    /// before the cluster and are after it. Parting things that meet no more takes
    /// J (u + u') / 2 with the impulse J, where u and u' are the speeds at which they part before
    /// and after that: no more than J u' with all the impulse there was (the masses of other balls
    /// are in it).
    S gain_in_cluster(const Event& event, const Event& whole) const {
        if constexpr (Type::Motion::kTransitions) {
            const std::size_t balls = event.kind == kBallBall ? 2 : 1;
            if (!parts_slowly(whole, balls, least_parting(whole, balls))) return S(0);
            const std::size_t light =
                balls == 2 && body(event, 1).mass < body(event, 0).mass ? 1 : 0;
            const Vec unit = event.normal / math::norm<S>(event.normal);
            const Vec change = event.after[light].velocity - event.before[light].velocity;
            const S impulse = body(event, light).mass * math::abs<S>(math::dot<S>(change, unit));
            const S parting = parting_speed(whole.after, unit, balls);
            return parting > S(0) ? S(S(2) * impulse * parting) : S(0);
        } else {
            return S(0);
        }
    }

    /// The least speed at which the law of pressed balls lets them part [m/s], at the most.
    S least_parting(const Event& event, std::size_t balls) const {
        S least(0);
        for (std::size_t k = 0; k < balls; ++k) {
            least = least + pressing_acceleration(event, balls, k) * scene_.contact_time / S(2);
        }
        return least;
    }
    static bool parts_slowly(const Event& event, std::size_t balls, const S& least) {
        S noise = least;
        for (std::size_t k = 0; k < balls; ++k) {
            noise = noise + math::norm1<S>(event.after[k].velocity);
        }
        const Vec unit = event.normal / math::norm<S>(event.normal);
        return parting_speed(event.after, unit, balls) <= least + motion_slack<S>() * noise;
    }
    static S parting_speed(const std::array<Memory, 2>& memories, const Vec& unit,
                           std::size_t balls) {
        Vec apart = -memories[0].velocity;
        if (balls == 2) apart += memories[1].velocity;
        return math::dot<S>(apart, unit);
    }

    /// What a ball of that impact can be pressed with [m/s^2]: at twice the sum of all speeds there
    /// are, for that is the most that a light ball gets from a heavy one.
    S pressing_acceleration(const Event& event, std::size_t balls, std::size_t of) const {
        S result = largest_acceleration<S>(scene_.motion);
        if constexpr (ResistedState<std::decay_t<decltype(scene_.bodies[0].state)>, S>) {
            S speed(0);
            for (std::size_t k = 0; k < balls; ++k) {
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

    void check_momentum(const Event& event, const S& speed, RunAudit& result) const {
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
        Vec change(S(0), S(0));
        for (std::size_t k = 0; k < 2; ++k) {
            change += body(event, k).mass *
                      Vec((event.after[k].velocity - event.before[k].velocity) / speed);
        }
        const S error = math::norm<S>(change);
        const S share = error == S(0) ? error : S(error / scale);
        const int bound = event.cluster.number != 0 ? math::kClusterMomentum
                          : Type::Motion::kSpin     ? math::kFrictionMomentum
                                                    : math::kImpactMomentum;
        result.note(result.largest_momentum_error, math::to_double<S>(share),
                    share <= S(bound) * math::epsilon<S>());
    }

    const SceneData<Type>& scene_;
    const std::vector<S>& path_;
};

}  // namespace osculo::engine::detail
