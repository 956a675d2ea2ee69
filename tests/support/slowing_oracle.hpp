#pragma once

#include <vector>

#include "osculo/motion/slowing.hpp"
#include "support/exact.hpp"

/// Slowing down by its differential equation alone: power series of q' = -(m + k q + c q^2) in many
/// short steps, in 100 digits. No closed form, nothing in common with the library.
namespace osculo::support {

struct SlowedExactly {
    Exact sigma;
    Exact q;
};

[[nodiscard]] inline SlowedExactly slow_down(const motion::Slowing<double>& law, const Exact& t) {
    constexpr int kOrder = 40;
    const Exact m(law.m), k(law.k), c(law.c);
    SlowedExactly now{Exact(0), Exact(1)};
    Exact left = t;
    while (left > 0) {
        const Exact rate = m + k + c * now.q;
        Exact h = rate > 0 ? Exact(Exact(1) / (8 * rate)) : left;
        if (h > left) h = left;
        std::vector<Exact> q{now.q};
        for (int n = 0; n < kOrder; ++n) {
            Exact square(0);
            for (int i = 0; i <= n; ++i) {
                square += q[static_cast<std::size_t>(i)] * q[static_cast<std::size_t>(n - i)];
            }
            const Exact sum = (n == 0 ? m : Exact(0)) + k * q.back() + c * square;
            q.push_back(Exact(-sum / (n + 1)));
        }
        Exact power = h;
        Exact end = q[0];
        for (int n = 0; n <= kOrder; ++n) {
            now.sigma += q[static_cast<std::size_t>(n)] * power / (n + 1);
            if (n < kOrder) end += q[static_cast<std::size_t>(n + 1)] * power;
            power *= h;
        }
        now.q = end;
        left -= h;
    }
    return now;
}

/// Coefficients over many orders of magnitude, some of them zero, some near the case in which the
/// roots of the characteristic equation are equal.
template <class Random>
[[nodiscard]] motion::Slowing<double> random_slowing(Random& random) {
    const auto coefficient = [&] {
        return random.below(4) == 0 ? 0.0 : std::pow(10.0, random.template uniform<double>(-8, 2));
    };
    motion::Slowing<double> law{coefficient(), coefficient(), coefficient()};
    if (random.below(6) == 0) {
        const double off = std::pow(10.0, -15 * random.template unit<double>());
        law.k = 2 * std::sqrt(law.m * law.c) * (1 + (random.coin() ? off : -off));
    }
    return law;
}

}  // namespace osculo::support
