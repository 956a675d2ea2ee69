#pragma once

#include "osculo/engine/audit/result.hpp"
#include "osculo/engine/audit/rims.hpp"
#include "osculo/engine/audit/tipping_rims.hpp"

namespace osculo::engine::detail {

/// Follows every ball from its initial to its final state through its pieces and events.
template <class Type>
class HistoryAudit {
public:
    using S = typename Type::Scalar;
    using Instant = math::Instant<S>;
    using Piece = PieceOf<Type>;
    using Event = EventOf<Type>;
    using Memory = MemoryOf<Type>;

    HistoryAudit(const SceneData<Type>& scene, const std::vector<Piece>& pieces)
        : scene_(scene), histories_(scene.bodies.size()) {
        for (std::size_t i = 0; i < histories_.size(); ++i) {
            histories_[i].state = Type::Recorder::remember(scene.bodies[i].state);
            histories_[i].noise = noise_of(histories_[i].state, S(0), S(0));
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
            expect(i, Type::Recorder::remember(final_bodies[i].state), result);
            if (history.captured == final_bodies[i].present) ++result.unexplained;
        }
    }

private:
    struct History {
        std::vector<const Piece*> pieces;
        std::size_t next = 0;  ///< the first piece still ahead
        Instant now{S(0)};
        Memory state;
        S travelled{0};  ///< since the last place it was said to be at [m]
        S noise{0};      ///< of velocity and radius * spin since they were last stated [m/s]
        bool captured = false;
    };

    void follow(const Event& event, std::size_t side, BallIndex i, RunAudit& result) {
        History& history = histories_[i];
        if (history.captured) ++result.unexplained;
        take_pieces(i, event.when, result);
        if (!(history.now == event.when)) ++result.unexplained;
        expect(i, event.before[side], result);
        history.captured = captures<Type>(event);
        // What an impact changes is checked with the impact; nothing else changes anything.
        const bool impact = event.kind != kTransition && !history.captured &&
                            !has_effect<Type>(event.kind, Effect::entry);
        if (impact) history.noise = math::never<S>();
        // A phase too short for instants to show ends when it begins.
        if (event.kind == kTransition) {
            history.noise = std::max<S>(
                history.noise, noise_of(event.before[side], S(0), math::narrow(event.when)));
            if constexpr (requires { hits_edge<S>(event.before[side]); }) {
                if (hits_edge<S>(event.before[side])) {
                    const bool sound =
                        hit_explained<S>(scene_.motion, event.before[side], event.after[side]);
                    if (!sound) ++result.unexplained;
                    history.noise = math::never<S>();
                }
            }
        }
        expect(i, event.after[side], result);
        history.now = event.when;
        history.noise = S(0);
    }

    void take_pieces(BallIndex i, const Instant& until, RunAudit& result) {
        History& history = histories_[i];
        for (int taken = 0; history.now < until && history.next < history.pieces.size(); ++taken) {
            const Piece& piece = *history.pieces[history.next++];
            if (taken > 0) ++result.unexplained;  // no event ends the one before
            if (!(piece.from == history.now) || !(piece.from < piece.to)) ++result.unexplained;
            expect(i, beginning(piece), result);
            history.now = piece.to;
            history.state = end_of(piece);
            history.travelled = path_length(piece);
            if constexpr (Type::Motion::kTransitions) check_law(i, piece, result);
        }
    }

    /// Holds a piece that has just been taken against the motion law.
    void check_law(BallIndex i, const Piece& piece, RunAudit& result) {
        History& history = histories_[i];
        const S duration = math::duration<S>(piece.from, piece.to);
        const S when = math::narrow(piece.to);
        history.noise = noise_of(piece.state, duration, when);
        const S unresolved = S(math::kContactGap) * math::wide_epsilon<S>() * math::abs<S>(when) +
                             S(math::kShortest);
        if (!obeys<S>(scene_.motion, piece.state, S(duration - unresolved))) ++result.unexplained;
        // In a rim that holds the energy against that of the field, which is known to less than a
        // slow ball's own.
        if constexpr (requires { piece.state.stay; }) {
            if (piece.state.stay) return;
        }
        // No law speeds a ball up. Squares of speeds could leave the range of numbers.
        const S scale = motion_scale<S>(piece.state, duration);
        if (!(scale > S(0))) return;
        const S gain = twice_energy_per_mass<S>(in_units_of(scale, history.state)) -
                       twice_energy_per_mass<S>(in_units_of(scale, piece.state));
        if (!(gain <= history.noise / scale)) ++result.unexplained;
    }

    template <class State>
    static State in_units_of(const S& speed, State state) {
        state.velocity = state.velocity / speed;
        if constexpr (requires { state.spin; }) state.spin = state.spin / speed;
        return state;
    }

    /// How much of velocity and spin [m/s] rounding may take in a duration that ends at an instant.
    S noise_of(const Memory& state, const S& duration, const S& when) const {
        if constexpr (Type::Motion::kTransitions) {
            return motion_slack<S>() * motion_scale<S>(state, duration) +
                   S(math::kContactGap) * math::wide_epsilon<S>() *
                       motion_scale<S>(state, math::abs<S>(when)) +
                   S(math::kShortest) * largest_acceleration<S>(scene_.motion) +
                   underflow<S>(state);
        } else {
            return S(0);
        }
    }

    /// The ball is said to be in that state now.
    void expect(BallIndex i, const Memory& state, RunAudit& result) {
        History& history = histories_[i];
        const S jump = math::norm<S>(math::difference<S>(state.position, history.state.position));
        const S bound =
            S(math::kPieceJump) * math::epsilon<S>() * history.travelled +
            resolution<S>(state.position, math::norm1<S>(history.state.velocity), history.now);
        result.note(result.largest_jump, math::to_double<S>(jump / scene_.bodies[i].radius),
                    jump <= bound);
        if (!(motion_change<S>(state, history.state) <= history.noise)) ++result.unexplained;
        history.state = state;
        history.travelled = S(0);
    }

    const SceneData<Type>& scene_;
    std::vector<History> histories_;
    Instant last_event_{S(0)};
};

}  // namespace osculo::engine::detail
