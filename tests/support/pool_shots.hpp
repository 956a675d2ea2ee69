#pragma once

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The recorded shots of tests/reference/pool_shots.txt; see the README there.
namespace osculo::support::pool_shots {

enum class Phase { rest, spinning, sliding, rolling, pocketed };

struct State {
    std::string ball;
    Phase phase = Phase::rest;
    std::array<double, 2> position{};
    std::array<double, 2> velocity{};
    std::array<double, 3> spin{};
};

struct Event {
    std::string type;
    double time = 0;
    std::vector<std::string> ids;  ///< the ball first, then what it meets
    std::vector<State> before;     ///< of the balls in it, in the order of ids
    std::vector<State> after;
};

struct Segment {
    std::string id;
    std::array<double, 2> from{};
    std::array<double, 2> to{};
    double height = 0;
    int side = 0;
    std::array<double, 2> normal{};
};

struct Circle {
    std::string id;
    std::array<double, 2> center{};
    double radius = 0;
    double height = 0;  ///< of a jaw's nose
};

struct Table {
    double width = 0;
    double length = 0;
    std::vector<Segment> segments;
    std::vector<Circle> arcs;
    std::vector<Circle> pockets;
};

struct Balls {
    double mass = 0, radius = 0;
    double sliding = 0, rolling = 0, spinning = 0;
    double ball_friction = 0, ball_restitution = 0, cushion_restitution = 0, cushion_friction = 0;
    double gravity = 0;
};

struct CueSpec {
    double mass = 0, tip_radius = 0, end_mass = 0;
};

struct Cue {
    std::string ball;
    double speed = 0, azimuth = 0, elevation = 0, a = 0, b = 0;  ///< angles in degrees
};

struct Shot {
    std::string id, kind, table, balls, ball_law, cushion_law;
    double time = 0;
    Cue cue;
    std::vector<State> initial;
    std::vector<Event> events;
    std::vector<State> final;
};

struct Record {
    std::map<std::string, Table> tables;
    std::map<std::string, Balls> balls;
    std::map<std::string, CueSpec> cues;  ///< by table
    std::vector<Shot> shots;
};

namespace detail {

class Reader {
public:
    explicit Reader(const std::string& path) : in_(path) {
        if (!in_) throw std::runtime_error("cannot open " + path);
    }

    Record read() {
        for (std::string text; std::getline(in_, text);) {
            if (text.empty() || text[0] == '#') continue;
            ++line_;
            words_ = std::istringstream(text);
            const std::string kind = word();
            if (kind.size() == 1) {
                state(kind[0]);
            } else if (kind == "shot") {
                shot();
            } else if (kind == "cue") {
                cue();
            } else {
                part_of_table(kind);
            }
            if (!(words_ >> std::ws).eof()) fail("trailing words");
        }
        if (record_.shots.empty()) fail("no shots");
        return std::move(record_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error("item " + std::to_string(line_) + ": " + what);
    }
    std::string word() {
        std::string result;
        if (!(words_ >> result)) fail("a word is missing");
        return result;
    }
    double number() { return parse(word()); }
    double parse(const std::string& text) const {
        std::size_t end = 0;
        const double result = std::stod(text, &end);
        if (end != text.size()) fail("not a number: " + text);
        return result;
    }
    template <std::size_t N>
    std::array<double, N> numbers() {
        std::array<double, N> result{};
        for (double& x : result) x = number();
        return result;
    }
    /// N numbers, or one "=" for those of another state.
    template <std::size_t N>
    std::array<double, N> numbers_or(const std::array<double, N>* same) {
        const std::string first = word();
        if (first == "=") {
            if (same == nullptr) fail("nothing to repeat");
            return *same;
        }
        std::array<double, N> result{};
        result[0] = parse(first);
        for (std::size_t i = 1; i < N; ++i) result[i] = number();
        return result;
    }

    void part_of_table(const std::string& kind) {
        if (kind == "table") {
            table_ = &record_.tables[word()];
            table_->width = number();
            table_->length = number();
        } else if (kind == "segment") {
            Segment s{word(), numbers<2>(), numbers<2>(), number(), 0, {}};
            s.side = static_cast<int>(number());
            s.normal = numbers<2>();
            table_->segments.push_back(s);
        } else if (kind == "arc") {
            table_->arcs.push_back({word(), numbers<2>(), number(), number()});
        } else if (kind == "pocket") {
            table_->pockets.push_back({word(), numbers<2>(), number(), 0});
        } else if (kind == "balls") {
            record_.balls[word()] = {number(), number(), number(), number(), number(),
                                     number(), number(), number(), number(), number()};
        } else if (kind == "cue_spec") {
            record_.cues[word()] = {number(), number(), number()};
        } else if (kind == "e") {
            event();
        } else {
            fail("unknown item " + kind);
        }
    }
    void shot() {
        record_.shots.push_back(
            {word(), word(), word(), word(), word(), word(), number(), {}, {}, {}, {}});
        last_.clear();
    }
    void cue() {
        record_.shots.back().cue = {word(), number(), number(), number(), number(), number()};
    }
    void event() {
        Event e{word(), number(), {}, {}, {}};
        for (std::string id; words_ >> id;) e.ids.push_back(id);
        record_.shots.back().events.push_back(std::move(e));
    }
    void state(char kind) {
        if (kind == 'e') return event();
        State s;
        s.ball = word();
        s.phase = static_cast<Phase>(static_cast<int>(number()));
        const auto known = last_.find(s.ball);
        const State* same = known == last_.end() ? nullptr : &known->second;
        s.position = numbers_or<2>(same ? &same->position : nullptr);
        s.velocity = numbers_or<2>(same ? &same->velocity : nullptr);
        s.spin = numbers_or<3>(same ? &same->spin : nullptr);
        last_[s.ball] = s;
        Shot& current = record_.shots.back();
        switch (kind) {
            case 'i': current.initial.push_back(s); break;
            case 'b': current.events.back().before.push_back(s); break;
            case 'a': current.events.back().after.push_back(s); break;
            case 'f': current.final.push_back(s); break;
            default: fail("unknown state");
        }
    }

    std::ifstream in_;
    std::istringstream words_;
    Record record_;
    Table* table_ = nullptr;
    std::map<std::string, State> last_;
    int line_ = 0;
};

}  // namespace detail

[[nodiscard]] inline Record read(const std::string& path) {
    return detail::Reader(path).read();
}

}  // namespace osculo::support::pool_shots
