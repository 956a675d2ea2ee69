#pragma once

#include <cstddef>
#include <vector>

#include "osculo/math/vec.hpp"

namespace osculo::impact::symmetric {

/// The factors A = Q R of a matrix whose columns come and go: Q'Q = I, R upper triangular.
///
/// A column is orthogonalised twice (Gram-Schmidt; "twice is enough", W. Kahan in B. N. Parlett,
/// "The Symmetric Eigenvalue Problem"), one that goes is rotated out. R is that of a matrix within
/// some epsilon of each column. Columns are about 1 long.
template <math::Scalar S>
class Basis {
public:
    /// Starts anew, for columns of [rows] entries.
    void clear(std::size_t rows) {
        rows_ = rows;
        size_ = 0;
        if (q_.size() < rows * rows) q_.resize(rows * rows);
        if (r_.size() < rows * rows) r_.resize(rows * rows);
        if (rest_.size() < rows) rest_.resize(rows);
        if (parts_.size() < rows) parts_.resize(rows);
    }

    [[nodiscard]] std::size_t size() const { return size_; }

    /// How far a column is from the span of those here. What is left of it stays for append().
    /// [scatter](entries) writes it into zeros.
    template <class Scatter>
    [[nodiscard]] S distance(const Scatter& scatter) {
        for (std::size_t i = 0; i < rows_; ++i) rest_[i] = S(0);
        scatter(rest_);
        if (size_ == rows_) return S(0);
        S* column = &r_[size_ * rows_];
        for (std::size_t j = 0; j < size_; ++j) column[j] = S(0);
        for (int pass = 0; pass < 2; ++pass) {
            for (std::size_t j = 0; j < size_; ++j) {
                const S* q = &q_[j * rows_];
                S part(0);
                for (std::size_t i = 0; i < rows_; ++i) part += q[i] * rest_[i];
                for (std::size_t i = 0; i < rows_; ++i) rest_[i] -= part * q[i];
                column[j] += part;
            }
        }
        S square(0);
        for (std::size_t i = 0; i < rows_; ++i) square += rest_[i] * rest_[i];
        column[size_] = math::square_root<S>(square);
        return column[size_];
    }

    /// Of the column last measured: 1 + the sum of the |c| of what it is nearest to, the sum of c
    /// times the columns here. So much the rounding of columns counts in its distance. That must
    /// be > 0.
    [[nodiscard]] S weight() {
        const S* column = &r_[size_ * rows_];
        S sum(1);
        for (std::size_t j = size_; j-- > 0;) {
            S part = column[j];
            for (std::size_t k = j + 1; k < size_; ++k) part -= r_[k * rows_ + j] * parts_[k];
            parts_[j] = part / r_[j * rows_ + j];
            sum += math::abs<S>(parts_[j]);
        }
        return sum;
    }

    /// Takes in the column last measured. Its distance must be > 0.
    void append() {
        const S length = r_[size_ * rows_ + size_];
        for (std::size_t i = 0; i < rows_; ++i) q_[size_ * rows_ + i] = rest_[i] / length;
        ++size_;
    }

    /// Takes out the column at [place]; those after it move up.
    void remove(std::size_t place) {
        --size_;
        for (std::size_t j = place; j < size_; ++j) {
            for (std::size_t i = 0; i <= j + 1; ++i) r_[j * rows_ + i] = r_[(j + 1) * rows_ + i];
        }
        for (std::size_t j = place; j < size_; ++j) {
            const S a = r_[j * rows_ + j];
            const S b = r_[j * rows_ + j + 1];
            const S length = math::square_root<S>(a * a + b * b);
            const S c = a / length;
            const S s = b / length;
            for (std::size_t k = j; k < size_; ++k) {
                rotate(r_[k * rows_ + j], r_[k * rows_ + j + 1], c, s);
            }
            for (std::size_t i = 0; i < rows_; ++i) {
                rotate(q_[j * rows_ + i], q_[(j + 1) * rows_ + i], c, s);
            }
        }
    }

    /// x with R'R x = x.
    void solve_normal(std::vector<S>& x) const {
        for (std::size_t j = 0; j < size_; ++j) {
            for (std::size_t i = 0; i < j; ++i) x[j] -= r_[j * rows_ + i] * x[i];
            x[j] /= r_[j * rows_ + j];
        }
        for (std::size_t j = size_; j-- > 0;) {
            x[j] /= r_[j * rows_ + j];
            for (std::size_t i = 0; i < j; ++i) x[i] -= r_[j * rows_ + i] * x[j];
        }
    }

private:
    // Not c a + s b and c b - s a as they stand: g++ 12 contracts the pair into one fused operation
    // where the processor has it (vfmsubadd), whatever -ffp-contract says.
    static void rotate(S& a, S& b, const S& c, const S& s) {
        const S first = math::difference_of_products<S>(c, a, -s, b);
        b = math::difference_of_products<S>(c, b, s, a);
        a = first;
    }

    std::size_t rows_ = 0;
    std::size_t size_ = 0;
    std::vector<S> q_;      // by columns
    std::vector<S> r_;      // by columns
    std::vector<S> rest_;   // of the column last measured
    std::vector<S> parts_;  // of what it is nearest to
};

}  // namespace osculo::impact::symmetric
