#include "osculo/impact/pressing.hpp"

#include <gtest/gtest.h>

#include "support/scalars.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
class Pressing : public testing::Test {};
TYPED_TEST_SUITE(Pressing, AllScalars, ScalarName);

TYPED_TEST(Pressing, RemembersTheLongestHop) {
    using S = TypeParam;
    using Instant = math::Instant<S>;
    impact::Hops<S> hops;
    EXPECT_EQ(hops.note(Instant(S(2)), S(4)), S(0));  // the first impact
    EXPECT_EQ(hops.longest(Instant(S(3)), S(4)), S(1));
    EXPECT_EQ(hops.note(Instant(S(5)), S(4)), S(3));
    EXPECT_EQ(hops.note(Instant(S(6)), S(4)), S(3));
    EXPECT_EQ(hops.note(Instant(S(14)), S(4)), S(8));    // just follows the last one
    EXPECT_EQ(hops.note(Instant(S(22.5)), S(4)), S(0));  // and this does not
    // No time at all is told as the least that passes.
    const S least = hops.note(Instant(S(22.5)), S(4));
    EXPECT_GT(least, S(0));
    EXPECT_EQ(math::resolution<S>(Instant(S(22.5))), least);
    const Instant next = math::after<S>(Instant(S(22.5)), S(2) * least);
    EXPECT_GT(math::duration<S>(Instant(S(22.5)), next), S(0));
}

TYPED_TEST(Pressing, LastsAsLongAsTheForceAndTheContact) {
    using S = TypeParam;
    const S contact = S(1) / S(1024);
    EXPECT_EQ(impact::pressing_time<S>(contact, math::never<S>(), S(0)), contact);
    EXPECT_EQ(impact::pressing_time<S>(contact, contact / S(8), S(0)), contact / S(8));
    EXPECT_EQ(impact::pressing_time<S>(contact, contact / S(8), contact / S(4)), contact / S(2));
    EXPECT_EQ(impact::pressing_time<S>(contact, contact / S(8), contact), contact);
}

// A force that lasts for less than the clock can tell, however often it comes back; and one that
// presses every other time only.
TYPED_TEST(Pressing, LetsHopsDoubleFromTheLeastTimeOn) {
    using S = TypeParam;
    const S contact = S(1) / S(8192);
    const S shortest = S(5e-324);
    for (const int turns : {1, 2}) {
        math::Instant<S> now(S(7) / S(8));
        impact::Hops<S> hops;
        S tau(0);
        int impacts = 0;
        for (; tau < contact && impacts < turns * (2 * math::ScalarTraits<S>::kDigits + 100);
             ++impacts) {
            tau = impact::pressing_time<S>(contact, shortest, hops.note(now, contact));
            if (impacts % turns == 0) now = math::after<S>(now, tau);
        }
        EXPECT_EQ(tau, contact) << impacts;
    }
}

}  // namespace
