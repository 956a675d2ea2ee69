#pragma once

#include "osculo/impact/mathavan/contact_modes.hpp"
#include "osculo/impact/mathavan/slip_series.hpp"

namespace osculo::impact::mathavan {

/// 3/4 to this power is about 1e-125.
inline constexpr int kMostShortenings = 1000;

/// The motion during one step as power series in the normal impulse p at the cushion, as long as
/// neither contact changes its mode. Everything is to be set up to order 0 of the slips (order 0
/// of the directions for `leaving` and `straight`, too) and the normal velocity. p counts in
/// [unit].
template <math::Scalar S>
struct Step {
    using Vec = math::Vec<S>;

    const Constants<S>& k;
    S unit{1};  ///< of p, in which the coefficients neither overflow nor underflow
    Mode at_cushion = Mode::slipping;
    Mode at_cloth = Mode::slipping;
    SlipSeries<S> cushion{};
    SlipSeries<S> cloth{};
    Series<S> f[2]{};      ///< friction at the cushion along p, t
    Series<S> g[2]{};      ///< friction at the cloth along n, t
    Series<S> press{};     ///< q, what the cloth bears
    Series<S> approach{};  ///< vn

    void build() {
        for (const auto* series : {&cushion, &cloth}) {
            if ((series == &cushion ? at_cushion : at_cloth) != Mode::slipping) continue;
            const S size = math::norm<S>(series->slip(0));
            if (size < unit) unit = size;
        }
        for (std::size_t j = 0; j < kOrder<S>; ++j) {
            extend(at_cushion, cushion, j);
            extend(at_cloth, cloth, j);
            switch (at_cushion) {
                case Mode::sticking: hold_at_cushion(j); break;
                case Mode::leaving: leave_cushion(j); break;
                default: slip_at_cushion(j);
            }
            const S next = S(static_cast<double>(j + 1)) / unit;
            approach[j + 1] = ((j == 0 ? S(-k.c) : S(0)) - k.s * f[0][j] - g[0][j]) / next;
            if (at_cushion == Mode::slipping || at_cushion == Mode::straight) {
                const Vec pull = pull_at_cushion(j, friction_at_cloth(j));
                cushion.set_slip(j + 1,
                                 Vec(pull.x() - k.a * f[0][j], pull.y() - k.d * f[1][j]) / next);
            }
            if (at_cloth != Mode::sticking && at_cloth != Mode::leaving) {
                const Vec pull = pull_at_cloth(j);
                cloth.set_slip(j + 1, (pull - k.d * friction_at_cloth(j)) / next);
            }
        }
    }

    /// Longest step <= [longest] whose error is below epsilon times the smallest slip or 1.
    [[nodiscard]] S length(S longest) const {
        S largest[2] = {S(0), S(0)};
        const auto regard = [&](const Series<S>& series) {
            for (std::size_t i = 0; i < 2; ++i) {
                const S x = math::abs<S>(series[kOrder<S> - i]);
                if (largest[i] < x) largest[i] = x;
            }
        };
        regard(cushion.u[0]);
        regard(cushion.u[1]);
        regard(cloth.u[0]);
        regard(cloth.u[1]);
        regard(approach);
        for (int i = 0; i < kMostShortenings; ++i) {
            S power(1);
            for (std::size_t j = 1; j < kOrder<S>; ++j) power *= longest;
            const S bound = math::epsilon<S>() * unit;  // a small slip's direction counts
            if (largest[1] * power <= bound && largest[0] * power * longest <= bound) {
                return longest;
            }
            longest *= S(0.75);
        }
        return longest;
    }

private:
    [[nodiscard]] Vec friction_at_cloth(std::size_t j) const { return {g[0][j], g[1][j]}; }
    [[nodiscard]] Vec pull_at_cushion(std::size_t j, const Vec& g_j) const {
        return {(j == 0 ? S(-k.s * k.c) : S(0)) + k.b * g_j.x(), -k.h * g_j.y()};
    }
    [[nodiscard]] Vec pull_at_cloth(std::size_t j) const {
        return {(j == 0 ? S(-k.c) : S(0)) + k.b * f[0][j], -k.h * f[1][j]};
    }
    static void extend(Mode mode, SlipSeries<S>& series, std::size_t j) {
        if (mode == Mode::slipping) series.extend(j);
        if (mode == Mode::straight && j > 0) series.set_direction(j, Vec::Zero());
    }
    void set_f(std::size_t j, const Vec& value) {
        f[0][j] = value.x();
        f[1][j] = value.y();
        press[j] = (j == 0 ? k.s : S(0)) - k.c * value.x();
    }
    void set_g(std::size_t j, const Vec& value) {
        g[0][j] = value.x();
        g[1][j] = value.y();
    }
    /// Sum of press_i d_(j-i) at the cloth for first <= i <= last.
    [[nodiscard]] Vec pressed(std::size_t j, std::size_t first, std::size_t end) const {
        Vec sum = Vec::Zero();
        for (std::size_t i = first; i < end; ++i) sum += press[i] * cloth.direction(j - i);
        return sum;
    }

