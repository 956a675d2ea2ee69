#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> digits50_engines() {
    return wide_engines<boost::multiprecision::cpp_bin_float_50, impact::Sequential>();
}

}  // namespace osculo::facade
