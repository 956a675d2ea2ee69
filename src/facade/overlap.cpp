#include "overlap.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "osculo/math/vec.hpp"

namespace osculo::facade {
namespace {

/// Where a ball is in the grid of its own size class: cells of at least its diameter. Cell numbers
/// are whole doubles, for they may exceed any integer type.
struct Entry {
    int size_class;
    double column;
    double row;
    std::size_t ball;

    [[nodiscard]] std::tuple<int, double, double> key() const { return {size_class, column, row}; }
    friend bool operator<(const Entry& a, const Entry& b) {
        return std::tuple(a.size_class, a.column, a.row, a.ball) <
               std::tuple(b.size_class, b.column, b.row, b.ball);
    }
};

double cell_size(int size_class) {
    return std::ldexp(1.0, size_class + 1);
}

Entry place(const Ball& ball, int size_class, std::size_t index) {
    const double size = cell_size(size_class);
    return {size_class, std::floor(ball.position.x / size), std::floor(ball.position.y / size),
            index};
}

/// r1 + r2 - distance [m], exact to rounding of the result.
double overlap_depth(const Ball& a, const Ball& b) {
    const math::Vec<double> c{a.position.x - b.position.x, a.position.y - b.position.y};
    return (a.radius + b.radius) - math::norm<double>(c);
}

}  // namespace

std::optional<Overlap> find_overlap(const std::vector<Ball>& balls, double allowed) {
    // Balls of like size share a grid; a ball is looked up in its own grid and in all coarser ones.
    std::vector<Entry> entries;
    entries.reserve(balls.size());
    std::vector<int> classes;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        entries.push_back(place(balls[i], std::ilogb(balls[i].radius) + 1, i));
        classes.push_back(entries.back().size_class);
    }
    std::sort(entries.begin(), entries.end());
    std::sort(classes.begin(), classes.end());
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());

    for (std::size_t i = 0; i < balls.size(); ++i) {
        const int own = std::ilogb(balls[i].radius) + 1;
        for (auto c = std::lower_bound(classes.begin(), classes.end(), own); c != classes.end();
             ++c) {
            const Entry here = place(balls[i], *c, i);
            for (int dx = -1; dx <= 1; ++dx) {
                // The three cells of a column stand next to each other.
                const Entry low{*c, here.column + dx, here.row - 1, 0};
                auto it = std::lower_bound(entries.begin(), entries.end(), low);
                const std::tuple high{*c, here.column + dx, here.row + 1};
                for (; it != entries.end() && it->key() <= high; ++it) {
                    const std::size_t j = it->ball;
                    if (j == i || (*c == own && j < i)) continue;
                    const double depth = overlap_depth(balls[i], balls[j]);
                    if (depth > allowed * std::min(balls[i].radius, balls[j].radius)) {
                        return Overlap{std::min(i, j), std::max(i, j), depth};
                    }
                }
            }
        }
    }
    return std::nullopt;
}

bool has_overlap(const std::vector<Ball>& balls, std::span<const std::uint8_t> present,
                 double allowed) {
    constexpr std::size_t kFew = 100;  // for which looking at every pair is cheap
    if (present.empty() && balls.size() > kFew) return find_overlap(balls, allowed).has_value();
    const auto is_there = [&](std::size_t i) { return present.empty() || present[i] != 0; };
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (!is_there(i)) continue;
        for (std::size_t j = 0; j < i; ++j) {
            const double reach = balls[i].radius + balls[j].radius;
            if (std::abs(balls[i].position.x - balls[j].position.x) >= reach ||
                std::abs(balls[i].position.y - balls[j].position.y) >= reach || !is_there(j)) {
                continue;
            }
            const double depth = overlap_depth(balls[i], balls[j]);
            if (depth > allowed * std::min(balls[i].radius, balls[j].radius)) return true;
        }
    }
    return false;
}

}  // namespace osculo::facade
