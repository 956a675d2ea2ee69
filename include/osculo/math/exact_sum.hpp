#pragma once

#include <array>
#include <cstddef>

#include "osculo/math/error_bounds.hpp"
#include "osculo/math/wide.hpp"

namespace osculo::math {

/// A sum of at most kCapacity terms without any rounding, as an expansion of components that do
/// not overlap (J. R. Shewchuk, Discrete Comput. Geom. 18, 1997): for what is decided by digits
/// that wide arithmetic no longer has. Exact unless a term under- or overflows; no allocation.
template <Builtin S, std::size_t kCapacity>
class ExactSum {
public:
    void add(S term) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const DoubleDouble<S> sum = two_sum(term, components_[i]);
            term = sum.hi;
            if (sum.lo != 0) components_[kept++] = sum.lo;
        }
        if (term != 0) components_[kept++] = term;
        count_ = kept;
    }

    void add_product(S a, S b) {
        const DoubleDouble<S> product = two_product(a, b);
        add(product.lo);
        add(product.hi);
    }

    /// The sum, to the relative precision of wide numbers; its sign is exact.
    [[nodiscard]] DoubleDouble<S> value() const {
        DoubleDouble<S> sum;
        for (std::size_t i = 0; i < count_; ++i) {
            sum = DoubleDouble<S>(components_[i]) + sum;  // from the smallest to the largest
        }
        return sum;
    }

private:
    std::array<S, kCapacity> components_{};
    std::size_t count_ = 0;
};

/// True if a - b has lost so many digits in wide arithmetic that it has to be formed exactly.
template <Builtin S>
[[nodiscard]] bool cancelled(const DoubleDouble<S>& difference, const DoubleDouble<S>& subtrahend) {
    return abs<S>(difference.hi) <= S(kExactStage) * epsilon<S>() * abs<S>(subtrahend.hi);
}

}  // namespace osculo::math
