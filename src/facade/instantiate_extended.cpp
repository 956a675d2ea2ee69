#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> extended_engines() {
    return wide_engines<long double, impact::Sequential>();
}

}  // namespace osculo::facade
