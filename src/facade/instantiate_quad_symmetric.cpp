#include "wide_engines.hpp"

namespace osculo::facade {

std::span<const ReadyEngine> quad_symmetric_engines() {
    return wide_engines<math::Quad, impact::Symmetric>();
}

}  // namespace osculo::facade
