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
        elapsed_ = 0;
        look(h);
        // Contacts without end would need balls pressed together; nothing here presses.
        for (int passes = 0; passes < 100000; ++passes) {
            const Hit hit = earliest();
            if (!(hit.time <= h)) break;
            move(hit.time - elapsed_);
            elapsed_ = hit.time;
            resolve(hit, now_ + elapsed_);
            if (too_fast(hit.ball) || (hit.what == 0 && too_fast(hit.other))) {
                look(h);
            } else {
                look_again(hit);
            }
        }
        move(h - elapsed_);
        now_ += h;
    }

    [[nodiscard]] const std::vector<Moving>& balls() const { return balls_; }

    std::vector<Contact> contacts;

private:
    struct Pair {
        std::size_t first;
        std::size_t second;
        double time;  ///< of their contact, from the start of the step
    };

    /// Finds the pairs that may meet before the end of the step, by sweeping along x, and when.
    void look(double h) {
        double fastest = 0;
        double largest = 0;
        for (const Moving& ball : balls_) {
            fastest = std::max(fastest, ball.vx * ball.vx + ball.vy * ball.vy);
            largest = std::max(largest, ball.radius);
        }
        // A ball that becomes faster than that in the step makes us look again.
        limit_ = 2 * std::sqrt(fastest);
        reach_ = (h - elapsed_) * limit_;
        order_.resize(balls_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t a, std::size_t b) { return balls_[a].x < balls_[b].x; });
        pairs_.clear();
        cushions_.resize(balls_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) {
            const Moving& a = balls_[order_[k]];
            look_at_cushions(order_[k]);
            if (!a.present) continue;
            for (std::size_t l = k + 1; l < order_.size(); ++l) {
                const Moving& b = balls_[order_[l]];
                if (b.x - a.x > a.radius + largest + 2 * reach_) break;
                const double near = a.radius + b.radius + 2 * reach_;
                if (!b.present || std::abs(b.y - a.y) > near) continue;
                const auto [first, second] = std::minmax(order_[k], order_[l]);
                pairs_.push_back({first, second, contact(first, second)});
            }
        }
    }

    /// After a contact, only those that took part have other contacts ahead.
    void look_again(const Hit& hit) {
        look_at_cushions(hit.ball);
        if (hit.what == 0) look_at_cushions(hit.other);
        const std::size_t i = hit.ball;
        const std::size_t j = hit.what == 0 ? hit.other : hit.ball;
        for (Pair& pair : pairs_) {
            if (pair.first == i || pair.second == i || pair.first == j || pair.second == j) {
                pair.time = contact(pair.first, pair.second);
            }
        }
    }

    [[nodiscard]] bool too_fast(std::size_t i) const {
        const Moving& ball = balls_[i];
        return ball.vx * ball.vx + ball.vy * ball.vy > limit_ * limit_;
    }

    [[nodiscard]] double contact(std::size_t i, std::size_t j) const {
        const Moving& a = balls_[i];
        const Moving& b = balls_[j];
        if (!a.present || !b.present) return kNever;
        return elapsed_ +
               entry(b.x - a.x, b.y - a.y, b.vx - a.vx, b.vy - a.vy, a.radius + b.radius);
    }

    void look_at_cushions(std::size_t i) {
        const Moving& a = balls_[i];
        Hit& best = cushions_[i];
        best = {};
        if (!a.present || (a.vx == 0 && a.vy == 0)) return;
        const auto offer = [&](double t, int what, double nx, double ny) {
            if (t + elapsed_ < best.time) best = {t + elapsed_, i, 0, what, nx, ny};
        };
        const double near = a.radius + reach_;
        for (const Line& line : outline_.lines) {
            if (line.near(a.x, a.y, near)) sweep(a, line, offer);
        }
        for (const Curve& arc : outline_.curves) {
            if (arc.near(a.x, a.y, near)) sweep(a, arc, offer);
        }
        for (const Rim& rim : scene_.rims) {
            offer(entry(a.x - rim.center.x, a.y - rim.center.y, a.vx, a.vy, rim.radius), kRim, 0,
                  0);
        }
    }

    [[nodiscard]] Hit earliest() const {
        Hit best;
        for (const Pair& pair : pairs_) {
            if (pair.time < best.time) best = {pair.time, pair.first, pair.second, 0, 0, 0};
        }
        for (const Hit& hit : cushions_) {
            if (hit.time < best.time) best = hit;
        }
        return best;
    }

    template <class Offer>
    static void sweep(const Moving& a, const Line& line, const Offer& offer) {
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
                offer(t, kCushion, -sign * line.ty, sign * line.tx);
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
            offer(t, kCushion, nx / d, ny / d);
        }
    }

    template <class Offer>
    static void sweep(const Moving& a, const Curve& arc, const Offer& offer) {
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
        offer(t, kCushion, nx / d, ny / d);
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
    std::vector<Pair> pairs_;
    std::vector<Hit> cushions_;  ///< the first of each ball
    double limit_ = 0;           ///< speed beyond which pairs may be missing [m/s]
    double reach_ = 0;           ///< how far a ball may come in what is left of the step [m]
    double elapsed_ = 0;         ///< of the step
    double now_ = 0;             ///< start of the step
};

}  // namespace

Contender swept_steps() {
    return {"swept steps", true, false, [](const Task& task) {
                SweptWorld world(task.scene);
                return step_through(world, task);
            }};
}

}  // namespace osculo::bench
