#pragma once

#include <memory>
#include <utility>

#include "compile_scene.hpp"
#include "convert.hpp"
#include "osculo/engine/scenes.hpp"
#include "state_archive.hpp"
#include "stoppable_run.hpp"

namespace osculo::facade {

/// A run with the engine of that scene type.
template <class Type>
class EngineRun final : public StoppableRun {
public:
    using S = typename Type::Scalar;

    /// Keeps a reference to the scene, which must be valid.
    explicit EngineRun(const Scene& scene) : EngineRun(scene, compile_scene<Type>(scene)) {}

    [[nodiscard]] std::unique_ptr<StoppableRun> clone() const override {
        return std::make_unique<EngineRun>(*this);
    }

    Status play(const Limits& limits) override {
        return engine_.play({S(limits.time), limits.events}, pause_);
    }

    void archive(StateArchive& archive) override {
        engine_.archive(archive);
        archive(pause_.at_this_instant);
    }

    [[nodiscard]] double time() const override {
        return math::to_double<S>(math::narrow(engine_.time()));
    }
    [[nodiscard]] std::uint64_t event_count() const override { return engine_.event_count(); }

    [[nodiscard]] Run finish(Status status, const Limits& limits, bool audit) override {
        Run run;
        run.status = engine_.finish(status, {S(limits.time), limits.events});
        run.time = time();
        run.event_count = engine_.event_count();
        run.settled_count = engine_.settled_count();
        const Converter<Type> convert{scene_, *compiled_};
        run.balls = convert.balls(engine_.bodies());
        if constexpr (Type::Recorder::kEvents) {
            run.events.reserve(engine_.recorder().events.size());
            for (const auto& event : engine_.recorder().events) {
                run.events.push_back(convert.event(event));
            }
        }
        if constexpr (Type::Recorder::kPieces) {
            run.pieces.reserve(engine_.recorder().pieces.size());
            for (const auto& piece : engine_.recorder().pieces) {
                run.pieces.push_back(convert.piece(piece));
            }
            if (audit) {
                run.audit = convert.audit(engine::audit<Type>(compile_scene<Type>(scene_).data,
                                                              engine_.recorder(), engine_.bodies(),
                                                              engine_.time()));
            }
        }
        run.points = compiled_->points;
        return run;
    }

private:
    EngineRun(const Scene& scene, CompiledScene<Type>&& compiled)
        : scene_(scene),
          engine_(std::move(compiled.data)),
          compiled_(std::make_shared<const CompiledScene<Type>>(std::move(compiled))) {}

    const Scene& scene_;
    engine::Engine<Type> engine_;
    std::shared_ptr<const CompiledScene<Type>> compiled_;  ///< without its data; for all copies
    engine::Pause pause_;
};

template <class Type>
[[nodiscard]] std::unique_ptr<StoppableRun> begin_engine_run(const Scene& scene) {
    return std::make_unique<EngineRun<Type>>(scene);
}

}  // namespace osculo::facade
