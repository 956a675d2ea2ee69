#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "osculo/noise.hpp"
#include "python/bindings.hpp"
#include "python/noise.hpp"

namespace osculo::python {

namespace py = pybind11;
using namespace pybind11::literals;

CueNoise noise_from(const py::object& noise) {
    if (py::isinstance<py::float_>(noise) || py::isinstance<py::int_>(noise)) {
        return computational_pool_noise(noise.cast<double>());
    }
    CueNoise result;
    for (const auto& [name, value] : noise.cast<py::dict>()) {
        const auto key = name.cast<std::string>();
        double* const member = key == "side"        ? &result.side
                               : key == "height"    ? &result.height
                               : key == "speed"     ? &result.speed
                               : key == "azimuth"   ? &result.azimuth
                               : key == "elevation" ? &result.elevation
                                                    : nullptr;
        if (!member) throw py::key_error("noise has no member '" + key + "'");
        *member = value.cast<double>();
    }
    return result;
}

namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::dict tournament_noise(double magnitude) {
    const CueNoise noise = computational_pool_noise(magnitude);
    py::dict result;
    result["side"] = noise.side;
    result["height"] = noise.height;
    result["speed"] = noise.speed;
    result["azimuth"] = noise.azimuth;
    result["elevation"] = noise.elevation;
    return result;
}

Rows perturb(const Rows& shots, std::uint64_t draws, double radius, const py::object& noise,
             std::uint64_t seed) {
    if (shots.ndim() != 2 || shots.shape(1) != 5) {
        throw std::invalid_argument("shots must be of the shape (N, 5)");
    }
    const CueNoise deviations = noise_from(noise);
    const auto count = static_cast<std::uint64_t>(shots.shape(0));
    Rows result({shots.shape(0), static_cast<py::ssize_t>(draws), py::ssize_t{5}});
    double* out = result.mutable_data();
    for (std::uint64_t shot = 0; shot < count; ++shot) {
        const double* const row = shots.data(static_cast<py::ssize_t>(shot));
        const Strike strike{row[0], row[1], row[2], row[3], row[4]};
        for (std::uint64_t number = 0; number < draws; ++number) {
            const Strike played = perturbed(strike, deviations, radius, {seed, shot, number});
            for (const double value :
                 {played.speed, played.azimuth, played.elevation, played.side, played.height}) {
                *out++ = value;
            }
        }
    }
    return result;
}

}  // namespace

void bind_noise(py::module_& module) {
    module.def(
        "tournament_noise", tournament_noise, "magnitude"_a = 1.0,
        R"(Standard deviations of what is executed from what is intended, as in the computational
pool tournaments, times the magnitude: side and height of the tip [m], speed [m/s], azimuth and
elevation [rad].)");
    module.def("perturb", perturb, "shots"_a, py::kw_only(), "draws"_a, "radius"_a, "noise"_a = 1.0,
               "seed"_a = std::uint64_t{0},
               R"(The shots as they are executed: shape (N, draws, 5) for shots of shape (N, 5).

radius: of the cue ball [m]. noise: a dict as of tournament_noise(), or its magnitude. The same seed
gives the same numbers everywhere; an elevation of NaN remains it.)");
}

}  // namespace osculo::python
