#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "support/builder.hpp"
#include "support/random.hpp"

/// Random clusters as scenes: balls and walls that touch and nowhere overlap.
namespace osculo::support {

/// The shape is drawn first, then walls around it, then everything else.
template <class Type>
struct RandomTouching {
    using S = typename Type::Scalar;
    using Vec = math::Vec<S>;

    Builder<Type> builder;
    std::string name;

    /// [doublings]: of masses below and above 1, at most.
    explicit RandomTouching(Random& source, int doublings = 10)
        : random_(&source), doublings_(doublings) {
        switch (random_->below(5)) {
            case 0: add_chain(); break;
            case 1: add_rack(); break;
            case 2: add_wedge(); break;
            default: grow(random_->coin()); break;
        }
        if (random_->coin()) add_walls();
        set_masses();
        set_velocities();
        const S values[] = {S(0), S(3) / S(10), S(19) / S(20), S(1), S(1), S(1)};
        const S e = values[random_->below(6)];
        builder.restitution(e, random_->below(4) == 0 ? values[random_->below(6)] : e);
    }

private:
    struct Disk {
        Vec place;
        S radius;
    };

    void add(const Vec& place, const S& radius = S(1)) {
        disks_.push_back({place, radius});
        builder.ball(place, Vec(S(0), S(0)), radius);
    }
    [[nodiscard]] bool is_free(const Vec& place, const S& radius) const {
        for (const Disk& disk : disks_) {
            const S reach = (disk.radius + radius) * (S(1) - S(8) * math::epsilon<S>());
            if (math::norm<S>(place - disk.place) < reach) return false;
        }
        return true;
    }

    void add_chain() {
        name = "chain";
        axis_ = random_->direction<S>();
        const int count = random_->between(2, 8);
        for (int i = 0; i < count; ++i) add(S(2 * i) * axis_);
    }
    void add_rack() {
        name = "rack";
        const int rows = random_->between(2, 4);
        const S height = math::square_root<S>(S(3));
        for (int row = 0; row < rows; ++row) {
            for (int place = 0; place <= row; ++place) {
                add({S(row) * height, S(2 * place - row)});
            }
        }
        if (random_->coin()) add({S(-2), S(0)});
    }
    /// One ball where two walls meet at a small angle.
    void add_wedge() {
        name = "wedge";
        add({S(0), S(0)});
        const S half = random_->magnitude<S>(-11, 0) / S(2);
        const S size = math::square_root<S>(S(1) + half * half);
        add_wall({half / size, S(1) / size});
        add_wall({half / size, S(-1) / size});
    }
    /// Each ball touches one before it, anywhere, and sometimes a second one.
    void grow(bool notches) {
        name = "heap";
        const int count = random_->between(3, 8);
        const bool alike = random_->coin();
        add({S(0), S(0)});
        for (int tries = 0; tries < 100 && static_cast<int>(disks_.size()) < count; ++tries) {
            const S radius = alike ? S(1) : random_->magnitude<S>(-2, 1);
            const Disk& one =
                disks_[static_cast<std::size_t>(random_->below(static_cast<int>(disks_.size())))];
            Vec place = one.place + (one.radius + radius) * random_->direction<S>();
            if (notches && disks_.size() > 1) {
                const Disk& other = disks_[static_cast<std::size_t>(
                    random_->below(static_cast<int>(disks_.size())))];
                if (!find_notch(one, other, radius, place)) continue;
            }
            if (is_free(place, radius)) add(place, radius);
        }
    }
    /// Where a ball touches both.
    [[nodiscard]] static bool find_notch(const Disk& one, const Disk& other, const S& radius,
                                         Vec& place) {
        const Vec apart = other.place - one.place;
        const S d = math::norm<S>(apart);
        const S a = one.radius + radius, b = other.radius + radius;
        if (!(d > S(0))) return false;
        const S along = (d * d + a * a - b * b) / (S(2) * d);
        const S square = a * a - along * along;
        if (!(square > S(0))) return false;
        const Vec unit = apart / d;
        place = one.place + along * unit + math::square_root<S>(square) * Vec(-unit.y(), unit.x());
        return true;
    }

    void add_walls() {
        const int count = random_->between(1, 3);
        for (int i = 0; i < count; ++i) {
            const bool behind = name == "chain" && random_->coin();
            add_wall(behind ? Vec(i % 2 == 0 ? axis_ : Vec(-axis_)) : random_->direction<S>());
        }
    }
    /// Touches what lies furthest in that direction.
    void add_wall(const Vec& normal) {
        S furthest = math::dot<S>(disks_[0].place, normal) + disks_[0].radius;
        for (const Disk& disk : disks_) {
            furthest = std::max<S>(furthest, math::dot<S>(disk.place, normal) + disk.radius);
        }
        const Vec foot = furthest * normal, along = S(1000) * Vec(-normal.y(), normal.x());
        builder.wall(foot - along, foot + along);
    }

    void set_masses() {
        const int kind = random_->below(3);
        if (kind == 0) return;
        name += kind == 1 ? ", similar masses" : ", all kinds of masses";
        for (auto& body : builder.scene.bodies) {
            body.mass = kind == 1 ? S(0.5) + random_->unit<S>()
                                  : random_->magnitude<S>(-doublings_, doublings_ - 1);
        }
    }
    void set_velocities() {
        for (auto& body : builder.scene.bodies) {
            if (random_->coin()) continue;
            const S speed =
                random_->below(8) == 0 ? random_->magnitude<S>(-20, 20) : random_->unit<S>();
            body.state.velocity = speed * random_->direction<S>();
        }
    }

    Random* random_;
    int doublings_;
    std::vector<Disk> disks_;
    Vec axis_{S(1), S(0)};
};

}  // namespace osculo::support
