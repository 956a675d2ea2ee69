#include "osculo/simulation.hpp"

#include <algorithm>
#include <optional>

#include "ready_engine.hpp"
#include "simulation_state.hpp"
#include "state_archive.hpp"

namespace osculo {
namespace {

Scene valid(const Scene& scene) {
    validate(scene);
    return scene;
}

}  // namespace

struct Simulation::Implementation {
    Implementation(const Scene& given, const Options& run_options)
        : scene(std::make_shared<const Scene>(valid(given))),
          options(run_options),
          run(facade::begin_run(*scene, options)),
          most(scene->limits) {}
    Implementation(const Implementation& other)
        : scene(other.scene),
          options(other.options),
          run(other.run->clone()),
          most(other.most),
          reached(other.reached),
          status(other.status) {}
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation() = default;

    std::shared_ptr<const Scene> scene;  ///< for all copies
    Options options;
    std::unique_ptr<facade::StoppableRun> run;
    Limits most;
    std::optional<Limits> reached;  ///< of the last play()
    Status status = Status::event_limit;
};

void SimulationState::show(Simulation::Implementation& simulation, facade::StateArchive& archive) {
    bool has_reached = simulation.reached.has_value();
    Limits reached = simulation.reached.value_or(Limits{});
    auto status = static_cast<std::uint8_t>(simulation.status);
    archive(simulation.most.time, simulation.most.events, has_reached, reached.time, reached.events,
            status);
    const bool is_new = status == static_cast<std::uint8_t>(Status::event_limit);
    facade::StateArchive::require(status <= static_cast<std::uint8_t>(Status::numeric) &&
                                  (has_reached || is_new));
    if (has_reached) simulation.reached = reached;
    simulation.status = static_cast<Status>(status);
    simulation.run->archive(archive);
}

Simulation::Simulation(const Scene& scene, const Options& options)
    : implementation_(std::make_unique<Implementation>(scene, options)) {}
Simulation::Simulation(const Simulation& other)
    : implementation_(std::make_unique<Implementation>(*other.implementation_)) {}
Simulation& Simulation::operator=(const Simulation& other) {
    implementation_ = std::make_unique<Implementation>(*other.implementation_);
    return *this;
}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Status Simulation::play(const Limits& limits) {
    Implementation& self = *implementation_;
    const bool can_go_on = self.status == Status::time_limit || self.status == Status::event_limit;
    const Limits& most = self.most;
    if (!can_go_on) {  // more room changes nothing
        Limits& reached = *self.reached;
        reached = {std::max(reached.time, std::min(limits.time, most.time)),
                   std::max(reached.events, std::min(limits.events, most.events))};
        return self.status;
    }
    // Never back behind where it has been; a limit that is not > 0 is no limit of a run.
    const double from = self.status == Status::time_limit ? self.reached->time : time();
    const Limits next{std::min(std::max(limits.time, from), most.time),
                      std::min(std::max(limits.events, event_count()), most.events)};
    if (!(next.time > 0) || next.events == 0) return self.status;
    self.reached = next;
    self.status = self.run->play(next);
    return self.status;
}

Status Simulation::play() {
    return play(implementation_->most);
}

void Simulation::set_limits(const Limits& limits) {
    Scene limited = scene();
    limited.limits = limits;
    validate(limited);
    implementation_->most = limits;
}

const Limits& Simulation::limits() const {
    return implementation_->most;
}

const Scene& Simulation::scene() const {
    return *implementation_->scene;
}

const Options& Simulation::options() const {
    return implementation_->options;
}

Status Simulation::status() const {
    return implementation_->status;
}

double Simulation::time() const {
    return implementation_->run->time();
}

std::uint64_t Simulation::event_count() const {
    return implementation_->run->event_count();
}

Run Simulation::result() const {
    const Implementation& self = *implementation_;
    Scene limited = *self.scene;
    limited.limits = self.reached.value_or(self.most);
    return facade::finish_run(*self.run->clone(), self.status, limited, self.options);
}

std::string SimulationState::save(const Simulation& simulation) {
    facade::StateArchive archive;
    show(*simulation.implementation_, archive);
    return archive.bytes();
}

Simulation SimulationState::restore(const Scene& scene, const Options& options,
                                    std::string_view bytes) {
    Simulation simulation(scene, options);
    facade::StateArchive archive(bytes);
    show(*simulation.implementation_, archive);
    archive.end();
    simulation.set_limits(simulation.limits());
    return simulation;
}

}  // namespace osculo
