#pragma once

#include <algorithm>
#include <numeric>

#include "osculo/engine/audit/pieces.hpp"
#include "osculo/engine/audit/resisted.hpp"
#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/smallest_gap.hpp"

namespace osculo::engine::detail {

/// Measures the smallest gap of every ball with everything else, over every stretch of time.
template <class Type>
class GapAudit {
public:
    using S = typename Type::Scalar;
    using Wide = math::Wide<S>;
    using Piece = PieceOf<Type>;

    GapAudit(const SceneData<Type>& scene, const std::vector<S>& path, RunAudit& result)
        : scene_(scene), path_(path), result_(result) {
        measure_boxes(std::make_index_sequence<kKinds>{});
    }

    /// Takes the pieces in order of their beginnings: when one begins, those of the other balls
    /// that are not over yet are known, so that every two meet once.
    void check(const std::vector<Piece>& pieces) {
        std::vector<std::size_t> order(pieces.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return pieces[a].from < pieces[b].from;
        });
        const std::size_t balls = scene_.bodies.size();
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        const Box nowhere{kInfinity, -kInfinity, kInfinity, -kInfinity};
        std::vector<Box> boxes(balls, nowhere);
        std::vector<const Piece*> current(balls, nullptr);

        for (const std::size_t p : order) {
            const Piece& piece = pieces[p];
            const BallIndex i = piece.ball;
            const Box box = box_of(piece);
            current[i] = nullptr;
            for (BallIndex j = 0; j < balls; ++j) {
                if (boxes[j].apart(within_reach(box, i)) || current[j] == nullptr) continue;
                check_pair(piece, *current[j]);
            }
            boxes[i] = box;
            current[i] = &piece;
            check_obstacles(piece, box, std::make_index_sequence<kKinds>{});
        }
    }

private:
    static constexpr std::size_t kKinds = Type::ObstacleList::kCount;

    /// Around everything the ball covers during the piece.
    Box box_of(const Piece& piece) const {
        const double radius = math::to_double<S>(scene_.bodies[piece.ball].radius);
        return box_around(stretch(piece, piece.from, piece.to))
            .grown(radius * (1 + 4 * math::epsilon<double>()) +
                   math::to_double<S>(deviation_of(piece, piece.from, piece.to)));
    }
    /// How far the piece may be from its stretch.
    static S deviation_of(const Piece& piece, const math::Instant<S>& start,
                          const math::Instant<S>& end) {
        if constexpr (requires { deviation(piece, start, end); }) {
            return deviation(piece, start, end);
        } else {
            return S(0);
        }
    }
    /// What to do with a gap that is only known to within a deviation: if it is as good as known,
    /// take it; if it cannot be the smallest, leave it; else look at its halves.
    enum class Sure { enough, no_matter, not_yet };
    Sure sure_of(const S& gap, const S& deviation, const S& reach, const S& smaller) const {
        constexpr double kShare = 1e-6;  // of a gap that is none of a contact
        // Nor is a deviation that is no number halved for ever.
        if (!(deviation > math::epsilon<S>() * reach) || deviation <= S(kShare) * gap) {
            return Sure::enough;
        }
        const double least = math::to_double<S>((gap - deviation) / smaller);
        return least > std::max(0.0, result_.worst_gap) ? Sure::no_matter : Sure::not_yet;
    }
    static math::Instant<S> middle(const math::Instant<S>& start, const math::Instant<S>& end) {
        return start + math::duration<S>(start, end) / S(2);
    }
    /// With room for every gap smaller than the smallest one yet.
    Box within_reach(const Box& box, BallIndex i) const {
        return box.grown(std::max(0.0, result_.worst_gap) *
                         math::to_double<S>(scene_.bodies[i].radius));
    }

    void check_pair(const Piece& a, const Piece& b) {
        const math::Instant<S> start = std::max(a.from, b.from);
        const math::Instant<S> end = std::min(a.to, b.to);
        if (end < start) return;
        check_pair(a, b, start, end);
    }
    void check_pair(const Piece& a, const Piece& b, const math::Instant<S>& start,
                    const math::Instant<S>& end) {
        const Body<Type>& one = scene_.bodies[a.ball];
        const Body<Type>& other = scene_.bodies[b.ball];
        const Wide reach = math::wide_sum<S>(one.radius, other.radius);
        const auto path = seen_from(stretch(a, start, end), stretch(b, start, end));
        const S smaller = std::min<S>(one.radius, other.radius);
        const S off = deviation_of(a, start, end) + deviation_of(b, start, end);
        const double far = (math::to_double<S>(math::narrow(reach)) + math::to_double<S>(off) +
                            std::max(0.0, result_.worst_gap) * math::to_double<S>(smaller)) *
                           (1 + 4 * math::epsilon<double>());
        if (box_around(path).apart({-far, far, -far, far})) return;
        const GapAt<S> gap = smallest_distance_beyond<S>(path, reach);
        const Sure sure = sure_of(gap.gap, off, math::narrow(reach), smaller);
        if (sure == Sure::no_matter) return;
        const math::Instant<S> half = middle(start, end);
        if (sure == Sure::not_yet && start < half && half < end) {
            check_pair(a, b, start, half);
            check_pair(a, b, half, end);
            return;
        }
        const auto initial = [&] {
            return length_beyond<S>(seen_from(one.state.position, other.state.position), reach);
        };
        const S speed =
            math::norm1<S>(beginning(a).velocity) + math::norm1<S>(beginning(b).velocity);
        note(gap, smaller, math::narrow(reach), S(path_[a.ball] + path_[b.ball]), speed, a, start,
             {kBallBall, b.ball}, beginning(b).position.rounded(), initial);
    }

