#include <algorithm>
#include <cstdio>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "random_clusters.hpp"

// What must not matter: the order of balls and contacts, mirrors, units.
namespace osculo::support {
namespace {

using impact::SymmetricSolver;
using Cluster = impact::Cluster<double>;
using Point = math::Vec<double>;

constexpr int kCases = 100000;
constexpr int kBitCases = 30000;
constexpr double kEpsilon = 0x1p-52;
constexpr int kCap = 1000;

/// Largest difference of sqrt(m) v over |y|, the root of twice the energy before.
double difference(const Cluster& a, const Cluster& b, const Cluster& before) {
    double size = 0;
    double worst = 0;
    for (std::size_t i = 0; i < a.balls.size(); ++i) {
        const double root = std::sqrt(a.balls[i].mass);
        size = std::hypot(size, root * math::norm<double>(before.balls[i].velocity));
        worst = std::max(worst,
                         root * math::norm_max<double>(a.balls[i].velocity - b.balls[i].velocity));
    }
    return size > 0 ? worst / size : 0;
}

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = count; i > 1; --i) {
        std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    return order;
}

TEST(Invariance, OrderOfBallsAndContacts) {
    Random random(424301);
    SymmetricSolver<double> solver(kCap);
    double worst[] = {0, 0, 0};
    int undecided = 0;
    for (int i = 0; i < kCases; ++i) {
        const RandomCluster<double> source(random);
        const Cluster& before = source.stage.cluster;
        Cluster first = before;
        const auto outcome = solver.resolve(first);

        const auto balls = shuffled(before.balls.size(), random);
        const auto contacts = shuffled(before.contacts.size(), random);
        Cluster permuted;
        permuted.balls.resize(balls.size());
        for (std::size_t b = 0; b < balls.size(); ++b) permuted.balls[balls[b]] = before.balls[b];
        for (const std::size_t c : contacts) {
            auto contact = before.contacts[c];
            contact.one = balls[contact.one];
            if (contact.other != impact::kFixed) {
                contact.other = balls[contact.other];
                if (random.coin()) {
                    std::swap(contact.one, contact.other);
                    contact.normal = -contact.normal;
                }
            }
            permuted.contacts.push_back(contact);
        }
        const auto again = solver.resolve(permuted);
        ASSERT_EQ(outcome.well_posed, again.well_posed) << i << ' ' << source.described();
        Cluster second = before;
        for (std::size_t b = 0; b < balls.size(); ++b) second.balls[b] = permuted.balls[balls[b]];
        const double off = difference(first, second, before) / kEpsilon / (1 + again.reflections);
        // Different restitutions ask for the share of each contact, where more bear than have to.
        // With masses from 1e-6 to 1e6 wedges are right angles but for a tolerance, 2^-26, and now
        // and then some contact approaches by just about kClusterApproach epsilon of |y|: an
        // ill-posed outcome turns on whether it does.
        const int kind = source.masses == Masses::extreme ? 1 : source.same_restitution ? 0 : 2;
        const double most[] = {50, 0x1p26, 1e6};
        if (off > most[kind] && source.masses == Masses::extreme && !outcome.well_posed) {
            ++undecided;
            continue;
        }
        worst[kind] = std::max(worst[kind], off);
        ASSERT_LE(off, most[kind]) << "case " << i << ": " << source.described();
    }
    std::printf(
        "  permuted: epsilons per reflection: %.2f, extreme masses %.2f, different e %.3g; "
        "%d undecided\n",
        worst[0], worst[1], worst[2], undecided);
    EXPECT_LE(undecided, kCases / 2000);
}

TEST(Invariance, MirrorsAtTheAxesAndUnitsBitForBit) {
    Random random(424302);
    SymmetricSolver<double> solver(kCap);
    for (int i = 0; i < kBitCases; ++i) {
        const RandomCluster<double> source(random);
        const Cluster& before = source.stage.cluster;
        Cluster first = before;
        solver.resolve(first);
        const double sx = random.coin() ? -1 : 1;
        const double sy = random.coin() ? -1 : 1;
        const double speed = power_of_two<double>(random.between(-200, 200));
        const double mass = power_of_two<double>(2 * random.between(-100, 100));
        Cluster image = before;
        for (auto& ball : image.balls) {
            ball.mass *= mass;
            ball.velocity = {sx * speed * ball.velocity.x(), sy * speed * ball.velocity.y()};
        }
        for (auto& contact : image.contacts) {
            contact.normal = {sx * contact.normal.x(), sy * contact.normal.y()};
            contact.normal *= power_of_two<double>(random.between(-100, 100));
        }
        solver.resolve(image);
        for (std::size_t b = 0; b < first.balls.size(); ++b) {
            const Point v = first.balls[b].velocity;
            ASSERT_EQ(image.balls[b].velocity, Point(sx * speed * v.x(), sy * speed * v.y()))
                << "case " << i << ": " << source.described();
        }
        for (std::size_t c = 0; c < first.contacts.size(); ++c) {
            ASSERT_EQ(image.contacts[c].impulse, speed * mass * first.contacts[c].impulse);
        }
    }
}

/// A cluster that is its own mirror image at the x axis.
struct Symmetric {
    Stage<double> stage;
    std::vector<std::size_t> partner;

