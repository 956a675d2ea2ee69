#include "osculo/motion/rim_paper.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/exact_rim.hpp"
#include "support/exact_scalars.hpp"
#include "support/random.hpp"

namespace {

using namespace osculo;
using namespace osculo::support;
using motion::RimOutcome;
using Vec = math::Vec<double>;

/// A ball at (x, 0) beside a hole around the origin.
struct Case {
    double rim, radius, gravity, x;
    double vx, vy;

    template <class S>
    [[nodiscard]] motion::RimPaperMotion<S> motion() const {
        const geometry::Rim<S> hole{math::Vec<S>(S(0), S(0)), S(rim)};
        return {hole, S(gravity), S(radius), math::WidePoint<S>(math::Vec<S>(S(x), S(0))),
                math::Vec<S>(S(vx), S(vy))};
    }
    [[nodiscard]] ExactRim reference() const { return {rim, radius, gravity, {x, 0, vx, vy}}; }
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
    out.precision(17);
    return out << "rim " << c.rim << " radius " << c.radius << " gravity " << c.gravity << " x "
               << c.x << " v " << c.vx << " " << c.vy;
}

/// A pool ball that enters a hole of 60 mm with the speeds inwards and along the rim.
Case entering(double inwards, double along) {
    return {0.06, 0.028575, 9.81, 0.06, -inwards, along};
}

/// The worst distance from the reference over a stay, in units of the rim and of the speeds.
double worst_error(const Case& c) {
    const auto m = c.motion<double>();
    ExactRim reference = c.reference();
    const double speed = std::sqrt(c.vx * c.vx + c.vy * c.vy + c.gravity * c.radius);
    double worst = 0;
    for (const double share : {0.03125, 0.25, 0.5, 0.75, 0.9375, 0.9990234375}) {
        const double t = share * m.duration();
        const auto is = m.at(t);
        const auto& should = reference.at(t);
        const Digits50 place = abs(Digits50(exact<Digits50>(is.position.x) - should.x)) +
                               abs(Digits50(exact<Digits50>(is.position.y) - should.y));
        const Digits50 velocity =
            abs(Digits50(is.velocity.x() - should.vx)) + abs(Digits50(is.velocity.y() - should.vy));
        worst = std::max({worst, double(place) / c.rim, double(velocity) / speed});
    }
    return worst;
}

struct Row {
    double inwards, along;
    RimOutcome outcome;
    const char* time;
    const char* angle;
};
constexpr double kSeparatrix = 0.32351607697434975;

/// The rows of NUMERICS 3.2 for R = 60 mm. Times and angles by this library's 100 digits, from the
/// speeds as doubles, confirmed by ExactRim below; they agree with the printed rows to 3e-14, which
/// have what the prototype's double arithmetic left of them.
TEST(RimPaper, PublishedRows) {
    const Row rows[] = {
        {1, 0, RimOutcome::capture, "0.02757098728238989", "0"},
        {0.1, 0, RimOutcome::capture, "0.1314844327021434", "0"},
        {1e-3, 0, RimOutcome::capture, "0.3802229130220509", "0"},
        {1e-8, 0, RimOutcome::capture, "1.001584553813454", "0"},
        {0.3, 0.2, RimOutcome::capture, "0.08117690520202665", "0.4926636515656"},
        {0.3, kSeparatrix * (1 - 1e-3), RimOutcome::capture, "0.1150023664613007",
         "1.292788064752"},
        {0.3, kSeparatrix * (1 + 1e-3), RimOutcome::exit, "0.2342814147985601", "2.67037162001"},
        {0.3, kSeparatrix * (1 + 1e-9), RimOutcome::exit, "0.2340798944013973", "2.666047550884"},
        {0.3, 1, RimOutcome::exit, "0.03405650108283548", "0.6019671636678"},
        {0.05, 3, RimOutcome::exit, "6.664900013477614e-4", "0.03333067099104"},
        {2, 1.5, RimOutcome::exit, "0.03884391237688909", "1.90414788205"},
        {5, 1, RimOutcome::capture, "5.814276200926105e-3", "0.1860015886384"},
    };
    for (const Row& row : rows) {
        const auto m = entering(row.inwards, row.along).motion<double>();
        EXPECT_TRUE(m.sound());
        EXPECT_EQ(m.outcome(), row.outcome) << row.time;
        const double time = std::stod(row.time);
        const double angle = std::stod(row.angle);
        EXPECT_NEAR(m.duration(), time, 3e-12 * time) << row.inwards << " " << row.along;
        EXPECT_NEAR(m.swept(), angle, 3e-12 * angle) << row.inwards << " " << row.along;
    }
}

TEST(RimPaper, FollowsIndependentIntegration) {
    for (const auto& [inwards, along] : {std::pair{1.0, 0.0},
                                         {0.1, 0.0},
                                         {1e-3, 0.0},
                                         {1e-8, 0.0},
                                         {0.3, 0.2},
                                         {0.3, kSeparatrix * (1 - 1e-3)},
                                         {0.3, kSeparatrix * (1 + 1e-3)},
                                         {0.3, kSeparatrix * (1 - 1e-9)},
                                         {0.3, kSeparatrix * (1 + 1e-9)},
                                         {0.3, 1.0},
                                         {0.05, 3.0},
                                         {2.0, 1.5},
                                         {5.0, 1.0}}) {
        const Case c = entering(inwards, along);
        EXPECT_LE(worst_error(c), 1e-14) << c;
    }
}

/// Exits happen where the reference crosses the rim.
TEST(RimPaper, TimesOfExitAreThoseOfTheReference) {
    for (const auto& [inwards, along] : {std::pair{0.3, kSeparatrix * (1 + 1e-3)},
                                         {0.3, kSeparatrix * (1 + 1e-9)},
                                         {0.3, 1.0},
                                         {0.05, 3.0},
                                         {2.0, 1.5},
                                         {1e-6, 1.0}}) {
        const Case c = entering(inwards, along);
        const auto m = c.motion<double>();
        const auto end = c.reference().at(m.duration());
        const Digits50 d = sqrt(Digits50(end.x * end.x + end.y * end.y));
        const Digits50 radial = (end.x * end.vx + end.y * end.vy) / d;
        EXPECT_GT(radial, 0) << c;
        EXPECT_LE(double(abs(Digits50((d - c.rim) / radial))), 1e-14 * m.duration()) << c;
        Digits50 angle = atan2(end.y, end.x);
        EXPECT_NEAR(double(angle), m.swept(), 1e-14 * m.swept()) << c;
    }
}

/// What the Cartesian series converge to where the ball falls in: the last stretch of the fall, on
/// which nothing but the singularity of the field is left.
TEST(RimPaper, TimesOfCaptureAreThoseOfTheReference) {
    for (const auto& [inwards, along] : {std::pair{1.0, 0.0},
                                         {1e-3, 0.0},
                                         {0.3, 0.2},
                                         {0.3, kSeparatrix * (1 - 1e-3)},
                                         {5.0, 1.0}}) {
        const Case c = entering(inwards, along);
        const auto m = c.motion<double>();
        // At t = (1 - 1e-5) T the acceleration, of the order of sqrt(1e-5 T), is 0 to all that
        // counts: two terms of d(t) and the next one's size.
        ExactRim reference = c.reference();
        const Digits50 left = m.duration() * Digits50(1e-5);
        const auto& s = reference.at(Digits50(m.duration()) - left);
        const Digits50 d = sqrt(Digits50(s.x * s.x + s.y * s.y));
        const Digits50 radial = (s.x * s.vx + s.y * s.vy) / d;
        const Digits50 swing = pow(Digits50(s.x * s.vy - s.y * s.vx), 2) / (d * d * d);
        const Digits50 q = (c.rim - d) / c.radius;
        const Digits50 pull = c.gravity * q * sqrt(Digits50(1 - q * q));
        const Digits50 at_end = d + radial * left + (swing - pull * 4 / 5) * left * left / 2;
        EXPECT_LE(double(abs(Digits50((at_end - (c.rim - c.radius)) / radial))),
                  1e-13 * m.duration())
            << c;
    }
}

TEST(RimPaper, SeparatrixSpeeds) {
    const double slow = 0.22726397496780312;
    for (const auto& [inwards, along] : {std::pair{0.3, kSeparatrix}, {0.05, slow}}) {
        EXPECT_EQ(entering(inwards, along * (1 - 1e-14)).motion<double>().outcome(),
                  RimOutcome::capture);
        EXPECT_EQ(entering(inwards, along * (1 + 1e-14)).motion<double>().outcome(),
                  RimOutcome::exit);
    }
}

/// Starts as rolling balls and impacts leave them: on the rim or anywhere inside, moving anywhere.
Case random_case(Random& random) {
    const double radius = 0.0286;
    const double rim = radius * (1.05 + 2.5 * random.unit<double>());
    const bool on_rim = random.below(3) == 0;
    const double x = on_rim ? rim : rim - radius * random.unit<double>();
    const double speed = random.magnitude<double>(-10, 3);
    math::Vec<double> v = speed * random.direction<double>();
    if (on_rim) v.x() = -std::abs(v.x());
    if (random.below(8) == 0) v.setZero();
    return {rim, radius, 9.81, x, v.x(), v.y()};
}

TEST(RimPaper, RandomStartsFollowIndependentIntegration) {
    Random random(5);
    int outcomes[4] = {};
    for (int i = 0; i < 60; ++i) {
        const Case c = random_case(random);
        const auto m = c.motion<double>();
        ++outcomes[static_cast<int>(m.outcome())];
        EXPECT_TRUE(m.sound()) << c;
        if (m.duration() > 0) {
            EXPECT_LE(worst_error(c), 1e-13) << c;
        }
    }
    EXPECT_GT(outcomes[static_cast<int>(RimOutcome::exit)], 3);
    EXPECT_GT(outcomes[static_cast<int>(RimOutcome::capture)], 3);
}

/// Orbits: from circles at the maximum of F, where both turns come together, to wide ones.
TEST(RimPaper, OrbitsSwingBetweenTwoTurns) {
    Random random(6);
    int turns = 0;
    for (int i = 0; i < 40; ++i) {
        const double radius = 0.0286;
        const double rim = radius * (1.1 + random.unit<double>());
        const double q = 0.6 + 0.39 * random.unit<double>();
        const double x = rim - radius * q;
        const double circling = std::sqrt(9.81 * q * std::sqrt(1 - q * q) * x);
        const double off = random.magnitude<double>(-60, -4);
        const Case c{
            rim, radius, 9.81, x, i % 4 == 0 ? 0 : off * circling, circling * (1 + (i % 2) * off)};
        const auto m = c.motion<double>();
        EXPECT_TRUE(m.sound()) << c;
        EXPECT_LE(worst_error(c), 1e-13) << c;
        if (m.outcome() != RimOutcome::turn) continue;
        ++turns;
        const auto end = m.at(m.duration());
        const auto& p = end.position.rounded();
        EXPECT_LE(std::abs(math::dot<double>(p, end.velocity)),
                  1e-14 * math::norm<double>(p) * math::norm<double>(end.velocity))
            << c;
    }
    EXPECT_GT(turns, 20);
}

TEST(RimPaper, KeepsEnergyAndAngularMomentum) {
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Case c = random_case(random);
        const auto m = c.motion<double>();
        const auto energy = [&](const motion::ParabolicPath<double>& at) {
            const math::Vec<double> x = at.position.rounded();
            const double q = (c.rim - math::norm<double>(x)) / c.radius;
            return math::dot<double>(at.velocity, at.velocity) / 2 +
                   c.gravity * c.radius / 3 * std::pow(std::max(1 - q * q, 0.0), 1.5);
        };
        const auto moment = [](const motion::ParabolicPath<double>& at) {
            return math::accurate_cross<double>(at.position.rounded(), at.velocity);
        };
        const auto start = m.at(0);
        for (int k = 1; k <= 16; ++k) {
            const auto now = m.at(m.duration() * k / 16);
            // Of the energies in the field: where q is nearly 1, so much is 1e-17 m.
            const double scale = energy(start) + c.gravity * c.radius / 3;
            EXPECT_NEAR(energy(now), energy(start), 1e-13 * scale) << c;
            EXPECT_NEAR(moment(now), moment(start),
                        1e-14 * c.rim * math::norm<double>(now.velocity))
                << c;
        }
    }
}

