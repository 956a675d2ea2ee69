#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/nonnegative.hpp"

namespace osculo::impact::symmetric {

/// 1 - cos beta of the wedge of two contacts, cos beta = -a1.a2 (well_posed.hpp): |a1 + a2|^2 / 2,
/// for where beta is small a1.a2 has lost it.
template <math::Scalar S>
[[nodiscard]] S versine(const Column<S>& a, const Column<S>& b) {
    S sum(0);
    const auto add = [&sum](const math::Vec<S>& v) { sum += math::dot<S>(v, v); };
    const auto at = [](const Column<S>& column, std::size_t ball) {
        math::Vec<S> result(S(0), S(0));
        if (column.one == ball) result += column.at_one;
        if (column.other == ball) result += column.at_other;
        return result;
    };
    for (const std::size_t ball : {a.one, a.other}) {
        if (ball != Column<S>::kNone) add(at(a, ball) + at(b, ball));
    }
    for (const std::size_t ball : {b.one, b.other}) {
        if (ball != Column<S>::kNone && ball != a.one && ball != a.other) add(at(b, ball));
    }
    return sum / S(2);
}

/// Two contacts that are reflected in turn, very often where a light ball is between heavy ones: as
/// many reflections as one likes at once.
///
/// When it is reflected, the contact whose turn it is parts at s_j < 0, in units of sqrt(m), where
/// s_(j+1) = 2 cos(beta) s_j - s_(j-1): the velocities turn by beta in the wedge (G. Galperin,
/// "Playing pool with pi", 2003). So s_j = s(j beta) with s(x) = s_0 cos x + t sin x; it ends with
/// the first s_j >= 0. After m reflections of each the impulses -2 s_j add up to
///
///     X_0 = -2 U s((m - 1) beta),   X_1 = -2 U s(m beta),   U = sin(m beta) / sin(beta).
///
/// The largest m with s(2 m beta) < 0 is found bit by bit, from rotations by beta, 2 beta, 4 beta,
/// ...: in as many steps as pi / beta has bits, with a rounding or two for each.
template <math::Scalar S>
class Wedge {
public:
    /// Sums of impulses, in units of sqrt(m); 0 if there are none to be made at once.
    struct Impulses {
        S first{0};
        S second{0};
    };

    /// [closing] < 0: s_0, of the first contact; [next]: of the other one, at the same time.
    /// [versine]: in (0, 1). [allowed](X_0, X_1): whether no other contact comes to bear; if not,
    /// then not for more either.
    template <class Allowed>
    [[nodiscard]] Impulses reflections(const S& closing, const S& next, const S& versine,
                                       const Allowed& allowed) {
        turns_.clear();
        for (Turn turn{S(1) - versine, math::square_root<S>(versine * (S(2) - versine))};
             turn.cosine > S(0) && turns_.size() < kMostBits; turn = turn.then(turn)) {
            turns_.push_back(turn);
        }
        const Turn once = turns_.front();
        const S t = ((next + closing) - versine * closing) / once.sine;
        const auto s = [&](const Turn& at) { return closing * at.cosine + t * at.sine; };
        Impulses result;
        Turn now{S(1), S(0)};
        for (auto turn = turns_.rbegin(); turn != turns_.rend(); ++turn) {
            const Turn then = now.then(*turn);
            if (!(s(then.then(then)) < S(0))) continue;
            const S sum = S(-2) * (then.sine / once.sine);
            const S first = sum * s(then.then({once.cosine, -once.sine}));
            const S second = sum * s(then);
            if (!allowed(first, second)) continue;
            now = then;
            result = {first, second};
        }
        return result;
    }

private:
    /// More than angles have in any type: 2^-400 is 1e-120.
    static constexpr std::size_t kMostBits = 400;

    struct Turn {
        S cosine, sine;
        [[nodiscard]] Turn then(const Turn& by) const {
            return {cosine * by.cosine - sine * by.sine, sine * by.cosine + cosine * by.sine};
        }
    };
    std::vector<Turn> turns_;
};

}  // namespace osculo::impact::symmetric
