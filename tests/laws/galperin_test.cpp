#include <gtest/gtest.h>

#include "support/builder.hpp"
#include "support/scalars.hpp"

// Masses 1 and 100^k and a wall: the number of collisions has the first k + 1 digits of pi
// (G. Galperin 2003).
namespace osculo::support {
namespace {

template <math::Scalar S>
void expect_digits_of_pi(int digits) {
    using Type = engine::UniformScene<S, engine::Walls, engine::NoRecorder, engine::AllPairs>;
    using Vec = math::Vec<S>;
    const std::uint64_t counts[] = {3, 31, 314, 3141, 31415, 314159, 3141592};
    S mass(1);
    for (int k = 0; k < digits; ++k) {
        Builder<Type> builder;
        builder.wall(Vec(S(0), S(9)), Vec(S(0), S(-9)), true)
            .ball(Vec(S(2), S(0)), Vec(S(0), S(0)), S(0.5), S(1))
            .ball(Vec(S(4), S(0)), Vec(S(-1), S(0)), S(0.5), mass);
        const auto played = play<Type>(builder.scene, S(1e9), 10'000'000);
        EXPECT_EQ(played.events, counts[k]) << k;
        EXPECT_EQ(played.status, Status::time_limit);
        S energy(0);
        for (const auto& body : played.bodies) {
            energy += body.mass * math::dot<S>(body.state.velocity, body.state.velocity);
        }
        EXPECT_LT(math::to_double<S>(math::abs<S>(energy / mass - S(1))), 1e-11) << k;
        mass *= S(100);
    }
}

TEST(Galperin, Double) {
    expect_digits_of_pi<double>(7);
}
TEST(Galperin, Extended) {
    expect_digits_of_pi<long double>(5);
}
TEST(Galperin, Quad) {
    expect_digits_of_pi<math::Quad>(4);
}
TEST(Galperin, Digits50) {
    expect_digits_of_pi<Digits50>(3);
}
TEST(Galperin, Digits100) {
    expect_digits_of_pi<Digits100>(3);
}

}  // namespace
}  // namespace osculo::support
