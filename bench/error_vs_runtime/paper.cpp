#include "outline.hpp"
#include "stepping.hpp"

// The routine that osculo's founding paper (Ko and Bang, on collisions of circles and lines in
// games) gives: in every frame move everything, then test every pair once, in the order of the
// numbers. Circles exchange velocities along the line of centres, found by its angle; lines reverse
// the velocity across them and push the circle out. It is rebuilt here from what is known of the
// printed listing, its faults included, not transcribed from it:
//
//   - the angle of the line of centres by asin, which does not know left from right,
//   - ball B's velocity measured along the flipped axis,
//   - the across component of B's velocity where the one along belongs,
//   - no test that the two approach, so that they collide in every frame in which they overlap,
//   - a ball that has met one partner in a frame is not tested against others,
//   - circles are pushed one pixel too far off a line (a ball has a radius of 15 pixels here).
//
// Repaired, it has none of these but is the same routine: contacts are found after the fact.

namespace osculo::bench {
namespace {

struct Components {
    double along;
    double across;
};

Components turn(double x, double y, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {x * c + y * s, y * c - x * s};
}

constexpr double kPixelsPerRadius = 15;

class PaperWorld {
public:
    PaperWorld(const Scene& scene, bool repaired)
        : scene_(scene), outline_(scene), balls_(balls_of(scene)), repaired_(repaired) {}

    void step(double h) {
        now_ += h;
        for (Moving& ball : balls_) {
            if (!ball.present) continue;
            ball.x += ball.vx * h;
            ball.y += ball.vy * h;
        }
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (!balls_[i].present) continue;
            for (const Line& line : outline_.lines) meet(i, line.foot(balls_[i].x, balls_[i].y));
            for (const Curve& arc : outline_.curves) meet(i, arc.foot(balls_[i].x, balls_[i].y));
        }
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            for (std::size_t j = i + 1; j < balls_.size(); ++j) {
                if (meet(i, j) && !repaired_) break;
            }
        }
        if (scene_.rims.empty()) return;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            if (!balls_[i].present || !in_a_hole(scene_, balls_[i].x, balls_[i].y)) continue;
            balls_[i].present = false;
            contacts.push_back({now_, static_cast<int>(i), kRim});
        }
    }

    [[nodiscard]] const std::vector<Moving>& balls() const { return balls_; }

    std::vector<Contact> contacts;

private:
    void meet(std::size_t i, const Foot& foot) {
        Moving& ball = balls_[i];
        // Deep behind a one-sided line is outside of the table, not in the cushion.
        if (foot.distance >= ball.radius || foot.distance <= -ball.radius) return;
        const double angle = std::atan2(foot.ny, foot.nx);
        Components v = turn(ball.vx, ball.vy, angle);
        if (repaired_ && v.along >= 0) return;
        v.along = -v.along;
        const Components back = turn(v.along, v.across, -angle);
        ball.vx = back.along;
        ball.vy = back.across;
        const double out =
            ball.radius - foot.distance + (repaired_ ? 0 : ball.radius / kPixelsPerRadius);
        ball.x += out * foot.nx;
        ball.y += out * foot.ny;
        contacts.push_back({now_, static_cast<int>(i), kCushion});
    }

    bool meet(std::size_t i, std::size_t j) {
        Moving& a = balls_[i];
        Moving& b = balls_[j];
        const double dx = b.x - a.x;
        const double dy = b.y - a.y;
        const double reach = a.radius + b.radius;
        const double square = dx * dx + dy * dy;
        if (square >= reach * reach || !a.present || !b.present) return false;
        const double angle = repaired_ ? std::atan2(dy, dx) : std::asin(dy / std::sqrt(square));
        const Components va = turn(a.vx, a.vy, angle);
        Components vb = turn(b.vx, b.vy, angle);
        if (repaired_ && va.along <= vb.along) return false;
        const double across_b = vb.across;
        if (!repaired_) vb = {-vb.along, -vb.across};
        const double sum = a.mass + b.mass;
        const double new_a = ((a.mass - b.mass) * va.along + 2 * b.mass * vb.along) / sum;
        const double new_b =
            ((b.mass - a.mass) * (repaired_ ? vb.along : vb.across) + 2 * a.mass * va.along) / sum;
        const Components after_a = turn(new_a, va.across, -angle);
        const Components after_b = turn(new_b, across_b, -angle);
        a.vx = after_a.along;
        a.vy = after_a.across;
        b.vx = after_b.along;
        b.vy = after_b.across;
        add_pair(contacts, now_, i, j);
        return true;
    }

    const Scene& scene_;
    Outline outline_;
    std::vector<Moving> balls_;
    bool repaired_;
    double now_ = 0;
};

}  // namespace

Contender paper(bool repaired) {
    return {repaired ? "paper repaired" : "paper as printed", true, false,
            [repaired](const Task& task) {
                PaperWorld world(task.scene, repaired);
                return step_through(world, task);
            }};
}

}  // namespace osculo::bench
