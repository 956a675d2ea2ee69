#include "compare.hpp"

#include <algorithm>

namespace osculo::bench {
namespace {

/// What one ball met, in its order.
std::vector<std::vector<Contact>> by_ball(const std::vector<Contact>& contacts, std::size_t balls,
                                          double tolerance) {
    std::vector<std::vector<Contact>> result(balls);
    for (const Contact& contact : contacts) {
        auto& list = result[static_cast<std::size_t>(contact.ball)];
        const bool again = contact.other == kCushion && !list.empty() &&
                           list.back().other == kCushion &&
                           contact.time - list.back().time <= tolerance;
        if (!again) list.push_back(contact);
    }
    return result;
}

std::size_t until(const std::vector<Contact>& list, double time) {
    const auto after = [&](const Contact& contact) { return contact.time > time; };
    return static_cast<std::size_t>(std::find_if(list.begin(), list.end(), after) - list.begin());
}

}  // namespace

Difference compare(const Snapshot& is, const Snapshot& should, double radius,
                   const Exact& start_energy) {
    Exact sum = 0;
    Exact most = 0;
    for (std::size_t i = 0; i < should.positions.size(); ++i) {
        const Exact dx = is.positions[i].x - should.positions[i].x;
        const Exact dy = is.positions[i].y - should.positions[i].y;
        const Exact square = dx * dx + dy * dy;
        sum += square;
        most = std::max(most, square);
    }
    const auto balls = static_cast<double>(should.positions.size());
    return {static_cast<double>(Exact(sqrt(Exact(sum / balls)))) / radius,
            static_cast<double>(Exact(sqrt(most))) / radius,
            static_cast<double>(Exact(abs(is.energy - should.energy) / start_energy))};
}

bool same_contacts(const std::vector<Contact>& is, const std::vector<Contact>& should,
                   std::size_t balls, double time, double step) {
    const double tolerance = std::min(2 * step, time / 10);
    const auto mine = by_ball(is, balls, tolerance);
    const auto theirs = by_ball(should, balls, tolerance);
    for (std::size_t i = 0; i < balls; ++i) {
        const std::size_t count = until(mine[i], time);
        if (count < until(theirs[i], time - tolerance)) return false;
        if (count > until(theirs[i], time + tolerance)) return false;
        for (std::size_t k = 0; k < count; ++k) {
            if (mine[i][k].other != theirs[i][k].other) return false;
        }
    }
    return true;
}

}  // namespace osculo::bench
