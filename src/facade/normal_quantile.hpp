#pragma once

namespace osculo::facade {

/// The number below which a standard normal number lies with probability 1/2 + q. Requires
/// |q| <= 1/2 - 2^-54. Relative error <= 8e-16; the same bits with every compiler and library.
///
/// (M. J. Wichura, Algorithm AS 241: The percentage points of the normal distribution, Applied
/// Statistics 37, 1988, 477-484: three rational functions; PPND16)
[[nodiscard]] double normal_quantile(double q);

}  // namespace osculo::facade
