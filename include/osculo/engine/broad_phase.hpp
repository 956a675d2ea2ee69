#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "osculo/engine/event.hpp"
#include "osculo/math/vec.hpp"

namespace osculo::engine {

/// Every ball may meet every other: cost per event grows with the number of balls. No state.
template <math::Scalar S>
class AllPairs {
public:
    static constexpr const char* kName = "all-pairs";
    static constexpr bool kCrossings = false;

    template <class Bodies>
    explicit AllPairs(const Bodies& bodies) : count_(static_cast<BallIndex>(bodies.size())) {}

    /// Calls visit(j) for every ball that ball i could meet before its next cell crossing.
    template <class Visit>
    void for_each_candidate(BallIndex i, Visit&& visit) const {
        for (BallIndex j = 0; j < count_; ++j) {
            if (j != i) visit(j);
        }
    }

    void remove(BallIndex) {}

    template <class Archive>
    void archive(Archive&) {}

private:
    BallIndex count_;
};

/// A square grid over the balls' start; its outermost cells reach to infinity. Cells are at least
/// as large as the largest ball's diameter, so that balls can only touch in the same or in
/// neighbouring cells. Crossing into another cell is an event of the ball that changes only this
/// bookkeeping: a prediction does not depend on when it is made, so results are those of AllPairs
/// bit for bit. Cost per event grows with the number of balls in nine cells.
template <math::Scalar S>
class CellGrid {
public:
    static constexpr const char* kName = "cell-grid";
    static constexpr bool kCrossings = true;

    /// Requires finite positions; [bodies] have state.position and radius.
    template <class Bodies>
    explicit CellGrid(const Bodies& bodies);

    /// Calls visit(j) for every other ball in the nine cells around ball i's.
    template <class Visit>
    void for_each_candidate(BallIndex i, Visit&& visit) const;

    /// When ball i leaves its cell, counted from the start of its path, or never().
    template <class Path>
    [[nodiscard]] S next_crossing(BallIndex i, const Path& path) const;

    /// Moves ball i into the cell that its next crossing leads to.
    template <class Path>
    void cross(BallIndex i, const Path& path);

    void remove(BallIndex i);

    /// As Engine::archive(): the lists of the cells.
    template <class Archive>
    void archive(Archive& archive);

private:
    static constexpr std::int32_t kNone = -1;
    struct Place {
        std::int32_t column = 0;
        std::int32_t row = 0;
        std::int32_t next = kNone;  ///< neighbours in the list of the ball's cell
        std::int32_t previous = kNone;
    };
    struct Crossing {
        S when = math::never<S>();
        std::int32_t column_step = 0;
        std::int32_t row_step = 0;
    };

