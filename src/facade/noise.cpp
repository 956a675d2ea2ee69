#include "osculo/noise.hpp"

#include <algorithm>
#include <numbers>

#include <Random123/philox.h>

#include "normal_quantile.hpp"

namespace osculo {
namespace {

/// The middle of one of 2^53 equal parts of (0, 1), minus 1/2: exact, and never an end.
double centred_uniform(std::uint64_t word) {
    return (static_cast<double>(word >> 11U) - (0x1p52 - 0.5)) * 0x1p-53;
}

}  // namespace

CueNoise computational_pool_noise(double magnitude) {
    constexpr double kDegree = std::numbers::pi / 180;
    return {.side = magnitude * 0.0005,
            .height = magnitude * 0.0005,
            .speed = magnitude * 0.075,
            .azimuth = magnitude * 0.125 * kDegree,
            .elevation = magnitude * 0.1 * kDegree};
}

std::array<double, 5> standard_normals(const Draw& draw) {
    using Generator = r123::Philox4x64;
    std::array<double, 5> normals{};
    const Generator::key_type key{{draw.seed, 0}};
    for (std::uint64_t block = 0; 4 * block < normals.size(); ++block) {
        const Generator::ctr_type counter{{draw.number, draw.shot, block, 0}};
        const Generator::ctr_type words = Generator()(counter, key);
        for (std::size_t i = 0; i < 4 && 4 * block + i < normals.size(); ++i) {
            normals[4 * block + i] = facade::normal_quantile(centred_uniform(words[i]));
        }
    }
    return normals;
}

Strike perturbed(const Strike& strike, const CueNoise& noise, double radius, const Draw& draw) {
    const auto [side, height, speed, azimuth, elevation] = standard_normals(draw);
    Strike result = strike;
    result.side += noise.side * side / radius;
    result.height += noise.height * height / radius;
    result.speed += noise.speed * speed;
    result.azimuth += noise.azimuth * azimuth;
    const double raised = strike.elevation + noise.elevation * elevation;
    result.elevation = raised < 0 ? 0 : raised;  // NaN remains
    return result;
}

}  // namespace osculo
