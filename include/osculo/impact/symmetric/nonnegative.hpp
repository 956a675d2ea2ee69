#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/symmetric/basis.hpp"
#include "osculo/math/error_bounds.hpp"
#include "osculo/math/vec.hpp"

namespace osculo::impact::symmetric {

/// A column of at most five entries: one pair of rows for each of two balls and a row of its own.
template <math::Scalar S>
struct Column {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    std::size_t one;
    std::size_t other;  ///< ball, or kNone
    math::Vec<S> at_one;
    math::Vec<S> at_other;
    std::size_t row = kNone;  ///< further row, or kNone
    S at_row{0};

    void add_to(std::vector<S>& rows, const S& factor) const {
        rows[2 * one] += factor * at_one.x();
        rows[2 * one + 1] += factor * at_one.y();
        if (other != kNone) {
            rows[2 * other] += factor * at_other.x();
            rows[2 * other + 1] += factor * at_other.y();
        }
        if (row != kNone) rows[row] += factor * at_row;
    }
    [[nodiscard]] S dot(const std::vector<S>& rows) const {
        S sum = at_one.x() * rows[2 * one] + at_one.y() * rows[2 * one + 1];
        if (other != kNone) {
            sum += at_other.x() * rows[2 * other] + at_other.y() * rows[2 * other + 1];
        }
        if (row != kNone) sum += at_row * rows[row];
        return sum;
    }
};

/// The smallest |y + A x|^2 / 2 over x >= 0, for y known by its products with the columns only:
/// b = A'y. Active sets after C. L. Lawson and R. J. Hanson, "Solving Least Squares Problems", ch.
/// 23. The sum y + A x is unique, x is if the columns that take part are independent.
///
/// Each step lowers |y + A x|, so that it may be ended at any time. A candidate that rounding
/// makes dependent on those that take part, or whose x would not become positive, is passed over.
/// With b from closing speeds instead of y, errors are relative to what is to be changed.
template <math::Scalar S>
class Nonnegative {
public:
    void clear(std::size_t rows) {
        rows_ = rows;
        items_.clear();
        places_.clear();
        basis_.clear(rows);
    }

    /// [product]: of the column with y; left alone above -tolerance.
    void add(const Column<S>& column, const S& product, const S& tolerance) {
        items_.push_back({column, product, product, tolerance, S(0), kOut});
    }

    /// False if rounding kept it from the end.
    bool solve() {
        const std::size_t most = 10 * items_.size() + 20;
        bool done = false;
        for (std::size_t step = 0; step < most && !done; ++step) {
            const std::size_t next = candidate();
            done = next == kNone;
            if (!done && !enter(next)) items_[next].place = kPassedOver;
        }
        refresh();
        return done;
    }

    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] const S& x(std::size_t k) const { return items_[k].x; }
    /// Product of the column with y.
    [[nodiscard]] const S& start(std::size_t k) const { return items_[k].start; }
    /// Product of the column with y + A x.
    [[nodiscard]] const S& product(std::size_t k) const { return items_[k].product; }
    [[nodiscard]] const Column<S>& column(std::size_t k) const { return items_[k].column; }
    [[nodiscard]] bool takes_part(std::size_t k) const { return items_[k].place < kPassedOver; }
    /// A x.
    [[nodiscard]] const std::vector<S>& change() const { return change_; }
    /// Distance of a column from the span of those that take part.
    [[nodiscard]] S distance(std::size_t k) {
        return basis_.distance([&](std::vector<S>& rows) { items_[k].column.add_to(rows, S(1)); });
    }

    /// Calls apply(k, z_k) for those that take part, z = (A'A)^-1 [products].
    template <class Product, class Apply>
    void solve_normal(const Product& products, const Apply& apply) {
        for (std::size_t p = 0; p < places_.size(); ++p) trial_[p] = products(places_[p]);
        basis_.solve_normal(trial_);
        for (std::size_t p = 0; p < places_.size(); ++p) apply(places_[p], trial_[p]);
    }
    /// A better x, of a column that takes part.
    void set_x(std::size_t k, const S& x) {
        if (x > S(0)) items_[k].x = x;
    }

private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    static constexpr std::size_t kOut = kNone;
    static constexpr std::size_t kPassedOver = kNone - 1;

