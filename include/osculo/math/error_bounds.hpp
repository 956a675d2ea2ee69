#pragma once

#include "osculo/math/floating_point.hpp"

/// Every tolerance of osculo. All are relative: the unit is the rounding unit of the scalar type
/// times a quantity of the problem itself. tests/math/error_bounds_test.cpp shows for each that it
/// is large enough, and that a tenth of it is not (or what else would go wrong).
namespace osculo::math {

/// Slack of a rejection test, in units of epsilon times the sum of the absolute terms of the tested
/// expression. A dot or cross product of rounded differences of wide coordinates errs by at most
/// 3 epsilon of its terms (1/2 for each of two factors, product and sum); comparing its square with
/// s^2 |b|^2 adds 2.
inline constexpr int kRejectionSlack = 8;

/// Rounding noise of a velocity that an impact has just computed, in units of
/// epsilon (|v before| + |v after|): impulse, product and sum err by 1/2 ulp each, the impulse's
/// factors by 1 more; two components. A closing speed below the noise of the two velocities it is
/// the difference of is no approach: without this, residual speeds of a perfectly inelastic chain
/// would be exchanged for ever.
inline constexpr int kVelocityNoise = 4;

/// Gap below which two things count as touching when their closing speed is noise, in units of
/// epsilon times the contact distance: the rounding of an event's instant and of the contact
/// distance itself.
inline constexpr int kTouch = 8;

/// Largest gap that rounding leaves at a predicted contact, in units of epsilon times
/// (contact distance + distance travelled since the prediction's reference instant): half an ulp
/// each of time, relative velocity and relative position; and in units of the wide epsilon times
/// (coordinate + speed * instant), the resolution of where and when. More than that means that the
/// scalar type cannot resolve the motion: status `numeric`.
inline constexpr int kContactGap = 16;

/// Overlap that a scene may start with, over the smaller radius: data typed with eight digits.
inline constexpr double kStartOverlap = 1e-7;

}  // namespace osculo::math
