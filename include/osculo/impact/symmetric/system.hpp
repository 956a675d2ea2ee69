#pragma once

#include <cstddef>
#include <vector>

#include "osculo/impact/cluster.hpp"
#include "osculo/impact/restitution.hpp"
#include "osculo/impact/symmetric/nonnegative.hpp"
#include "osculo/math/error_bounds.hpp"

namespace osculo::impact::symmetric {

/// A cluster in the metric of its masses: y_i = sqrt(m_i) v_i, so that |y|^2 / 2 is the energy.
///
/// The contact of balls 1 and 2 with unit normal n and reduced mass m is the half-space a.y >= 0
/// with the unit vector a = sqrt(m) (-n / sqrt(m1), n / sqrt(m2)); of ball 1 and something fixed,
/// a = (-n). An impulse J = sqrt(m) x along n adds x a to y, and a.y = sqrt(m) (v2 - v1).n.
/// Velocities themselves are kept: differences of them are formed before anything is multiplied,
/// and equal and opposite impulses keep the momentum whatever their error.
template <math::Scalar S>
class System {
public:
    struct Ball {
        S mass;
        S root;  // of the mass
        math::Vec<S> velocity;
        math::WidePoint<S> gain;  // of momentum, not yet applied
        S start;                  // speed in the beginning
        S push;                   // sum of the impulses not yet applied
        S stir{0};                // largest change of velocity at once, were the impulses parallel
    };
    struct Contact {
        math::Vec<S> normal;  // unit
        math::Vec<S> given;   // as long as it came
        S root;               // of the reduced mass
        S restitution;
        Column<S> column;
        S parting{0};  // speed at which they have to part at least
    };

    template <class ClusterType>
    void load(const ClusterType& cluster) {
        balls_.clear();
        for (const auto& ball : cluster.balls) {
            balls_.push_back({ball.mass,
                              math::square_root<S>(ball.mass),
                              ball.velocity,
                              {},
                              math::norm<S>(ball.velocity),
                              S(0),
                              S(0)});
        }
        contacts_.clear();
        for (const auto& contact : cluster.contacts) {
            const math::Vec<S> n = contact.normal / math::norm<S>(contact.normal);
            const Ball& one = balls_[contact.one];
            const S e = in_the_plane(contact);
            if (contact.other == kFixed) {
                contacts_.push_back({n,
                                     contact.normal,
                                     one.root,
                                     e,
                                     {contact.one, Column<S>::kNone, -n, -n, kNoRow, S(0)}});
            } else {
                const Ball& other = balls_[contact.other];
                const S total = one.mass + other.mass;
                const S share_one = math::square_root<S>(other.mass / total);
                const S share_other = math::square_root<S>(one.mass / total);
                contacts_.push_back(
                    {n,
                     contact.normal,
                     one.root * share_one,
                     e,
                     {contact.one, contact.other, -share_one * n, share_other * n, kNoRow, S(0)}});
            }
        }
    }

    [[nodiscard]] std::vector<Ball>& balls() { return balls_; }
    [[nodiscard]] const std::vector<Ball>& balls() const { return balls_; }
    [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
    [[nodiscard]] std::size_t rows() const { return 2 * balls_.size(); }

    /// (v2 - v1).n [m/s], less the speed at which they have to part: negative if they approach.
    [[nodiscard]] S separation(std::size_t k) const {
        const Column<S>& c = contacts_[k].column;
        const math::Vec<S>& v = balls_[c.one].velocity;
        const S parting = c.other == kFixed
                              ? S(-math::dot<S>(v, contacts_[k].normal))
                              : math::dot<S>(balls_[c.other].velocity - v, contacts_[k].normal);
        return parting - contacts_[k].parting;
    }
    void demand(std::size_t k, const S& parting) { contacts_[k].parting = parting; }
    /// Rounding noise of it, as far as the velocities' own rounding goes.
    [[nodiscard]] S noise(std::size_t k) const {
        return of_both(k, [](const Ball& b) { return b.start + math::norm<S>(b.velocity); });
    }
    /// The same with the rounding of the impulses: those on a ball that is jammed may cancel.
    [[nodiscard]] S most_noise(std::size_t k) const {
        return of_both(k,
                       [](const Ball& b) { return b.start + math::norm<S>(b.velocity) + b.stir; });
    }
    /// |y|, the root of twice the energy; with velocities of one's own.
    [[nodiscard]] S size() const {
        return size([this](std::size_t i) { return balls_[i].velocity; });
    }
    template <class Velocity>
    [[nodiscard]] S size(const Velocity& velocity) const {
        S largest(0);
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const S part = balls_[i].root * math::norm<S>(velocity(i));
            if (part > largest) largest = part;
        }
        if (!(largest > S(0))) return largest;
        S sum(0);
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const S part = balls_[i].root * math::norm<S>(velocity(i)) / largest;
            sum += part * part;
        }
        return largest * math::square_root<S>(sum);
    }

