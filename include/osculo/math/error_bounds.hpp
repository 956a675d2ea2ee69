#pragma once

#include "osculo/math/floating_point.hpp"

/// Every tolerance of osculo. All are relative: the unit is the rounding unit of the scalar type
/// times a quantity of the problem itself. tests/math/error_bounds_test.cpp shows for each that it
/// is large enough, and that a tenth of it is not (or what else would go wrong); those of clusters
/// have tests/impact/simultaneous/bounds_test.cpp.
namespace osculo::math {

/// Slack of a rejection test, in units of epsilon times the sum of the absolute terms of the tested
/// expression and again relative to what it is compared with. 3 suffice: a dot or cross product
/// errs by 1 of its terms, Q by 1.5 of |c|^2 + s^2; -2 slope * horizon errs by 2.5 (1.5 for the
/// slope), s^2 |b|^2 by 2.
inline constexpr int kRejectionSlack = 4;

/// A difference of wide numbers below this many epsilon of its terms is formed again without
/// rounding, for the error of the difference would be above a tenth of epsilon: it is at most
/// 4.75 epsilon^2 of the terms (s^2 |b|^2 against (b x c)^2; 3/4 for each sum that goes in, 5/4
/// for each product), of which solving for the time leaves a quarter.
inline constexpr int kExactStage = 64;

/// An extreme gap on a curved path below this many epsilon of the bound of its rounding error in S
/// is none: the path is a tangent, which is no contact. Each of the ten operations in wide
/// precision errs by up to 1.25 epsilon^2 of a term, the bound has kRejectionSlack epsilon of each;
/// they all but never add up: a hundredth would not be enough.
inline constexpr int kTangent = 1;

/// Rounding noise of a velocity that an impact has just computed, in units of
/// epsilon (|v before| + |v after|), such that the noises of a pair cover the error of its closing
/// speed: 5/2 of the speeds before (difference, quotients and products) and 1/2 of those after. A
/// closing speed below the noise of the two velocities it is the difference of is no approach:
/// without this, residual speeds of a perfectly inelastic chain would be exchanged for ever.
inline constexpr int kVelocityNoise = 4;

/// Gap below which two things count as touching when their closing speed is noise, in units of
/// epsilon times the contact distance: the rounding of an event's instant and of the contact
/// distance itself.
inline constexpr int kTouch = 8;

/// Largest gap that rounding leaves at a predicted contact, in units of epsilon times
/// (contact distance + distance travelled since the prediction's reference instant): 1/2 each for
/// the relative position, the relative velocity and the two durations, 1/2 for the time of the
/// built-in types and up to 3 for that of the others, 2 for measuring it; and in units of the wide
/// epsilon times (coordinate + speed * instant), the resolution of where and when. More than that
/// means that the scalar type cannot resolve the motion: status `numeric`.
inline constexpr int kContactGap = 8;

/// Events that follow each other within this many wide roundings of their instant are at one
/// instant: that much is lost in the sum of an instant and a wait. Things that are pressed together
/// at speeds of which nothing is left would take a part of a rounding every few events, for ever.
inline constexpr int kSameInstant = 1;

/// How far a ball may go in the least time that the clock can tell, in units of its radius, when it
/// has an event. Where it is, is no more certain than that: of balls that go farther the contacts
/// could as well be others, and a run ends with `numeric`. Far above what rounding leaves anywhere
/// else (a ball gets there on paths of 1e25 radii, or when it is faster and faster), and far below
/// what could hide a contact.
inline constexpr double kUnresolved = 0x1p-20;

/// What one impact may gain in energy, in units of epsilon times the energy of its balls, and lose
/// in momentum, in units of epsilon times the sum of their |m v|. With u = epsilon / 2: the impulse
/// errs by 9 u of the relative velocity, its two products by 2 u, the new velocities by 1 u. As an
/// impulse is at most twice the reduced momentum, that makes 39 u of the energy and, in two
/// components, 18 u of the momenta.
inline constexpr int kImpactEnergy = 20;
inline constexpr int kImpactMomentum = 9;

/// How far the end of a ball's path may be from its next state, in units of epsilon times the
/// path's length: the duration is rounded once.
inline constexpr int kPieceJump = 1;

/// Overlap that a scene may start with, over the smaller radius: data typed with eight digits.
inline constexpr double kStartOverlap = 1e-7;

/// Slip of a ball on its cloth that counts as none, in units of epsilon (|v| + R |w|): a sum of two
/// terms that an impact has computed, each to a few ulp. An impact that ends in rolling must not
/// start a slide of no length.
inline constexpr int kSlip = 8;

/// What an impact with friction of up to 4 may lose in momentum, in the units of kImpactMomentum:
/// its tangential impulse, up to 4 times the other one, comes with two roundings for each ball.
inline constexpr int kFrictionMomentum = 20;

/// How far velocity and radius * spin at the end of a piece may be from what its motion law says,
/// in units of epsilon times the speeds that go in: some eight roundings of half a unit each; and
/// likewise accelerations and durations, in units of epsilon times themselves.
inline constexpr int kMotionNoise = 8;

/// What rounding may come to below the range of a double, which ends at 2^-1022 and has no relative
/// precision from there down to 2^-1074: some of its last units, of places, speeds and
/// accelerations [m, m/s, m/s^2]. tests/extremes/smallest_test.cpp.
inline constexpr double kUnderflow = 0x1p-1070;

/// Shorter durations may count as none [s]: the inverse of one is beyond the range of a double.
inline constexpr double kShortest = 0x1p-1022;

/// How far what a certified path says of a place may be off, in units of epsilon times the way gone
/// since its start, and of a velocity, times that at the start. Of the closed forms of motion with
/// drag (motion/slowing.hpp): 1/2 for each of some ten operations on g, the rest for log(1 + x) and
/// e^-x; four times as much for the wider types where the roots of the characteristic equation all
/// but coincide. tests/motion/slowing_test.cpp.
inline constexpr int kPathNoise = 8;

/// Gap below which a ball belongs to a cluster, in units of epsilon (|place| + |last place| +
/// radius) of both: data is given to rounding, instants are predicted from it to some ulp, and
/// places at an instant are speeds times that.
inline constexpr int kTogether = 32;

/// What a cluster may gain in energy, in units of epsilon times the energy of its balls, and what
/// the impulse of one of its contacts may lose in momentum, in units of epsilon times the sum of
/// the largest |m v| of each of them. A light ball between heavy ones is reflected to and fro up to
/// 10,000 times (SymmetricSolver::kMostReflections), and each time the heavy ones' velocities are
/// rounded by up to 1/2 ulp, mostly in one direction: 5,000 epsilon if they were all at their
/// worst, 330 (mass ratios of 1e12) and 160 (1e6) in the worst of 400,000 random clusters.
inline constexpr int kClusterEnergy = 1024;
inline constexpr int kClusterMomentum = 1024;

/// How fast the pairs of a cluster may still approach, in units of epsilon times its largest speed.
/// The solver ends at kVelocityNoise times the speeds of both before and after, two of each, that
/// is 4 times that, and twice as much where balls are stirred in between.
inline constexpr int kClusterClosing = 32;

/// Contacts of a cluster approach if stopping the pair would take more than the square of this many
/// epsilon out of the cluster's energy, in units of that of |y|, the root of twice the energy:
/// impulses of one reflection err by some epsilon of |y|, those of several dependent contacts by
/// more, and normals that are differences of coordinates by the coordinates over the radius. What a
/// symmetric cluster leaves at rest must not be seen to approach on one side. Approaches below are
/// stopped, which takes nothing that counts from the energy.
inline constexpr int kClusterApproach = 256;

/// A contact whose unit vector (in the metric of the masses) is this many epsilon from the span of
/// others, times 1 + the sum of their shares in it, lies in it: 1 for each of the vectors, 1 for
/// each of two orthogonalisations, the rest for the normals, as above. Without the shares, that of
/// light balls and heavy ones in a row between two walls, a jam would be taken for a way out.
inline constexpr int kClusterDependent = 64;

/// Contacts cannot all separate if a sum of their unit vectors, of positive shares that add up to
/// 1, has a square below this many epsilon: the shares, of up to some dozen, err by epsilon each.
inline constexpr int kClusterJam = 8;

/// A gain of energy of a cluster, in units of epsilon of its energy, that is more than rounding of
/// its impulses and velocities (1 for each of three products, two sums, the root and the quotient
/// of an impulse, 1 for the velocity).
inline constexpr int kClusterGain = 8;

/// The last three terms of a Chebyshev series below this many epsilon of its largest one are
/// rounding: each coefficient is a sum of some dozen values with an error of some epsilon each. An
/// integral divides its terms by their number and so errs by less than epsilon.
inline constexpr int kChebyshevTail = 16;

/// |F| at the saddle of a rim's field below this many wide epsilon of its terms is no more than
/// their rounding (NUMERICS 3.2), 1/2 for each of some ten operations that go into a term and never
/// add up. Whether such a ball gets over the saddle cannot be told.
inline constexpr int kRimBalance = 2;

}  // namespace osculo::math
