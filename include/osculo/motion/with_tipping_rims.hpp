#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "osculo/math/error_bounds.hpp"
#include "osculo/motion/in_rims.hpp"
#include "osculo/motion/rim_tipping_stay.hpp"

namespace osculo::motion {

/// A motion law, and rims over whose edge rigid balls tip (PHYSICS 5).
///
/// A ball whose centre comes within a rim tips over its edge until that pushes no more, or it tips
/// back. In flight it may fall in, hit the edge anywhere, or get over it. There
///
///  - the edge is without friction, and a ball that rolls on it under a law with inertia k is moved
///    by g / (1 + k), speeds around the edge and along it alike, as it would be without slipping,
///    but for the spin about the normal that would wind up. Once it has lost contact or has been
///    struck, it slides;
///  - the edge is hit with the rim's restitution along the normal in space. What would part from it
///    for less than the contact time stays on it;
///  - a ball is captured when its centre comes to be level with the edge: from there, the edge can
///    only push it down;
///  - a ball that comes back over the rim is on the table from there, and what it has of height and
///    vertical speed is lost;
///  - balls and cushions see a disc, whatever its height, until it is captured. What strikes it
///    changes its velocity in the plane; if it was on the edge, it then hits that or leaves it.
///
/// No step of these makes energy. [Base]: a law whose paths are parabolas.
template <class Base>
struct WithTippingRims : InRims<Base> {
    static constexpr const char* kName = Base::kNameWithTippingRims;
    using InRims<Base>::kOutside;
    using InRims<Base>::kUnknown;

    template <math::Scalar S>
    struct Parameters : Base::template Parameters<S> {
        std::vector<geometry::PullingRim<S>> rims;  ///< no two overlap
        std::vector<S> restitutions;                ///< of their edges
        S gravity{0};                               ///< [m/s^2], > 0 if there are rims
        S contact_time{0};                          ///< [s], see impact/pressing.hpp
    };

    template <math::Scalar S>
    struct State : Base::template State<S> {
        S ball_radius{1};  ///< [m]
        S inertia{0};      ///< k of a ball that rolls on the edge, 0 of one that slides
        std::uint32_t rim = kUnknown;
        bool fallen = false;  ///< into the rim
        bool lost = false;    ///< no number says what happens next
        bool slides = false;  ///< on the edge, although it rolls on the table
        S height{0};          ///< of the centre above the table's plane, in a rim [m]
        S climb{0};           ///< how fast that changes [m/s]
        S since{0};           ///< in the stretch [s]
        std::shared_ptr<const RimTippingStay<S>> stay{};

        void follow() {
            const Hovering<S> now = stay->in_space(since);
            this->position = now.position;
            this->velocity = now.velocity;
            height = now.height;
            climb = now.climb;
            this->half_acceleration = stay->at(since).half_acceleration;
        }

        /// How long it goes on accelerating as it does [s]: on the edge too if it is about to hit
        /// that, which is all it does in no time.
        [[nodiscard]] S acceleration_time() const {
            const math::Vec<S>& half = this->half_acceleration;
            const bool accelerates = half.x() != S(0) || half.y() != S(0);
            const bool at_once = stay && stay->touches(since) && !stay->on_edge();
            return accelerates && !at_once ? this->remaining : math::never<S>();
        }
    };

    /// Sets what follows from place, velocity and the rim it is in. To be called whenever the
    /// velocity changes. Allocates in a rim.
    template <math::Scalar S>
    static void begin(const Parameters<S>& law, State<S>& state) {
        if (state.rim == kUnknown) state.rim = rim_around<S>(law.rims, state.position);
        if (state.rim == kOutside) {
            state.stay = nullptr;
            state.since = S(0);
            Base::template begin<S>(law, state);
        } else if (state.stay == nullptr) {
            come_in(law, state);
        } else {
            be_struck(law, state);
        }
    }

    /// What happens after `remaining`.
    template <math::Scalar S>
    static void transition(const Parameters<S>& law, State<S>& state) {
        if (!state.stay) {
            Base::template transition<S>(law, state);
            return;
        }
        const TippingEnd end = state.stay->end();
        state.lost = !state.stay->sound() || end == TippingEnd::balanced;
        state.fallen = !state.lost && end == TippingEnd::capture;
        if (state.lost || state.fallen) {
            InRims<Base>::template end<S>(state);
            return;
        }
        switch (end) {
            case TippingEnd::exit:
                state.rim = kOutside;
                state.height = state.climb = S(0);
                state.slides = false;
                begin(law, state);
                return;
            case TippingEnd::edge: hit_edge(law, state); return;
            case TippingEnd::lift_off: follow(law, state, TippingStart::lifts_off); return;
            default: follow(law, state, TippingStart::touches); return;
        }
    }