    [[nodiscard]] std::size_t cell(std::int32_t column, std::int32_t row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    void insert(BallIndex i);
    template <class Path>
    [[nodiscard]] Crossing crossing(BallIndex i, const Path& path) const;
    /// Time until a coordinate at x with speed v leaves the interval of cell [index] of [count].
    [[nodiscard]] S leave(const S& x, const S& v, const S& origin, std::int32_t index,
                          std::int32_t count) const;

    S origin_x_{0};
    S origin_y_{0};
    S size_{1};
    std::int32_t columns_ = 1;
    std::int32_t rows_ = 1;
    std::vector<Place> places_;
    std::vector<std::int32_t> heads_;  ///< first ball of each cell
};

template <math::Scalar S>
template <class Bodies>
CellGrid<S>::CellGrid(const Bodies& bodies) : places_(bodies.size()) {
    if (bodies.empty()) {
        heads_.assign(1, kNone);
        return;
    }
    S largest{0};
    math::Vec<S> low = bodies.front().state.position.rounded();
    math::Vec<S> high = low;
    for (const auto& body : bodies) {
        largest = std::max<S>(largest, body.radius);
        const math::Vec<S> p = body.state.position.rounded();
        low = {std::min<S>(low.x(), p.x()), std::min<S>(low.y(), p.y())};
        high = {std::max<S>(high.x(), p.x()), std::max<S>(high.y(), p.y())};
    }
    origin_x_ = low.x();
    origin_y_ = low.y();
    const S width = high.x() - low.x();
    const S height = high.y() - low.y();
    // The margins cover the rounding of cell borders and crossings. Cells hold about one ball if
    // the balls are spread evenly, and there are never many more cells than balls.
    const S count = S(static_cast<double>(bodies.size()));
    const S reach = std::max<S>(math::norm_max<S>(low), math::norm_max<S>(high));
    size_ = S(2) * largest * S(1.001) + S(16) * math::epsilon<S>() * reach;
    size_ = std::max<S>(size_, math::square_root<S>(width / count) * math::square_root<S>(height));
    size_ = std::max<S>(size_, (width + height) / (S(2) * count));
    columns_ = 1 + static_cast<std::int32_t>(math::to_double<S>(width / size_));
    rows_ = 1 + static_cast<std::int32_t>(math::to_double<S>(height / size_));
    heads_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
    for (BallIndex i = 0; i < bodies.size(); ++i) {
        const math::Vec<S> p = bodies[i].state.position.rounded();
        const auto index = [&](const S& x, const S& origin, std::int32_t limit) {
            return std::min(static_cast<std::int32_t>(math::to_double<S>((x - origin) / size_)),
                            limit - 1);
        };
        places_[i].column = index(p.x(), origin_x_, columns_);
        places_[i].row = index(p.y(), origin_y_, rows_);
        insert(i);
    }
}

template <math::Scalar S>
template <class Visit>
void CellGrid<S>::for_each_candidate(BallIndex i, Visit&& visit) const {
    const Place& place = places_[i];
    const std::int32_t last_row = std::min(place.row + 1, rows_ - 1);
    const std::int32_t last_column = std::min(place.column + 1, columns_ - 1);
    for (std::int32_t row = std::max(place.row - 1, 0); row <= last_row; ++row) {
        for (std::int32_t column = std::max(place.column - 1, 0); column <= last_column; ++column) {
            for (std::int32_t j = heads_[cell(column, row)]; j != kNone;
                 j = places_[static_cast<std::size_t>(j)].next) {
                if (static_cast<BallIndex>(j) != i) visit(static_cast<BallIndex>(j));
            }
        }
    }
}

template <math::Scalar S>
template <class Path>
S CellGrid<S>::next_crossing(BallIndex i, const Path& path) const {
    return crossing(i, path).when;
}

template <math::Scalar S>
template <class Path>
void CellGrid<S>::cross(BallIndex i, const Path& path) {
    const Crossing to = crossing(i, path);
    remove(i);
    places_[i].column += to.column_step;
    places_[i].row += to.row_step;
    insert(i);
}

template <math::Scalar S>
template <class Path>
typename CellGrid<S>::Crossing CellGrid<S>::crossing(BallIndex i, const Path& path) const {
    const Place& place = places_[i];
    const math::Vec<S> p = path.position.rounded();
    const S tx = leave(p.x(), path.velocity.x(), origin_x_, place.column, columns_);
    const S ty = leave(p.y(), path.velocity.y(), origin_y_, place.row, rows_);
    if (!math::is_finite<S>(tx) && !math::is_finite<S>(ty)) return {};
    if (tx <= ty) return {tx, path.velocity.x() > S(0) ? 1 : -1, 0};
    return {ty, 0, path.velocity.y() > S(0) ? 1 : -1};
}

template <math::Scalar S>
S CellGrid<S>::leave(const S& x, const S& v, const S& origin, std::int32_t index,
                     std::int32_t count) const {
    const bool up = v > S(0);
    if (v == S(0) || (up ? index == count - 1 : index == 0)) return math::never<S>();
    const S border = origin + size_ * S(up ? index + 1 : index);
    const S t = (border - x) / v;
    return t > S(0) ? t : S(0);
}

template <math::Scalar S>
void CellGrid<S>::insert(BallIndex i) {
    Place& place = places_[i];
    std::int32_t& head = heads_[cell(place.column, place.row)];
    place.previous = kNone;
    place.next = head;
    if (head != kNone)
        places_[static_cast<std::size_t>(head)].previous = static_cast<std::int32_t>(i);
    head = static_cast<std::int32_t>(i);
}

template <math::Scalar S>
void CellGrid<S>::remove(BallIndex i) {
    const Place& place = places_[i];
    if (place.next != kNone)
        places_[static_cast<std::size_t>(place.next)].previous = place.previous;
    if (place.previous != kNone) {
        places_[static_cast<std::size_t>(place.previous)].next = place.next;
    } else {
        heads_[cell(place.column, place.row)] = place.next;
    }
}

template <math::Scalar S>
template <class Archive>
void CellGrid<S>::archive(Archive& archive) {
    // Cell by cell, each list from its end on, as insert() makes it. Balls that are gone have none.
    std::vector<BallIndex> order;
    for (std::int32_t ball : heads_) {
        const auto begin = order.size();
        for (; ball != kNone; ball = places_[static_cast<std::size_t>(ball)].next) {
            order.push_back(static_cast<BallIndex>(ball));
        }
        std::reverse(order.begin() + static_cast<std::ptrdiff_t>(begin), order.end());
    }
    archive(order);
    std::vector<bool> seen(places_.size(), false);
    std::fill(heads_.begin(), heads_.end(), kNone);
    for (const BallIndex i : order) {
        archive.require(i < places_.size() && !seen[i]);
        seen[i] = true;
        Place& place = places_[i];
        archive(place.column, place.row);
        archive.require(place.column >= 0 && place.column < columns_ && place.row >= 0 &&
                        place.row < rows_);
        insert(i);
    }
}

}  // namespace osculo::engine
