#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "osculo/math/error_bounds.hpp"
#include "support/random_touching.hpp"
#include "support/scalars.hpp"

// What clusters are allowed to leave, and how far apart things may be that touch: it suffices for
// random ones, and a tenth of it does not.
namespace osculo::support {
namespace {

template <class S>
using DiscTable = engine::DiscScene<S, engine::DiscPieces, impact::Symmetric>;

/// Of all clusters that were looked at, in epsilons, as the audit counts.
struct Worst {
    double energy = 0, momentum = 0, closing = 0;
    int clusters = 0;
};

/// Friction and spins for what has them.
template <class Type>
void add_friction(engine::SceneData<Type>& scene, Random& random) {
    using S = typename Type::Scalar;
    if constexpr (Type::Motion::kSpin) {
        const S friction = random.magnitude<S>(-6, -1);
        scene.friction.ball_ball = {scene.ball_ball_restitution, {friction, S(0), S(0)}};
        scene.friction.ball_cushion = {scene.ball_cushion_restitution, friction};
        for (auto& body : scene.bodies) {
            if (random.coin()) continue;
            const S rate = random.magnitude<S>(-4, 2) * random.signed_unit<S>();
            body.state.spin = {S(0), S(0), rate};
        }
    }
}

/// How fast the contacts of the cluster still close, over the largest speed in it.
template <class Type>
double closing(const Played<Type>& played) {
    using S = typename Type::Scalar;
    S speed{0}, most{0};
    for (const auto& event : played.record.events) {
        const bool pair = event.kind == engine::kBallBall;
        for (std::size_t k = 0; k < (pair ? 2U : 1U); ++k) {
            for (const auto* of : {&event.before[k], &event.after[k]}) {
                speed = std::max<S>(speed, math::norm_max<S>(of->velocity));
            }
        }
        math::Vec<S> v = played.velocity(event.first);
        if (pair) v -= played.velocity(event.second);
        most =
            std::max<S>(most, math::accurate_dot<S>(v, event.normal) / math::norm<S>(event.normal));
    }
    return math::to_double<S>(most / speed);
}

/// Plays clusters of which all is at one instant, the beginning.
template <class Type>
void measure(std::uint64_t seed, int cases, Worst& worst) {
    using S = typename Type::Scalar;
    const double epsilon = math::to_double<S>(math::epsilon<S>());
    Random random(seed);
    for (int i = 0; i < cases; ++i) {
        RandomTouching<Type> touching(random);
        add_friction<Type>(touching.builder.scene, random);
        const auto played = play<Type>(touching.builder.scene, S(0));
        const auto& events = played.record.events;
        const auto audit = played.audit();
        ASSERT_TRUE(audit.clean) << "case " << i << ", " << touching.name << ": "
                                 << describe(audit);
        const bool one_cluster =
            !events.empty() && std::ranges::all_of(events, [](const auto& event) {
                return event.cluster.number == 1;
            });
        if (!one_cluster) continue;
        ++worst.clusters;
        worst.energy = std::max(worst.energy, audit.largest_energy_gain / epsilon);
        worst.momentum = std::max(worst.momentum, audit.largest_momentum_error / epsilon);
        worst.closing = std::max(worst.closing, closing(played) / epsilon);
    }
}

TEST(ClusterBounds, RoundingIsWithinThemAndNotWithinATenth) {
    Worst worst;
    measure<SymmetricTable<double>>(424701, 60000, worst);
    measure<DiscTable<double>>(424702, 60000, worst);
    measure<SymmetricTable<long double>>(424703, 10000, worst);
    std::printf("  %d clusters: energy %.1f, momentum %.1f, closing %.1f epsilons\n",
                worst.clusters, worst.energy, worst.momentum, worst.closing);
    EXPECT_LE(worst.energy, math::kClusterEnergy);
    EXPECT_LE(worst.momentum, math::kClusterMomentum);
    EXPECT_LE(worst.closing, math::kClusterClosing);
    EXPECT_GT(worst.energy, math::kClusterEnergy / 10.0);
    EXPECT_GT(worst.momentum, math::kClusterMomentum / 10.0);
    EXPECT_GT(worst.closing, math::kClusterClosing / 10.0);
}

/// A light ball gives two heavy ones far more momentum than it had, to and fro.
TEST(ClusterBounds, MomentumIsMeasuredByWhatThereIs) {
    using Point = math::Vec<double>;
    for (const double light : {1e-2, 1e-4, 1e-6, 1e-8}) {
        Builder<SymmetricTable<double>> builder;
        const Point axis(0.6, 0.8);
        builder.ball(-2 * axis, Point(0, 0), 1, 1)
            .ball(Point(0, 0), 0.7 * axis, 1, light)
            .ball(2 * axis, Point(0, 0), 1, 1);
        const auto played = play<SymmetricTable<double>>(builder.scene, 1e-9);
        EXPECT_EQ(played.events, 2U);
        EXPECT_TRUE(played.audit().clean) << light << ": " << describe(played.audit());
    }
}

/// Where rounding leaves a ball that touches two at one instant, in units of kTogether: one that
/// comes from up to [distance] radii away, somewhere within [distance] radii of the origin.
double gap_at_one_instant(Random& random, int distance, bool& found) {
    using Quad = math::Quad;
    using Point = math::Vec<double>;
    const double epsilon = math::epsilon<double>();
    found = true;
    const double r[] = {random.magnitude<double>(-2, 2), random.magnitude<double>(-2, 2),
                        random.magnitude<double>(-2, 2)};
    // Ball 1 at 0, ball 2 beside it on the axis, ball 0 above, touching both.
    const Quad a = Quad(r[0]) + r[1], b = Quad(r[0]) + r[2], base = Quad(r[1]) + r[2];
    const Quad along = (base * base + a * a - b * b) / (2 * base);
    const Quad up = math::square_root<Quad>(a * a - along * along);
    const Point way = random.direction<double>();
    const Quad to_one = -(along * way.x() + up * way.y()) / a;
    const Quad to_other = ((base - along) * way.x() - up * way.y()) / b;
    if (to_one < 0.0625 || to_other < 0.0625) return 0;  // grazes, or flies away

    const Point turn = random.direction<double>();
    const Point shift = random.magnitude<double>(-3, distance) * random.direction<double>();
    const Quad back = random.magnitude<double>(-3, distance);
    const auto put = [&](const Quad& x, const Quad& y) {
        return Point(static_cast<double>(turn.x() * x - turn.y() * y + shift.x()),
                     static_cast<double>(turn.y() * x + turn.x() * y + shift.y()));
    };
    Builder<SymmetricTable<double>> builder;
    const Point velocity(turn.x() * way.x() - turn.y() * way.y(),
                         turn.y() * way.x() + turn.x() * way.y());
    builder.ball(put(along - back * way.x(), up - back * way.y()), velocity, r[0])
        .ball(put(0, 0), Point(0, 0), r[1])
        .ball(put(base, 0), Point(0, 0), r[2]);
    const auto played = play<SymmetricTable<double>>(builder.scene, 1e9, 1);
    if (played.record.events.empty()) return 0;
    found = played.record.events.front().cluster.number == 1;

    std::vector<engine::Body<SymmetricTable<double>>> now = builder.scene.bodies;
    const double t = math::narrow(played.record.events.front().when);
    now[0].state.position = math::displaced<double>(now[0].state.position, velocity, t);
    const auto known = [&](std::size_t i) {
        return math::norm1<double>(builder.scene.bodies[i].state.position.rounded()) +
               math::norm1<double>(now[i].state.position.rounded()) + now[i].radius;
    };
    double worst = 0;
    for (const auto& [i, j] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}}) {
        const Point apart = math::difference<double>(now[j].state.position, now[i].state.position);
        const double gap = math::norm<double>(apart) - (now[i].radius + now[j].radius);
        worst = std::max(worst, gap / (epsilon * (known(i) + known(j))));
    }
    return worst;
}

