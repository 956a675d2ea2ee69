#include "ours.hpp"

namespace osculo::bench {

Contender ours_double() {
    return ours::contender<double>("osculo double");
}

}  // namespace osculo::bench