/// What certified segments rest on: the parabola at t is left by less than the bound says, at once
/// and near the fall too, where the third derivative has none.
TEST(RimPaper, StaysWithinItsJerkBoundOfItsParabola) {
    Random random(10);
    double tightest = 0;
    for (int i = 0; i < 3000; ++i) {
        const Case c = random_case(random);
        const auto m = c.motion<double>();
        if (!(m.duration() > 0)) continue;
        const double left =
            random.coin() ? random.unit<double>() : random.magnitude<double>(-20, -1);
        const double t = m.duration() * (1 - left);
        const double h =
            m.duration() * left * (random.coin() ? 1 : random.magnitude<double>(-12, -1));
        const double jerk = m.jerk_bound(t, h);
        auto parabola = m.at(t);
        const auto later = m.at(std::min(t + h, m.duration()));
        parabola.shift(h);
        const math::WidePoint<double> off{later.position.x - parabola.position.x,
                                          later.position.y - parabola.position.y};
        const double noise = 1e-15 * c.rim + 1e-15 * h * m.most_speed();
        EXPECT_LE(math::norm<double>(off.rounded()), jerk * h * h * h / 6 + noise) << c << " " << t;
        EXPECT_LE(math::norm<double>(Vec(later.velocity - parabola.velocity)),
                  jerk * h * h / 2 + 1e-14 * m.most_speed())
            << c << " " << t << " " << h;
        if (jerk * h * h * h > 1e-9 * c.rim) {
            tightest =
                std::max(tightest, math::norm<double>(off.rounded()) / (jerk * h * h * h / 6));
        }
        EXPECT_LE(math::norm<double>(later.velocity), m.most_speed());
    }
    EXPECT_GT(tightest, 0.2);
}

