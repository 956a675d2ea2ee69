#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "osculo/scene.hpp"

namespace osculo::bench {

/// A kind of scene, in seeded variants.
struct Workload {
    std::string name;
    std::vector<double> times;  ///< when balls are compared [s], ascending
    Scene (*make)(std::uint64_t seed, double parameter) = nullptr;
    double parameter = 0;
    bool cloth = false;
    int variants = 200;
    int quick_variants = 20;
    double budget = 0.4;  ///< processor time per contender and step [s], less only with --quick
};

/// All of them, from trivial to chaotic.
[[nodiscard]] const std::vector<Workload>& workloads();

}  // namespace osculo::bench
