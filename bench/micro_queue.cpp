#include <benchmark/benchmark.h>
#include <boost/heap/binomial_heap.hpp>
#include <boost/heap/d_ary_heap.hpp>
#include <boost/heap/fibonacci_heap.hpp>
#include <boost/heap/pairing_heap.hpp>
#include <boost/heap/skew_heap.hpp>

#include "osculo/engine/queue.hpp"
#include "support/random.hpp"

/// What the future event list could be: one entry per ball, and per event the earliest entry is
/// looked up and those of two balls are replaced. Random waiting times, so that the list is in a
/// steady state; time per event.
namespace {

using namespace osculo;
using Event = engine::Event<double>;

/// As the engine's: the whole event, in its total order, turned round for a maximum heap.
struct Entry {
    Event event;
    engine::BallIndex ball;
    friend bool operator<(const Entry& a, const Entry& b) {
        if (b.event < a.event) return true;
        if (a.event < b.event) return false;
        return b.ball < a.ball;
    }
};

template <class Heap>
class HeapQueue {
public:
    explicit HeapQueue(std::size_t balls) {
        for (std::size_t i = 0; i < balls; ++i) {
            handles_.push_back(heap_.push({Event{}, static_cast<engine::BallIndex>(i)}));
        }
    }
    void update(engine::BallIndex i, const Event& event) { heap_.update(handles_[i], {event, i}); }
    [[nodiscard]] const Event& top() const { return heap_.top().event; }
    [[nodiscard]] engine::BallIndex top_ball() const { return heap_.top().ball; }

private:
    Heap heap_;
    std::vector<typename Heap::handle_type> handles_;
};

/// No structure at all.
class Scan {
public:
    explicit Scan(std::size_t balls) {
        for (std::size_t i = 0; i < balls; ++i) {
            entries_.push_back({Event{}, static_cast<engine::BallIndex>(i)});
        }
    }
    void update(engine::BallIndex i, const Event& event) {
        entries_[i].event = event;
        best_ = nullptr;
    }
    [[nodiscard]] const Event& top() { return best().event; }
    [[nodiscard]] engine::BallIndex top_ball() { return best().ball; }

private:
    const Entry& best() {
        if (best_ == nullptr) {
            best_ = &entries_.front();
            for (const Entry& entry : entries_) {
                if (*best_ < entry) best_ = &entry;
            }
        }
        return *best_;
    }
    std::vector<Entry> entries_;
    const Entry* best_ = nullptr;
};

using boost::heap::arity;
using Mutable = boost::heap::mutable_<true>;
template <unsigned N>
using DAry = HeapQueue<boost::heap::d_ary_heap<Entry, arity<N>, Mutable>>;
using Binomial = HeapQueue<boost::heap::binomial_heap<Entry>>;
using Fibonacci = HeapQueue<boost::heap::fibonacci_heap<Entry>>;
using Pairing = HeapQueue<boost::heap::pairing_heap<Entry>>;
using Skew = HeapQueue<boost::heap::skew_heap<Entry, Mutable>>;

template <class Queue>
void hold(benchmark::State& state) {
    const auto balls = static_cast<std::size_t>(state.range(0));
    support::Random random(3);
    // Waiting times as in a gas, exponentially distributed; drawn beforehand.
    std::vector<double> waits(4096);
    for (double& wait : waits) wait = -std::log(1 - random.unit<double>());
    std::vector<engine::BallIndex> partners(4093);
    for (auto& partner : partners) {
        partner = static_cast<engine::BallIndex>(random.below(static_cast<int>(balls)));
    }
    Queue queue(balls);
    std::size_t k = 0;
    const auto renew = [&](engine::BallIndex i, double now) {
        Event event;
        event.when = now + waits[k++ % waits.size()];
        event.kind = engine::kBallBall;
        event.first = i;
        queue.update(i, event);
    };
    for (std::size_t i = 0; i < balls; ++i) renew(static_cast<engine::BallIndex>(i), 0);
    const auto play = [&] {
        const double now = math::narrow(queue.top().when);
        const engine::BallIndex first = queue.top_ball();
        renew(first, now);
        renew(partners[k % partners.size()], now);
    };
    // Lazy heaps put off work until they are first asked.
    for (int i = 0; i < 10000; ++i) play();
    for (auto _ : state) play();
}

template <class Queue>
void add(const char* name, int most) {
    auto* all = benchmark::RegisterBenchmark((std::string("queue/") + name).c_str(), hold<Queue>);
    for (const int balls : {16, 100, 1000, 10000, 100000, 1000000}) {
        if (balls <= most) all->Arg(balls);
    }
}

const int kRegistered = [] {
    constexpr int kMost = 1000000;
    add<engine::EventQueue<double>>("engine", kMost);
    add<DAry<2>>("d-ary 2", kMost);
    add<DAry<4>>("d-ary 4", kMost);
    add<DAry<8>>("d-ary 8", kMost);
    add<Binomial>("binomial", kMost);
    add<Fibonacci>("fibonacci", kMost);
    add<Pairing>("pairing", kMost);
    add<Skew>("skew", kMost);
    add<Scan>("scan", 10000);
    return 0;
}();

}  // namespace
