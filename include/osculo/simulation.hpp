#pragma once

#include <cstdint>
#include <memory>

#include "osculo/run.hpp"
#include "osculo/scene.hpp"
#include "osculo/simulate.hpp"

namespace osculo {

/// A run that can be stopped anywhere, copied, kept in a file (io.hpp) and played on, each copy by
/// itself, bit for bit as if it had never stopped. Stopping disturbs nothing: balls are brought to
/// the end of a run only in what result() returns.
class Simulation {
public:
    /// At the start of the scene's run. Throws as simulate() does.
    explicit Simulation(const Scene& scene, const Options& options = {});
    Simulation(const Simulation& other);
    Simulation& operator=(const Simulation& other);
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();

    /// Plays on to those limits, or to the scene's (set_limits) if they come first: at most until
    /// that time, counted from the start of the run, and until there have been so many events from
    /// the start of the run on. Returns how it ended; after anything but time_limit and event_limit
    /// there is nothing more to play.
    Status play(const Limits& limits);
    /// Plays on to the end.
    Status play();

    /// Lets play() go on to these limits instead of the scene's. Throws SceneError if they are not
    /// limits of a scene.
    void set_limits(const Limits& limits);
    [[nodiscard]] const Limits& limits() const;

    /// What is played.
    [[nodiscard]] const Scene& scene() const;
    [[nodiscard]] const Options& options() const;

    /// How play() ended last; event_limit before the first time.
    [[nodiscard]] Status status() const;
    /// Instant of the last event, rounded [s].
    [[nodiscard]] double time() const;
    [[nodiscard]] std::uint64_t event_count() const;

    /// What simulate() returns for this scene with the limits of the last play(). Before the first
    /// one: with no event.
    [[nodiscard]] Run result() const;

private:
    friend struct SimulationState;  // for files: io.hpp
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace osculo
