#include "ours.hpp"

namespace osculo::bench {

Contender ours_quad() {
    return ours::contender<math::Quad>("osculo quad");
}

}  // namespace osculo::bench
