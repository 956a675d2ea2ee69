// Many balls: every contact multiplies the errors of places by some factor.

#include "case.hpp"
#include "osculo/presets.hpp"

namespace osculo::bench::stability {
namespace {

Case named(std::string name, Scene scene) {
    Case c;
    c.name = std::move(name);
    c.family = "chaos";
    c.stiff = "an error grows with every contact";
    c.scene = std::move(scene);
    c.read = read_positions;
    return c;
}

}  // namespace

void add_chaos(Catalogue& all) {
    for (const std::uint64_t events : {50U, 100U, 150U}) {
        Case c = named("16 disks, " + std::to_string(events) + " events",
                       presets::make("gas", {.balls = 16, .seed = 1}));
        c.scene.limits = {1e9, events};
        c.statuses = {Status::event_limit};
        all.push_back(c);
    }
    Case rack = named("frictionless break, 60 events", presets::make("frictionless-break", {}));
    rack.scene.limits.events = 60;
    rack.statuses = {Status::event_limit};
    all.push_back(rack);

    Case cloth = named("break on cloth, to rest", presets::make("break", {}));
    cloth.statuses = {Status::at_rest};
    all.push_back(cloth);
    Case snooker = named("snooker break on cloth, to rest", presets::make("snooker-break", {}));
    snooker.statuses = {Status::at_rest};
    all.push_back(snooker);
}

Catalogue catalogue() {
    Catalogue all;
    add_wedges(all);
    add_impacts(all);
    add_instants(all);
    add_scales(all);
    add_curves(all);
    add_collapses(all);
    add_resting(all);
    add_chaos(all);
    return all;
}

}  // namespace osculo::bench::stability
