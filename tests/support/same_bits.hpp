#pragma once

#include <cstring>

#include "support/builder.hpp"

/// Whether two runs are the same bit for bit.
namespace osculo::support {

template <math::Scalar S>
[[nodiscard]] bool same_bits(const S& a, const S& b) {
    // Equal numbers of one type have equal bits but for the sign of zero, which 1 / x would show.
    return a == b && (a != S(0) || (S(1) / a > S(0)) == (S(1) / b > S(0)));
}
template <math::Scalar S>
[[nodiscard]] bool same_bits(const math::Vec<S>& a, const math::Vec<S>& b) {
    return same_bits<S>(a.x(), b.x()) && same_bits<S>(a.y(), b.y());
}
template <math::Scalar S>
[[nodiscard]] bool same_bits(const math::WidePoint<S>& a, const math::WidePoint<S>& b) {
    return a.x == b.x && a.y == b.y;
}
template <math::Scalar S>
[[nodiscard]] bool same_bits(const engine::EventRecord<S>& a, const engine::EventRecord<S>& b) {
    bool same = a.when == b.when && a.kind == b.kind && a.first == b.first &&
                a.second == b.second && same_bits<S>(a.normal, b.normal);
    for (std::size_t k = 0; k < 2; ++k) {
        same = same && same_bits<S>(a.before[k].position, b.before[k].position) &&
               same_bits<S>(a.before[k].velocity, b.before[k].velocity) &&
               same_bits<S>(a.after[k].position, b.after[k].position) &&
               same_bits<S>(a.after[k].velocity, b.after[k].velocity);
    }
    return same;
}
template <math::Scalar S>
[[nodiscard]] bool same_bits(const engine::PieceRecord<S>& a, const engine::PieceRecord<S>& b) {
    return a.ball == b.ball && a.from == b.from && a.to == b.to &&
           same_bits<S>(a.position, b.position) && same_bits<S>(a.velocity, b.velocity);
}

template <class A, class B>
[[nodiscard]] bool same_final_bodies(const std::vector<A>& a, const std::vector<B>& b) {
    using S = std::decay_t<decltype(a.front().mass)>;
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!same_bits<S>(a[i].state.position, b[i].state.position) ||
            !same_bits<S>(a[i].state.velocity, b[i].state.velocity) ||
            a[i].present != b[i].present) {
            return false;
        }
    }
    return true;
}

/// Of the same kinds of obstacles in the same order; everything recorded.
template <class A, class B>
[[nodiscard]] bool same_bits(const Played<A>& a, const Played<B>& b) {
    using S = typename A::Scalar;
    const auto same_lists = [](const auto& one, const auto& other) {
        if (one.size() != other.size()) return false;
        for (std::size_t k = 0; k < one.size(); ++k) {
            if (!same_bits<S>(one[k], other[k])) return false;
        }
        return true;
    };
    return a.status == b.status && a.events == b.events && a.end == b.end &&
           same_final_bodies(a.bodies, b.bodies) && same_lists(a.record.events, b.record.events) &&
           same_lists(a.record.pieces, b.record.pieces);
}

}  // namespace osculo::support
