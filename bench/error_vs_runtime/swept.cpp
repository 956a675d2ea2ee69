#include <algorithm>
#include <limits>

#include "outline.hpp"
#include "stepping.hpp"

// A careful fixed-step integrator: within a step it moves everything to the earliest contact of
// any pair (swept circles, solved in plain double), resolves it, and goes on with what is left of
// the step. Nothing tunnels, and contacts come in their order. It is event-driven in disguise, and
// what the step still decides is which pairs it looks at and how often it looks at them in vain.

namespace osculo::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// First time at which a point at (x, y) with velocity (vx, vy) comes within r of the origin while
/// approaching; now, if it is within r already.
double entry(double x, double y, double vx, double vy, double r) {
    const double b = x * vx + y * vy;
    if (b >= 0) return kNever;
    const double c = x * x + y * y - r * r;
    if (c <= 0) return 0;
    const double a = vx * vx + vy * vy;
    const double discriminant = b * b - a * c;
    return discriminant < 0 ? kNever : c / (std::sqrt(discriminant) - b);
}

/// First time at which it goes farther than r from the origin, coming from within.
double leaving(double x, double y, double vx, double vy, double r) {
    if (r <= 0) return kNever;
    const double b = x * vx + y * vy;
    const double c = x * x + y * y - r * r;
    if (c >= 0) return b > 0 && c < 2 * r * r ? 0 : kNever;
    const double a = vx * vx + vy * vy;
    return a > 0 ? (std::sqrt(b * b - a * c) - b) / a : kNever;
}

struct Hit {
    double time = kNever;
    std::size_t ball = 0;
    std::size_t other = 0;
    int what = 0;  // kCushion, kRim, or 0 for a ball
    double nx = 0;
    double ny = 0;
};

class SweptWorld {
public:
    explicit SweptWorld(const Scene& scene)
        : scene_(scene), outline_(scene), balls_(balls_of(scene)) {}

    void step(double h) {
        find_neighbours(h);
        double left = h;
        // Contacts without end would need balls pressed together; nothing here presses.
        for (int passes = 0; passes < 100000; ++passes) {
            const Hit hit = earliest(left);
            if (!(hit.time <= left)) break;
            move(hit.time);
            left -= hit.time;
            resolve(hit, now_ + h - left);
        }
        move(left);
        now_ += h;
    }

    [[nodiscard]] const std::vector<Moving>& balls() const { return balls_; }

