#pragma once

#include <vector>

#include <boost/heap/d_ary_heap.hpp>

#include "osculo/engine/event.hpp"

namespace osculo::engine {

/// The future event list: one mutable entry per ball, its earliest event. No allocation after
/// construction. O(log n) per update.
template <math::Scalar S>
class EventQueue {
public:
    explicit EventQueue(std::size_t balls) {
        heap_.reserve(balls);
        entries_.reserve(balls);
        for (std::size_t i = 0; i < balls; ++i) {
            entries_.push_back(heap_.push({Event<S>{}, static_cast<BallIndex>(i)}));
        }
    }

    /// The handles belong to their heap: a copy has its own. Entries are totally ordered, so that
    /// the order inside of the heap does not matter.
    EventQueue(const EventQueue& other) : EventQueue(other.entries_.size()) {
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            const auto ball = static_cast<BallIndex>(i);
            update(ball, other.next_of(ball));
        }
    }
    EventQueue& operator=(const EventQueue& other) {
        EventQueue copy(other);
        heap_.swap(copy.heap_);  // handles go along
        entries_.swap(copy.entries_);
        return *this;
    }
    ~EventQueue() = default;

    /// Replaces the event of ball i.
    void update(BallIndex i, const Event<S>& event) { heap_.update(entries_[i], {event, i}); }

    /// The event of ball i.
    [[nodiscard]] const Event<S>& next_of(BallIndex i) const { return (*entries_[i]).event; }

    [[nodiscard]] bool empty() const { return heap_.empty(); }

    /// The earliest event of all. Requires !empty().
    [[nodiscard]] const Event<S>& top() const { return heap_.top().event; }
    /// The ball whose entry that is.
    [[nodiscard]] BallIndex top_ball() const { return heap_.top().ball; }

private:
    struct Entry {
        Event<S> event;
        BallIndex ball;
        // A maximum heap turned round. The ball only breaks ties between the two entries of a pair.
        friend bool operator<(const Entry& a, const Entry& b) {
            if (b.event < a.event) return true;
            if (a.event < b.event) return false;
            return b.ball < a.ball;
        }
    };
    using Heap = boost::heap::d_ary_heap<Entry, boost::heap::arity<4>, boost::heap::mutable_<true>>;

    Heap heap_;
    std::vector<typename Heap::handle_type> entries_;
};

}  // namespace osculo::engine
