#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace osculo::bench {

/// Numbers of which medians and the like are asked for.
class Sample {
public:
    /// What is not a number, or no sensible one, counts as 1e30.
    void add(double x) { values_.push_back(x < 1e30 ? x : 1e30); }
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] double quantile(double q) const {
        std::vector<double> sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        const double at = q * static_cast<double>(sorted.size() - 1);
        const auto low = static_cast<std::size_t>(at);
        const std::size_t high = std::min(low + 1, sorted.size() - 1);
        const double part = at - static_cast<double>(low);
        return sorted[low] + (part > 0 ? part * (sorted[high] - sorted[low]) : 0);
    }
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double worst() const { return quantile(1); }

private:
    std::vector<double> values_;
};

}  // namespace osculo::bench
