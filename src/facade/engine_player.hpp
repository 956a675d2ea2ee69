#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "compile_scene.hpp"
#include "convert.hpp"
#include "shot_player.hpp"

namespace osculo::facade {

/// True of engines that record no states: they serve batches that keep outcomes only.
template <class Type>
inline constexpr bool kContactsOnly =
    std::is_same_v<typename Type::Recorder, engine::ContactRecorder<typename Type::Scalar>>;

/// Plays shots with the engine of that scene type, which is made once.
template <class Type>
class EnginePlayer final : public ShotPlayer {
public:
    using S = typename Type::Scalar;

    /// Keeps a reference to the scene. Requires one without a cue.
    explicit EnginePlayer(const Scene& scene)
        : scene_(scene),
          compiled_(compile_scene<Type>(scene)),
          bodies_(compiled_.data.bodies),
          engine_(std::move(compiled_.data)) {}

    void play(std::span<const std::uint8_t> present, const Limits& limits,
              PlayedShot& played) override {
        for (std::size_t n = 0; n < bodies_.size(); ++n) {
            const std::uint32_t index = compiled_.balls[n];
            bodies_[n] = compile_ball<Type>(scene_, scene_.balls[index]);
            bodies_[n].present = present.empty() || present[index] != 0;
        }
        engine_.restart(bodies_);
        played.status = engine_.run({S(limits.time), limits.events});
        played.time = math::to_double<S>(math::narrow(engine_.time()));
        played.event_count = engine_.event_count();
        played.settled_count = engine_.settled_count();
        const Converter<Type> convert{scene_, compiled_};
        count(convert, played);
        played.balls.resize(bodies_.size());
        for (std::size_t n = 0; n < bodies_.size(); ++n) {
            const std::uint32_t index = compiled_.balls[n];
            if (bodies_[n].present) {
                played.balls[index] = convert.final_ball(engine_.bodies()[n], index);
            }
        }
        keep(convert, played);
    }

    [[nodiscard]] const std::vector<std::string>& points() const override {
        return compiled_.points;
    }

private:
    void count(const Converter<Type>& convert, PlayedShot& played) {
        played.counter.begin(cue_ball_of(scene_), bodies_.size());
        for (const auto& event : engine_.recorder().events) {
            const EventKind kind = Converter<Type>::kind(event.kind);
            if constexpr (engine::kHasRims<typename Type::Motion>) {
                // A ball that falls into a rim that pulls it does so by a transition.
                if (kind == EventKind::transition) {
                    const Event converted = convert.event(event);
                    if (converted.kind == EventKind::capture) {
                        played.counter.add(converted.kind, converted.ball, converted.other,
                                           converted.time);
                    }
                    continue;
                }
            }
            if (kind == EventKind::transition) continue;
            played.counter.add(kind, compiled_.balls[event.first],
                               convert.other(kind, event.second),
                               math::to_double<S>(math::narrow(event.when)));
        }
    }

    void keep(const Converter<Type>& convert, PlayedShot& played) {
        if constexpr (!kContactsOnly<Type>) {
            if (played.record == Record::none) return;
            for (const auto& event : engine_.recorder().events) {
                played.events.push_back(convert.event(event));
            }
        }
        if constexpr (Type::Recorder::kPieces) {
            if (played.record != Record::pieces) return;
            for (const auto& piece : engine_.recorder().pieces) {
                played.pieces.push_back(convert.piece(piece));
            }
        }
    }

    const Scene& scene_;
    CompiledScene<Type> compiled_;
    std::vector<engine::Body<Type>> bodies_;  ///< at the start
    engine::Engine<Type> engine_;
};

template <class Type>
[[nodiscard]] std::unique_ptr<ShotPlayer> make_engine_player(const Scene& scene) {
    return std::make_unique<EnginePlayer<Type>>(scene);
}

}  // namespace osculo::facade
