#include "presets/tables.hpp"

namespace osculo::presets {

// 2.84 m x 1.42 m between the noses of the cushions, without pockets [UMB equipment rules].
void add_carom_10ft(Scene& scene) {
    add_rectangle(scene, kCarom10ft.width, kCarom10ft.length);
}

}  // namespace osculo::presets
