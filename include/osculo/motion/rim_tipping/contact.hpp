#pragma once

#include <algorithm>
#include <vector>

#include "osculo/math/error_bounds.hpp"
#include "osculo/motion/rim_tipping/field.hpp"
#include "osculo/motion/rim_tipping/series.hpp"

namespace osculo::motion {

/// How a ball's contact with the edge of a hole ends.
enum class ContactEnd {
    lift_off,  ///< the edge pushes no more
    exit,      ///< the tilt is 0 again, and the ball on its way out
    down,      ///< the centre is level with the edge
    turn,      ///< none of these: it swings between two tilts, and this is its second turn
    balanced,  ///< no digit is left that says whether it gets over the saddle
};

/// The motion of a ball that touches the edge, until that ends: exact but for rounding. Units as in
/// field.hpp, sqrt(n r / g) of time.
///
/// Where it ends is told by its energy, in wide precision where it counts; when and how, by Taylor
/// series. No allocation but theirs.
template <math::Scalar S>
class TippingContact {
    using Wide = math::Wide<S>;
    using Field = TippingField<S>;

public:
    struct Start {
        Wide rim;        ///< R
        Wide tilt_sine;  ///< q, >= 0 but for rounding
        Wide cosine;     ///< c, > 0
        Wide rate;       ///< w, of the tilt
        Wide moment;     ///< L
        math::Vec<S> out;
        S heaviness;  ///< n
    };

    explicit TippingContact(const Start& start)
        : start_(start),
          first_(first_of(start)),
          field_{math::narrow(start.rim), math::narrow(speed_square(Wide(S(0))).value),
                 S(math::narrow(start.moment) * math::narrow(start.moment)), start.heaviness} {
        if (pushes()) follow();
    }

    /// Whether the edge pushes at the start; if not, there is no contact to follow.
    [[nodiscard]] bool pushes() const {
        const Wide square = start_.moment * start_.moment;
        const Wide swing = square * first_.q * first_.i * first_.i * first_.i;
        const Wide heavy = first_.c * Wide(start_.heaviness);
        return math::narrow(Wide(heavy - first_.w * first_.w + swing)) > S(0);
    }
    [[nodiscard]] ContactEnd end() const { return end_; }
    [[nodiscard]] const S& duration() const { return duration_; }
    /// False if the numbers cannot follow it.
    [[nodiscard]] bool sound() const { return sound_ && math::is_finite<S>(duration_); }
    [[nodiscard]] std::size_t stretches() const { return stretches_.size(); }
    [[nodiscard]] const S& moment() const { return moment_; }
    /// The largest sine of the tilt on the way.
    [[nodiscard]] const S& highest() const { return highest_; }

    /// Where the ball is at a time, and its motion.
    struct Hand {
        S q, c, rate;
        S inverse;  ///< 1 / d
        math::Vec<S> out;
    };
    /// Requires pushes(), 0 <= t <= duration().
    [[nodiscard]] Hand at(const S& t) const {
        std::size_t i = stretches_.size() - 1;
        while (i > 0 && t < stretches_[i].from) --i;
        const TippingSeries<S>& series = stretches_[i].series;
        const S h = t - stretches_[i].from;
        return {series.tilt()(h), series.cosine()(h), series.rate()(h), series.inverse()(h),
                series.out(h)};
    }

private:
    struct Stretch {
        S from;
        TippingSeries<S> series;
    };
    struct Value {
        Wide value;
        S noise;
    };
    struct Tilt {
        Wide q, c;
    };
    [[nodiscard]] static Tilt tilt_at(const Wide& z) {
        const Wide one{S(1)};
        const Wide norm = one + z * z;
        return {math::wide_quotient(Wide(z + z), norm),
                math::wide_quotient(Wide((one - z) * (one + z)), norm)};
    }

    [[nodiscard]] static typename TippingSeries<S>::Start first_of(const Start& s) {
        return {s.tilt_sine,     s.cosine,
                s.rate,          math::wide_quotient(Wide(S(1)), Wide(s.rim - s.tilt_sine)),
                Wide(s.out.x()), Wide(s.out.y())};
    }

