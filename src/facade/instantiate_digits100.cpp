#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> digits100_engines() {
    return wide_engines<boost::multiprecision::cpp_bin_float_100, impact::Sequential>();
}

}  // namespace osculo::facade
