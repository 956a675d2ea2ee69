#include "outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace osculo::facade {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}
double cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}
double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}
double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// The angle swept seen from p when going along the polyline [rad].
double swept(const Point& p, const std::vector<Point>& way) {
    double angle = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Point u = way[i - 1] - p;
        const Point v = way[i] - p;
        angle += std::atan2(cross(u, v), dot(u, v));
    }
    return angle;
}

bool inside(const Point& p, const std::vector<Point>& polygon) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point& a = polygon[i];
        const Point& b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * ((p.y - a.y) / (b.y - a.y)) + a.x) {
            in = !in;
        }
    }
    return in;
}

}  // namespace

Point Outline::Shape::nearest(const Point& p) const {
    if (kind == Kind::segment) {
        const Point along = b - a;
        const double s = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
        return {a.x + s * along.x, a.y + s * along.y};
    }
    const Point d = p - a;
    const double length = std::hypot(d.x, d.y);
    if (kind == Kind::disk) {
        if (length <= radius) return p;
        return {a.x + radius * (d.x / length), a.y + radius * (d.y / length)};
    }
    // The angle after from_angle, in [0, 2 pi); outside of the arc, the nearer end.
    double angle = std::fmod(std::atan2(d.y, d.x) - from_angle, kTurn);
    if (angle < 0) angle += kTurn;
    const double sweep = to_angle - from_angle;
    if (angle > sweep) angle = angle - sweep < kTurn - angle ? sweep : 0;
    return {a.x + radius * std::cos(from_angle + angle),
            a.y + radius * std::sin(from_angle + angle)};
}

Point Outline::Shape::anchor() const {
    if (kind != Kind::arc) return a;
    return {a.x + radius * std::cos(from_angle), a.y + radius * std::sin(from_angle)};
}

Point Outline::Shape::middle() const {
    return kind == Kind::segment ? Point{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2} : a;
}

double Outline::Shape::extent() const {
    return kind == Kind::segment ? distance(a, b) * 0.500001 : radius * 1.000001;
}

void Outline::Shape::append_way(const Point& from, const Point& to, double step,
                                std::vector<Point>& way) const {
    way.push_back(from);
    if (kind == Kind::arc) {
        const auto angle_of = [&](const Point& q) {
            const double angle = std::fmod(std::atan2(q.y - a.y, q.x - a.x) - from_angle, kTurn);
            // A hair before the start is the start, not a whole turn later.
            const double sweep = to_angle - from_angle;
            const double positive = angle < 0 ? angle + kTurn : angle;
            return positive > sweep + (kTurn - sweep) / 2 ? 0.0 : std::min(positive, sweep);
        };
        const double start = angle_of(from);
        const double end = angle_of(to);
        const int parts =
            1 + static_cast<int>(std::min(1e4, std::abs(end - start) * radius / step));
        for (int k = 1; k < parts; ++k) {
            const double angle = from_angle + start + (end - start) * k / parts;
            way.push_back({a.x + radius * std::cos(angle), a.y + radius * std::sin(angle)});
        }
    }
    way.push_back(to);
}

Outline::Outline(const Scene& scene, double radius) : radius_(radius) {
    for (const Segment& s : scene.segments) {
        shapes_.push_back({Shape::Kind::segment, s.from, s.to, 0, 0, 0, radius});
    }
    for (const Arc& arc : scene.arcs) {
        // In parts of less than half a turn, so that a full circle is a chain like any other.
        const int parts = 1 + static_cast<int>((arc.to_angle - arc.from_angle) / 2);
        const double step = (arc.to_angle - arc.from_angle) / parts;
        for (int k = 0; k < parts; ++k) {
            shapes_.push_back({Shape::Kind::arc,
                               arc.center,
                               {},
                               arc.radius,
                               arc.from_angle + k * step,
                               arc.from_angle + (k + 1) * step,
                               radius});
        }
    }
    for (const Rim& rim : scene.rims) {
        if (rim.law != RimLaw::capture) continue;  // balls may cross it
        shapes_.push_back({Shape::Kind::disk, rim.center, {}, rim.radius, 0, 0, 0});
    }
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        for (std::size_t j = i + 1; j < shapes_.size(); ++j) join(i, j);
    }
}