    /// speed^2 around the edge at z, and how much of it may be rounding.
    [[nodiscard]] Value speed_square(const Wide& z) const {
        const auto [q, c] = tilt_at(z);
        const Wide d = start_.rim - q;
        const Wide d0 = start_.rim - start_.tilt_sine;
        const Wide way = q - start_.tilt_sine;
        const Wide sum = q + start_.tilt_sine;
        const Wide pulled = math::wide_quotient(Wide(sum + sum), Wide(c + first_.c));
        const Wide dd = d * d0;
        const Wide swung =
            math::wide_quotient(Wide(start_.moment * start_.moment * (d + d0)), Wide(dd * dd));
        const Wide square = start_.rate * start_.rate;
        const S terms = math::narrow(square) + math::abs<S>(math::narrow(way)) *
                                                   (math::narrow(pulled) + math::narrow(swung));
        return {square + way * (pulled - swung),
                S(S(math::kRimBalance) * math::wide_epsilon<S>() * terms)};
    }
    /// d speed^2 / dq / 2 times c.
    [[nodiscard]] Wide half_slope(const Wide& z) const {
        const auto [q, c] = tilt_at(z);
        const Wide d = start_.rim - q;
        return q - math::wide_quotient(Wide(start_.moment * start_.moment * c), Wide(d * d * d));
    }

    /// The sign of speed^2 at a place where it turns or ends, 0 if that is rounding.
    [[nodiscard]] int sign_at(const S& border) const {
        Wide z(border);
        if (border > S(0) && border < S(1)) {  // a minimum has to be met to all digits
            const typename Field::SpeedSquare f{field_};
            const S step = S(0x1p-20) * std::min<S>(border, S(S(1) - border));
            const S bend = (f.slope(S(border + step)) - f.slope(S(border - step))) / (S(2) * step);
            const S norm = S(1) + border * border;
            for (int i = 0; i < 3 && bend != S(0); ++i) {
                z = z - Wide(math::narrow(half_slope(z)) * (S(4) / norm) / bend);
            }
        }
        const Value found = speed_square(z);
        const S value = math::narrow(found.value);
        return value > found.noise ? 1 : value < -found.noise ? -1 : 0;
    }

    /// What comes first from z on.
    struct Ahead {
        ContactEnd end;
        S z;
        bool turns;
    };
    [[nodiscard]] Ahead look_ahead(const S& z, bool outwards, int turns) const {
        const typename Field::SpeedSquare speed{field_};
        const typename Field::Push push{field_};
        const auto pushes = field_.borders(push);
        const auto speeds = field_.borders(speed);
        const S lost = first_fall<S>(push, pushes, z, outwards, [&](std::size_t i) {
            return push(pushes.z[i]) > S(0) ? 1 : -1;
        });
        bool uncertain = false;
        const S turn = first_fall<S>(speed, speeds, z, outwards, [&](std::size_t i) {
            const int sign = sign_at(speeds.z[i]);
            if (sign == 0) uncertain = true;
            return sign;
        });
        const bool turns_first = turn <= S(1) && (outwards ? !(lost <= turn) : turn <= lost);
        if (turns_first) {
            if (uncertain) return {ContactEnd::balanced, turn, false};
            return {ContactEnd::turn, turn, turns == 0};
        }
        if (lost <= S(1))
            return {lost < S(1) ? ContactEnd::lift_off : ContactEnd::down, lost, false};
        return outwards ? Ahead{ContactEnd::exit, S(0), false}
                        : Ahead{ContactEnd::down, S(1), false};
    }

