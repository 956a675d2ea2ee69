#pragma once

#include <cstddef>
#include <tuple>

#include "osculo/engine/scenes.hpp"

// What the state of an engine consists of: for each of its types, all members by reference. A
// member that is forgotten does not compile.
namespace osculo::facade {

/// Serves as any member of an aggregate.
struct AnyMember {
    template <class T>
    operator T() const;  // NOLINT(google-explicit-constructor)
};
/// How many members an aggregate has; a base counts as one.
template <class T, class... Members>
inline constexpr std::size_t kMemberCount = [] {
    if constexpr (requires { T{Members{}..., AnyMember{}}; }) {
        return kMemberCount<T, Members..., AnyMember>;
    } else {
        return sizeof...(Members);
    }
}();

template <math::Builtin S>
auto members(math::DoubleDouble<S>& number) {
    auto& [hi, lo] = number;
    return std::tie(hi, lo);
}
template <math::Scalar S>
auto members(math::WidePoint<S>& point) {
    auto& [x, y] = point;
    return std::tie(x, y);
}
template <math::Scalar S>
auto members(geometry::Box<S>& box) {
    auto& [low_x, high_x, low_y, high_y] = box;
    return std::tie(low_x, high_x, low_y, high_y);
}

// Balls.
template <math::Scalar S>
auto members(motion::Uniform::State<S>& state) {
    auto& [position, velocity] = state;
    return std::tie(position, velocity);
}
template <math::Scalar S>
auto members(motion::Rolling::State<S>& state) {
    auto& [position, velocity, half_acceleration, remaining] = state;
    return std::tie(position, velocity, half_acceleration, remaining);
}
template <math::Scalar S>
auto members(motion::Resistance<S>& law) {
    auto& [constant, linear, quadratic] = law;
    return std::tie(constant, linear, quadratic);
}
template <math::Scalar S>
auto members(motion::Slowing<S>& slowing) {
    auto& [m, k, c] = slowing;
    return std::tie(m, k, c);
}
template <math::Scalar S>
auto members(motion::Resisted::State<S>& state) {
    auto& [position, velocity, law, half_acceleration, slowing, remaining, longest] = state;
    return std::tie(position, velocity, law, half_acceleration, slowing, remaining, longest);
}
template <math::Scalar S>
auto members(motion::Cloth::State<S>& state) {
    auto& [position, velocity, spin, radius, inertia, phase, half_acceleration, spin_rate,
           spin_decay, remaining] = state;
    return std::tie(position, velocity, spin, radius, inertia, phase, half_acceleration, spin_rate,
                    spin_decay, remaining);
}
template <math::Scalar S>
auto members(motion::Disc::State<S>& state) {
    static_assert(kMemberCount<motion::Disc::State<S>> == 4);  // the first one is the base
    auto& base = static_cast<motion::Resisted::State<S>&>(state);
    return std::tie(base, state.spin, state.radius, state.inertia);
}
template <math::Scalar S>
auto members(motion::WithRims<motion::Rolling>::State<S>& state) {
    static_assert(kMemberCount<motion::WithRims<motion::Rolling>::State<S>> == 7);
    auto& base = static_cast<motion::Rolling::State<S>&>(state);
    return std::tie(base, state.ball_radius, state.rim, state.fallen, state.lost, state.since,
                    state.stay);
}
template <math::Scalar S>
auto members(motion::Hovering<S>& ball) {
    auto& [position, velocity, height, climb] = ball;
    return std::tie(position, velocity, height, climb);
}
template <math::Scalar S>
auto members(motion::WithTippingRims<motion::Rolling>::State<S>& state) {
    static_assert(kMemberCount<motion::WithTippingRims<motion::Rolling>::State<S>> == 11);
    auto& base = static_cast<motion::Rolling::State<S>&>(state);
    return std::tie(base, state.ball_radius, state.inertia, state.rim, state.fallen, state.lost,
                    state.slides, state.height, state.climb, state.since, state.stay);
}
inline auto members(engine::Nothing&) {
    return std::tie();
}
template <class Type>
auto members(engine::Body<Type>& body) {
    auto& [state, clock, mass, radius, noise, age, last_kind, last_other, present, hops] = body;
    return std::tie(state, clock, mass, radius, noise, age, last_kind, last_other, present, hops);
}
template <math::Scalar S>
auto members(engine::Event<S>& event) {
    auto& [when, kind, first, second, first_age, second_age] = event;
    return std::tie(when, kind, first, second, first_age, second_age);
}

// Records.
template <math::Scalar S>
auto members(engine::Moment<S>& moment) {
    auto& [position, velocity] = moment;
    return std::tie(position, velocity);
}
template <math::Scalar S, class Memory>
auto members(engine::EventRecord<S, Memory>& event) {
    auto& [when, kind, first, second, cluster, normal, before, after] = event;
    return std::tie(when, kind, first, second, cluster, normal, before, after);
}
template <math::Scalar S>
auto members(engine::PieceRecord<S>& piece) {
    auto& [ball, from, to, position, velocity] = piece;
    return std::tie(ball, from, to, position, velocity);
}
template <math::Scalar S, class State>
auto members(engine::StatePieceRecord<S, State>& piece) {
    auto& [ball, from, to, state] = piece;
    return std::tie(ball, from, to, state);
}

}  // namespace osculo::facade
