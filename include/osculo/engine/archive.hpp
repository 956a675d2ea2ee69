#pragma once

#include "osculo/engine/engine.hpp"

// What an engine has to keep to be played on elsewhere.
namespace osculo::engine {

template <class Type>
template <class Archive>
void Engine<Type>::archive(Archive& archive) {
    for (BodyType& body : scene_.bodies) {
        archive(body);
        archive.require(is_known(body.state));
    }
    for (BallIndex i = 0; i < scene_.bodies.size(); ++i) {
        Scheduled next = queue_.next_of(i);
        archive(next);
        archive.require(exists(next.kind, next.first, next.second));
        queue_.update(i, next);
    }
    for (Box& box : swept_) archive(box);
    broad_phase_.archive(archive);
    if constexpr (Type::Simultaneous::kGathersCluster) archive(cluster_.number, cluster_.settled);
    if constexpr (Recorder::kEvents) {
        archive(recorder_.events);
        for (const auto& event : recorder_.events) {
            archive.require(event.kind != kNothing &&
                            exists(event.kind, event.first, event.second));
            for (const auto& memory : event.before) archive.require(is_known(memory));
            for (const auto& memory : event.after) archive.require(is_known(memory));
        }
    }
    if constexpr (Recorder::kPieces) {
        archive(recorder_.pieces);
        for (const auto& piece : recorder_.pieces) {
            archive.require(piece.ball < scene_.bodies.size());
            if constexpr (requires { piece.state; }) archive.require(is_known(piece.state));
        }
    }
    archive(now_, event_count_, prediction_count_);
}

/// Whether the scene has what an event is about.
template <class Type>
bool Engine<Type>::exists(Kind kind, BallIndex first, std::uint32_t second) const {
    const std::size_t balls = scene_.bodies.size();
    if (kind == kNothing) return true;
    if (first >= balls) return false;
    if (kind == kTransition) return Type::Motion::kTransitions;
    if (kind == kCellCrossing) return Type::BroadPhase::kCrossings;
    if (kind == kBallBall) return second < balls && second != first;
    bool result = false;
    (void)visit_kind(kind, [&](auto k) {
        result = second < std::get<decltype(k)::value>(scene_.obstacles).size();
        return true;
    });
    return result;
}

/// Whether the scene has what a ball's state is about.
template <class Type>
template <class Memory>
bool Engine<Type>::is_known(const Memory& memory) const {
    if constexpr (requires { memory.rim; }) {
        return memory.rim == Type::Motion::kOutside || memory.rim < scene_.motion.rims.size();
    }
    return true;
}

}  // namespace osculo::engine
