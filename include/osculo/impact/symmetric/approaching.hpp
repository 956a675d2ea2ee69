#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/system.hpp"
#include "osculo/impact/symmetric/well_posed.hpp"

namespace osculo::impact::symmetric {

/// The contacts of a cluster that approach, in connected groups: those whose elastic outcome is
/// unique, for all wedges of the group are pi / n, and those that need a law.
template <math::Scalar S>
class Approaching {
public:
    /// Contacts that approach by more than [noise], in units of sqrt(m). False if there are none.
    bool find(const System<S>& system, const S& noise, const S& tolerance) {
        unique_.clear();
        joint_.assign(system.contacts().size(), false);
        has_joint_ = false;
        for (std::size_t k = 0; k < joint_.size(); ++k) {
            if (approaches(system, k, noise)) unique_.push_back(k);
        }
        if (unique_.size() < 2) return !unique_.empty();
        ball_is_joint_.assign(system.balls().size(), false);
        const auto column = [&](std::size_t k) -> const Column<S>& {
            return system.contacts()[k].column;
        };
        for (std::size_t i = 0; i < unique_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const Column<S>& a = column(unique_[i]);
                const Column<S>& b = column(unique_[j]);
                if (wedge_is_well_posed<S>(-product<S>(a, b), true, tolerance)) continue;
                claim(a);
                claim(b);
            }
        }
        if (!has_joint_) return true;
        // What touches a group belongs to it.
        for (bool grown = true; grown;) {
            grown = false;
            for (const std::size_t k : unique_) {
                if (joint_[k] || !is_claimed(column(k))) continue;
                claim(column(k));
                joint_[k] = true;
                grown = true;
            }
        }
        std::erase_if(unique_, [&](std::size_t k) { return joint_[k]; });
        return true;
    }

    [[nodiscard]] static bool approaches(const System<S>& system, std::size_t k, const S& noise) {
        return system.contacts()[k].root * system.separation(k) < -noise;
    }
    [[nodiscard]] const std::vector<std::size_t>& unique() const { return unique_; }
    [[nodiscard]] bool has_joint() const { return has_joint_; }
    [[nodiscard]] bool is_joint(std::size_t k) const { return joint_[k]; }

private:
    void claim(const Column<S>& column) {
        has_joint_ = true;
        ball_is_joint_[column.one] = true;
        if (column.other != kFixed) ball_is_joint_[column.other] = true;
    }
    [[nodiscard]] bool is_claimed(const Column<S>& column) const {
        return ball_is_joint_[column.one] ||
               (column.other != kFixed && ball_is_joint_[column.other]);
    }

    std::vector<std::size_t> unique_;
    std::vector<bool> joint_;
    std::vector<bool> ball_is_joint_;
    bool has_joint_ = false;
};

}  // namespace osculo::impact::symmetric
