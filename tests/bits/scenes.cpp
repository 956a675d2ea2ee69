// Plays scenes with every built-in scalar type and prints every bit of where the balls end up.
// Built by check.cmake with several compilers and optimisation levels, all of which must print the
// same.
#include <cstdint>
#include <cstdio>
#include <utility>

#include "osculo/osculo.hpp"

namespace {

using namespace osculo;

/// A small portable generator (Steele, Lea & Flood 2014, SplitMix64), as a number in [0, 1).
double next(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

template <math::Scalar S>
void print(const S& x) {
    // Three doubles hold every bit of the types in use.
    S rest = x;
    for (int i = 0; i < 3; ++i) {
        const double part = math::to_double<S>(rest);
        std::printf(" %a", part);
        rest -= S(part);
    }
}

template <math::Scalar S>
void play(const char* name, std::uint64_t seed, double restitution) {
    using Type = engine::UniformScene<S, engine::Table, engine::NoRecorder, engine::CellGrid>;
    using Vec = math::Vec<S>;
    engine::SceneData<Type> scene;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 5; ++column) {
            engine::Body<Type> body;
            body.state.position = math::WidePoint<S>(
                Vec(S(0.2 + 0.15 * column + 0.02 * next(seed)), S(0.2 + 0.15 * row)));
            body.state.velocity = {S(next(seed) - 0.5), S(next(seed) - 0.5)};
            body.radius = S(0.02 + 0.04 * next(seed));
            body.mass = S(0.1 + next(seed));
            scene.bodies.push_back(body);
        }
    }
    scene.ball_ball_restitution = S(restitution);
    scene.ball_cushion_restitution = S(restitution);
    const Vec corners[] = {{S(0), S(0)}, {S(1), S(-0.25)}, {S(1.25), S(1)}, {S(0), S(1.125)}};
    auto& rims = std::get<0>(scene.obstacles);
    auto& segments = std::get<1>(scene.obstacles);
    auto& arcs = std::get<2>(scene.obstacles);
    auto& points = std::get<3>(scene.obstacles);
    for (int i = 0; i < 4; ++i) {
        segments.emplace_back(corners[i], corners[(i + 1) % 4], true);
        points.push_back({corners[i]});
    }
    arcs.push_back({Vec(S(1), S(0.375)), S(0.0625), Vec(S(1), S(0)), Vec(S(1), S(0)), false, true});
    rims.push_back({Vec(S(0.01), S(0.01)), S(0.03)});

    engine::Engine<Type> engine(std::move(scene));
    const Status status = engine.run({S(20), 4000});
    std::printf("%s e=%g %d %llu", name, restitution, static_cast<int>(status),
                static_cast<unsigned long long>(engine.event_count()));
    print<S>(math::narrow(engine.time()));
    for (const auto& body : engine.bodies()) {
        print<S>(math::narrow(body.state.position.x));
        print<S>(math::low_part(body.state.position.y));
        print<S>(body.state.velocity.x());
        print<S>(body.state.velocity.y());
    }
    std::printf("\n");
}

}  // namespace

int main() {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        for (const double restitution : {1.0, 0.75}) {
            play<float>("float", seed, restitution);
            play<double>("double", seed, restitution);
            play<long double>("long double", seed, restitution);
            play<math::Quad>("quad", seed, restitution);
        }
    }
    return 0;
}
