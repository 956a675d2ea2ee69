#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "osculo/geometry/box.hpp"

namespace osculo::engine {

/// Boxes of one kind of obstacles, found by where a box overlaps them: for 16 slabs each way, which
/// obstacles begin at the latest, and end at the earliest, in that slab. One bit each.
template <math::Scalar S>
class BoxIndex {
    using Box = geometry::Box<S>;
    using Word = std::uint64_t;
    static constexpr std::size_t kSlabs = 16;

public:
    void add(const Box& box) { boxes_.push_back(box); }
    [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

    /// To be called when all have been added; [around] all of them.
    void build(const Box& around) {
        x_ = Slabs(around.low_x, around.high_x);
        y_ = Slabs(around.low_y, around.high_y);
        masks_.assign((boxes_.size() + 63) / 64, {});
        for (std::size_t k = 0; k < boxes_.size(); ++k) {
            Masks& masks = masks_[k / 64];
            const Word bit = Word(1) << (k % 64);
            masks.begun_x[x_(boxes_[k].low_x)] |= bit;
            masks.begun_y[y_(boxes_[k].low_y)] |= bit;
            masks.not_over_x[x_(boxes_[k].high_x)] |= bit;
            masks.not_over_y[y_(boxes_[k].high_y)] |= bit;
        }
        for (Masks& masks : masks_) {
            for (std::size_t s = 1; s < kSlabs; ++s) {
                masks.begun_x[s] |= masks.begun_x[s - 1];
                masks.begun_y[s] |= masks.begun_y[s - 1];
                masks.not_over_x[kSlabs - 1 - s] |= masks.not_over_x[kSlabs - s];
                masks.not_over_y[kSlabs - 1 - s] |= masks.not_over_y[kSlabs - s];
            }
        }
    }

    /// Calls visit(k), k rising, for every obstacle whose box is not apart from [box], which visit
    /// may make smaller.
    template <class Visit>
    void for_each_near(const Box& box, Visit&& visit) const {
        const std::size_t low_x = x_(box.low_x), high_x = x_(box.high_x);
        const std::size_t low_y = y_(box.low_y), high_y = y_(box.high_y);
        for (std::size_t word = 0; word < masks_.size(); ++word) {
            const Masks& masks = masks_[word];
            Word near = masks.begun_x[high_x] & masks.not_over_x[low_x] & masks.begun_y[high_y] &
                        masks.not_over_y[low_y];
            for (; near != 0; near &= near - 1) {
                const std::size_t k = 64 * word + static_cast<std::size_t>(std::countr_zero(near));
                if (!boxes_[k].apart(box)) visit(k);
            }
        }
    }

private:
    /// The slab of a coordinate. It never falls when the coordinate rises, so rounding cannot hide
    /// an overlap. What is not a number is nowhere in particular; boxes have none.
    struct Slabs {
        S low{0}, high{0}, per_length{0};

        Slabs() = default;
        Slabs(const S& from, const S& to) : low(from), high(to) {
            if (to > from) per_length = S(static_cast<double>(kSlabs)) / (to - from);
        }
        [[nodiscard]] std::size_t operator()(const S& x) const {
            if (!(x > low)) return 0;
            if (!(x < high)) return kSlabs - 1;
            const auto slab = static_cast<std::size_t>(math::to_double<S>((x - low) * per_length));
            return std::min(slab, kSlabs - 1);
        }
    };
    struct Masks {
        std::array<Word, kSlabs> begun_x{}, not_over_x{}, begun_y{}, not_over_y{};
    };

    std::vector<Box> boxes_;
    Slabs x_, y_;
    std::vector<Masks> masks_;
};

/// Boxes around a scene's obstacles, and a rectangle between them that none reaches into: what most
/// balls are told apart from their obstacles with. Kinds without a bounding_box() have none and are
/// always looked at. [Storage]: a tuple of vectors of obstacles.
template <math::Scalar S, class Storage>
class ObstacleBoxes {
    using Box = geometry::Box<S>;
    static constexpr std::size_t kKinds = std::tuple_size_v<Storage>;

public:
    template <std::size_t K>
    static constexpr bool kHas =
        requires(const typename std::tuple_element_t<K, Storage>::value_type& obstacle) {
        { bounding_box(obstacle) } -> std::convertible_to<Box>;
    };

    explicit ObstacleBoxes(const Storage& obstacles) {
        [&]<std::size_t... K>(std::index_sequence<K...>) {
            (add_kind<K>(std::get<K>(obstacles)), ...);
        }
        (std::make_index_sequence<kKinds>{});
        Box around{math::never<S>(), -math::never<S>(), math::never<S>(), -math::never<S>()};
        for_each_box([&around](const Box& box) {
            around = {std::min<S>(around.low_x, box.low_x), std::max<S>(around.high_x, box.high_x),
                      std::min<S>(around.low_y, box.low_y), std::max<S>(around.high_y, box.high_y)};
        });
        for (BoxIndex<S>& kind : kinds_) kind.build(around);
        clear_ = around;
        for_each_box([this](const Box& box) { cut_away(box); });
    }

    /// Calls visit(k), k rising, for every obstacle of kind K that may be near a ball that stays in
    /// [swept], which visit may make smaller.
    template <std::size_t K, class Visit>
    void for_each_near(const Box& swept, Visit&& visit) const {
        if (!clear_.encloses(swept)) kinds_[K].for_each_near(swept, visit);
    }

private:
    template <std::size_t K, class Kind>
    void add_kind(const Kind& obstacles) {
        if constexpr (kHas<K>) {
            for (const auto& obstacle : obstacles) kinds_[K].add(bounding_box(obstacle));
        }
    }
    template <class F>
    void for_each_box(F&& f) const {
        for (const BoxIndex<S>& kind : kinds_) {
            for (const Box& box : kind.boxes()) f(box);
        }
    }

    /// Takes the box out of the clear rectangle by the cut that leaves most of its area.
    void cut_away(const Box& box) {
        if (clear_.apart(box)) return;
        const std::array<Box, 4> parts{Box{clear_.low_x, box.low_x, clear_.low_y, clear_.high_y},
                                       Box{box.high_x, clear_.high_x, clear_.low_y, clear_.high_y},
                                       Box{clear_.low_x, clear_.high_x, clear_.low_y, box.low_y},
                                       Box{clear_.low_x, clear_.high_x, box.high_y, clear_.high_y}};
        const auto area = [](const Box& b) {
            const S width = b.high_x - b.low_x;
            const S height = b.high_y - b.low_y;
            return width > S(0) && height > S(0) ? S(width * height) : S(0);
        };
        Box best = parts[0];
        for (const Box& part : parts) {
            if (area(part) > area(best)) best = part;
        }
        clear_ = best;
    }

    std::array<BoxIndex<S>, kKinds> kinds_;
    Box clear_;
};

/// Nothing to be near to.
template <math::Scalar S>
class ObstacleBoxes<S, std::tuple<>> {
public:
    explicit ObstacleBoxes(const std::tuple<>&) {}
};

}  // namespace osculo::engine
