#pragma once

namespace osculo {

/// The version of these headers, as "major.minor.patch". Same scene and version: same bytes.
inline constexpr const char* kVersion = "0.1.0";

}  // namespace osculo
