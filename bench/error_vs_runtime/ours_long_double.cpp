#include "ours.hpp"

namespace osculo::bench {

Contender ours_long_double() {
    return ours::contender<long double>("osculo long double");
}

}  // namespace osculo::bench
