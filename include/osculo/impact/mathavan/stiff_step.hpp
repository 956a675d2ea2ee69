#pragma once

#include <array>

#include "osculo/impact/mathavan/contact_modes.hpp"

namespace osculo::impact::mathavan {

/// Everything that changes during an impact: slips at the cushion and the cloth, approach, impulses
/// of friction at both, work done on the cushion.
template <math::Scalar S>
struct Motion {
    static constexpr int kSize = 10;
    enum Part { kCushionSlip = 0, kClothSlip = 2, kApproach = 4, kF = 5, kG = 7, kWork = 9 };
    std::array<S, kSize> part{};

    [[nodiscard]] math::Vec<S> pair(int first) const {
        return {part[static_cast<std::size_t>(first)], part[static_cast<std::size_t>(first) + 1]};
    }
    void set_pair(int first, const math::Vec<S>& value) {
        part[static_cast<std::size_t>(first)] = value.x();
        part[static_cast<std::size_t>(first) + 1] = value.y();
    }
    [[nodiscard]] S& approach() { return part[kApproach]; }
    [[nodiscard]] const S& approach() const { return part[kApproach]; }
    [[nodiscard]] const S& work() const { return part[kWork]; }
};

/// Steps for a contact that has just broken loose: while its slip n is small, its direction is
/// bound to follow the forces within an impulse of the order of n, far shorter than the motion
/// takes otherwise, so that power series get nowhere. The linearly implicit Euler method,
/// extrapolated (P. Deuflhard, E. Hairer, J. Zugck, Numer. Math. 51, 1987), does not mind.
template <math::Scalar S>
class StiffStep {
    using Vec = math::Vec<S>;

public:
    static constexpr int kRows = 10;

    StiffStep(const Constants<S>& constants, Mode at_cushion, Mode at_cloth)
        : k_(constants), at_cushion_(at_cushion), at_cloth_(at_cloth) {}

    /// Carries [motion] over the impulse [length]; returns an estimate of the error.
    S advance(Motion<S>& motion, const S& length) const {
        std::array<Motion<S>, kRows> table;
        S error = math::never<S>();
        for (int row = 0; row < kRows; ++row) {
            // Changes only: the extrapolation would magnify the rounding of the whole.
            Motion<S> next;
            for (int i = 0; i <= row; ++i) euler(motion, next, length / S(row + 1));
            // Aitken and Neville, for powers of 1 / (row + 1): table holds the last row.
            S largest(0);
            for (int column = 0; column < row; ++column) {
                const S ratio = S(row + 1) / S(row - column) - S(1);
                Motion<S> better = next;
                largest = S(0);
                for (std::size_t i = 0; i < Motion<S>::kSize; ++i) {
                    const S correction =
                        (next.part[i] - table[static_cast<std::size_t>(column)].part[i]) / ratio;
                    better.part[i] += correction;
                    const S size = math::abs<S>(correction);
                    if (!(size <= largest)) largest = size;
                }
                table[static_cast<std::size_t>(column)] = next;
                next = better;
            }
            table[static_cast<std::size_t>(row)] = next;
            if (row > 0) error = largest;
        }
        for (std::size_t i = 0; i < Motion<S>::kSize; ++i) {
            motion.part[i] += table[kRows - 1].part[i];
        }
        return error;
    }

    struct Friction {
        Vec f, g;
    };
    /// Friction at a pair of slips, and (with [change]) how a change of the slips changes it.
    [[nodiscard]] Friction friction(const Vec& cushion, const Vec& cloth) const {
        const Vec c0 = at_cloth_ == Mode::slipping ? Vec(cloth / math::norm<S>(cloth)) : Vec(cloth);
        if (at_cushion_ == Mode::sticking) {
            if (at_cloth_ == Mode::lifted) return {Vec(-k_.s * k_.c / k_.a, S(0)), Vec::Zero()};
            const Vec f = k_.holding_at_cushion(c0);
            return {f, k_.cloth_friction * k_.press(f.x()) * c0};
        }
        const Vec f = k_.cushion_friction * (cushion / math::norm<S>(cushion));
        if (at_cloth_ == Mode::lifted) return {f, Vec::Zero()};
        if (at_cloth_ == Mode::sticking) return {f, k_.holding_at_cloth(f)};
        return {f, k_.cloth_friction * k_.press(f.x()) * c0};
    }

private:
    using Slips = std::array<S, 4>;

