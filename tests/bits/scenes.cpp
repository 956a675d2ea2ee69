// Plays scenes with every built-in scalar type and prints every bit of where the balls end up.
// Built by check.cmake with several compilers and optimisation levels, all of which must print the
// same.
#include <cstdint>
#include <cstdio>
#include <utility>

#include "osculo/impact/cue_strike.hpp"
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

template <class Type>
void add_table(engine::SceneData<Type>& scene) {
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;
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
}

template <class Type>
void run(const char* name, double restitution, engine::SceneData<Type> scene) {
    using S = typename Type::Scalar;
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
    add_table(scene);
    run(name, restitution, std::move(scene));
}

/// A rack without gaps, broken in a box: what touches is resolved at once.
template <math::Scalar S>
void play_rack(const char* name, std::uint64_t seed, double restitution) {
    using Type = engine::UniformScene<S, engine::Table, engine::NoRecorder, engine::AllPairs,
                                      impact::Symmetric>;
    using Vec = math::Vec<S>;
    engine::SceneData<Type> scene;
    const auto ball = [&](const Vec& place, const Vec& velocity) {
        engine::Body<Type> body;
        body.state.position = math::WidePoint<S>(place);
        body.state.velocity = velocity;
        body.radius = S(0.03125);
        scene.bodies.push_back(body);
    };
    ball(Vec(S(0.25), S(0.5)), Vec(S(1), S(0.2 * next(seed) - 0.1)));
    const S row_step = math::square_root<S>(S(3)) / S(32);
    for (int row = 0; row < 5; ++row) {
        for (int place = 0; place <= row; ++place) {
            ball(Vec(S(0.5) + S(row) * row_step, S(0.5) + S(2 * place - row) / S(32)),
                 Vec(S(0), S(0)));
        }
    }
    scene.ball_ball_restitution = S(restitution);
    scene.ball_cushion_restitution = S(restitution);
    scene.rest_speed = S(1e-6);
    add_table(scene);
    run(name, restitution, std::move(scene));
}

/// The same on a cloth with friction everywhere, one of the balls struck by a cue.
template <math::Scalar S>
void play_cloth(const char* name, std::uint64_t seed) {
    using Type = engine::ClothScene<S, impact::CushionHan2005, engine::NoRecorder>;
    using Vec = math::Vec<S>;
    engine::SceneData<Type> scene;
    for (int k = 0; k < 12; ++k) {
        engine::Body<Type> body;
        body.radius = S(0.03);
        body.mass = S(0.17);
        body.state.radius = body.radius;
        body.state.position = math::WidePoint<S>(
            Vec(S(0.2 + 0.15 * (k % 4) + 0.02 * next(seed)), S(0.2 + 0.15 * (k / 4))));
        scene.bodies.push_back(body);
    }
    auto struck = impact::spinning_ball<S>(scene.bodies[0]);
    impact::CueStrike<S>{S(6 * next(seed) + 1),
                         S(6 * next(seed)),
                         S(next(seed)),
                         S(0.3 * next(seed)),
                         S(0.3 * next(seed)),
                         S(0.54),
                         S(0.006),
                         S(1),
                         S(0.55)}
        .resolve(struck);
    impact::take<S>(struck, scene.bodies[0]);
    scene.motion = {S(0.2 * 9.81), S(0.01 * 9.81), S(0.0127 * 9.81)};
    scene.friction.ball_ball = {S(0.95), {S(0.009951), S(0.108), S(1.088)}};
    scene.friction.ball_cushion = {S(0.85), S(0.2), S(0.0384)};
    scene.contact_time = S(1e-4);
    add_table(scene);
    run(name, 0.95, std::move(scene));
}

/// Discs that drag slows down and that rub.
template <math::Scalar S>
void play_discs(const char* name, std::uint64_t seed) {
    using Type = engine::DiscScene<S, engine::NoRecorder>;
    using Vec = math::Vec<S>;
    engine::SceneData<Type> scene;
    for (int k = 0; k < 12; ++k) {
        engine::Body<Type> body;
        body.radius = S(0.02 + 0.02 * next(seed));
        body.mass = S(0.1 + next(seed));
        body.state.radius = body.radius;
        body.state.position = math::WidePoint<S>(
            Vec(S(0.2 + 0.15 * (k % 4) + 0.02 * next(seed)), S(0.2 + 0.15 * (k / 4))));
        body.state.velocity = {S(4 * next(seed) - 2), S(4 * next(seed) - 2)};
        body.state.spin = {S(0), S(0), S(60 * next(seed) - 30)};
        body.state.law = {S(0.1), S(next(seed)), S(2 * next(seed))};
        scene.bodies.push_back(body);
    }
    scene.friction.ball_ball = {S(0.95), {S(0.1), S(0), S(0)}};
    scene.friction.ball_cushion = {S(0.85), S(0.2)};
    scene.contact_time = S(1e-4);
    add_table(scene);
    run(name, 0.95, std::move(scene));
}

}  // namespace

int main() {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        for (const double restitution : {1.0, 0.75}) {
            play<float>("float", seed, restitution);
            play<double>("double", seed, restitution);
            play<long double>("long double", seed, restitution);
            play<math::Quad>("quad", seed, restitution);
            play_rack<double>("rack double", seed, restitution);
            play_rack<long double>("rack long double", seed, restitution);
        }
        play_cloth<float>("cloth float", seed);
        play_cloth<double>("cloth double", seed);
        play_cloth<long double>("cloth long double", seed);
        play_cloth<math::Quad>("cloth quad", seed);
        play_discs<float>("discs float", seed);
        play_discs<double>("discs double", seed);
        play_discs<long double>("discs long double", seed);
        play_discs<math::Quad>("discs quad", seed);
    }
    return 0;
}
