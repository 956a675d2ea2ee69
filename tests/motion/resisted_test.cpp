#include "osculo/motion/resisted.hpp"

#include <gtest/gtest.h>

#include "osculo/motion/rolling.hpp"
#include "support/random.hpp"

namespace osculo::motion {
namespace {

using Vec = math::Vec<double>;
using State = Resisted::State<double>;

State begun(const Vec& velocity, const Resistance<double>& law) {
    State state;
    state.position = math::WidePoint<double>(Vec(0.5, -0.25));
    state.velocity = velocity;
    state.law = law;
    Resisted::begin<double>({}, state);
    return state;
}

Resistance<double> random_law(support::Random& random) {
    return {random.uniform<double>(0, 0.5), random.coin() ? random.uniform<double>(0, 2) : 0,
            random.coin() ? random.uniform<double>(0, 2) : 0};
}

TEST(Resisted, WithAConstantAloneItIsRolling) {
    support::Random random(20271);
    for (int round = 0; round < 1000; ++round) {
        const Vec velocity = random.direction<double>() * random.uniform<double>(0.1, 5);
        const double deceleration = random.uniform<double>(0.01, 1);
        State state = begun(velocity, {deceleration, 0, 0});
        Rolling::State<double> rolling;
        rolling.position = state.position;
        rolling.velocity = velocity;
        Rolling::begin<double>({deceleration}, rolling);
        ASSERT_NEAR(state.remaining, rolling.remaining, 4e-16 * rolling.remaining);
        const double t = rolling.remaining * random.unit<double>();
        Resisted::advance<double>(state, t);
        Rolling::advance<double>(rolling, t);
        const double way = math::norm<double>(velocity) * t;
        ASSERT_LE(math::norm<double>(math::difference<double>(state.position, rolling.position)),
                  4e-16 * way);
        ASSERT_LE(math::norm<double>(state.velocity - rolling.velocity),
                  4e-16 * math::norm<double>(velocity));
    }
}

TEST(Resisted, TwoStepsAreOne) {
    support::Random random(20272);
    for (int round = 0; round < 2000; ++round) {
        const State start =
            begun(random.direction<double>() * random.uniform<double>(0.1, 5), random_law(random));
        const double until = std::min(start.remaining, 10.0);
        const double t = until * random.unit<double>() * 0.9;
        const double more = (until - t) * random.unit<double>() * 0.9;
        State once = start;
        State twice = start;
        Resisted::advance<double>(once, t + more);
        Resisted::advance<double>(twice, t);
        Resisted::advance<double>(twice, more);
        const double way = Resisted::travel<double>(start, t + more);
        ASSERT_LE(math::norm<double>(math::difference<double>(once.position, twice.position)),
                  1e-14 * way);
        ASSERT_LE(math::norm<double>(once.velocity - twice.velocity),
                  1e-14 * math::norm<double>(start.velocity));
        // The law is not remembered but followed: what is left takes as long from here.
        State anew = twice;
        Resisted::begin<double>({}, anew);
        if (math::is_finite<double>(anew.remaining)) {
            ASSERT_NEAR(anew.remaining, twice.remaining, 1e-12 * start.remaining);
        }
    }
}

TEST(Resisted, SpeedNeverGrowsAndRestIsExact) {
    support::Random random(20273);
    for (int round = 0; round < 1000; ++round) {
        auto law = random_law(random);
        law.constant += 0.01;
        State state = begun(random.direction<double>() * random.uniform<double>(0.1, 5), law);
        double speed = math::norm<double>(state.velocity);
        for (int step = 0; step < 10; ++step) {
            Resisted::advance<double>(state, state.remaining / 3);
            const double now = math::norm<double>(state.velocity);
            ASSERT_LT(now, speed);
            speed = now;
        }
        Resisted::advance<double>(state, state.remaining);
        ASSERT_LE(math::norm<double>(state.velocity), 1e-14);
        Resisted::transition<double>({}, state);
        ASSERT_TRUE(Resisted::at_rest<double>(state));
        ASSERT_EQ(state.remaining, math::never<double>());
    }
}

TEST(Resisted, TurningAndMirroringTheStartTurnsAndMirrorsTheWay) {
    support::Random random(20274);
    for (int round = 0; round < 500; ++round) {
        const Vec v = random.direction<double>() * random.uniform<double>(0.1, 5);
        const auto law = random_law(random);
        const auto one = Resisted::path<double>(begun(v, law));
        const auto turned = Resisted::path<double>(begun(Vec(-v.y(), v.x()), law));
        const auto mirrored = Resisted::path<double>(begun(Vec(-v.x(), v.y()), law));
        const double t = std::min(one.end, 3.0) * random.unit<double>();
        const Vec a = math::difference<double>(one.at(t).position, one.position);
        const Vec b = math::difference<double>(turned.at(t).position, turned.position);
        const Vec c = math::difference<double>(mirrored.at(t).position, mirrored.position);
        ASSERT_EQ(b, Vec(-a.y(), a.x()));
        ASSERT_EQ(c, Vec(-a.x(), a.y()));
    }
}

TEST(Resisted, ItsParabolasStayWithinTheirBounds) {
    support::Random random(20275);
    for (int round = 0; round < 2000; ++round) {
        const auto path = Resisted::path<double>(
            begun(random.direction<double>() * random.uniform<double>(0.1, 5), random_law(random)));
        const double end = std::min(path.end, 3.0);
        const double t = end * random.unit<double>();
        const double h = (end - t) * random.unit<double>();
        ParabolicPath<double> parabola = path.quadratic(t);
        parabola.shift(h);
        const double off = math::norm<double>(
            math::difference<double>(parabola.position, path.at(t + h).position));
        ASSERT_LE(off, path.jerk_bound(t, h) * h * h * h / 6 + 1e-14);
    }
}

TEST(Resisted, ItsBoxHoldsTheWay) {
    support::Random random(20276);
    for (int round = 0; round < 2000; ++round) {
        const auto path = Resisted::path<double>(
            begun(random.direction<double>() * random.uniform<double>(0.1, 5), random_law(random)));
        const double until = 5 * random.unit<double>();
        const auto box = swept_box<double>(path, until);
        const double t = std::min(until, path.end) * random.unit<double>();
        const Vec p = path.at(t).position.rounded();
        ASSERT_TRUE(box.low_x <= p.x() && p.x() <= box.high_x && box.low_y <= p.y() &&
                    p.y() <= box.high_y);
    }
}

}  // namespace
}  // namespace osculo::motion
