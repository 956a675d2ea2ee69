#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> quad_engines() {
    return wide_engines<math::Quad, impact::Sequential>();
}

}  // namespace osculo::facade
