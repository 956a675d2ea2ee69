#pragma once

#include <cstddef>
#include <sstream>
#include <string>

#include "clusters.hpp"
#include "support/exact.hpp"
#include "support/random.hpp"

/// Random clusters of touching balls and walls.
namespace osculo::support {

/// Twice the energy, in exact enough arithmetic.
template <class R, math::Scalar S>
[[nodiscard]] R energy(const impact::Cluster<S>& cluster) {
    R sum(0);
    for (const auto& ball : cluster.balls) {
        const R x = exact<R>(ball.velocity.x());
        const R y = exact<R>(ball.velocity.y());
        sum += exact<R>(ball.mass) * (x * x + y * y);
    }
    return sum;
}

enum class Masses { equal, similar, extreme };

template <math::Scalar S>
struct RandomCluster {
    Stage<S> stage;
    const char* shape = "";
    Masses masses = Masses::equal;
    bool walls = false;
    bool same_restitution = true;
    S e{1};
    Random* random;
    int decades;

    /// [most_decades]: of masses below and above 1.
    explicit RandomCluster(Random& source, int most_decades = 6)
        : random(&source), decades(most_decades) {
        const int kind = random->below(4);
        masses = kind < 2 ? Masses::equal : kind == 2 ? Masses::similar : Masses::extreme;
        const S values[] = {S(0), fraction<S>(3, 10), fraction<S>(19, 20), S(1)};
        same_restitution = random->below(4) > 0;
        e = values[random->below(4)];
        switch (random->below(5)) {
            case 0: make_chain(); break;
            case 1: make_rack(); break;
            case 2: make_star(); break;
            case 3: make_wedge(); break;
            default: make_tree(); break;
        }
        if (random->below(3) == 0) add_walls();
        if (same_restitution) return;
        for (auto& contact : stage.cluster.contacts) {
            contact.restitution = random->coin() ? random->unit<S>() : values[random->below(4)];
        }
    }

    [[nodiscard]] std::string described() const {
        std::ostringstream text;
        text << shape << '\n';
        for (const auto& ball : stage.cluster.balls) {
            text << "  ball {" << bits<S>(ball.mass) << ", " << bits<S>(ball.velocity) << "}\n";
        }
        for (const auto& c : stage.cluster.contacts) {
            text << "  contact {" << c.one << ", "
                 << (c.other == impact::kFixed ? -1 : int(c.other)) << ", " << bits<S>(c.normal)
                 << ", " << bits<S>(c.restitution) << "}\n";
        }
        return text.str();
    }

private:
    using Vec = math::Vec<S>;

    S mass() {
        if (masses == Masses::equal) return S(1);
        if (masses == Masses::similar) return S(0.5) + random->unit<S>();
        return (S(1) + random->unit<S>()) * power_of_ten<S>(random->between(-decades, decades - 1));
    }
    Vec velocity() {
        if (random->coin()) return {S(0), S(0)};
        const S speed = random->below(8) == 0 ? random->magnitude<S>(-20, 20) : random->unit<S>();
        return speed * random->direction<S>();
    }
    std::size_t ball(const Vec& place) { return stage.ball(place, velocity(), mass()); }
    void touch(std::size_t one, std::size_t other) {
        if (random->coin()) std::swap(one, other);
        stage.touch(one, other, e);
    }

    void make_chain() {
        shape = "chain";
        const Vec step = random->direction<S>();
        const int count = random->between(3, 8);
        for (int i = 0; i < count; ++i) {
            const std::size_t b = ball(S(2 * i) * step);
            if (i > 0) touch(b - 1, b);
        }
    }
    void make_rack() {
        shape = "rack";
        const int rows = random->between(2, 4);
        const auto index = [](int row, int place) {
            return static_cast<std::size_t>(row * (row + 1) / 2 + place);
        };
        for (int row = 0; row < rows; ++row) {
            for (int place = 0; place <= row; ++place) {
                ball({S(row) * root_of<S>(3), S(2 * place - row)});
                if (place > 0) touch(index(row, place - 1), index(row, place));
                if (place < row) touch(index(row - 1, place), index(row, place));
                if (place > 0) touch(index(row - 1, place - 1), index(row, place));
            }
        }
        if (random->coin()) {
            const std::size_t cue = ball({S(-2), S(0)});
            touch(cue, 0);
            stage.cluster.balls[cue].velocity = {S(1), random->signed_unit<S>() / S(8)};
        }
    }
    /// Balls around one.
    void make_star() {
        shape = "star";
        const std::size_t center = ball({S(0), S(0)});
        const int count = random->between(2, 6);
        const bool regular = random->coin();
        for (int i = 0; i < count; ++i) {
            const Vec spots[] = {{S(2), S(0)},  {S(1), root_of<S>(3)},   {S(-1), root_of<S>(3)},
                                 {S(-2), S(0)}, {S(-1), -root_of<S>(3)}, {S(1), -root_of<S>(3)}};
            const Vec place = regular ? spots[i] : Vec(S(2) * random->direction<S>());
            touch(center, ball(place));
        }
    }
    /// One ball and some walls.
    void make_wedge() {
        shape = "wedge";
        const std::size_t b = ball({S(0), S(0)});
        const int count = random->between(2, 3);
        for (int i = 0; i < count; ++i) wall(b);
        if (random->coin()) touch(b, ball({S(0), S(2)}));
    }
    /// Each ball touches one before it, anywhere.
    void make_tree() {
        shape = "tree";
        const int count = random->between(3, 8);
        ball({S(0), S(0)});
        for (int i = 1; i < count; ++i) {
            const auto parent = static_cast<std::size_t>(random->below(i));
            const Vec place = stage.places[parent] + S(2) * random->direction<S>();
            touch(parent, ball(place));
        }
    }
    void wall(std::size_t b) {
        walls = true;
        stage.wall(b, random->magnitude<S>(-3, 3) * random->direction<S>(), e);
    }
    void add_walls() {
        const int count = random->between(1, 2);
        for (int i = 0; i < count; ++i) {
            wall(static_cast<std::size_t>(
                random->below(static_cast<int>(stage.cluster.balls.size()))));
        }
    }
};

}  // namespace osculo::support
