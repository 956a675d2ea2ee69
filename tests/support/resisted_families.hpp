#pragma once

#include <optional>

#include "osculo/motion/resisted.hpp"
#include "support/random.hpp"
#include "support/scalars.hpp"

/// Pairs of balls with drag (the families of NUMERICS 2.2), and when they first meet, by sampling
/// and bisection in many digits.
namespace osculo::support {

struct ResistedPair {
    motion::ResistedPath<double> first, second;
    double reach;
    double end;  ///< of the search
};

enum class ResistedFamily { billiard, linear, linear_rolling, strong, stiff, chase };
inline constexpr int kResistedFamilies = 6;

[[nodiscard]] inline motion::ResistedPath<double> resisted_path(
    const math::Vec<double>& position, const math::Vec<double>& velocity,
    const motion::Resistance<double>& law) {
    motion::Resisted::State<double> state;
    state.position = math::WidePoint<double>(position);
    state.velocity = velocity;
    state.law = law;
    motion::Resisted::begin<double>({}, state);
    return motion::Resisted::path<double>(state);
}

[[nodiscard]] inline motion::Resistance<double> random_resistance(ResistedFamily family,
                                                                  Random& random) {
    const auto of_order = [&](double low, double high) {
        return std::pow(10.0, random.uniform<double>(low, high));
    };
    const double rolling = random.uniform<double>(0.05, 0.2);
    switch (family) {
        case ResistedFamily::billiard:
        case ResistedFamily::chase: return {rolling, 0, random.uniform<double>(0.002, 0.009)};
        case ResistedFamily::linear: return {0, of_order(-3, 1), 0};
        case ResistedFamily::linear_rolling: return {rolling, of_order(-3, 1), 0};
        case ResistedFamily::strong: return {random.coin() ? rolling : 0, 0, of_order(-1, 1.7)};
        case ResistedFamily::stiff: return {rolling, of_order(0, 3), of_order(-2, 1)};
    }
    return {};
}

/// Every third pair is aimed, every third grazes by up to 1e-12 of its reach or passes as near.
[[nodiscard]] inline ResistedPair random_pair(ResistedFamily family, int round, Random& random) {
    using Vec = math::Vec<double>;
    const double reach = random.uniform<double>(0.04, 0.08);
    const Vec velocity = random.direction<double>() * random.uniform<double>(0.2, 8);
    Vec other = random.direction<double>() * random.uniform<double>(0.2, 8);
    if (family == ResistedFamily::chase) other = velocity * random.uniform<double>(0.8, 1.2);
    const Vec origin(0, 0);
    ResistedPair pair{resisted_path(origin, velocity, random_resistance(family, random)),
                      resisted_path(origin, other, random_resistance(family, random)), reach, 0};
    pair.end = std::min({pair.first.end, pair.second.end, 20.0});
    const double shortest = 1 / (1 / pair.end + pair.first.slowing.k + pair.second.slowing.k);
    const double t = shortest * random.unit<double>();
    const auto one = pair.first.at(t);
    const auto two = pair.second.at(t);
    const Vec relative = one.velocity - two.velocity;
    Vec side = random.direction<double>();
    double distance = random.uniform<double>(0, 6) * reach;
    if (round % 3 != 0) {
        const double speed = math::norm<double>(relative);
        if (speed > 0) side = Vec(-relative.y(), relative.x()) / speed;
        const double depth = std::pow(10.0, random.uniform<double>(-12, -3));
        distance = round % 3 == 1 ? reach * random.uniform<double>(-1, 1)
                                  : reach * (random.coin() ? 1 - depth : 1 + depth);
    }
    const Vec apart = one.position.rounded() - two.position.rounded();
    pair.second.position = math::WidePoint<double>(Vec(apart + distance * side));
    return pair;
}

/// The gap function and half its slope of a pair, in S.
template <math::Scalar S>
class PairGap {
public:
    explicit PairGap(const ResistedPair& pair)
        : first_(law(pair.first)), second_(law(pair.second)), pair_(pair) {}

    struct Value {
        S gap, slope;
    };
    [[nodiscard]] Value operator()(const S& t) const {
        const auto one = first_.after(t);
        const auto two = second_.after(t);
        S gap = -S(pair_.reach) * S(pair_.reach);
        S slope(0);
        for (int i = 0; i < 2; ++i) {
            const S v1(pair_.first.velocity[i]);
            const S v2(pair_.second.velocity[i]);
            const S c = coordinate(pair_.first, i) - coordinate(pair_.second, i);
            const S x = c + v1 * one.sigma - v2 * two.sigma;
            gap += x * x;
            slope += x * (v1 * one.q - v2 * two.q);
        }
        return {gap, slope};
    }

private:
    [[nodiscard]] static motion::Slowing<S> law(const motion::ResistedPath<double>& path) {
        return {S(path.slowing.m), S(path.slowing.k), S(path.slowing.c)};
    }
    [[nodiscard]] static S coordinate(const motion::ResistedPath<double>& path, int i) {
        const auto& x = i == 0 ? path.position.x : path.position.y;
        return S(x.hi) + S(x.lo);
    }

    motion::Slowing<S> first_, second_;
    const ResistedPair& pair_;
};

struct PairMeeting {
    std::optional<Digits50> time;
    /// The smallest size of a gap at a turn before then, in reaches: how close the decision was.
    double closest = 1e300;
};

/// When the pair first meets. [samples]: its distance turns at most once between two of them.
[[nodiscard]] inline PairMeeting first_meeting(const ResistedPair& pair, int samples) {
    const PairGap<long double> rough(pair);
    const PairGap<Digits50> exact(pair);
    const auto share = [&](int n) {  // denser where the balls are fast
        const long double x = static_cast<long double>(n) / static_cast<long double>(samples);
        return static_cast<long double>(pair.end) * x * x;
    };
    const auto bisect = [&](Digits50 low, Digits50 high, auto below) {
        for (int i = 0; i < 100; ++i) {
            const Digits50 middle = (low + high) / 2;
            (below(middle) ? high : low) = middle;
        }
        return high;
    };
    PairMeeting meeting;
    const double square = pair.reach * pair.reach;
    Digits50 from(0);
    auto before = rough(0);
    for (int n = 1; n <= samples; ++n) {
        const long double t = share(n);
        const auto now = rough(t);
        // A minimum in between, or the gap already closed.
        const bool turns = before.slope < 0 && now.slope >= 0;
        const bool near = now.gap < 1e-9L * square || turns;
        before = now;
        if (!near) {
            from = Digits50(t);
            continue;
        }
        Digits50 to(t);
        if (turns) to = bisect(from, to, [&](const Digits50& x) { return exact(x).slope >= 0; });
        const Digits50 least = exact(to).gap;
        if (turns) {
            meeting.closest =
                std::min(meeting.closest, std::abs(static_cast<double>(least)) / square);
        }
        if (least < 0) {
            meeting.time = bisect(from, to, [&](const Digits50& x) { return exact(x).gap < 0; });
            return meeting;
        }
        from = Digits50(t);
    }
    const double last = std::abs(static_cast<double>(exact(Digits50(pair.end)).gap)) / square;
    meeting.closest = std::min(meeting.closest, last);
    return meeting;
}

}  // namespace osculo::support