/// Every scalar type against the widest.
template <class S>
class RimPaperTypes : public testing::Test {};
TYPED_TEST_SUITE(RimPaperTypes, AllScalars, ScalarName);

TYPED_TEST(RimPaperTypes, AreAsAccurateAsTheyAreWide) {
    using S = TypeParam;
    Random random(8);
    for (int i = 0; i < (math::Builtin<S> ? 20 : 3); ++i) {
        const Case c = random_case(random);
        const auto m = c.motion<S>();
        const auto wide = c.motion<Digits100>();
        ASSERT_EQ(m.outcome(), wide.outcome()) << c;
        const Digits100 unit = sqrt(Digits100(c.radius / c.gravity));
        const Digits100 bound = 100 * exact<Digits100>(math::epsilon<S>());
        if (std::is_same_v<S, Digits100>) continue;
        EXPECT_LE(abs(Digits100(exact<Digits100>(m.duration()) - wide.duration())),
                  bound * (wide.duration() + unit))
            << c;
        EXPECT_LE(abs(Digits100(exact<Digits100>(m.swept()) - wide.swept())),
                  bound * (1 + abs(wide.swept())))
            << c;
    }
}

/// Which side of the saddle a ball falls to, decided and not: with one part in 10^9, 10^16 and
/// 10^30 more or less moment than it takes.
TEST(RimPaper, BesideTheSeparatrix) {
    for (const double off : {1e-9, 1e-12, 1e-15}) {
        for (const int side : {-1, 1}) {
            const Case c = entering(0.3, kSeparatrix * (1 + side * off));
            const auto m = c.motion<double>();
            EXPECT_EQ(m.outcome(), side < 0 ? RimOutcome::capture : RimOutcome::exit) << c;
            EXPECT_LE(worst_error(c), 1e-12) << c;
        }
    }
}

