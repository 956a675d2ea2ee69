#include "osculo/motion/rim_tipping_stay.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "osculo/motion/rim_tipping.hpp"
#include "support/exact_scalars.hpp"
#include "support/exact_tipping.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using motion::TippingEnd;
using motion::TippingStart;
using Vec = math::Vec<double>;

constexpr double kGravity = 9.81;
constexpr double kRadius = 0.028575;

/// A ball that comes to the rim at (rim, 0).
template <class S>
motion::RimTippingStay<S> entering(double rim, double inwards, double along, double heaviness = 1) {
    const geometry::Rim<S> hole{math::Vec<S>(S(0), S(0)), S(rim)};
    const motion::Hovering<S> ball{math::WidePoint<S>(math::Vec<S>(S(rim), S(0))),
                                   math::Vec<S>(S(-inwards), S(along)), S(kRadius), S(0)};
    return {hole, S(kGravity), S(kRadius), S(heaviness), ball, TippingStart::touches};
}
ExactTipping reference(double rim, double inwards, double along) {
    return {rim, kRadius, kGravity, {rim, 0, kRadius, -inwards, along, 0}};
}

/// Where the reference's own function of its state comes down to 0, by bisection in [low, high].
template <class F>
Digits50 zero(double rim, double inwards, double along, double low, double high, const F& f) {
    Digits50 a = low, b = high;
    ExactTipping start = reference(rim, inwards, along);
    start.at(a);
    for (int i = 0; i < 80; ++i) {
        const Digits50 middle = (a + b) / 2;
        ExactTipping now = start;
        (f(now, now.at(middle)) > 0 ? a : b) = middle;
    }
    return a;
}

struct Row {
    double rim, inwards, along;
    TippingEnd end;
};

/// Time and place at the end, against 50 digits of the motion in space: by lift-off, back over the
/// rim, straight, from all but rest, swinging, grazing, and beside the separatrix.
TEST(RimTippingStay, EndsWhenAndWhereFiftyDigitsSay) {
    const Row rows[] = {
        {0.0571, 0.3, 0, TippingEnd::lift_off},     {0.0571, 1e-3, 0, TippingEnd::lift_off},
        {0.0571, 1e-8, 0, TippingEnd::lift_off},    {0.0571, 0.1, 0.173, TippingEnd::lift_off},
        {0.0571, 0.15, 0.26, TippingEnd::lift_off}, {0.0571, 0.05, 0.1, TippingEnd::lift_off},
        {0.0571, 0.25, 0.45, TippingEnd::exit},     {0.0571, 0.1, 1.5, TippingEnd::exit},
        {0.0571, 1e-6, 1.0, TippingEnd::exit},      {0.2, 0.5, 0.3, TippingEnd::lift_off},
        {0.2, 0.3, 2.0, TippingEnd::exit},          {0.033, 0.3, 0.05, TippingEnd::lift_off},
        {0.033, 0.3, 0.2, TippingEnd::exit}};
    for (const Row& row : rows) {
        const auto stay = entering<double>(row.rim, row.inwards, row.along);
        ASSERT_EQ(stay.end(), row.end) << row.rim << " " << row.inwards << " " << row.along;
        ASSERT_TRUE(stay.sound());
        const double end = stay.duration();
        const Digits50 exact_end =
            zero(row.rim, row.inwards, row.along, end * (1 - 1e-6), end * (1 + 1e-6),
                 [&](ExactTipping& ball, const ExactTipping::State& s) {
                     if (row.end == TippingEnd::lift_off) return ball.push(s);
                     return Digits50(Digits50(row.rim) - sqrt(Digits50(s.x * s.x + s.y * s.y)));
                 });
        EXPECT_LE(double(abs(Digits50(end / exact_end - 1))), 1e-13)
            << row.rim << " " << row.inwards << " " << row.along;
        ExactTipping ball = reference(row.rim, row.inwards, row.along);
        const double speed = std::sqrt(kGravity * kRadius) + std::hypot(row.inwards, row.along);
        for (const double share : {0.03125, 0.25, 0.5, 0.75, 0.9375, 1.0}) {
            const double t = share * end;
            const auto is = stay.in_space(t);
            const auto& should = ball.at(t);
            const auto error = [](double a, const Digits50& b) { return std::abs(double(a - b)); };
            const double place = double(abs(Digits50(exact<Digits50>(is.position.x) - should.x))) +
                                 double(abs(Digits50(exact<Digits50>(is.position.y) - should.y))) +
                                 error(is.height, should.z);
            EXPECT_LE(place, 4e-15 * row.rim) << row.inwards << " " << row.along << " at " << share;
            EXPECT_LE(error(is.velocity.x(), should.vx) + error(is.velocity.y(), should.vy) +
                          error(is.climb, should.vz),
                      8e-15 * speed)
                << row.inwards << " " << row.along << " at " << share;
        }
    }
}

}  // namespace
