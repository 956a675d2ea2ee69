#include <array>
#include <charconv>
#include <cstdint>

#include <boost/crc.hpp>

#include "facade/simulation_state.hpp"
#include "io/json_text.hpp"
#include "io/members.hpp"
#include "io/read.hpp"
#include "osculo/io.hpp"
#include "osculo/version.hpp"

// A snapshot is a line, "osculo/snapshot-1 CHECKSUM SIZE", then SIZE bytes of JSON, which say what
// is played and how, then the state of the engine. The checksum is of all that follows the line.
namespace osculo::io {
namespace {

constexpr std::string_view kSchema = "osculo/snapshot-1";
constexpr std::array<std::string_view, 3> kRecords{"none", "events", "pieces"};

/// CRC-64 as in xz, in 16 hexadecimal digits: any error within 64 bits is seen.
std::string checksum(std::string_view bytes) {
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~std::uint64_t(0), ~std::uint64_t(0), true, true>
        crc;
    crc.process_bytes(bytes.data(), bytes.size());
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(crc.checksum() >> shift) & 15];
    return text;
}

/// What comes before the next [end], which is taken away too; everything if there is none.
std::string_view take_until(std::string_view& text, char end) {
    const std::size_t size = std::min(text.find(end), text.size());
    const std::string_view result = text.substr(0, size);
    text.remove_prefix(std::min(size + 1, text.size()));
    return result;
}

struct Parts {
    std::string_view json;
    std::string_view state;
};

Parts parts_of(std::string_view bytes) {
    if (!is_snapshot(bytes)) throw FormatError("is no snapshot");
    std::string_view line = take_until(bytes, '\n');
    const std::string_view schema = take_until(line, ' ');
    if (schema != kSchema) {
        throw FormatError("must be " + std::string(kSchema) + ", but it is " + std::string(schema));
    }
    const std::string_view sum = take_until(line, ' ');
    std::size_t size = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), size);
    if (error != std::errc() || end != line.data() + line.size() || size > bytes.size() ||
        sum != checksum(bytes)) {
        throw FormatError("is damaged: its checksum is not that of its content");
    }
    return {bytes.substr(0, size), bytes.substr(size)};
}

Options options_of(const Fields& fields) {
    static constexpr std::array<std::string_view, 5> kPrecisions{"double", "extended", "quad", "50",
                                                                 "100"};
    Options options;
    const Value precision = fields.require("precision");
    options.precision = *precision_from_string(kPrecisions[choice(precision, kPrecisions)]);
    options.record = static_cast<Record>(choice(fields.require("record"), kRecords));
    options.audit = fields.require("audit").boolean();
    options.certify = fields.require("certify").boolean();
    return options;
}

}  // namespace

bool is_snapshot(std::string_view bytes) {
    return bytes.starts_with(kSchema.substr(0, kSchema.size() - 1));
}

std::string simulation_to_snapshot(const Simulation& simulation) {
    const Options& options = simulation.options();
    JsonText json;
    Members members(json);
    members.string("version", kVersion);
    members.string("engine", choose_engine(simulation.scene(), options).name);
    members.string("precision", to_string(options.precision));
    members.string("record", kRecords[static_cast<std::size_t>(options.record)]);
    members.boolean("audit", options.audit);
    members.boolean("certify", options.certify);
    json.next_member("  ", "scene");
    write_scene(json, simulation.scene(), "  ");
    members.close();
    json.raw("\n");
    std::string content = json.take();
    const std::size_t size = content.size();
    content += SimulationState::save(simulation);
    return std::string(kSchema) + ' ' + checksum(content) + ' ' + std::to_string(size) + '\n' +
           content;
}

Simulation simulation_from_snapshot(std::string_view bytes) {
    static constexpr std::array<std::string_view, 7> kKeys{
        "version", "engine", "precision", "record", "audit", "certify", "scene"};
    const Parts parts = parts_of(bytes);
    const Document document = parse_json(parts.json);
    const Value whole(document, "snapshot");
    // The version comes first: nothing else of another one need make sense.
    if (const auto version = whole.member("version")) {
        if (version->text() != kVersion) {
            throw FormatError("is of osculo " + std::string(version->text()) + ", and this is " +
                              kVersion + ": another version cannot play it on bit for bit");
        }
    }
    const Fields fields(whole, kKeys);
    static_cast<void>(fields.require("version"));
    const Options options = options_of(fields);
    const Scene scene = read_scene(fields.require("scene"));
    const std::string engine = choose_engine(scene, options).name;
    const Value known = fields.require("engine");
    if (known.text() != engine) known.fail("must be " + engine);
    try {
        return SimulationState::restore(scene, options, parts.state);
    } catch (const facade::BadState& error) {
        throw FormatError(error.what());
    }
}

}  // namespace osculo::io
