#pragma once

#include "osculo/engine/audit/pieces.hpp"
#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/smallest_gap.hpp"

namespace osculo::engine::detail {

/// Follows every ball from its initial to its final state through its pieces and events.
template <class Type>
class HistoryAudit {
public:
    using S = typename Type::Scalar;
    using Instant = math::Instant<S>;
    using Vec = math::Vec<S>;
    using Piece = PieceRecord<S>;
    using Event = EventRecord<S>;

    HistoryAudit(const SceneData<Type>& scene, const std::vector<Piece>& pieces)
        : scene_(scene), histories_(scene.bodies.size()) {
        for (std::size_t i = 0; i < histories_.size(); ++i) {
            histories_[i].position = scene.bodies[i].state.position;
            histories_[i].velocity = scene.bodies[i].state.velocity;
        }
        for (const Piece& piece : pieces) histories_[piece.ball].pieces.push_back(&piece);
    }

    /// To be called for the events in the order of the record.
    void follow(const Event& event, RunAudit& result) {
        if (event.when < last_event_) ++result.unexplained;
        last_event_ = event.when;
        follow(event, 0, event.first, result);
        if (event.kind == kBallBall) follow(event, 1, event.second, result);
    }

    /// To be called after the last event.
    void finish(const std::vector<Body<Type>>& final_bodies, const Instant& end, RunAudit& result) {
        for (BallIndex i = 0; i < histories_.size(); ++i) {
            History& history = histories_[i];
            if (!history.captured) {
                take_pieces(i, end, result);
                if (!(history.now == end)) ++result.unexplained;
            }
            result.unexplained += history.pieces.size() - history.next;
            const auto& state = final_bodies[i].state;
            expect_at(i, state.position, result);
            if (history.velocity != state.velocity) ++result.unexplained;
            if (history.captured == final_bodies[i].present) ++result.unexplained;
        }
    }

private:
    struct History {
        std::vector<const Piece*> pieces;
        std::size_t next = 0;  ///< the first piece still ahead
        Instant now{S(0)};
        math::WidePoint<S> position;
        Vec velocity;
        S travelled{0};  ///< since the last place it was said to be at [m]
        bool captured = false;
    };

    void follow(const Event& event, std::size_t side, BallIndex i, RunAudit& result) {
        History& history = histories_[i];
        if (history.captured) ++result.unexplained;
        take_pieces(i, event.when, result);
        if (!(history.now == event.when)) ++result.unexplained;
        if (history.velocity != event.before[side].velocity) ++result.unexplained;
        expect_at(i, event.before[side].position, result);
        expect_at(i, event.after[side].position, result);
        history.now = event.when;
        history.velocity = event.after[side].velocity;
        history.captured = event_captures<Type>(event.kind);
    }

    void take_pieces(BallIndex i, const Instant& until, RunAudit& result) {
        History& history = histories_[i];
        while (history.now < until && history.next < history.pieces.size()) {
            const Piece& piece = *history.pieces[history.next++];
            if (!(piece.from == history.now) || !(piece.from < piece.to)) ++result.unexplained;
            if (piece.velocity != history.velocity) ++result.unexplained;
            expect_at(i, piece.position, result);
            history.now = piece.to;
            history.position = position_at<S>(piece, piece.to);
            history.velocity = piece.velocity;
            history.travelled = path_length<S>(piece);
        }
    }

    /// The ball is said to be at [position] now.
    void expect_at(BallIndex i, const math::WidePoint<S>& position, RunAudit& result) {
        History& history = histories_[i];
        const S jump = math::norm<S>(math::difference<S>(position, history.position));
        const S bound = S(math::kPieceJump) * math::epsilon<S>() * history.travelled +
                        resolution<S>(position, history.velocity, history.now);
        result.note(result.largest_jump, math::to_double<S>(jump / scene_.bodies[i].radius),
                    jump <= bound);
        history.position = position;
        history.travelled = S(0);
    }

    const SceneData<Type>& scene_;
    std::vector<History> histories_;
    Instant last_event_{S(0)};
};

}  // namespace osculo::engine::detail
