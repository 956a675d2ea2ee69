#include <array>
#include <charconv>

#include "io/members.hpp"
#include "osculo/io.hpp"
#include "osculo/shots.hpp"
#include "osculo/version.hpp"

namespace osculo::io {
namespace {

constexpr std::string_view kOutcomesSchema = "osculo/outcomes-1";

template <class Thing>
std::vector<std::string> ids_of(const std::vector<Thing>& things) {
    std::vector<std::string> ids;
    ids.reserve(things.size());
    for (const Thing& thing : things) ids.push_back(thing.id);
    return ids;
}

std::size_t place(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

void write_ball(JsonText& json, const Scene& scene, const BatchResult& result, std::size_t k) {
    Members members(json);
    members.string("fate", to_string(result.fate[k]));
    if (result.fate[k] != ShotFate::absent) {
        members.vector("position", result.position[k]);
        members.number("balls", std::uint64_t{result.ball_contacts[k]});
        members.number("cushions", std::uint64_t{result.cushion_contacts[k]});
    }
    if (result.rim[k] >= 0) {
        members.string("rim", scene.rims[place(result.rim[k])].id);
        members.number("time", result.capture_time[k]);
    }
    members.close();
}

void write_json(JsonText& json, const Scene& scene, const BatchResult& result, std::size_t row,
                std::uint64_t shot, std::string_view error) {
    Members members(json);
    members.number("shot", shot);
    members.string("status", to_string(result.status[row]));
    if (!error.empty()) members.string("error", error);
    if (result.status[row] < ShotStatus::invalid) {
        members.number("time", result.time[row]);
        members.number("events", result.event_count[row]);
        if (result.cue_ball[row] >= 0) {
            members.string("cue_ball", scene.balls[place(result.cue_ball[row])].id);
        }
        if (result.first_hit[row] >= 0) {
            members.string("first_hit", scene.balls[place(result.first_hit[row])].id);
        }
        members.number("cushions_before_hit", std::uint64_t{result.cushions_before_hit[row]});
        members.number("cushions_after_hit", std::uint64_t{result.cushions_after_hit[row]});
        members.number("driven_to_cushion", std::uint64_t{result.driven_to_cushion[row]});
        members.number("kisses", std::uint64_t{result.kisses[row]});
        if (result.settled_count[row] > 0) {
            members.number("settled_count", result.settled_count[row]);
        }
        members.key("balls");
        for (std::size_t i = 0; i < result.balls; ++i) {
            json.raw(i == 0 ? "[" : ", ");
            write_ball(json, scene, result, row * result.balls + i);
        }
        json.raw(result.balls == 0 ? "[]" : "]");
    }
    members.close();
    json.raw("\n");
}

/// In quotes if it has to be.
std::string csv_text(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) {
        result += c == '\n' || c == '\r' ? ' ' : c;  // a record stays on its line
        if (c == '"') result += '"';
    }
    return result + '"';
}

template <class Number>
void add_number(std::string& text, Number value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text += ',';
    text.append(buffer.data(), end);
}

void add_text(std::string& text, std::string_view value) {
    text += ',';
    text += csv_text(value);
}

template <class Thing>
void add_id(std::string& text, const std::vector<Thing>& things, std::int32_t index) {
    add_text(text, index < 0 ? std::string_view() : std::string_view(things[place(index)].id));
}

void append_csv(std::string& text, const Scene& scene, const BatchResult& result, std::size_t row,
                std::uint64_t shot, std::string_view error) {
    text += std::to_string(shot);
    add_text(text, to_string(result.status[row]));
    add_number(text, result.time[row]);
    add_number(text, result.event_count[row]);
    add_id(text, scene.balls, result.cue_ball[row]);
    add_id(text, scene.balls, result.first_hit[row]);
    add_number(text, result.cushions_before_hit[row]);
    add_number(text, result.cushions_after_hit[row]);
    add_number(text, result.driven_to_cushion[row]);
    add_number(text, result.kisses[row]);
    add_number(text, result.settled_count[row]);
    for (std::size_t k = row * result.balls; k < (row + 1) * result.balls; ++k) {
        add_text(text, to_string(result.fate[k]));
        add_number(text, result.position[k].x);
        add_number(text, result.position[k].y);
        add_id(text, scene.rims, result.rim[k]);
        if (result.rim[k] >= 0) {
            add_number(text, result.capture_time[k]);
        } else {
            text += ',';
        }
    }
    add_text(text, error);
    text += '\n';
}

std::string csv_header(const Scene& scene) {
    std::string text =
        "shot,status,time,events,cue_ball,first_hit,cushions_before_hit,cushions_after_hit,"
        "driven_to_cushion,kisses,settled_count";
    for (const Ball& ball : scene.balls) {
        for (const char* what : {".fate", ".x", ".y", ".rim", ".capture_time"}) {
            add_text(text, ball.id + what);
        }
    }
    return text + ",error\n";
}

}  // namespace

std::string fingerprint(const Scene& scene, const BatchOptions& options) {
    Scene limited = scene;
    limited.limits = options.limits.value_or(scene.limits);
    const std::string text =
        scene_to_json(limited) + std::string(to_string(options.precision)) + kVersion;
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string result;
    for (int shift = 60; shift >= 0; shift -= 4) result += kHex[(hash >> shift) & 15U];
    return result;
}

std::string outcomes_header(OutcomeFormat format, const Scene& scene, const BatchOptions& options) {
    if (format == OutcomeFormat::csv) return csv_header(scene);
    JsonText json;
    Members members(json);
    members.string("schema", kOutcomesSchema);
    members.string("fingerprint", fingerprint(scene, options));
    members.string("precision", to_string(options.precision));
    members.key("balls");
    json.strings(ids_of(scene.balls));
    members.key("rims");
    json.strings(ids_of(scene.rims));
    members.close();
    json.raw("\n");
    return json.take();
}

void append_outcome(std::string& text, OutcomeFormat format, const Scene& scene,
                    const BatchResult& result, std::size_t row, std::uint64_t shot,
                    std::string_view error) {
    if (format == OutcomeFormat::csv) {
        append_csv(text, scene, result, row, shot, error);
        return;
    }
    JsonText json(std::move(text));
    write_json(json, scene, result, row, shot, error);
    text = json.take();
}

}  // namespace osculo::io
