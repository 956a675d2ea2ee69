#include "presets/tables.hpp"

// What balls do on each kind of table. The frictions and restitutions are those that pooltool gives
// balls of each game (commit 9a8abfe), for cloth and cushions of ordinary quality.

namespace osculo::presets {
namespace {

// 4/9 of the radius in metres [pooltool]: with a gravity of 9.81 m/s^2 the spin about the vertical
// of a solid sphere decays at 10.9 rad/s^2, whatever its size.
constexpr double spinning_friction(double radius) {
    return 4.0 / 9 * radius;
}

constexpr ClothMotion kPoolCloth{.sliding_friction = 0.2,
                                 .rolling_friction = 0.01,
                                 .spinning_friction = spinning_friction(kPoolBallRadius)};
constexpr ClothMotion kSnookerCloth{.sliding_friction = 0.5,
                                    .rolling_friction = 0.01,
                                    .spinning_friction = spinning_friction(kSnookerBallRadius)};
constexpr ClothMotion kCaromCloth{.sliding_friction = 0.2,
                                  .rolling_friction = 0.01,
                                  .spinning_friction = spinning_friction(kCaromBallRadius)};

// The friction between balls falls with their slip speed [Alciatore, technical proof A.14: a fit of
// Marlow's measurements].
constexpr BallBallImpact kBalls{
    .law = BallBallLaw::frictional, .restitution = 0.95, .friction = {0.009951, 0.108, 1.088}};

constexpr CushionImpact cushion(double friction, double height) {
    return {CushionLaw::han_2005, 0.85, friction, height};
}

// Noses at 64 % of a ball's height [WPA equipment specifications: 62.5 to 64.5 %], at 28 mm [the
// snooker table of pooltool], at 37 mm [UMB equipment rules: 36 to 38 mm].
constexpr CushionImpact kPoolCushion = cushion(0.2, 0.64 * (2 * kPoolBallRadius));
constexpr CushionImpact kSnookerCushion = cushion(0.5, 0.028);
constexpr CushionImpact kCaromCushion = cushion(0.15, 0.037);

}  // namespace

void set_table_laws(Scene& scene, std::string_view name) {
    scene.impacts = {};
    scene.impacts.ball_ball = kBalls;
    switch (table_named(name).game) {
        case Game::pool:
            scene.motion = kPoolCloth;
            scene.impacts.ball_cushion = kPoolCushion;
            break;
        case Game::snooker:
            scene.motion = kSnookerCloth;
            scene.impacts.ball_cushion = kSnookerCushion;
            break;
        case Game::carom:
            scene.motion = kCaromCloth;
            scene.impacts.ball_cushion = kCaromCushion;
            break;
    }
}

}  // namespace osculo::presets
