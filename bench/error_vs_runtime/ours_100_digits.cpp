#include "ours.hpp"

namespace osculo::bench {

Contender ours_100_digits() {
    return ours::contender<boost::multiprecision::cpp_bin_float_100>("osculo 100 digits");
}

}  // namespace osculo::bench
