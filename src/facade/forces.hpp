#pragma once

#include "osculo/scene.hpp"

namespace osculo::facade {

/// Throws unless what slows balls down is nothing, or enough to be told from nothing.
///
/// A path curves by w R / u^2 of its own size, for a deceleration w of a ball of radius R at the
/// speed u. First contacts form up to the fifth power of that, which below 1e-65 leaves the range
/// of double and was seen to miss cushions; at least 1e-50 is asked for, of the weakest force and
/// the smallest ball at the largest speed that the energy of all balls allows. Of rolling and
/// cloth: with drag, paths are straight. Nor do forces below 1e-120 or above 1e120 m/s^2 leave the
/// coefficients of that equation in range, whatever the speeds; 1e-80 to 1e80 are asked for
/// (tests/extremes/units_test.cpp).
void validate_forces(const Scene& scene);

}  // namespace osculo::facade
