#pragma once

#include <string>
#include <string_view>

#include "bad_state.hpp"
#include "osculo/simulation.hpp"

namespace osculo {

namespace facade {
class StateArchive;
}

/// Where a simulation is, as bytes: what io.hpp keeps in files besides scene and options.
struct SimulationState {
    [[nodiscard]] static std::string save(const Simulation& simulation);
    /// The simulation that the bytes were taken of, with its scene and options. Throws as its
    /// constructor does, and facade::BadState for what save() does not write; but bytes that it
    /// could have written of another scene, and numbers that no run has, are not told apart.
    [[nodiscard]] static Simulation restore(const Scene& scene, const Options& options,
                                            std::string_view bytes);

private:
    static void show(Simulation::Implementation& simulation, facade::StateArchive& archive);
};

}  // namespace osculo