    std::vector<Contact> contacts;

private:
    /// Pairs that may meet within the step, by sweeping along x.
    void find_neighbours(double h) {
        double energy = 0;
        double lightest = kNever;
        double largest = 0;
        for (const Moving& ball : balls_) {
            energy += ball.mass * (ball.vx * ball.vx + ball.vy * ball.vy);
            lightest = std::min(lightest, ball.mass);
            largest = std::max(largest, ball.radius);
        }
        // No ball becomes faster than if it had all energy.
        const double reach = h * std::sqrt(energy / lightest);
        order_.resize(balls_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t a, std::size_t b) { return balls_[a].x < balls_[b].x; });
        pairs_.clear();
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const Moving& a = balls_[order_[k]];
            if (!a.present) continue;
            for (std::size_t l = k + 1; l < order_.size(); ++l) {
                const Moving& b = balls_[order_[l]];
                if (b.x - a.x > a.radius + largest + 2 * reach) break;
                const double near = a.radius + b.radius + 2 * reach;
                if (!b.present || std::abs(b.y - a.y) > near) continue;
                pairs_.emplace_back(std::min(order_[k], order_[l]), std::max(order_[k], order_[l]));
            }
        }
    }

    Hit earliest(double horizon) const {
        Hit best;
        best.time = std::nextafter(horizon, kNever);
        bool found = false;
        const auto offer = [&](double t, std::size_t i, std::size_t j, int what, double nx,
                               double ny) {
            if (!(t < best.time)) return;
            best = {t, i, j, what, nx, ny};
            found = true;
        };
        for (const auto& [i, j] : pairs_) {
            const Moving& a = balls_[i];
            const Moving& b = balls_[j];
            if (!a.present || !b.present) continue;
            offer(entry(b.x - a.x, b.y - a.y, b.vx - a.vx, b.vy - a.vy, a.radius + b.radius), i, j,
                  0, 0, 0);
        }
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const Moving& a = balls_[i];
            if (!a.present || (a.vx == 0 && a.vy == 0)) continue;
            for (const Line& line : outline_.lines) sweep(a, line, i, offer);
            for (const Curve& arc : outline_.curves) sweep(a, arc, i, offer);
            for (const Rim& rim : scene_.rims) {
                offer(entry(a.x - rim.center.x, a.y - rim.center.y, a.vx, a.vy, rim.radius), i, 0,
                      kRim, 0, 0);
            }
        }
        if (!found) best.time = kNever;
        return best;
    }

    template <class Offer>
    static void sweep(const Moving& a, const Line& line, std::size_t i, Offer& offer) {
        const double dx = a.x - line.x;
        const double dy = a.y - line.y;
        double side = dy * line.tx - dx * line.ty;
        double across = a.vy * line.tx - a.vx * line.ty;
        double sign = 1;
        if (side < 0 && !line.one_sided) sign = -1;
        side *= sign;
        across *= sign;
        if (across < 0 && side > -a.radius) {
            const double t = std::max(0.0, (side - a.radius) / -across);
            const double along =
                dx * line.tx + dy * line.ty + t * (a.vx * line.tx + a.vy * line.ty);
            if (along >= 0 && along <= line.length) {
                offer(t, i, 0, kCushion, -sign * line.ty, sign * line.tx);
            }
        }
        for (const double end : {0.0, line.length}) {
            const double ex = dx - end * line.tx;
            const double ey = dy - end * line.ty;
            const double t = entry(ex, ey, a.vx, a.vy, a.radius);
            if (t == kNever) continue;
            const double nx = ex + t * a.vx;
            const double ny = ey + t * a.vy;
            const double d = std::hypot(nx, ny);
            offer(t, i, 0, kCushion, nx / d, ny / d);
        }
    }

    template <class Offer>
    static void sweep(const Moving& a, const Curve& arc, std::size_t i, Offer& offer) {
        const double dx = a.x - arc.x;
        const double dy = a.y - arc.y;
        const bool inside = dx * dx + dy * dy < arc.radius * arc.radius;
        const double t = inside ? leaving(dx, dy, a.vx, a.vy, arc.radius - a.radius)
                                : entry(dx, dy, a.vx, a.vy, arc.radius + a.radius);
        if (t == kNever) return;
        const double nx = dx + t * a.vx;
        const double ny = dy + t * a.vy;
        if (!arc.spans(nx, ny)) return;
        const double d = inside ? -std::hypot(nx, ny) : std::hypot(nx, ny);
        offer(t, i, 0, kCushion, nx / d, ny / d);
    }

    void move(double t) {
        for (Moving& ball : balls_) {
            if (!ball.present) continue;
            ball.x += ball.vx * t;
            ball.y += ball.vy * t;
        }
    }

    void resolve(const Hit& hit, double when) {
        Moving& a = balls_[hit.ball];
        if (hit.what == kRim) {
            a.present = false;
            contacts.push_back({when, static_cast<int>(hit.ball), kRim});
        } else if (hit.what == kCushion) {
            const double along = a.vx * hit.nx + a.vy * hit.ny;
            a.vx -= 2 * along * hit.nx;
            a.vy -= 2 * along * hit.ny;
            contacts.push_back({when, static_cast<int>(hit.ball), kCushion});
        } else {
            Moving& b = balls_[hit.other];
            double nx = b.x - a.x;
            double ny = b.y - a.y;
            const double d = std::hypot(nx, ny);
            nx /= d;
            ny /= d;
            const double approach = (a.vx - b.vx) * nx + (a.vy - b.vy) * ny;
            const double impulse = 2 * a.mass * b.mass / (a.mass + b.mass) * approach;
            a.vx -= impulse / a.mass * nx;
            a.vy -= impulse / a.mass * ny;
            b.vx += impulse / b.mass * nx;
            b.vy += impulse / b.mass * ny;
            add_pair(contacts, when, hit.ball, hit.other);
        }
    }

    const Scene& scene_;
    Outline outline_;
    std::vector<Moving> balls_;
    std::vector<std::size_t> order_;
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
    double now_ = 0;
};

}  // namespace

Contender swept_steps() {
    return {"swept steps", true, false, [](const Task& task) {
                SweptWorld world(task.scene);
                return step_through(world, task);
            }};
}

}  // namespace osculo::bench