    template <std::size_t... K>
    void measure_boxes(std::index_sequence<K...>) {
        [[maybe_unused]] const auto measure = [](const auto& obstacles, std::vector<Box>& boxes) {
            for (const auto& obstacle : obstacles) boxes.push_back(box_around(obstacle));
        };
        (measure(std::get<K>(scene_.obstacles), obstacle_boxes_[K]), ...);
    }

    template <std::size_t... K>
    void check_obstacles(const Piece& piece, const Box& box, std::index_sequence<K...>) {
        (check_obstacles_of_kind<K>(piece, box), ...);
    }

    template <std::size_t K>
    void check_obstacles_of_kind(const Piece& piece, const Box& box) {
        const auto& obstacles = std::get<K>(scene_.obstacles);
        for (std::uint32_t k = 0; k < obstacles.size(); ++k) {
            if (obstacle_boxes_[K][k].apart(within_reach(box, piece.ball))) continue;
            check_obstacle<K>(piece, k, piece.from, piece.to);
        }
    }

    template <std::size_t K>
    void check_obstacle(const Piece& piece, std::uint32_t k, const math::Instant<S>& start,
                        const math::Instant<S>& end) {
        const Body<Type>& body = scene_.bodies[piece.ball];
        const auto& obstacle = std::get<K>(scene_.obstacles)[k];
        if constexpr (kEffect<std::decay_t<decltype(obstacle)>> == Effect::entry) {
            if (piece.state.stay) return;  // it may be inside
        }
        const auto path = stretch(piece, start, end, origin(obstacle));
        const GapAt<S> gap = smallest_gap(path, body.radius, obstacle);
        const S reach = body.radius + contact_reach(obstacle);
        const Sure sure = sure_of(gap.gap, deviation_of(piece, start, end), reach, body.radius);
        if (sure == Sure::no_matter) return;
        const math::Instant<S> half = middle(start, end);
        if (sure == Sure::not_yet && start < half && half < end) {
            check_obstacle<K>(piece, k, start, half);
            check_obstacle<K>(piece, k, half, end);
            return;
        }
        const auto initial = [&] {
            return contact_gap(seen_from(body.state.position, origin(obstacle)), body.radius,
                               obstacle);
        };
        note(gap, body.radius, reach, path_[piece.ball], math::norm1<S>(beginning(piece).velocity),
             piece, start, {kFirstObstacle + static_cast<Kind>(K), k}, origin(obstacle), initial);
    }

    /// [speed]: of both, together. [initial] gives the gap of the two at the start of the run: a
    /// scene may start with a small overlap, which is theirs until they are apart.
    template <class InitialGap>
    void note(const GapAt<S>& found, const S& smaller_radius, const S& reach, const S& path,
              const S& speed, const Piece& piece, const math::Instant<S>& start, Thing other,
              const math::Vec<S>& from, InitialGap initial) {
        const double share = math::to_double<S>(found.gap / smaller_radius);
        if (!(share >= result_.worst_gap)) {
            result_.worst_gap = share;
            result_.worst_gap_time = math::to_double<S>(math::narrow(Wide(start + found.t)));
            result_.worst_first = {kBallBall, piece.ball};
            result_.worst_second = other;
        }
        if (found.gap >= S(0)) return;
        const S allowed = std::clamp<S>(-initial(), S(0), S(math::kStartOverlap) * smaller_radius);
        const S bound = allowed + gap_bound<S>(reach, path) +
                        resolution<S>(beginning(piece).position, speed, piece.to, from);
        result_.clean = result_.clean && found.gap >= -bound;
    }

    const SceneData<Type>& scene_;
    const std::vector<S>& path_;
    RunAudit& result_;
    std::array<std::vector<Box>, kKinds> obstacle_boxes_;
};

}  // namespace osculo::engine::detail