TEST(ClusterBounds, TogetherCoversWhatRoundingMakesOfOneInstant) {
    Random random(424704);
    double worst = 0;
    for (int i = 0; i < 40000; ++i) {
        bool found = true;
        worst = std::max(worst, gap_at_one_instant(random, i % 2 == 0 ? 2 : 20, found));
        EXPECT_TRUE(found) << "case " << i;
    }
    std::printf("  up to %.2f\n", worst);
    EXPECT_LE(worst, math::kTogether);
    EXPECT_GT(worst, math::kTogether / 10.0);
}

/// A ball that leans on a wall is found to touch it wherever along the wall that is.
TEST(ClusterBounds, LongWallsAreTouchedAsShortOnesAre) {
    using Point = math::Vec<double>;
    Random random(424705);
    for (int i = 0; i < 2000; ++i) {
        const Point normal = random.direction<double>(), along(-normal.y(), normal.x());
        const double before = random.magnitude<double>(0, 30);
        Builder<SymmetricTable<double>> builder;
        builder.wall(normal - before * along, normal + 10 * along)
            .ball(Point(0, 0), Point(0, 0))
            .ball(-2 * normal, normal);
        const auto played = play<SymmetricTable<double>>(builder.scene, 0.0);
        EXPECT_TRUE(played.audit().clean)
            << "case " << i << ", " << before << ": " << describe(played.audit());
    }
}

}  // namespace
}  // namespace osculo::support
