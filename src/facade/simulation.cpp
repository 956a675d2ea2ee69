#include "osculo/simulation.hpp"

#include <algorithm>
#include <optional>

#include "ready_engine.hpp"

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
          run(facade::begin_run(*scene, options)) {}
    Implementation(const Implementation& other)
        : scene(other.scene),
          options(other.options),
          run(other.run->clone()),
          reached(other.reached),
          status(other.status) {}
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation() = default;

    std::shared_ptr<const Scene> scene;  ///< for all copies
    Options options;
    std::unique_ptr<facade::StoppableRun> run;
    std::optional<Limits> reached;  ///< of the last play()
    Status status = Status::event_limit;
};

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
    if (!can_go_on) return self.status;
    // Never back behind where it has been; a limit that is not > 0 is no limit of a run.
    const Limits& most = self.scene->limits;
    const double from = self.status == Status::time_limit ? self.reached->time : time();
    const Limits next{std::min(std::max(limits.time, from), most.time),
                      std::min(std::max(limits.events, event_count()), most.events)};
    if (!(next.time > 0) || next.events == 0) return self.status;
    self.reached = next;
    self.status = self.run->play(next);
    return self.status;
}

Status Simulation::play() {
    return play(implementation_->scene->limits);
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
    if (self.reached) limited.limits = *self.reached;
    return facade::finish_run(*self.run->clone(), self.status, limited, self.options);
}

}  // namespace osculo
