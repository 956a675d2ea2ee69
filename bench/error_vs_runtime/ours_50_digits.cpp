#include "ours.hpp"

namespace osculo::bench {

Contender ours_50_digits() {
    return ours::contender<boost::multiprecision::cpp_bin_float_50>("osculo 50 digits");
}

}  // namespace osculo::bench
