#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "support/exact.hpp"

namespace osculo::support {

/// More than this is another contact, not an inaccurate one.
inline constexpr double kWrongUlps = 1000;

/// How a computed contact compares with the exact one, over many cases.
class Tally {
public:
    /// Returns false if the contact is missed, false or wrong.
    template <math::Scalar S, class R>
    bool add(const S& computed, const std::optional<R>& reference) {
        ++cases_;
        const bool found = math::is_finite<S>(computed);
        if (!found && !reference) return true;
        if (!found) return ++missed_, false;
        if (!reference) return ++false_, false;
        const double error = error_in_ulp<S>(computed, *reference);
        if (!(error <= kWrongUlps)) return ++wrong_, false;
        errors_.push_back(static_cast<float>(error));
        return true;
    }

    void add(const Tally& other) {
        cases_ += other.cases_;
        missed_ += other.missed_;
        false_ += other.false_;
        wrong_ += other.wrong_;
        errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end());
    }

    [[nodiscard]] std::size_t cases() const { return cases_; }
    [[nodiscard]] std::size_t contacts() const { return errors_.size(); }
    [[nodiscard]] std::size_t missed() const { return missed_; }
    [[nodiscard]] std::size_t invented() const { return false_; }
    [[nodiscard]] std::size_t wrong() const { return wrong_; }

    /// The error [ulp] that the given fraction of the contacts does not exceed.
    [[nodiscard]] double quantile(double fraction) {
        if (errors_.empty()) return 0;
        std::sort(errors_.begin(), errors_.end());
        const auto place =
            static_cast<std::size_t>(fraction * static_cast<double>(errors_.size() - 1) + 0.5);
        return static_cast<double>(errors_[place]);
    }

private:
    std::size_t cases_ = 0;
    std::size_t missed_ = 0;
    std::size_t false_ = 0;
    std::size_t wrong_ = 0;
    std::vector<float> errors_;
};

}  // namespace osculo::support