/// Looks for two points of the shapes that are near enough, by projecting to and fro from several
/// starts; what it finds are points of the shapes, so it cannot find too small a distance.
void Outline::join(std::size_t i, std::size_t j) {
    const Shape& one = shapes_[i];
    const Shape& other = shapes_[j];
    const double reach = one.reach + other.reach;
    if (distance(one.middle(), other.middle()) > one.extent() + other.extent() + reach) return;
    const auto ends = [](const Shape& s) {
        const double middle = (s.from_angle + s.to_angle) / 2;
        const Point half{s.a.x + s.radius * std::cos(middle), s.a.y + s.radius * std::sin(middle)};
        const Point last{s.a.x + s.radius * std::cos(s.to_angle),
                         s.a.y + s.radius * std::sin(s.to_angle)};
        return s.kind == Shape::Kind::segment ? std::array{s.a, s.b, s.b}
                                              : std::array{s.anchor(), half, last};
    };
    std::vector<Point> starts;
    for (const Point& p : ends(one)) starts.push_back(p);
    for (const Point& p : ends(other)) starts.push_back(one.nearest(p));
    // One joint for each way that is found: two arcs of one circle meet at both ends.
    std::vector<Point> met;
    for (Point p : starts) {
        for (int k = 0; k < 50; ++k) {
            const Point q = other.nearest(p);
            const Point back = one.nearest(q);
            const bool near = distance(back, q) <= reach * (1 - 1e-9);
            if (near || back == p) {
                const bool seen = std::any_of(met.begin(), met.end(), [&](const Point& m) {
                    return distance(m, back) <= radius_;
                });
                if (near && !seen) {
                    met.push_back(back);
                    Joint joint{i, j, {}};
                    one.append_way(one.anchor(), back, radius_ / 2, joint.way);
                    other.append_way(q, other.anchor(), radius_ / 2, joint.way);
                    joints_.push_back(std::move(joint));
                }
                break;
            }
            p = back;
        }
    }
}

bool Outline::encloses(const Point& p) {
    for (const auto& chain : chains_) {
        if (inside(p, chain)) return true;
    }
    auto chain = find_chain(p);
    if (!chain) return false;
    chains_.push_back(std::move(*chain));
    return true;
}

/// Spans every connected part with a tree of joints, noting the angle swept seen from p; a joint
/// that closes a loop with a whole turn winds round p.
std::optional<std::vector<Point>> Outline::find_chain(const Point& p) const {
    struct Node {
        bool seen = false;
        double angle = 0;
        std::size_t parent = 0;
        std::vector<Point> way;  ///< from the parent's anchor to this one's; empty for a root
    };
    std::vector<Node> nodes(shapes_.size());
    std::vector<std::vector<std::size_t>> joints_of(shapes_.size());
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        joints_of[joints_[k].one].push_back(k);
        joints_of[joints_[k].other].push_back(k);
    }
    // The way from a node back to its root.
    const auto append_way_home = [&](std::size_t i, std::vector<Point>& chain) {
        for (; !nodes[i].way.empty(); i = nodes[i].parent) {
            chain.insert(chain.end(), nodes[i].way.rbegin(), nodes[i].way.rend());
        }
    };
    for (std::size_t root = 0; root < nodes.size(); ++root) {
        if (nodes[root].seen) continue;
        nodes[root].seen = true;
        std::vector<std::size_t> open{root};
        for (std::size_t head = 0; head < open.size(); ++head) {
            const std::size_t i = open[head];
            for (const std::size_t k : joints_of[i]) {
                std::vector<Point> way = joints_[k].way;
                std::size_t j = joints_[k].other;
                if (j == i) {
                    std::reverse(way.begin(), way.end());
                    j = joints_[k].one;
                }
                const double angle = nodes[i].angle + swept(p, way);
                if (!nodes[j].seen) {
                    nodes[j] = {true, angle, i, std::move(way)};
                    open.push_back(j);
                } else if (std::abs(angle - nodes[j].angle) > kTurn / 2) {
                    std::vector<Point> chain;
                    append_way_home(i, chain);
                    std::reverse(chain.begin(), chain.end());
                    chain.insert(chain.end(), way.begin(), way.end());
                    append_way_home(j, chain);
                    return chain;
                }
            }
        }
    }
    return std::nullopt;
}

}  // namespace osculo::facade
