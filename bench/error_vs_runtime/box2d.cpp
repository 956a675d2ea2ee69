#include <algorithm>
#include <cstdint>

#include <box2d/box2d.h>

#include "stepping.hpp"

// Box2D 2.4, single precision. It is made for things of 0.1 to 10 m (its manual), so lengths are
// multiplied by 16. As it comes: continuous collision against what is fixed only, and impacts
// slower than 1 m/s lose their energy. Tuned: every ball a "bullet", no such threshold, edges
// without skin, no sleeping, and lengths multiplied by up to 1024, as far as the 2 m allow that
// Box2D lets a body move in a step: its tolerances (0.005 m) stay what they are, so that they
// matter less. More iterations, no warm starting and no position correction changed nothing.

namespace osculo::bench {
namespace {

constexpr std::uintptr_t kCushionMark = UINTPTR_MAX;

class Box2dWorld : public b2ContactListener {
public:
    Box2dWorld(const Task& task, bool tuned)
        : scene_(task.scene), world_(b2Vec2(0, 0)), balls_(balls_of(scene_)) {
        if (tuned) {
            const double farthest = top_speed() * std::min(task.step, task.times.back());
            scale_ = std::min(kLargestScale, 1.9 / farthest);
        }
        world_.SetContactListener(this);
        world_.SetAllowSleeping(!tuned);
        for (const Segment& segment : scene_.segments) add_edge(segment, tuned);
        // The arcs of tables bulge towards the balls, so that whole disks do.
        for (const Arc& arc : scene_.arcs) add_post(arc, tuned);
        for (std::size_t i = 0; i < balls_.size(); ++i) add_ball(i, tuned);
    }

    void step(double h) {
        now_ += h;
        world_.Step(static_cast<float>(h), 8, 3);
        if (scene_.rims.empty()) return;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!balls_[i].present) continue;
            const b2Vec2 p = bodies_[i]->GetPosition();
            if (!in_a_hole(scene_, p.x / scale_, p.y / scale_)) continue;
            read(i);
            balls_[i].present = false;
            bodies_[i]->SetEnabled(false);
            contacts.push_back({now_, static_cast<int>(i), kRim});
        }
    }

    [[nodiscard]] const std::vector<Moving>& balls() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (balls_[i].present) read(i);
        }
        return balls_;
    }

    void BeginContact(b2Contact* contact) override {
        const std::uintptr_t a = contact->GetFixtureA()->GetUserData().pointer;
        const std::uintptr_t b = contact->GetFixtureB()->GetUserData().pointer;
        if (a == kCushionMark || b == kCushionMark) {
            contacts.push_back({now_, static_cast<int>(std::min(a, b)), kCushion});
        } else {
            add_pair(contacts, now_, a, b);
        }
    }

    std::vector<Contact> contacts;

private:
    static constexpr double kScale = 16;
    static constexpr double kLargestScale = 1024;

    /// What no ball will exceed: not if it had all energy, and among equal balls hardly four times
    /// the speed of the fastest.
    [[nodiscard]] double top_speed() const {
        double energy = 0;
        double fastest = 0;
        double lightest = balls_.front().mass;
        double heaviest = lightest;
        for (const Moving& ball : balls_) {
            const double square = ball.vx * ball.vx + ball.vy * ball.vy;
            energy += ball.mass * square;
            fastest = std::max(fastest, square);
            lightest = std::min(lightest, ball.mass);
            heaviest = std::max(heaviest, ball.mass);
        }
        const double all = std::sqrt(energy / lightest);
        return lightest < heaviest ? all : std::min(all, 4 * std::sqrt(fastest));
    }

    [[nodiscard]] float scaled(double x) const { return static_cast<float>(x * scale_); }

    void add(b2Body* body, const b2Shape& shape, double density, std::uintptr_t mark, bool tuned) {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = static_cast<float>(density);
        fixture.friction = 0;
        fixture.restitution = 1;
        if (tuned) fixture.restitutionThreshold = 0;
        fixture.userData.pointer = mark;
        body->CreateFixture(&fixture);
    }

    void add_edge(const Segment& segment, bool tuned) {
        const b2BodyDef fixed;
        b2EdgeShape edge;
        edge.SetTwoSided({scaled(segment.from.x), scaled(segment.from.y)},
                         {scaled(segment.to.x), scaled(segment.to.y)});
        if (tuned) edge.m_radius = 0;
        add(world_.CreateBody(&fixed), edge, 0, kCushionMark, tuned);
    }

    void add_post(const Arc& arc, bool tuned) {
        b2BodyDef fixed;
        fixed.position.Set(scaled(arc.center.x), scaled(arc.center.y));
        b2CircleShape circle;
        circle.m_radius = scaled(arc.radius);
        add(world_.CreateBody(&fixed), circle, 0, kCushionMark, tuned);
    }

    void add_ball(std::size_t i, bool tuned) {
        const Moving& ball = balls_[i];
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        definition.position.Set(scaled(ball.x), scaled(ball.y));
        definition.linearVelocity.Set(scaled(ball.vx), scaled(ball.vy));
        definition.fixedRotation = true;
        definition.bullet = tuned;
        definition.allowSleep = !tuned;
        b2Body* body = world_.CreateBody(&definition);
        b2CircleShape circle;
        circle.m_radius = scaled(ball.radius);
        const double area = b2_pi * double(circle.m_radius) * double(circle.m_radius);
        add(body, circle, ball.mass / area, i, tuned);
        bodies_.push_back(body);
    }

    void read(std::size_t i) {
        const b2Vec2 p = bodies_[i]->GetPosition();
        const b2Vec2 v = bodies_[i]->GetLinearVelocity();
        balls_[i].x = p.x / scale_;
        balls_[i].y = p.y / scale_;
        balls_[i].vx = v.x / scale_;
        balls_[i].vy = v.y / scale_;
    }

    const Scene& scene_;
    double scale_ = kScale;
    b2World world_;
    std::vector<Moving> balls_;
    std::vector<b2Body*> bodies_;
    double now_ = 0;
};

}  // namespace

Contender box2d(bool tuned) {
    return {tuned ? "Box2D tuned" : "Box2D default", true, false, [tuned](const Task& task) {
                Box2dWorld world(task, tuned);
                return step_through(world, task);
            }};
}

}  // namespace osculo::bench