    explicit Symmetric(Random& random) {
        const bool equal = random.coin();
        const double e = random.coin() ? 1.0 : 0.95;
        const auto mass = [&] { return equal ? 1.0 : random.magnitude<double>(-3, 2); };
        const int along = random.between(1, 3);
        for (int i = 0; i < along; ++i) {
            add({2.0 * i, 0}, {random.signed_unit<double>(), 0}, mass());
            if (i > 0) stage.touch(partner.size() - 2, partner.size() - 1, e);
        }
        stage.cluster.balls[0].velocity.x() = 1;
        const int pairs = random.between(1, 4);
        for (int i = 0; i < pairs; ++i) {
            const auto parent =
                static_cast<std::size_t>(random.below(static_cast<int>(partner.size())));
            Point step = 2 * random.direction<double>();
            if (random.coin()) step = {std::sqrt(3.0), 1};
            const Point place = stage.places[parent] + step;
            const Point v = random.coin() ? Point(0, 0) : Point(random.direction<double>());
            const double m = mass();
            const std::size_t one = add(place, v, m);
            const std::size_t other = add({place.x(), -place.y()}, {v.x(), -v.y()}, m);
            partner[one] = other;
            partner[other] = one;
            stage.touch(parent, one, e);
            stage.touch(partner[parent], other, e);
            if (random.below(3) == 0) {
                const Point n = random.direction<double>();
                stage.wall(one, n, e);
                stage.wall(other, {n.x(), -n.y()}, e);
            }
            if (random.below(3) == 0) {
                stage.cluster.contacts.push_back({one, other, {0, place.y() < 0 ? 1.0 : -1.0}, e});
            }
        }
    }
    std::size_t add(const Point& place, const Point& v, double m) {
        partner.push_back(partner.size());
        return stage.ball(place, v, m);
    }
};

TEST(Invariance, SymmetricStaysSymmetric) {
    Random random(424303);
    SymmetricSolver<double> solver(kCap);
    double worst = 0;
    for (int i = 0; i < kCases; ++i) {
        const Symmetric source(random);
        Cluster cluster = source.stage.cluster;
        const auto order = shuffled(cluster.contacts.size(), random);
        for (std::size_t c = 0; c < order.size(); ++c) {
            cluster.contacts[c] = source.stage.cluster.contacts[order[c]];
        }
        const auto outcome = solver.resolve(cluster);
        Cluster image = cluster;
        for (std::size_t b = 0; b < image.balls.size(); ++b) {
            const Point& v = cluster.balls[source.partner[b]].velocity;
            image.balls[b].velocity = {v.x(), -v.y()};
        }
        const double off =
            difference(cluster, image, source.stage.cluster) / kEpsilon / (1 + outcome.reflections);
        worst = std::max(worst, off);
        ASSERT_LE(off, 1000) << "case " << i;
    }
    std::printf("  mirror pairs: at most %.2f epsilon per reflection\n", worst);
}

}  // namespace
}  // namespace osculo::support
