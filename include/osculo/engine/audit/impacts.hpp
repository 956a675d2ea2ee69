#pragma once

#include "osculo/engine/audit/pieces.hpp"
#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/smallest_gap.hpp"

namespace osculo::engine::detail {

/// Checks every event by itself: that its things touch and close in, that it keeps momentum and
/// makes no energy.
template <class Type>
class ImpactAudit {
public:
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;
    using Event = EventRecord<S>;

    explicit ImpactAudit(const SceneData<Type>& scene, const std::vector<S>& path)
        : scene_(scene), path_(path) {}

    void check(const Event& event, RunAudit& result) const {
        const std::size_t balls = event.kind == kBallBall ? 2 : 1;
        S speed{0};
        for (std::size_t k = 0; k < balls; ++k) {
            speed = std::max<S>(speed, math::norm_max<S>(event.before[k].velocity));
            speed = std::max<S>(speed, math::norm_max<S>(event.after[k].velocity));
        }
        check_gap(event, result);
        check_closing(event, balls, result);
        if (!(speed > S(0))) return;
        check_energy(event, balls, speed, result);
        if (balls == 2) check_momentum(event, speed, result);
    }

private:
    const Body<Type>& body(const Event& event, std::size_t k) const {
        return scene_.bodies[k == 0 ? event.first : event.second];
    }

    void check_gap(const Event& event, RunAudit& result) const {
        const Body<Type>& one = body(event, 0);
        S gap{0};
        S reach = one.radius;
        S smaller = one.radius;
        S path = path_[event.first];
        Vec from(S(0), S(0));
        if (event.kind == kBallBall) {
            const Body<Type>& other = body(event, 1);
            const math::WidePoint<S> apart{event.before[0].position.x - event.before[1].position.x,
                                           event.before[0].position.y - event.before[1].position.y};
            gap = length_beyond<S>(apart, math::wide_sum<S>(one.radius, other.radius));
            reach = reach + other.radius;
            smaller = std::min<S>(smaller, other.radius);
            path = path + path_[event.second];
        } else {
            with_obstacle<Type>(scene_, event.kind, event.second, [&](const auto& obstacle) {
                gap = contact_gap(seen_from(event.before[0].position, origin(obstacle)), one.radius,
                                  obstacle);
                reach = reach + contact_reach(obstacle);
                from = origin(obstacle);
            });
        }
        const S bound =
            gap_bound<S>(reach, path) +
            resolution<S>(event.before[0].position, event.before[0].velocity, event.when, from);
        result.note(result.largest_contact_error, math::to_double<S>(gap / smaller), gap <= bound);
    }

    /// Approaching before; after it not any more, unless captured.
    void check_closing(const Event& event, std::size_t balls, RunAudit& result) const {
        const Vec normal =
            balls == 2 ? math::difference<S>(event.before[1].position, event.before[0].position)
                       : event.normal;
        const auto closing = [&](const std::array<Moment<S>, 2>& moments) {
            Vec v = moments[0].velocity;
            if (balls == 2) v -= moments[1].velocity;
            return math::accurate_dot<S>(v, normal);
        };
        S noise{0};
        for (std::size_t k = 0; k < balls; ++k) {
            noise = noise + math::norm1<S>(event.before[k].velocity) +
                    math::norm1<S>(event.after[k].velocity);
        }
        noise = noise * S(math::kVelocityNoise) * math::epsilon<S>() * math::norm1<S>(normal);
        if (closing(event.before) < -noise) ++result.unexplained;
        if (!event_captures<Type>(event.kind) && closing(event.after) > noise) ++result.unexplained;
    }

    /// From the changes of velocity, so that nothing cancels but what the event exchanges.
    void check_energy(const Event& event, std::size_t balls, const S& speed,
                      RunAudit& result) const {
        S gain{0};
        S before{0};
        for (std::size_t k = 0; k < balls; ++k) {
            const Vec v = event.before[k].velocity / speed;
            const Vec change = (event.after[k].velocity - event.before[k].velocity) / speed;
            gain = gain + body(event, k).mass * math::dot<S>(change, Vec(change + S(2) * v));
            before = before + body(event, k).mass * math::dot<S>(v, v);
        }
        const S share = gain == S(0) ? gain : S(gain / before);
        result.note(result.largest_energy_gain, math::to_double<S>(share),
                    share <= S(math::kImpactEnergy) * math::epsilon<S>());
    }

    void check_momentum(const Event& event, const S& speed, RunAudit& result) const {
        Vec change(S(0), S(0));
        S before{0};
        for (std::size_t k = 0; k < 2; ++k) {
            const S mass = body(event, k).mass;
            change += mass * Vec((event.after[k].velocity - event.before[k].velocity) / speed);
            before = before + mass * math::norm<S>(event.before[k].velocity) / speed;
        }
        const S error = math::norm<S>(change);
        const S share = error == S(0) ? error : S(error / before);
        result.note(result.largest_momentum_error, math::to_double<S>(share),
                    share <= S(math::kImpactMomentum) * math::epsilon<S>());
    }

    const SceneData<Type>& scene_;
    const std::vector<S>& path_;
};

}  // namespace osculo::engine::detail
