#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/nonnegative.hpp"
#include "osculo/impact/symmetric/system.hpp"

namespace osculo::impact::symmetric {

/// The inelastic impact of some contacts of a cluster: the impulses J >= 0 that take y to the
/// nearest point where none of them approaches, which is the linear complementarity problem
///
///     x >= 0,   A'(y + A x) >= 0,   x.A'(y + A x) = 0.
///
/// The velocities are unique. Where the impulses are not, for more contacts bear than there are
/// directions to move in, those of the smallest sum of x^2 are chosen: what contacts of equal
/// stiffness would share. So symmetric clusters get symmetric impulses, in any order.
template <math::Scalar S>
class Projection {
public:
    /// [tolerance](k): contacts that approach by no more than this [m/s] are left alone; < 0: k is
    /// left out altogether. Impulses by x() in units of sqrt(m), until the next call.
    template <class Tolerance>
    void solve(const System<S>& system, const Tolerance& tolerance) {
        const auto& contacts = system.contacts();
        impulses_.assign(contacts.size(), S(0));
        included_.clear();
        bearing_.clear(system.rows());
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            const S least = tolerance(k);
            if (!(least >= S(0))) continue;
            included_.push_back(k);
            bearing_.add(contacts[k].column, contacts[k].root * system.separation(k),
                         contacts[k].root * least);
        }
        bearing_.solve();
        const Nonnegative<S>& source = share() ? sharing_ : bearing_;
        const std::vector<std::size_t>& names = &source == &sharing_ ? shared_ : included_;
        for (std::size_t i = 0; i < names.size(); ++i) impulses_[names[i]] = source.x(i);
    }

    [[nodiscard]] const S& x(std::size_t k) const { return impulses_[k]; }

    /// After [factor] times the impulses have been applied: what rounding has left of them, calls
    /// push(k, more). Impulses that all but cancel, on a light ball between heavy ones, err by more
    /// than its velocity; the difference to what the contacts' velocities should be does not.
    template <class Push>
    void refine(const System<S>& system, const S& factor, const Push& push) {
        bearing_.solve_normal(
            [&](std::size_t i) {
                const std::size_t k = included_[i];
                return S((S(1) - factor) * bearing_.start(i) -
                         system.contacts()[k].root * system.separation(k));
            },
            [&](std::size_t i, const S& more) { push(included_[i], more); });
    }

    /// Whether some impulses of these contacts, not all zero, cancel each other: then the contacts
    /// cannot all separate, and the ball between two parallel walls never comes to leave them (P.
    /// Gordan).
    template <class Included>
    [[nodiscard]] bool jammed(const System<S>& system, const Included& included) {
        // The x >= 0 of sum 1 with the smallest |A x| is zero of it; found as the solution of
        // A x = 0, sum x = 1 in the least squares.
        const auto& contacts = system.contacts();
        sharing_.clear(system.rows() + 1);
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (!included(k)) continue;
            Column<S> column = contacts[k].column;
            column.row = system.rows();
            column.at_row = S(1);
            sharing_.add(column, S(-1), math::epsilon<S>());
        }
        sharing_.solve();
        S sum(0);
        for (std::size_t k = 0; k < sharing_.size(); ++k) sum += sharing_.x(k);
        // |A x|^2 + (sum - 1)^2 = 1 - sum at the solution: 0 if jammed, else about the square of
        // the angle of the wedge.
        return S(1) - sum < S(math::kClusterJam) * math::epsilon<S>() && balanced(system);
    }

private:
    /// Whether the impulses that jammed() has found cancel on each ball by itself, but for angles
    /// and shares that are next to nothing. In the metric of the masses what a heavy ball at the
    /// end of a row gets is next to nothing, too, but nothing holds it.
    [[nodiscard]] bool balanced(const System<S>& system) {
        loads_.assign(system.balls().size(), Load{});
        const auto bear = [this](std::size_t ball, const math::Vec<S>& at, const S& x) {
            loads_[ball].sum += x * at;
            loads_[ball].directions += math::norm<S>(at);
        };
        for (std::size_t i = 0; i < sharing_.size(); ++i) {
            const Column<S>& column = sharing_.column(i);
            const S& x = sharing_.x(i);
            if (!(x > S(0))) continue;
            bear(column.one, column.at_one, x);
            if (column.other != kFixed) bear(column.other, column.at_other, x);
        }
        const S slight = math::square_root<S>(S(math::kClusterJam) * math::epsilon<S>());
        return std::ranges::all_of(loads_, [&](const Load& load) {
            return math::norm<S>(load.sum) <= slight * load.directions;
        });
    }

    static constexpr int kPasses = 6;

    /// Between rounding and any angle that matters: 2^-26 for double.
    static S slight() {
        S result(1);
        for (int i = 0; i < math::ScalarTraits<S>::kDigits / 2; ++i) result *= S(0.5);
        return result;
    }

    /// Where contacts that do not take part lie in the span of those that do: shares the load. The
    /// smallest of |A x - A x0|^2 + d |x|^2 is the wanted x up to d, which repetition removes.
    bool share() {
        shared_.clear();
        S largest(0);
        for (std::size_t i = 0; i < included_.size(); ++i) {
            if (bearing_.x(i) > largest) largest = bearing_.x(i);
        }
        if (!(largest > S(0))) return false;
        bool ambiguous = false;
        const auto& change = bearing_.change();
        // The root of d, 2^-7 for double: rounding errs by epsilon / d, d itself fades in passes.
        S weight(1);
        for (int i = 0; i < math::ScalarTraits<S>::kDigits / 7; ++i) weight *= S(0.5);
        for (std::size_t i = 0; i < included_.size(); ++i) {
            if (bearing_.takes_part(i)) {
                shared_.push_back(i);
            } else if (math::abs<S>(bearing_.product(i)) < slight() * largest &&
                       bearing_.distance(i) < slight()) {
                shared_.push_back(i);
                ambiguous = true;
            }
        }
        if (!ambiguous) return false;
        const std::size_t rows = change.size();
        sharing_.clear(rows + shared_.size());
        for (std::size_t i = 0; i < shared_.size(); ++i) {
            Column<S> column = bearing_.column(shared_[i]);
            const S product = -column.dot(change);
            column.row = rows + i;
            column.at_row = weight;
            sharing_.add(column, product, math::epsilon<S>() * largest);
        }
        sharing_.solve();
        for (int pass = 0; pass < kPasses; ++pass) {
            left_.assign(change.begin(), change.end());
            for (std::size_t i = 0; i < shared_.size(); ++i) {
                plain(i).add_to(left_, -sharing_.x(i));
            }
            sharing_.solve_normal(
                [&](std::size_t i) { return plain(i).dot(left_); },
                [&](std::size_t i, const S& more) { sharing_.set_x(i, sharing_.x(i) + more); });
        }
        for (std::size_t& name : shared_) name = included_[name];
        return true;
    }
    [[nodiscard]] Column<S> plain(std::size_t i) const {
        Column<S> column = sharing_.column(i);
        column.row = Column<S>::kNone;
        return column;
    }

    struct Load {
        math::Vec<S> sum{S(0), S(0)};
        S directions{0};
    };

    Nonnegative<S> bearing_;
    Nonnegative<S> sharing_;
    std::vector<std::size_t> included_;
    std::vector<std::size_t> shared_;
    std::vector<S> impulses_;
    std::vector<S> left_;
    std::vector<Load> loads_;
};

}  // namespace osculo::impact::symmetric
