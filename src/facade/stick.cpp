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
    if (!scene.cue || !(std::abs(scene.cue->azimuth) <= kLargestAzimuth) ||
        compile_cue<double>(*scene.cue).fault() != impact::StrikeFault::none) {
        return nullptr;
    }
    const auto ball = std::ranges::find(scene.balls, scene.cue->ball, &Ball::id);
    return ball == scene.balls.end() ? nullptr : &*ball;
}

/// Something in the way of the stick: where it is in which list of the scene.
struct Obstruction {
    enum class List { balls, segments, arcs } list;
    std::size_t index;
};

/// What a stick of the scene's cue could meet.
class Surroundings {
public:
    Surroundings(const Scene& scene, const Ball& struck)
        : scene_(scene),
          struck_(struck),
          nose_(scene.impacts.ball_cushion.law != CushionLaw::restitution
                    ? scene.impacts.ball_cushion.height
                    : 1.28 * struck.radius) {}

    [[nodiscard]] Stick stick(double elevation) const {
        return Stick(*scene_.cue, struck_, elevation);
    }

    [[nodiscard]] bool is_hit(const Stick& stick, const Obstruction& by) const {
        switch (by.list) {
            case Obstruction::List::balls: {
                const Ball& other = scene_.balls[by.index];
                return &other != &struck_ && stick.hits(other);
            }
            case Obstruction::List::segments: return stick.hits(scene_.segments[by.index], nose_);
            case Obstruction::List::arcs: return stick.hits(scene_.arcs[by.index], nose_);
        }
        return false;
    }

    /// The first thing that is hit.
    [[nodiscard]] std::optional<Obstruction> find_hit(const Stick& stick) const {
        const auto find_in = [&](Obstruction::List list,
                                 std::size_t size) -> std::optional<Obstruction> {
            for (std::size_t k = 0; k < size; ++k) {
                if (is_hit(stick, {list, k})) return Obstruction{list, k};
            }
            return std::nullopt;
        };
        auto hit = find_in(Obstruction::List::balls, scene_.balls.size());
        if (!hit) hit = find_in(Obstruction::List::segments, scene_.segments.size());
        if (!hit) hit = find_in(Obstruction::List::arcs, scene_.arcs.size());
        return hit;
    }

    /// segments[2] ("top")
    [[nodiscard]] std::string name(const Obstruction& hit) const {
        const auto name_in = [&](const char* list, const auto& things) {
            return concatenated(list, "[", std::to_string(hit.index), "] (\"", things[hit.index].id,
                                "\")");
        };
        switch (hit.list) {
            case Obstruction::List::balls: return name_in("balls", scene_.balls);
            case Obstruction::List::segments: return name_in("segments", scene_.segments);
            case Obstruction::List::arcs: return name_in("arcs", scene_.arcs);
        }
        return {};
    }

private:
    const Scene& scene_;
    const Ball& struck_;
    double nose_;
};

}  // namespace

std::optional<std::string> find_obstruction(const Scene& scene, double elevation) {
    const Ball* const ball = struck_ball(scene);
    if (ball == nullptr) return std::nullopt;
    const Surroundings surroundings(scene, *ball);
    const auto hit = surroundings.find_hit(surroundings.stick(elevation));
    if (!hit) return std::nullopt;
    return surroundings.name(*hit);
}

bool is_obstructed(const Scene& scene, double elevation) {
    const Ball* const ball = struck_ball(scene);
    if (ball == nullptr) return false;
    const Surroundings surroundings(scene, *ball);
    return surroundings.find_hit(surroundings.stick(elevation)).has_value();
}

}  // namespace osculo::facade

namespace osculo {

std::optional<double> least_elevation(const Scene& scene) {
    const Ball* const ball = facade::struck_ball(scene);
    if (ball == nullptr) return 0;
    const facade::Surroundings surroundings(scene, *ball);
    // In steps of a milliradian, so that no rounding shows; a right angle has 1570.8 of them. What
    // was in the way is looked at first: mostly it still is.
    std::optional<facade::Obstruction> hit;
    for (int step = 0; step <= 1570; ++step) {
        const double elevation = step / 1000.0;
        const auto stick = surroundings.stick(elevation);
        if (hit && surroundings.is_hit(stick, *hit)) continue;
        hit = surroundings.find_hit(stick);
        if (!hit) return elevation;
    }
    return std::nullopt;
}

}  // namespace osculo