    void slip_at_cushion(std::size_t j) {
        set_f(j, k.cushion_friction * cushion.direction(j));
        switch (at_cloth) {
            case Mode::lifted: return set_g(j, Vec::Zero());
            case Mode::sticking: return set_g(j, pull_at_cloth(j) / k.d);
            case Mode::leaving: return leave_cloth(j);
            default: return set_g(j, k.cloth_friction * pressed(j, 0, j + 1));
        }
    }

    /// The cloth's friction holds u at zero no longer: U_j appears in its own equation, through
    /// d_j.
    void leave_cloth(std::size_t j) {
        const S& mu = k.cloth_friction;
        const Vec d0 = cloth.direction(0);
        const Vec known = j == 0 ? Vec(d0) : cloth.known_direction(j);
        const Vec friction = mu * (press[0] * known + pressed(j, 1, j + 1));
        const Vec rest = pull_at_cloth(j) - k.d * friction;
        const S next = S(static_cast<double>(j + 1)) / unit;
        const Vec along = math::dot<S>(d0, rest) * d0;
        if (j == 0) {
            cloth.set_slip(1, along);
        } else {
            cloth.set_slip(
                j + 1, along / next + (rest - along) / (next + k.d * mu * press[0] / cloth.n[0]));
        }
        cloth.extend_from_zero(j, known);
        set_g(j, mu * pressed(j, 0, j + 1));
    }

    /// No slip at the cushion while the cloth slips or is lifted.
    void hold_at_cushion(std::size_t j) {
        if (at_cloth == Mode::lifted) {
            set_f(j, Vec(j == 0 ? S(-k.s * k.c / k.a) : S(0), S(0)));
            return set_g(j, Vec::Zero());
        }
        const S bm = k.b * k.cloth_friction;
        const S d0 = cloth.d[0][0];
        const S known = j == 0 ? S(-k.s * k.c + bm * k.s * d0) : S(bm * pressed(j, 0, j).x());
        set_f(j, Vec(known / (k.a + bm * k.c * d0), S(0)));
        set_g(j, k.cloth_friction * pressed(j, 0, j + 1));
        f[1][j] = -k.h * g[1][j] / k.d;
    }

    /// As leave_cloth, at the cushion while the cloth slips: (j + 1) U = known - M f, with M from
    /// what f does at the cushion directly and through the cloth.
    void leave_cushion(std::size_t j) {
        const S& mu = k.cushion_friction;
        const Vec d0 = cushion.direction(0);
        const Vec c0 = cloth.direction(0);
        const S cm = k.cloth_friction * k.c;
        const auto times_m = [&](const Vec& x) {
            return Vec((k.a + k.b * cm * c0.x()) * x.x(), k.d * x.y() - k.h * cm * c0.y() * x.x());
        };
        const Vec known = j == 0 ? Vec(d0) : cushion.known_direction(j);
        const Vec through = k.cloth_friction * (j == 0 ? Vec(k.s * c0) : pressed(j, 0, j));
        const Vec rest = pull_at_cushion(j, through) - mu * times_m(known);
        const S next = S(static_cast<double>(j + 1)) / unit;
        if (j == 0) {
            cushion.set_slip(1, math::dot<S>(d0, rest) * d0);
        } else {
            const Vec across(-d0.y(), d0.x());
            const S stiff = mu / cushion.n[0];
            const Vec m_across = times_m(across);
            const S part =
                math::dot<S>(across, rest) / (next + stiff * math::dot<S>(across, m_across));
            cushion.set_slip(j + 1, (rest - (stiff * part) * m_across) / next);
        }
        cushion.extend_from_zero(j, known);
        set_f(j, mu * cushion.direction(j));
        set_g(j, k.cloth_friction * pressed(j, 0, j + 1));
    }
};

}  // namespace osculo::impact::mathavan
