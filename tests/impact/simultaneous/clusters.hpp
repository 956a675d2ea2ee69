#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric.hpp"

/// Clusters with known outcomes.
namespace osculo::support {

template <math::Scalar S>
S fraction(int numerator, int denominator) {
    return S(numerator) / S(denominator);
}
template <math::Scalar S>
S root_of(int x) {
    return math::square_root<S>(S(x));
}

/// Builds clusters of balls at places in the plane: normals are differences of places.
template <math::Scalar S>
struct Stage {
    impact::Cluster<S> cluster;
    std::vector<math::Vec<S>> places;

    std::size_t ball(const math::Vec<S>& place, const math::Vec<S>& velocity = {S(0), S(0)},
                     const S& mass = S(1)) {
        cluster.balls.push_back({mass, velocity});
        places.push_back(place);
        return places.size() - 1;
    }
    void touch(std::size_t one, std::size_t other, const S& e = S(1)) {
        cluster.contacts.push_back({one, other, places[other] - places[one], e});
    }
    /// [normal]: from the ball to the wall.
    void wall(std::size_t one, const math::Vec<S>& normal, const S& e = S(1)) {
        cluster.contacts.push_back({one, impact::kFixed, normal, e});
    }
    [[nodiscard]] S vx(std::size_t i) const { return cluster.balls[i].velocity.x(); }
    [[nodiscard]] S vy(std::size_t i) const { return cluster.balls[i].velocity.y(); }
};

/// Touching balls in a row along x.
template <math::Scalar S>
Stage<S> chain(const std::vector<S>& speeds, const S& e, std::vector<S> masses = {}) {
    Stage<S> stage;
    masses.resize(speeds.size(), S(1));
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        stage.ball({S(static_cast<double>(2 * i)), S(0)}, {speeds[i], S(0)}, masses[i]);
        if (i > 0) stage.touch(i - 1, i, e);
    }
    return stage;
}

/// A ball on two touching ones (T5): the cue ball at the origin flies with [velocity].
template <math::Scalar S>
Stage<S> bernoulli(const math::Vec<S>& velocity, const S& e) {
    Stage<S> stage;
    const std::size_t cue = stage.ball({S(0), S(0)}, velocity);
    const std::size_t upper = stage.ball({root_of<S>(3), S(1)});
    const std::size_t lower = stage.ball({root_of<S>(3), S(-1)});
    stage.touch(cue, upper, e);
    stage.touch(cue, lower, e);
    stage.touch(upper, lower, e);
    return stage;
}

/// The triangle of fifteen (rows of 1 .. 5 along x) with the cue ball on its tip: 31 contacts. Ball
/// 0 is the cue ball; ball index(row, place) is in its row from below.
template <math::Scalar S>
struct Rack {
    Stage<S> stage;

    static std::size_t index(int row, int place) {
        return static_cast<std::size_t>(1 + row * (row + 1) / 2 + place);
    }
    Rack(const math::Vec<S>& velocity, const S& e) {
        stage.ball({S(-2), S(0)}, velocity);
        for (int row = 0; row < 5; ++row) {
            for (int place = 0; place <= row; ++place) {
                stage.ball({S(row) * root_of<S>(3), S(2 * place - row)});
            }
        }
        stage.touch(0, 1, e);
        for (int row = 0; row < 5; ++row) {
            for (int place = 0; place <= row; ++place) {
                if (place > 0) stage.touch(index(row, place - 1), index(row, place), e);
                if (row == 4) continue;
                stage.touch(index(row, place), index(row + 1, place), e);
                stage.touch(index(row, place), index(row + 1, place + 1), e);
            }
        }
    }
};

}  // namespace osculo::support
