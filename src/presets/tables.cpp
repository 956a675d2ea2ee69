#include "presets/tables.hpp"

#include <algorithm>
#include <array>

#include "presets/nearest_name.hpp"

namespace osculo::presets {
namespace {

constexpr std::array kTables{
    Table{"pool-7ft", Game::pool, kPool7ft, add_pool_7ft},
    Table{"pool-8ft", Game::pool, kPool8ft, add_pool_8ft},
    Table{"pool-9ft", Game::pool, kPool9ft, add_pool_9ft},
    Table{"snooker-12ft", Game::snooker, kSnooker12ft, add_snooker_12ft},
    Table{"carom-10ft", Game::carom, kCarom10ft, add_carom_10ft},
};

}  // namespace

const Table& table_named(std::string_view name) {
    const auto found = std::ranges::find(kTables, name, &Table::name);
    if (found != kTables.end()) return *found;
    std::array<std::string_view, kTables.size()> names;
    std::ranges::transform(kTables, names.begin(), &Table::name);
    throw SceneError("table", "must be " + listed(names, " or ", "\"") + did_you_mean(name, names),
                     '"' + std::string(name) + '"');
}

const Table* table_of(const Scene& scene) {
    for (const Table& table : kTables) {
        Scene bare;
        table.add(bare);
        const bool has_it =
            std::search(scene.segments.begin(), scene.segments.end(), bare.segments.begin(),
                        bare.segments.end()) != scene.segments.end();
        if (has_it) return &table;
    }
    return nullptr;
}

void add_table(Scene& scene, std::string_view name) {
    table_named(name).add(scene);
    scene.closed = true;
}

void add_rectangle(Scene& scene, double width, double height) {
    const Point corner[]{{0, 0}, {width, 0}, {width, height}, {0, height}};
    scene.segments.push_back({"bottom", corner[0], corner[1], Side::left});
    scene.segments.push_back({"right", corner[1], corner[2], Side::left});
    scene.segments.push_back({"top", corner[2], corner[3], Side::left});
    scene.segments.push_back({"left", corner[3], corner[0], Side::left});
}

}  // namespace osculo::presets
