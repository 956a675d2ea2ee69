// Fuzzes the engines: the bytes choose a scene with everything that is hard, balls that touch or
// nearly do, equal times, extreme masses and speeds, walls they fit between exactly, and its run
// must pass the oracle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "oracle.hpp"

namespace osculo::fuzz {
namespace {

/// Reads choices off the bytes; zeros when they are used up.
class Choices {
public:
    explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    std::size_t below(std::size_t count) {
        if (bytes_.empty()) return 0;
        const std::size_t byte = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return byte % count;
    }
    template <class T, std::size_t N>
    T one_of(const std::array<T, N>& values) {
        return values[below(N)];
    }
    /// In [-1, 1] in 127ths: many are equal, or multiples of each other.
    double coordinate() { return (static_cast<double>(below(255)) - 127) / 127; }

private:
    std::span<const std::uint8_t> bytes_;
};

constexpr std::array kMasses{1.0, 1.0, 2.0, 0.17, 1e-12, 1e12, 3.0};
constexpr std::array kRadii{0.1, 0.1, 0.1, 0.05, 0.2, 1e-6, 0.15};
constexpr std::array kGaps{0.0, 0.0, 1e-17, 1e-16, 1e-12, 1e-9, 1e-4, 1e-2, 0.5};
constexpr std::array kSpeeds{0.0, 0.0, 1.0, 1.0, -1.0, 0.5, 1e-9, 1e3, 1e-150, 1e150};
constexpr std::array kRestitutions{1.0, 1.0, 0.9, 0.5, 0.1, 0.0};
constexpr std::array kFrictions{0.01, 0.2, 0.0, 1.0};
constexpr std::array kDirections{0.0, 1 / 12.0, 1 / 8.0, 1 / 6.0, 1 / 4.0, 1 / 3.0, 1 / 2.0, 0.7};

Point toward(Point from, double turns, double distance) {
    const double angle = turns * 6.283185307179586;
    return {from.x + distance * std::cos(angle), from.y + distance * std::sin(angle)};
}

std::string numbered(const char* name, std::size_t number) {
    return name + std::to_string(number);
}

Ball next_ball(Choices& choices, const std::vector<Ball>& balls) {
    Ball ball;
    ball.id = numbered("b", balls.size());
    ball.mass = choices.one_of(kMasses);
    ball.radius = choices.one_of(kRadii);
    if (!balls.empty() && choices.below(3) != 0) {  // beside another one
        const Ball& other = balls[choices.below(balls.size())];
        ball.position = toward(other.position, choices.one_of(kDirections),
                               other.radius + ball.radius + choices.one_of(kGaps));
    } else {
        ball.position = {choices.coordinate(), choices.coordinate()};
    }
    const double speed = choices.one_of(kSpeeds);
    ball.velocity = toward({}, choices.one_of(kDirections), speed);
    if (choices.below(8) == 0) ball.velocity = {speed * choices.coordinate(), choices.coordinate()};
    return ball;
}

/// A wall that a ball rests at, or a free one.
Segment next_segment(Choices& choices, const Scene& scene) {
    Segment segment{numbered("s", scene.segments.size()), {}, {}, Side::both};
    if (choices.below(2) == 0) segment.side = Side::left;
    if (choices.below(2) == 0) {
        const Ball& ball = scene.balls[choices.below(scene.balls.size())];
        const double turns = choices.one_of(kDirections);
        const Point foot = toward(ball.position, turns, ball.radius + choices.one_of(kGaps));
        segment.from = toward(foot, turns + 0.25, choices.one_of(kGaps) + 0.1);
        segment.to = toward(foot, turns - 0.25, choices.one_of(kRadii));
    } else {
        segment.from = {choices.coordinate(), choices.coordinate()};
        segment.to = {choices.coordinate(), choices.coordinate()};
    }
    return segment;
}

void add_box(Scene& scene, double size) {
    const std::array<Point, 4> corners{
        {{-size, -size}, {size, -size}, {size, size}, {-size, size}}};
    for (std::size_t k = 0; k < 4; ++k) {
        scene.segments.push_back(
            {numbered("box", k), corners[k], corners[(k + 1) % 4], Side::left});
    }
}

/// Friction without a cloth.
void make_discs(Choices& choices, Scene& scene) {
    scene.impacts.ball_ball.law = BallBallLaw::frictional;
    scene.impacts.ball_ball.friction = {choices.one_of(kFrictions), 0, 0};
    if (choices.below(2) == 0) {
        scene.impacts.ball_cushion.law = CushionLaw::frictional;
        scene.impacts.ball_cushion.friction = choices.one_of(kFrictions);
    }
    for (Ball& ball : scene.balls) {
        ball.spin = {0, 0, choices.one_of(kSpeeds)};
        ball.inertia = choices.one_of(std::array{0.4, 0.5, 1.0, 1e-3});
    }
}

void choose_laws(Choices& choices, Scene& scene) {
    scene.impacts.ball_ball.restitution = choices.one_of(kRestitutions);
    scene.impacts.ball_cushion.restitution = choices.one_of(kRestitutions);
    if (choices.below(3) == 0) scene.impacts.simultaneous = Simultaneous::sequential;
    switch (choices.below(6)) {
        case 0: scene.motion = RollingMotion{choices.one_of(kFrictions)}; break;
        case 2:
            scene.motion = ResistedMotion{choices.one_of(kFrictions),
                                          choices.one_of(kFrictions),
                                          choices.one_of(kFrictions),
                                          {}};
            if (choices.below(2) == 0) make_discs(choices, scene);
            break;
        case 3: make_discs(choices, scene); break;
        case 1: {
            scene.motion = ClothMotion{choices.one_of(kFrictions), choices.one_of(kFrictions),
                                       choices.one_of(kFrictions)};
            if (choices.below(2) == 0) {
                scene.impacts.ball_ball.law = BallBallLaw::frictional;
                scene.impacts.ball_ball.friction = {choices.one_of(kFrictions), 0, 0};
            }
            if (choices.below(2) == 0) {
                scene.impacts.ball_cushion.law = CushionLaw::han_2005;
                scene.impacts.ball_cushion.friction = choices.one_of(kFrictions);
                scene.impacts.ball_cushion.height = 0.01;
            }
            for (Ball& ball : scene.balls) {
                ball.spin = {choices.one_of(kSpeeds), choices.one_of(kSpeeds),
                             choices.one_of(kSpeeds)};
            }
            break;
        }
        default: break;
    }
}

/// Holes that pull, where the motion law and the impacts know them.
void choose_pull(Choices& choices, Scene& scene) {
    const bool known = std::holds_alternative<UniformMotion>(scene.motion) ||
                       std::holds_alternative<RollingMotion>(scene.motion);
    if (!known || scene.impacts.ball_ball.law != BallBallLaw::restitution) return;
    // An edge of hundreds of radii is known to fewer digits (README.md).
    const bool fine =
        std::ranges::all_of(scene.balls, [](const Ball& b) { return b.radius > 1e-3; });
    if (!fine) return;
    const RimLaw law = choices.one_of(std::array{RimLaw::capture, RimLaw::paper, RimLaw::tipping});
    if (law == RimLaw::capture) return;
    for (Rim& rim : scene.rims) {
        rim.law = law;
        rim.radius += 0.3;  // no ball is larger
        if (law == RimLaw::tipping) rim.restitution = choices.one_of(kRestitutions);
    }
}

Scene scene_from(std::span<const std::uint8_t> bytes) {
    Choices choices(bytes);
    Scene scene;
    scene.limits.time = 10;
    const std::size_t balls = 1 + choices.below(8);
    for (std::size_t n = 0; n < balls; ++n) scene.balls.push_back(next_ball(choices, scene.balls));
    choose_laws(choices, scene);
    if (choices.below(2) == 0) add_box(scene, 2);
    for (std::size_t n = choices.below(4); n > 0; --n)
        scene.segments.push_back(next_segment(choices, scene));
    for (std::size_t n = choices.below(3); n > 0; --n) {
        scene.arcs.push_back({numbered("a", n),
                              {choices.coordinate(), choices.coordinate()},
                              choices.one_of(kRadii) + choices.one_of(kGaps),
                              choices.coordinate() * 3,
                              0});
        scene.arcs.back().to_angle =
            scene.arcs.back().from_angle + (choices.one_of(kDirections) + 0.05) * 6.28;
    }
    for (std::size_t n = choices.below(3); n > 0; --n) {
        scene.rims.push_back({numbered("r", n),
                              {choices.coordinate(), choices.coordinate()},
                              choices.one_of(kRadii),
                              RimLaw::capture});
    }
    choose_pull(choices, scene);  // the last, for what was there before it was
    return scene;
}

}  // namespace
}  // namespace osculo::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace osculo;
    const Scene scene = fuzz::scene_from({data, size});
    try {
        validate(scene);
    } catch (const SceneError&) {
        return -1;  // balls that overlap: nothing to learn
    }
    fuzz::check_run(scene);
    return 0;
}