    /// Where a ball in a rim is seen from the edge: its motion along the normal in space, and what
    /// the edge, if it touches it, makes of gravity along that.
    template <math::Scalar S>
    struct FromEdge {
        math::Vec<S> out;  ///< from the hole's centre to the ball's, unit
        S sine, cosine;    ///< of the tilt
        S off;             ///< speed away from the edge [m/s]
        S push;            ///< acceleration with which the edge keeps it from coming nearer [m/s^2]
    };
    template <math::Scalar S>
    [[nodiscard]] static FromEdge<S> from_edge(const Parameters<S>& law, const State<S>& state) {
        const auto& rim = law.rims[state.rim];
        const math::Vec<S> x = math::difference<S>(state.position, rim.center);
        const S d = math::norm<S>(x);
        const math::Vec<S> upright(S(rim.radius - d), state.height);
        const S distance = math::norm<S>(upright);
        FromEdge<S> from{x / d, S(upright.x() / distance), S(upright.y() / distance), S(0), S(0)};
        const S radial = math::dot<S>(state.velocity, from.out);
        const S along = math::cross<S>(from.out, state.velocity);
        const S around = radial * from.cosine + state.climb * from.sine;
        from.off = from.cosine * state.climb - from.sine * radial;
        from.push = law.gravity * from.cosine - around * around / state.ball_radius +
                    along * along / d * from.sine;
        return from;
    }

    /// Whether a ball that leaves the edge at that speed is back within the contact time.
    template <math::Scalar S>
    [[nodiscard]] static bool settles(const Parameters<S>& law, const FromEdge<S>& from,
                                      const S& off) {
        return from.push > S(0) && S(2) * off <= from.push * law.contact_time;
    }

private:
    template <math::Scalar S>
    static void follow(const Parameters<S>& law, State<S>& state, TippingStart begins) {
        const S heaviness = state.slides ? S(1) : S(S(1) + state.inertia);
        state.stay = std::make_shared<const RimTippingStay<S>>(
            law.rims[state.rim], law.gravity, state.ball_radius, heaviness,
            Hovering<S>{state.position, state.velocity, state.height, state.climb}, begins);
        state.slides = state.slides || !state.stay->on_edge();
        state.since = S(0);
        state.half_acceleration = state.stay->at(S(0)).half_acceleration;
        state.remaining = state.stay->duration();
    }

    /// From the table, or from the start of all: on the edge, with the vertical speed that goes
    /// with that.
    template <math::Scalar S>
    static void come_in(const Parameters<S>& law, State<S>& state) {
        const auto& rim = law.rims[state.rim];
        // In wide precision: of a large hole, the tilt is a small part.
        const auto wide = math::wide_difference<S>(state.position, rim.center);
        const math::Wide<S> distance =
            math::wide_square_root<S>(math::Wide<S>(wide.x * wide.x + wide.y * wide.y));
        const S inside = math::narrow(math::Wide<S>(math::Wide<S>(rim.radius) - distance));
        const math::Vec<S> x = wide.rounded();
        const S d = math::narrow(distance);
        const S sine = std::clamp<S>(S(inside / state.ball_radius), S(0), S(1));
        const S cosine = math::square_root<S>((S(1) - sine) * (S(1) + sine));
        const S radial = math::dot<S>(state.velocity, x) / d;
        state.height = state.ball_radius * cosine;
        state.climb = cosine > S(0) ? S(radial * (sine / cosine)) : S(0);
        state.slides = false;
        follow(law, state, TippingStart::touches);
    }

    template <math::Scalar S>
    static void be_struck(const Parameters<S>& law, State<S>& state) {
        const bool touches = state.stay->touches(state.since);
        state.slides = true;
        if (!touches) {
            follow(law, state, TippingStart::flies);
            return;
        }
        const FromEdge<S> from = from_edge(law, state);
        const bool presses = from.off < S(0) || settles(law, from, from.off);
        follow(law, state, presses ? TippingStart::presses : TippingStart::leaves);
        // The edge will keep it from following gravity, at which others may be pressed against it.
        if (presses && from.push > S(0)) {
            const S push = std::min<S>(from.push, law.gravity);
            state.half_acceleration = (-from.sine * push / S(2)) * from.out;
        }
    }

    template <math::Scalar S>
    static void hit_edge(const Parameters<S>& law, State<S>& state) {
        const FromEdge<S> from = from_edge(law, state);
        S off = from.off < S(0) ? S(-law.restitutions[state.rim] * from.off) : from.off;
        const S noise = S(math::kVelocityNoise) * math::epsilon<S>() *
                        (math::norm1<S>(state.velocity) + math::abs<S>(state.climb));
        if (off <= noise || settles(law, from, off)) off = S(0);
        state.velocity -= ((off - from.off) * from.sine) * from.out;
        state.climb += (off - from.off) * from.cosine;
        state.slides = true;
        follow(law, state, off > S(0) ? TippingStart::leaves : TippingStart::touches);
    }
};

}  // namespace osculo::motion