    /// What friction does to the slips, per impulse; linear, so that it serves for changes too.
    [[nodiscard]] Slips effect(const Friction& x) const {
        Slips rates{k_.b * x.g.x() - k_.a * x.f.x(), -k_.h * x.g.y() - k_.d * x.f.y(),
                    k_.b * x.f.x() - k_.d * x.g.x(), -k_.h * x.f.y() - k_.d * x.g.y()};
        if (at_cushion_ == Mode::sticking) rates[0] = rates[1] = S(0);
        if (at_cloth_ == Mode::sticking) rates[2] = rates[3] = S(0);
        return rates;
    }
    [[nodiscard]] Slips slip_rates(const Friction& x) const {
        Slips rates = effect(x);
        if (at_cushion_ != Mode::sticking) rates[0] -= k_.s * k_.c;
        if (at_cloth_ != Mode::sticking) rates[2] -= k_.c;
        return rates;
    }

    static Vec turned(const Vec& slip, const Vec& change) {
        const S n = math::norm<S>(slip);
        const Vec d = slip / n;
        return (change - math::dot<S>(d, change) * d) / n;
    }
    [[nodiscard]] Friction change(const Vec& cushion, const Vec& cloth, const Friction& now,
                                  const Slips& slips) const {
        const Vec dc(slips[0], slips[1]);
        const Vec dt(slips[2], slips[3]);
        Friction result{Vec::Zero(), Vec::Zero()};
        Vec c0 = Vec::Zero();
        Vec turn = Vec::Zero();
        if (at_cloth_ == Mode::slipping) {
            c0 = cloth / math::norm<S>(cloth);
            turn = turned(cloth, dt);
        }
        if (at_cushion_ == Mode::sticking) {
            if (at_cloth_ != Mode::slipping) return result;
            const S bm = k_.b * k_.cloth_friction;
            result.f.x() = bm * (k_.s - k_.c * now.f.x()) * turn.x() / (k_.a + bm * k_.c * c0.x());
        } else {
            result.f = k_.cushion_friction * turned(cushion, dc);
        }
        if (at_cloth_ == Mode::sticking) {
            result.g = Vec(k_.b * result.f.x(), -k_.h * result.f.y()) / k_.d;
        } else if (at_cloth_ == Mode::slipping) {
            result.g =
                k_.cloth_friction * (k_.press(now.f.x()) * turn - (k_.c * result.f.x()) * c0);
            if (at_cushion_ == Mode::sticking) result.f.y() = -k_.h * result.g.y() / k_.d;
        }
        return result;
    }

    /// Solves A x = b in place by Gauss's elimination with pivots.
    static void solve(std::array<Slips, 4>& a, Slips& b) {
        for (std::size_t i = 0; i < 4; ++i) {
            std::size_t pivot = i;
            for (std::size_t r = i + 1; r < 4; ++r) {
                if (math::abs<S>(a[r][i]) > math::abs<S>(a[pivot][i])) pivot = r;
            }
            std::swap(a[i], a[pivot]);
            std::swap(b[i], b[pivot]);
            for (std::size_t r = i + 1; r < 4; ++r) {
                const S factor = a[r][i] / a[i][i];
                for (std::size_t c = i; c < 4; ++c) a[r][c] -= factor * a[i][c];
                b[r] -= factor * b[i];
            }
        }
        for (std::size_t i = 4; i-- > 0;) {
            for (std::size_t c = i + 1; c < 4; ++c) b[i] -= a[i][c] * b[c];
            b[i] /= a[i][i];
        }
    }

    /// (1 - h J) change = h rates, onto the change [m] so far.
    void euler(const Motion<S>& start, Motion<S>& m, const S& h) const {
        const Vec cushion = start.pair(Motion<S>::kCushionSlip) + m.pair(Motion<S>::kCushionSlip);
        const Vec cloth = start.pair(Motion<S>::kClothSlip) + m.pair(Motion<S>::kClothSlip);
        const Friction now = friction(cushion, cloth);
        Slips step = slip_rates(now);
        std::array<Slips, 4> matrix{};
        for (std::size_t j = 0; j < 4; ++j) {
            Slips unit{};
            unit[j] = S(1);
            const Slips column = effect(change(cushion, cloth, now, unit));
            for (std::size_t i = 0; i < 4; ++i)
                matrix[i][j] = (i == j ? S(1) : S(0)) - h * column[i];
            step[j] *= h;
        }
        solve(matrix, step);
        const Friction then = change(cushion, cloth, now, step);
        const Vec f = now.f + then.f;
        const Vec g = now.g + then.g;
        for (std::size_t i = 0; i < 4; ++i) m.part[i] += step[i];
        m.approach() += h * (-k_.c - k_.s * f.x() - g.x());
        m.set_pair(Motion<S>::kF, m.pair(Motion<S>::kF) + h * f);
        m.set_pair(Motion<S>::kG, m.pair(Motion<S>::kG) + h * g);
        m.part[Motion<S>::kWork] += h * k_.c * (start.approach() + m.approach());
    }

    const Constants<S>& k_;
    Mode at_cushion_;
    Mode at_cloth_;
};

}  // namespace osculo::impact::mathavan
