#include "ours.hpp"

namespace osculo::bench {

Contender ours_float() {
    return ours::contender<float>("osculo float");
}

}  // namespace osculo::bench