    /// Where the edge stops pushing, from the z of that to all digits.
    [[nodiscard]] Tilt lift_off(const S& at) const {
        const typename Field::Push push{field_};
        const S slope = push.slope(at);
        const Wide square = start_.moment * start_.moment;
        Wide z(at);
        for (int i = 0; i < 2 && slope != S(0); ++i) {
            const Tilt tilt = tilt_at(z);
            const Wide d = start_.rim - tilt.q;
            const Wide swing = math::wide_quotient(Wide(square * tilt.q), Wide(d * d * d));
            const Wide value = tilt.c * Wide(start_.heaviness) - speed_square(z).value + swing;
            const S step = math::narrow(value) / slope;
            if (!(math::abs<S>(step) < S(0x1p-20))) break;  // it only just stops
            z = z - Wide(step);
        }
        return tilt_at(z);
    }
    /// Where it leaves: where the tilt is 0, or where it was if that was outside by rounding.
    [[nodiscard]] Tilt exit_tilt() const {
        if (start_.tilt_sine < Wide(S(0))) return {first_.q, first_.c};
        return {Wide(S(0)), Wide(S(1))};
    }

    void follow() {
        constexpr std::size_t kMostStretches = 4000;
        const S q = std::max<S>(math::narrow(start_.tilt_sine), S(0));
        const S c = math::narrow(first_.c);
        S z = q / (S(1) + c);
        const Wide square = start_.moment * start_.moment;
        const Wide pull = first_.q - square * first_.c * first_.i * first_.i * first_.i;
        const S rate = math::narrow(start_.rate);
        bool outwards = rate < S(0) || (rate == S(0) && math::narrow(pull) < S(0));
        moment_ = math::narrow(start_.moment);
        highest_ = q;
        Wide now{S(0)};
        typename TippingSeries<S>::Start place = first_;
        stretches_.push_back({S(0), TippingSeries<S>(place, start_.moment)});
        if (rate == S(0) && math::narrow(pull) == S(0)) {
            end_ = ContactEnd::balanced;
            return;
        }
        S since(0);  // in the last stretch, from where the way ahead is looked at
        const auto next = [&] {
            const S length = stretches_.back().series.length();
            now = now + length;
            place = stretches_.back().series.at(length);
            stretches_.push_back({math::narrow(now), TippingSeries<S>(place, start_.moment)});
            since = S(0);
        };
        for (int turns = 0;; ++turns) {
            const Ahead ahead = look_ahead(z, outwards, turns);
            end_ = ahead.end;
            if (end_ == ContactEnd::balanced) return;
            const S reached = S(2) * ahead.z / (S(1) + ahead.z * ahead.z);
            highest_ = std::max<S>(highest_, std::min<S>(reached, S(1)));
            if (ahead.end == ContactEnd::turn) {
                // The rate leaves its sign.
                const auto goes_on = [&](const S& t) {
                    const S w = stretches_.back().series.rate()(t);
                    return outwards ? w < S(0) : w > S(0);
                };
                // From a start at a turn, or so near that rounding says so, it has to get going.
                while (goes_on(stretches_.back().series.length()) &&
                       stretches_.size() < kMostStretches) {
                    next();
                }
                const S length = stretches_.back().series.length();
                since = math::bracketed_root<S>(stretches_.back().series.rate(), since, length,
                                                outwards);
            } else {
                const Tilt target = ahead.end == ContactEnd::lift_off ? lift_off(ahead.z)
                                    : ahead.end == ContactEnd::exit   ? exit_tilt()
                                                                      : Tilt{S(1), S(0)};
                const auto beyond = [&] {
                    return stretches_.back().series.beyond(target.q, target.c);
                };
                const auto short_of = [&](const S& t) {
                    const S rest = beyond()(t);
                    return outwards ? rest > S(0) : rest < S(0);
                };
                while (short_of(stretches_.back().series.length()) &&
                       stretches_.size() < kMostStretches) {
                    next();
                }
                since = math::bracketed_root<S>(beyond(), since, stretches_.back().series.length(),
                                                !outwards);
            }
            duration_ = math::narrow(Wide(now + since));
            if (stretches_.size() >= kMostStretches) sound_ = false;
            if (!ahead.turns || !sound_) return;
            outwards = !outwards;
            z = ahead.z;
        }
    }

    Start start_;
    typename TippingSeries<S>::Start first_;
    Field field_;
    std::vector<Stretch> stretches_;
    ContactEnd end_ = ContactEnd::lift_off;
    S moment_{0};
    S duration_{0};
    S highest_{0};
    bool sound_ = true;
};

}  // namespace osculo::motion
