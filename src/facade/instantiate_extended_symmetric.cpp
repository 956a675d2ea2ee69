#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> extended_symmetric_engines() {
    return wide_engines<long double, impact::Symmetric>();
}

}  // namespace osculo::facade
