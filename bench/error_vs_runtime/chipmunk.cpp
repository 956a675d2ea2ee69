#include <cstdint>
#include <memory>

#include <chipmunk/chipmunk.h>

#include "stepping.hpp"

// Chipmunk 7, double precision. As it comes, it allows overlaps of 0.1 and pushes out what is
// deeper: it is made for lengths in pixels, so it is given millimetres. Tuned: no overlap allowed
// and nothing pushed out (which would add energy), metres.

namespace osculo::bench {
namespace {

constexpr cpCollisionType kBallType = 1;
constexpr cpCollisionType kCushionType = 2;

struct FreeSpace {
    void operator()(cpSpace* space) const { cpSpaceFree(space); }
};
struct FreeBody {
    void operator()(cpBody* body) const { cpBodyFree(body); }
};
struct FreeShape {
    void operator()(cpShape* shape) const { cpShapeFree(shape); }
};

std::size_t number_of(const cpShape* shape) {
    return reinterpret_cast<std::uintptr_t>(cpShapeGetUserData(shape));
}

class ChipmunkWorld {
public:
    ChipmunkWorld(const Scene& scene, bool tuned)
        : scene_(scene), scale_(tuned ? 1 : 1000), balls_(balls_of(scene)), space_(cpSpaceNew()) {
        if (tuned) {
            cpSpaceSetCollisionSlop(space_.get(), 0);
            cpSpaceSetCollisionBias(space_.get(), 1);
        }
        cpBody* ground = cpSpaceGetStaticBody(space_.get());
        for (const Segment& segment : scene.segments) {
            add(cpSegmentShapeNew(ground, scaled(segment.from.x, segment.from.y),
                                  scaled(segment.to.x, segment.to.y), 0),
                kCushionType);
        }
        // The arcs of tables bulge towards the balls, so that whole disks do.
        for (const Arc& arc : scene.arcs) {
            add(cpCircleShapeNew(ground, scale_ * arc.radius, scaled(arc.center.x, arc.center.y)),
                kCushionType);
        }
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const Moving& ball = balls_[i];
            bodies_.emplace_back(cpBodyNew(ball.mass, INFINITY));
            cpBody* body = cpSpaceAddBody(space_.get(), bodies_.back().get());
            cpBodySetPosition(body, scaled(ball.x, ball.y));
            cpBodySetVelocity(body, scaled(ball.vx, ball.vy));
            cpShape* shape = add(cpCircleShapeNew(body, scale_ * ball.radius, cpvzero), kBallType);
            cpShapeSetUserData(shape, reinterpret_cast<cpDataPointer>(std::uintptr_t(i)));
        }
        listen(kCushionType, [](cpArbiter* arbiter, cpSpace*, cpDataPointer self) -> cpBool {
            cpShape *ball = nullptr, *cushion = nullptr;
            cpArbiterGetShapes(arbiter, &ball, &cushion);
            auto* world = static_cast<ChipmunkWorld*>(self);
            world->contacts.push_back({world->now_, static_cast<int>(number_of(ball)), kCushion});
            return cpTrue;
        });
        listen(kBallType, [](cpArbiter* arbiter, cpSpace*, cpDataPointer self) -> cpBool {
            cpShape *a = nullptr, *b = nullptr;
            cpArbiterGetShapes(arbiter, &a, &b);
            auto* world = static_cast<ChipmunkWorld*>(self);
            add_pair(world->contacts, world->now_, number_of(a), number_of(b));
            return cpTrue;
        });
    }

    ChipmunkWorld(const ChipmunkWorld&) = delete;
    ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

    ~ChipmunkWorld() {
        // The space must forget things before they are freed.
        for (const auto& shape : shapes_) {
            if (cpSpaceContainsShape(space_.get(), shape.get())) {
                cpSpaceRemoveShape(space_.get(), shape.get());
            }
        }
        for (const auto& body : bodies_) {
            if (cpSpaceContainsBody(space_.get(), body.get())) {
                cpSpaceRemoveBody(space_.get(), body.get());
            }
        }
    }

    void step(double h) {
        now_ += h;
        cpSpaceStep(space_.get(), h);
        if (scene_.rims.empty()) return;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (!balls_[i].present) continue;
            const cpVect p = cpBodyGetPosition(bodies_[i].get());
            if (!in_a_hole(scene_, p.x / scale_, p.y / scale_)) continue;
            read(i);
            balls_[i].present = false;
            cpSpaceRemoveShape(space_.get(), shapes_[shapes_.size() - bodies_.size() + i].get());
            cpSpaceRemoveBody(space_.get(), bodies_[i].get());
            contacts.push_back({now_, static_cast<int>(i), kRim});
        }
    }

    [[nodiscard]] const std::vector<Moving>& balls() {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (balls_[i].present) read(i);
        }
        return balls_;
    }

    std::vector<Contact> contacts;

private:
    [[nodiscard]] cpVect scaled(double x, double y) const { return cpv(scale_ * x, scale_ * y); }

    cpShape* add(cpShape* shape, cpCollisionType type) {
        shapes_.emplace_back(shape);
        cpShapeSetElasticity(shape, 1);
        cpShapeSetFriction(shape, 0);
        cpShapeSetCollisionType(shape, type);
        return cpSpaceAddShape(space_.get(), shape);
    }

    void listen(cpCollisionType other, cpCollisionBeginFunc begin) {
        cpCollisionHandler* handler = cpSpaceAddCollisionHandler(space_.get(), kBallType, other);
        handler->beginFunc = begin;
        handler->userData = this;
    }

    void read(std::size_t i) {
        const cpVect p = cpBodyGetPosition(bodies_[i].get());
        const cpVect v = cpBodyGetVelocity(bodies_[i].get());
        balls_[i].x = p.x / scale_;
        balls_[i].y = p.y / scale_;
        balls_[i].vx = v.x / scale_;
        balls_[i].vy = v.y / scale_;
    }

    const Scene& scene_;
    double scale_;
    std::vector<Moving> balls_;
    std::unique_ptr<cpSpace, FreeSpace> space_;
    std::vector<std::unique_ptr<cpBody, FreeBody>> bodies_;
    std::vector<std::unique_ptr<cpShape, FreeShape>> shapes_;
    double now_ = 0;
};

}  // namespace

Contender chipmunk(bool tuned) {
    return {tuned ? "Chipmunk tuned" : "Chipmunk default", true, false, [tuned](const Task& task) {
                ChipmunkWorld world(task.scene, tuned);
                return step_through(world, task);
            }};
}

}  // namespace osculo::bench
