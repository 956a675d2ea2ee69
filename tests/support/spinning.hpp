#pragma once

#include <sstream>
#include <string>

#include "osculo/impact/spinning_ball.hpp"
#include "support/random.hpp"

/// Spinning balls for tests of impact laws.
namespace osculo::support {

using Ball = impact::SpinningBall<double>;
using Point = math::Vec<double>;

template <math::Scalar S>
[[nodiscard]] S energy(const impact::SpinningBall<S>& b) {
    const S turning = b.inertia * b.radius * b.radius * b.spin.dot(b.spin);
    return b.mass * (math::dot<S>(b.velocity, b.velocity) + turning) / S(2);
}

/// The speed scale of a ball's rounding errors: |v| + r |w|.
template <math::Scalar S>
[[nodiscard]] S speed_scale(const impact::SpinningBall<S>& b) {
    return math::norm<S>(b.velocity) +
           b.radius *
               (math::abs<S>(b.spin.x()) + math::abs<S>(b.spin.y()) + math::abs<S>(b.spin.z()));
}

/// Largest difference of velocities and of k r times the spins.
template <math::Scalar S>
[[nodiscard]] S distance(const impact::SpinningBall<S>& a, const impact::SpinningBall<S>& b) {
    S worst(0);
    for (int i = 0; i < 2; ++i) {
        const S d = math::abs<S>(a.velocity[i] - b.velocity[i]);
        if (!(d <= worst)) worst = d;
    }
    for (int i = 0; i < 3; ++i) {
        const S k = a.inertia < S(1) ? a.inertia : S(1);
        const S d = k * a.radius * math::abs<S>(a.spin[i] - b.spin[i]);
        if (!(d <= worst)) worst = d;
    }
    return worst;
}

/// Mirrored at the line across the unit vector [m]: the spin is an axial vector.
[[nodiscard]] inline Point mirrored(const Point& v, const Point& m) {
    return v - 2 * math::dot<double>(v, m) * m;
}
[[nodiscard]] inline Ball mirrored(Ball ball, const Point& m) {
    ball.velocity = mirrored(ball.velocity, m);
    const Point w = -mirrored(Point(ball.spin.x(), ball.spin.y()), m);
    ball.spin = {w.x(), w.y(), -ball.spin.z()};
    return ball;
}

/// A ball of any kind: masses, radii and speeds over six decades, solid spheres, shells, disks and
/// what is between; at rest, stunned, rolling or spinning anyhow.
[[nodiscard]] inline Ball random_ball(Random& random) {
    Ball ball;
    ball.mass = random.magnitude<double>(-10, 10);
    ball.radius = random.magnitude<double>(-10, 10);
    const double kinds[] = {0.4, 2.0 / 3, 0.5, random.uniform(0.1, 1.0)};
    ball.inertia = kinds[random.below(4)];
    const double speed = random.below(8) == 0 ? 0 : random.magnitude<double>(-10, 10);
    ball.velocity = speed * random.direction<double>();
    const double rate = random.magnitude<double>(-3, 3) * speed / ball.radius;
    switch (random.below(4)) {
        case 0: ball.spin.setZero(); break;
        case 1:  // rolling, perhaps with side spin
            ball.spin = {-ball.velocity.y() / ball.radius, ball.velocity.x() / ball.radius,
                         random.coin() ? 0 : rate};
            break;
        case 2: ball.spin = {0, 0, rate}; break;
        default:
            ball.spin = {rate * random.signed_unit<double>(), rate * random.signed_unit<double>(),
                         rate * random.signed_unit<double>()};
    }
    return ball;
}

/// Everything needed to repeat a case.
[[nodiscard]] inline std::string described(const Ball& b) {
    std::ostringstream out;
    out << std::hexfloat << "{" << b.mass << ", " << b.radius << ", " << b.inertia << ", {"
        << b.velocity.x() << ", " << b.velocity.y() << "}, {" << b.spin.x() << ", " << b.spin.y()
        << ", " << b.spin.z() << "}}";
    return out.str();
}

[[nodiscard]] inline bool same_bits(const Ball& a, const Ball& b) {
    return a.velocity == b.velocity && a.spin == b.spin;
}

}  // namespace osculo::support