    /// The impulse J along the normal; takes effect with apply().
    void push(std::size_t k, const S& impulse) {
        const Column<S>& c = contacts_[k].column;
        pushed(balls_[c.one], -impulse, contacts_[k].normal);
        if (c.other != kFixed) pushed(balls_[c.other], impulse, contacts_[k].normal);
    }
    /// All pushes at once: one rounding of each velocity.
    void apply() {
        for (Ball& ball : balls_) {
            ball.velocity += ball.gain.rounded() / ball.mass;
            ball.gain = {};
            const S stir = ball.push / ball.mass;
            if (stir > ball.stir) ball.stir = stir;
            ball.push = S(0);
        }
    }
    /// One contact as if there were no other, by the binary law with e = 1. The impulse in units of
    /// sqrt(m).
    S reflect(std::size_t k) {
        const Column<S>& c = contacts_[k].column;
        const S impulse = -S(2) * contacts_[k].root * separation(k);
        Ball& one = balls_[c.one];
        if (c.other == kFixed) {
            Restitution::resolve<S>(S(1), contacts_[k].given, one.velocity);
        } else {
            Ball& other = balls_[c.other];
            Restitution::resolve<S>(S(1), one.mass, other.mass, contacts_[k].given, one.velocity,
                                    other.velocity);
        }
        return impulse;
    }

private:
    static constexpr std::size_t kNoRow = Column<S>::kNone;
    static_assert(Column<S>::kNone == kFixed);

    /// In wide precision: large impulses on a light ball may cancel but for a small one across.
    static void pushed(Ball& ball, const S& impulse, const math::Vec<S>& n) {
        ball.gain = {ball.gain.x + math::wide_product<S>(impulse, n.x()),
                     ball.gain.y + math::wide_product<S>(impulse, n.y())};
        ball.push += math::abs<S>(impulse);
    }

    template <class Speed>
    [[nodiscard]] S of_both(std::size_t k, const Speed& speed) const {
        const Column<S>& c = contacts_[k].column;
        S speeds = speed(balls_[c.one]);
        if (c.other != kFixed) speeds += speed(balls_[c.other]);
        return S(math::kVelocityNoise) * math::epsilon<S>() * speeds;
    }

    /// A nose tilted by theta lets 1 - (1 + e) cos^2 theta of the velocity towards it pass through
    /// zero (resolve_tilted_plane); the table bears what would go on approaching.
    template <class ContactType>
    [[nodiscard]] static S in_the_plane(const ContactType& contact) {
        if constexpr (requires { contact.tilt; }) {
            const S& s = contact.tilt;
            if (s == S(0)) return contact.restitution;
            const S e = (S(1) + contact.restitution) * ((S(1) - s) * (S(1) + s)) - S(1);
            return e > S(0) ? e : S(0);
        } else {
            return contact.restitution;
        }
    }

    std::vector<Ball> balls_;
    std::vector<Contact> contacts_;
};

}  // namespace osculo::impact::symmetric
