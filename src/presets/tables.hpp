#pragma once

#include "osculo/presets.hpp"

// The tables, one file each, and what they have in common.
namespace osculo::presets {

/// Width (along x) and length (along y) of the bed between the noses of the cushions [m]; the
/// origin is the corner of the noses at the bottom left.
struct Bed {
    double width;
    double length;
};

inline constexpr Bed kPool7ft{0.9906, 1.9812};
inline constexpr Bed kPool8ft{1.1684, 2.3368};
inline constexpr Bed kPool9ft{1.27, 2.54};
inline constexpr Bed kSnooker12ft{1.778, 3.569};
inline constexpr Bed kCarom10ft{1.42, 2.84};

/// Ball of pool: 2 1/4 in and 6 oz [WPA equipment specifications].
inline constexpr double kPoolBallRadius = 0.028575;
inline constexpr double kPoolBallMass = 0.170097;

/// Ball of snooker: 2 1/16 in, as most sets are made (the rules say 52.5 mm, a tenth of a
/// millimetre more), and 140 g, which the rules leave open [WPBSA rules, section 1; pooltool].
inline constexpr double kSnookerBallRadius = 0.02619375;
inline constexpr double kSnookerBallMass = 0.14;

/// Ball of carom: 61.5 mm and 210 g [UMB equipment rules: 61 to 61.5 mm, 205 to 220 g].
inline constexpr double kCaromBallRadius = 0.03075;
inline constexpr double kCaromBallMass = 0.21;

void add_pool_7ft(Scene& scene);
void add_pool_8ft(Scene& scene);
void add_pool_9ft(Scene& scene);
void add_snooker_12ft(Scene& scene);
void add_carom_10ft(Scene& scene);

/// What is played on a table.
enum class Game { pool, snooker, carom };

/// A table by its name.
struct Table {
    std::string_view name;
    Game game;
    Bed bed;
    void (*add)(Scene&);
};

/// The table of that name; throws SceneError (with the nearest name) if there is none.
[[nodiscard]] const Table& table_named(std::string_view name);

/// The table that the scene has, if it has one: a scene does not say, but its cushions do.
[[nodiscard]] const Table* table_of(const Scene& scene);

/// Four one-sided segments, "bottom", "right", "top" and "left", that bound the rectangle from the
/// origin to (width, height).
void add_rectangle(Scene& scene, double width, double height);

}  // namespace osculo::presets
