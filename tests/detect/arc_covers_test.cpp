#include <cmath>

#include <gtest/gtest.h>

#include "osculo/geometry/arc.hpp"
#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;

template <class S>
geometry::Arc<S> arc_between(double from, double to) {
    const auto unit = [](double angle) {
        return math::Vec<S>(S(std::cos(angle)), S(std::sin(angle)));
    };
    return {{S(0), S(0)}, S(1), unit(from), unit(to), to - from > 3.14159265358979323846, false};
}

template <class S>
class ArcCovers : public testing::Test {};
TYPED_TEST_SUITE(ArcCovers, AllScalars, ScalarName);

/// Against angles, wherever these are not within rounding of an end.
TYPED_TEST(ArcCovers, IsWhatTheAnglesSay) {
    using S = TypeParam;
    constexpr double kTurn = 6.283185307179586;
    Random random(61);
    int covered = 0;
    for (int i = 0; i < 20000; ++i) {
        const double from = random.uniform<double>(-kTurn, kTurn);
        const double sweep = i % 4 == 0   ? std::ldexp(1.0, -random.between(0, 40))
                             : i % 4 == 1 ? kTurn - std::ldexp(1.0, -random.between(0, 40))
                                          : random.uniform<double>(0, kTurn);
        const geometry::Arc<S> arc = arc_between<S>(from, from + sweep);
        const double beyond = random.coin() ? random.uniform<double>(0, kTurn)
                                            : sweep * random.uniform<double>(-1, 2);
        double within = std::fmod(beyond, kTurn);
        if (within < 0) within += kTurn;
        if (std::abs(within - sweep) < 1e-14 || within < 1e-14 || within > kTurn - 1e-14) continue;
        const double length = std::ldexp(1.0, random.between(-20, 20));
        const math::Vec<S> d(S(length * std::cos(from + beyond)),
                             S(length * std::sin(from + beyond)));
        const bool inside = within < sweep;
        covered += inside;
        EXPECT_EQ(inside, arc.covers(d))
            << "from " << from << " sweep " << sweep << " at " << beyond;
    }
    EXPECT_GT(covered, 5000);
}

TYPED_TEST(ArcCovers, EndsBelongToTheArc) {
    using S = TypeParam;
    for (const double sweep : {1e-9, 0.5, 1.5707963267948966, 3.0, 3.2, 6.0, 6.28}) {
        const geometry::Arc<S> arc = arc_between<S>(0.7, 0.7 + sweep);
        EXPECT_TRUE(arc.covers(arc.start));
        EXPECT_TRUE(arc.covers(arc.end));
        EXPECT_TRUE(arc.covers(math::Vec<S>(arc.start * S(1024))));
        EXPECT_TRUE(arc.covers(math::Vec<S>(arc.start + arc.end)) || sweep > 3.14);
        EXPECT_FALSE(arc.covers(math::Vec<S>(-arc.start - arc.end)) && sweep < 3.14);
    }
}

TYPED_TEST(ArcCovers, HalfAndFullTurns) {
    using S = TypeParam;
    const math::Vec<S> right(S(1), S(0));
    const geometry::Arc<S> half{{S(0), S(0)}, S(1), right, -right, false, false};
    EXPECT_TRUE(half.covers({S(0), S(1)}));
    EXPECT_FALSE(half.covers({S(0), S(-1)}));
    const geometry::Arc<S> full{{S(0), S(0)}, S(1), right, right, true, true};
    for (int k = -2; k <= 2; ++k) {
        EXPECT_TRUE(full.covers({S(k), S(1)}));
        EXPECT_TRUE(full.covers({S(k), S(-1)}));
    }
}

}  // namespace
