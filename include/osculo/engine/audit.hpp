#pragma once

#include <span>

#include "osculo/engine/audit/gaps.hpp"
#include "osculo/engine/audit/histories.hpp"
#include "osculo/engine/audit/impacts.hpp"
#include "osculo/engine/audit/resisted.hpp"
#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/rounding.hpp"

namespace osculo::engine {

namespace detail {

/// Straight pieces; or curved ones of a law that the audit knows.
template <class Type>
concept AuditableMotion = !Type::Motion::kTransitions ||
                          requires(const SceneData<Type>& scene, const PieceOf<Type>& piece,
                                   const typename Type::Scalar& t) {
    obeys<typename Type::Scalar>(scene.motion, beginning(piece), t);
};

}  // namespace detail

/// An independent check of a run, from what a recorder of events and pieces recorded: [scene] is
/// what was run, [bodies] and [end] are what Engine::bodies() and time() were afterwards.
///
/// It measures trajectories by its own formulas, holds every piece against its motion law, follows
/// every ball through its pieces and events, and shares no code with detection, queue and broad
/// phase. Costs (pieces) x (balls) comparisons of boxes, and arithmetic only for what comes near.
template <class Type>
[[nodiscard]] RunAudit audit(const SceneData<Type>& scene, const typename Type::Recorder& record,
                             const std::vector<Body<Type>>& bodies,
                             const math::Instant<typename Type::Scalar>& end) {
    using S = typename Type::Scalar;
    static_assert(Type::Recorder::kEvents && Type::Recorder::kPieces,
                  "osculo: an audit needs the record of events and pieces");
    static_assert(detail::AuditableMotion<Type>,
                  "osculo: an audit of motion with transitions needs its State recorded in pieces "
                  "and its law as in engine/audit/motion_laws.hpp");
    RunAudit result;
    const std::vector<S> path = rounding_paths<Type>(scene, record);

    const detail::ImpactAudit<Type> impacts(scene, path, record.pieces);
    detail::HistoryAudit<Type> histories(scene, record.pieces);
    if (!record.events.empty()) {
        result.largest_energy_gain = -std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 0; k < record.events.size();) {
        std::size_t end_of_cluster = k + 1;
        const std::uint32_t cluster = record.events[k].cluster.number;
        while (cluster != 0 && end_of_cluster < record.events.size() &&
               record.events[end_of_cluster].cluster.number == cluster) {
            ++end_of_cluster;
        }
        impacts.check(std::span(record.events).subspan(k, end_of_cluster - k), result);
        for (; k < end_of_cluster; ++k) histories.follow(record.events[k], result);
    }
    if (std::isinf(result.largest_energy_gain) && result.largest_energy_gain < 0) {
        result.largest_energy_gain = 0;  // events without motion
    }
    histories.finish(bodies, end, result);
    detail::GapAudit<Type>(scene, path, result).check(record.pieces);

    const auto energy = [&](const std::vector<Body<Type>>& of) {
        S sum{0};
        for (const Body<Type>& body : of) {
            auto state = body.state;
            if constexpr (kHasRims<typename Type::Motion>) {
                // One that is not yet known to be in a rim.
                if (state.rim == Type::Motion::kUnknown) {
                    Type::Motion::template begin<S>(scene.motion, state);
                }
            }
            sum = sum + body.mass * twice_energy_per_mass<S>(state) / S(2);
        }
        return math::to_double<S>(sum);
    };
    result.energy_initial = energy(scene.bodies);
    result.energy_final = energy(bodies);
    result.clean = result.clean && result.unexplained == 0;
    return result;
}

}  // namespace osculo::engine
