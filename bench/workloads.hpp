#pragma once

#include <string>
#include <vector>

#include "osculo/osculo.hpp"
#include "support/gas.hpp"
#include "support/random.hpp"

/// What the benchmarks measure: sets of predictions of one kind, and scenes.
namespace osculo::bench {

/// How a prediction ends.
enum class Outcome {
    hit,        ///< solved
    near_miss,  ///< approaching, up to a tenth of the radius beside
    beside,     ///< approaching, but far beside: rejected early
    later,      ///< would hit, but after an event that is known already
    leaving,    ///< moving apart
};

template <math::Scalar S>
struct Prediction {
    motion::LinearPath<S> ball;
    motion::LinearPath<S> other;
    S horizon;
};

inline constexpr std::size_t kPredictions = 1024;
inline constexpr double kRadius = 0.03;

/// Balls of radius 0.03 around one metre from what is at the origin.
template <math::Scalar S>
[[nodiscard]] std::vector<Prediction<S>> predictions(Outcome outcome, double reach) {
    support::Random random(7);
    std::vector<Prediction<S>> all;
    for (std::size_t i = 0; i < kPredictions; ++i) {
        const math::Vec<S> d = random.direction<S>();
        const math::Vec<S> left(-d.y(), d.x());
        S lateral = random.signed_unit<S>();
        if (outcome == Outcome::hit || outcome == Outcome::later) lateral *= S(reach);
        if (outcome == Outcome::near_miss) lateral = S(reach) * (S(1) + random.unit<S>() / S(10));
        if (outcome == Outcome::beside) lateral = S(reach) * (S(2) + random.unit<S>() * S(10));
        const math::Vec<S> c = d * -(S(0.5) + random.unit<S>()) + left * lateral;
        const math::Vec<S> b = d * (S(0.5) + random.unit<S>());
        const math::Vec<S> drift(random.signed_unit<S>(), random.signed_unit<S>());
        const math::Vec<S> place(random.unit<S>(), random.unit<S>());
        all.push_back(
            {{math::WidePoint<S>(math::Vec<S>(place + c)),
              outcome == Outcome::leaving ? math::Vec<S>(drift - b) : math::Vec<S>(drift + b)},
             {math::WidePoint<S>(place), drift},
             outcome == Outcome::later ? S(0.01) : math::never<S>()});
    }
    return all;
}

template <math::Scalar S, template <class> class BroadPhase>
using Gas = engine::UniformScene<S, engine::Walls, engine::NoRecorder, BroadPhase>;

/// Two balls and a wall: the number of contacts is that of the first digits of pi.
template <math::Scalar S>
using PiScene = engine::UniformScene<S, engine::Obstacles<geometry::Segment>, engine::NoRecorder,
                                     engine::AllPairs>;

template <math::Scalar S>
[[nodiscard]] engine::SceneData<PiScene<S>> pi_scene(int digits) {
    support::Builder<PiScene<S>> builder;
    S mass(1);
    for (int k = 1; k < digits; ++k) mass *= S(100);
    builder.ball({S(2), S(0)}, {S(0), S(0)}, S(0.5), S(1));
    builder.ball({S(4), S(0)}, {S(-1), S(0)}, S(0.5), mass);
    builder.wall({S(0), S(10)}, {S(0), S(-10)});
    return builder.scene;
}

}  // namespace osculo::bench