/// A ball at rest exactly on the rim stands there; one within it falls, however close.
TEST(RimPaper, BallsAtRest) {
    const auto on_edge = Case{0.06, 0.028575, 9.81, 0.06, 0, 0}.motion<double>();
    EXPECT_EQ(on_edge.outcome(), RimOutcome::balanced);
    EXPECT_EQ(on_edge.duration(), 0);
    for (const double depth : {1e-3, 1e-9, 1e-15}) {
        const Case c{0.06, 0.028575, 9.81, 0.06 * (1 - depth), 0, 0};
        const auto m = c.motion<double>();
        EXPECT_EQ(m.outcome(), RimOutcome::capture);
        EXPECT_LE(worst_error(c), 1e-13) << c;
        EXPECT_LT(m.duration(), 3);
    }
}

/// What may be rounding of F at the saddle covers what is, and a tenth of it does not.
TEST(RimPaper, BalanceCoversTheRoundingOfTheField) {
    using Wide = math::Wide<double>;
    Random random(9);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto wide = [&](double low, double high) {
            const double x = random.uniform<double>(low, high);
            return math::quick_two_sum(x, x * 0x1p-54 * random.signed_unit<double>());
        };
        const Wide rim = wide(1.1, 3);
        const Wide q = wide(0, 0.9);
        const Wide radial = wide(-1, 1) * Wide(random.magnitude<double>(-20, 0));
        const Wide moment = wide(-1, 1) * Wide(random.magnitude<double>(-3, 1));
        const motion::detail::RimExtrema<double> extrema(
            math::narrow(rim), math::narrow(rim - Wide(1.0)), math::narrow(moment * moment));
        if (!extrema.exist) continue;
        const Wide z(extrema.minimum);
        const auto is = motion::RimField<double>(rim, q, radial, moment).value(z);
        const auto exactly = [](const Wide& x) { return exact<Digits100>(x); };
        const auto should =
            motion::RimField<Digits100>(exactly(rim), exactly(q), exactly(radial), exactly(moment))
                .value(exactly(z));
        const double error = double(abs(Digits100(exactly(is.value) - should.value)));
        worst = std::max(worst, error / is.noise);
    }
    EXPECT_LE(worst, 1);
    EXPECT_GT(worst, 0.1);
}

/// A ball that climbs to the edge with the very energy it takes: undecided in the stored digits,
/// and no run hangs on it.
TEST(RimPaper, CannotTellWhatNoDigitTells) {
    using S = Digits50;
    // L = 0 and v^2 = (2 g r / 3)(1 - c^3) with c = 3/5, q = 4/5.
    const S radius = S(1);
    const S gravity = S(3) / S(2);
    const S speed = sqrt(S(S(1) - S(27) / S(125)));
    const geometry::Rim<S> hole{math::Vec<S>(S(0), S(0)), S(2)};
    const motion::RimPaperMotion<S> m(hole, gravity, radius,
                                      math::WidePoint<S>(math::Vec<S>(S(6) / S(5), S(0))),
                                      math::Vec<S>(speed, S(0)));
    EXPECT_EQ(m.outcome(), RimOutcome::balanced);
    EXPECT_GT(m.duration(), 10);
    EXPECT_LT(m.duration(), 1000);
    const auto end = m.at(m.duration());
    EXPECT_LT(abs(S(end.position.x - 2)), 1e-20);
    EXPECT_LT(abs(S(end.velocity.x())), 1e-20);
}

}  // namespace
