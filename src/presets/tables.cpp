#include "presets/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "presets/nearest_name.hpp"
#include "presets/parameters.hpp"

namespace osculo::presets {
namespace {

struct Table {
    std::string_view name;
    Bed bed;
    void (*add)(Scene&);
    bool for_pool;
};

constexpr std::array kTables{
    Table{"pool-7ft", kPool7ft, add_pool_7ft, true},
    Table{"carom-10ft", kCarom10ft, add_carom_10ft, false},
};

// A scene does not say which table it has, but its segments do.
const Table* pool_table_of(const Scene& scene) {
    for (const Table& table : kTables) {
        Scene bare;
        table.add(bare);
        const bool has_it =
            std::search(scene.segments.begin(), scene.segments.end(), bare.segments.begin(),
                        bare.segments.end()) != scene.segments.end();
        if (has_it && table.for_pool) return &table;
    }
    return nullptr;
}

}  // namespace

void add_table(Scene& scene, std::string_view name) {
    const auto found = std::ranges::find(kTables, name, &Table::name);
    if (found == kTables.end()) {
        std::array<std::string_view, kTables.size()> names;
        std::ranges::transform(kTables, names.begin(), &Table::name);
        throw SceneError("table",
                         "must be \"pool-7ft\" or \"carom-10ft\"" + did_you_mean(name, names),
                         '"' + std::string(name) + '"');
    }
    found->add(scene);
    scene.closed = true;
}

void add_rack(Scene& scene, std::string_view name, double gap) {
    constexpr std::array<std::string_view, 1> kRacks{"eight-ball"};
    if (name != kRacks[0]) {
        throw SceneError("rack", "must be \"eight-ball\"" + did_you_mean(name, kRacks),
                         '"' + std::string(name) + '"');
    }
    const Table* const table = pool_table_of(scene);
    if (table == nullptr) {
        throw SceneError("rack", "needs a pool table to stand on",
                         '"' + std::string(name) + "\" without one");
    }
    // Beyond one radius the triangle of the 7 ft table would reach its foot cushion.
    if (!(gap >= 0 && gap <= kPoolBallRadius)) {
        throw SceneError("rack.gap", "must be from 0 to " + number_text(kPoolBallRadius),
                         number_text(gap));
    }
    add_eight_ball(scene, table->bed, gap);
}

void add_rectangle(Scene& scene, double width, double height) {
    const Point corner[]{{0, 0}, {width, 0}, {width, height}, {0, height}};
    scene.segments.push_back({"bottom", corner[0], corner[1], Side::left});
    scene.segments.push_back({"right", corner[1], corner[2], Side::left});
    scene.segments.push_back({"top", corner[2], corner[3], Side::left});
    scene.segments.push_back({"left", corner[3], corner[0], Side::left});
}

}  // namespace osculo::presets
