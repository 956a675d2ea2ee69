#include "stick.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "compile_cue.hpp"
#include "osculo/math/trigonometry.hpp"
#include "text.hpp"

namespace osculo::facade {
namespace {

// Heights that differ by less than this are equal: far more than rounding, far less than anyone
// could see [m].
constexpr double kSlack = 1e-12;

struct Place {
    double x, y, z;
};

Place operator-(const Place& a, const Place& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Place& a, const Place& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

class Stick {
public:
    Stick(const Cue& cue, const Ball& ball, double elevation) {
        const auto [sin_azimuth, cos_azimuth] = math::sin_cos<double>(cue.azimuth);
        const auto [sin_elevation, cos_elevation] = math::sin_cos<double>(elevation);
        sine_ = sin_elevation;
        cosine_ = cos_elevation;
        back_ = {-cosine_ * cos_azimuth, -cosine_ * sin_azimuth, sine_};
        // The tip meets the ball at a to the left, b up and the rest back, as seen along the stick.
        const auto [a, b] = cue.offset;
        const double c = std::sqrt(std::max(0.0, 1 - a * a - b * b));
        const double r = ball.radius;
        tip_ = {ball.position.x + r * (-a * sin_azimuth + b * sine_ * cos_azimuth + c * back_.x),
                ball.position.y + r * (a * cos_azimuth + b * sine_ * sin_azimuth + c * back_.y),
                r + r * (b * cosine_ + c * back_.z)};
    }

    [[nodiscard]] bool hits(const Ball& ball) const {
        const Place center{ball.position.x, ball.position.y, ball.radius};
        const double along = std::clamp(dot(center - tip_, back_), 0.0, kStickLength);
        const Place nearest{tip_.x + along * back_.x, tip_.y + along * back_.y,
                            tip_.z + along * back_.z};
        const Place between = center - nearest;
        return std::sqrt(dot(between, between)) < ball.radius + kStickRadius - kSlack;
    }

    [[nodiscard]] bool hits(const Segment& s, double nose) const {
        // tip + t back = from + u along, in the plane.
        const Point along{s.to.x - s.from.x, s.to.y - s.from.y};
        const Point d{s.from.x - tip_.x, s.from.y - tip_.y};
        const double determinant = back_.x * along.y - back_.y * along.x;
        if (determinant == 0) return false;
        const double t = (d.x * along.y - d.y * along.x) / determinant;
        const double u = (d.x * back_.y - d.y * back_.x) / determinant;
        return u >= 0 && u <= 1 && is_low(t, nose);
    }

    [[nodiscard]] bool hits(const Arc& arc, double nose) const {
        // |tip + t back - center| = radius, in the plane.
        const Point d{tip_.x - arc.center.x, tip_.y - arc.center.y};
        const double a = cosine_ * cosine_;
        const double b = d.x * back_.x + d.y * back_.y;
        const double discriminant = b * b - a * (d.x * d.x + d.y * d.y - arc.radius * arc.radius);
        if (!(discriminant >= 0)) return false;
        const std::array ways{(-b - std::sqrt(discriminant)) / a,
                              (-b + std::sqrt(discriminant)) / a};
        return std::ranges::any_of(ways, [&](double t) {
            constexpr double kTurn = 2 * std::numbers::pi;
            const double angle = std::atan2(d.y + t * back_.y, d.x + t * back_.x);
            double after = std::fmod(angle - arc.from_angle, kTurn);
            if (after < 0) after += kTurn;
            return after <= arc.to_angle - arc.from_angle && is_low(t, nose);
        });
    }

private:
    // Whether it has something at the distance t along its axis, and there is lower than the nose.
    [[nodiscard]] bool is_low(double t, double nose) const {
        if (t < 0 || t > kStickLength) return false;
        const double underside = tip_.z + t * sine_ - kStickRadius / cosine_;
        return underside < nose - kSlack;
    }

    double sine_ = 0;
    double cosine_ = 1;
    Place back_{};  // unit vector from the tip along the axis
    Place tip_{};
};

const Ball* struck_ball(const Scene& scene) {
    if (!scene.cue || !(std::abs(scene.cue->azimuth) <= kMostAzimuth) ||
        compile_cue<double>(*scene.cue).fault() != impact::StrikeFault::none) {
        return nullptr;
    }
    const auto ball = std::ranges::find(scene.balls, scene.cue->ball, &Ball::id);
    return ball == scene.balls.end() ? nullptr : &*ball;
}

// The first thing that is hit.
template <class Thing, class Hits>
std::optional<std::string> find_hit(const std::vector<Thing>& things, const char* list, Hits hits) {
    const auto hit = std::ranges::find_if(things, hits);
    if (hit == things.end()) return std::nullopt;
    return concatenated(list, "[", std::to_string(hit - things.begin()), "] (\"", hit->id, "\")");
}

}  // namespace

std::optional<std::string> find_obstruction(const Scene& scene, double elevation) {
    const Ball* const ball = struck_ball(scene);
    if (ball == nullptr) return std::nullopt;
    const Stick stick(*scene.cue, *ball, elevation);
    const CushionImpact& cushion = scene.impacts.ball_cushion;
    const bool is_known = cushion.law != CushionLaw::restitution;
    const double nose = is_known ? cushion.height : 1.28 * ball->radius;

    auto hit = find_hit(scene.balls, "balls",
                        [&](const Ball& other) { return &other != ball && stick.hits(other); });
    if (hit) return hit;
    hit = find_hit(scene.segments, "segments",
                   [&](const Segment& segment) { return stick.hits(segment, nose); });
    if (hit) return hit;
    return find_hit(scene.arcs, "arcs", [&](const Arc& arc) { return stick.hits(arc, nose); });
}

}  // namespace osculo::facade

namespace osculo {

std::optional<double> least_elevation(const Scene& scene) {
    // In steps of a milliradian, so that no rounding shows; a right angle has 1570.8 of them.
    for (int step = 0; step <= 1570; ++step) {
        const double elevation = step / 1000.0;
        if (!facade::find_obstruction(scene, elevation)) return elevation;
    }
    return std::nullopt;
}

}  // namespace osculo
