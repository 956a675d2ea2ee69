#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "osculo/batch.hpp"
#include "shot_player.hpp"

namespace osculo::facade {

/// Writes into a result. Different shots and chunks may be written by different threads at once.
class BatchColumns {
public:
    /// Gives all shots the values of one that is not run.
    BatchColumns(BatchResult& result, std::size_t shots, std::size_t balls, std::size_t chunks,
                 const BatchOptions& options);

    void set_invalid(std::size_t shot) { result_.status[shot] = ShotStatus::invalid; }

    /// The outcome of a shot in which the balls with present[i] != 0 took part, all if it is empty.
    void set(std::size_t shot, PlayedShot& played, std::span<const std::uint8_t> present);

    /// How many events and pieces the shot added to those of its chunk.
    void set_records(std::size_t shot, std::size_t events, std::size_t pieces);

    /// Takes away the events and pieces of a chunk of shots.
    void keep_records(std::size_t chunk, PlayedShot& played);

    /// Puts those of all chunks one after another.
    void join_records();

private:
    void set_ball(std::size_t place, const FinalBall& ball, const Outcome::Tally& tally);

    BatchResult& result_;
    std::vector<std::vector<Event>> events_;  ///< by chunk
    std::vector<std::vector<Piece>> pieces_;
};

}  // namespace osculo::facade