    struct Item {
        Column<S> column;
        S start;    // product with y
        S product;  // product with y + A x
        S tolerance;
        S x;
        std::size_t place;  // in the basis, or kOut, kPassedOver
    };

    [[nodiscard]] std::size_t candidate() const {
        std::size_t best = kNone;
        for (std::size_t k = 0; k < items_.size(); ++k) {
            const Item& item = items_[k];
            if (item.place != kOut || !(item.product < -item.tolerance)) continue;
            if (best == kNone || item.product < items_[best].product) best = k;
        }
        return best;
    }

    /// Takes a column in and goes to the smallest value, leaving out what would become negative.
    bool enter(std::size_t k) {
        const S far = distance(k);
        const S least = S(math::kClusterDependent) * math::epsilon<S>();
        if (!(far > least) || !(far > least * basis_.weight())) return false;
        basis_.append();
        items_[k].place = places_.size();
        places_.push_back(k);
        bool entered = false;
        while (!places_.empty()) {
            find_trial();
            if (!entered && !(trial_[items_[k].place] > S(0))) {
                leave(items_[k].place);
                return false;
            }
            entered = true;
            // As far towards the trial as all stay positive.
            S share(1);
            std::size_t first = kNone;
            for (std::size_t p = 0; p < places_.size(); ++p) {
                if (trial_[p] > S(0)) continue;
                const S& x = items_[places_[p]].x;
                const S s = x / (x - trial_[p]);
                if (first == kNone || s < share) {
                    share = s;
                    first = p;
                }
            }
            for (std::size_t p = 0; p < places_.size(); ++p) {
                S& x = items_[places_[p]].x;
                x = first == kNone ? trial_[p] : S(x + share * (trial_[p] - x));
            }
            if (first == kNone) break;
            items_[places_[first]].x = S(0);
            for (std::size_t p = places_.size(); p-- > 0;) {
                if (!(items_[places_[p]].x > S(0))) leave(p);
            }
        }
        for (Item& item : items_) {
            if (item.place == kPassedOver) item.place = kOut;
        }
        refresh();
        return true;
    }

    void leave(std::size_t place) {
        items_[places_[place]].x = S(0);
        items_[places_[place]].place = kOut;
        places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(place));
        for (std::size_t p = place; p < places_.size(); ++p) items_[places_[p]].place = p;
        basis_.remove(place);
    }

    /// trial_ = -(A'A)^-1 A'y over those that take part, corrected once by what is left of A'(y +
    /// A x), for that is what energy depends on.
    void find_trial() {
        if (trial_.size() < places_.size()) {
            trial_.resize(items_.size());
            correction_.resize(items_.size());
        }
        for (std::size_t p = 0; p < places_.size(); ++p) trial_[p] = -items_[places_[p]].start;
        basis_.solve_normal(trial_);
        change_.assign(rows_, S(0));
        for (std::size_t p = 0; p < places_.size(); ++p) {
            items_[places_[p]].column.add_to(change_, trial_[p]);
        }
        for (std::size_t p = 0; p < places_.size(); ++p) {
            const Item& item = items_[places_[p]];
            correction_[p] = item.start + item.column.dot(change_);
        }
        basis_.solve_normal(correction_);
        for (std::size_t p = 0; p < places_.size(); ++p) trial_[p] -= correction_[p];
    }

    void refresh() {
        change_.assign(rows_, S(0));
        for (const std::size_t k : places_) items_[k].column.add_to(change_, items_[k].x);
        for (Item& item : items_) item.product = item.start + item.column.dot(change_);
    }

    std::size_t rows_ = 0;
    Basis<S> basis_;
    std::vector<Item> items_;
    std::vector<std::size_t> places_;  // items that take part, in the order of the basis
    std::vector<S> trial_;
    std::vector<S> correction_;
    std::vector<S> change_;
};

}  // namespace osculo::impact::symmetric
