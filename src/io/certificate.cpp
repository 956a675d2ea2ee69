#include "io/certificate.hpp"

#include "io/members.hpp"

namespace osculo::io {
namespace {

using Names = std::string_view[];

void write_digits(Members& members, bool confirmed, std::optional<double> time, double position,
                  double velocity) {
    members.boolean("confirmed", confirmed);
    if (confirmed) {
        if (time) members.number("time", *time);
        members.number("position", position);
        members.number("velocity", velocity);
    }
    members.close();
}

std::optional<std::uint64_t> read_index(const Fields& fields, std::string_view name,
                                        std::size_t count) {
    const auto index = fields.find(name);
    if (!index) return std::nullopt;
    if (index->natural() >= count) index->fail("must be the index of an event");
    return index->natural();
}

}  // namespace

void write_certificate(JsonText& json, const Run& run, const Certificate& certificate) {
    constexpr std::string_view kIndent = "    ";
    const auto key = [&](std::string_view name) { json.next_member(kIndent, name); };
    json.raw("{\n    \"certain\": ");
    json.boolean(certificate.certain());
    key("reference");
    json.string(certificate.reference);
    key("witness");
    json.string(certificate.witness);
    key("conclusive");
    json.boolean(certificate.conclusive);
    if (certificate.first_uncertain) {
        key("first_uncertain");
        json.number(*certificate.first_uncertain);
    }
    if (certificate.first_out_of_order) {
        key("first_out_of_order");
        json.number(*certificate.first_out_of_order);
    }
    key("balls");
    json.lines(certificate.balls, kIndent, [&](const Certificate::BallDigits& ball) {
        const auto index = static_cast<std::size_t>(&ball - certificate.balls.data());
        Members members(json);
        members.string("id", run.scene.balls[index].id);
        write_digits(members, ball.confirmed, std::nullopt, ball.position, ball.velocity);
    });
    key("events");
    json.lines(certificate.events, kIndent, [&](const Certificate::EventDigits& event) {
        Members members(json);
        write_digits(members, event.confirmed, event.time, event.position, event.velocity);
    });
    json.raw("\n  }");
}

Certificate read_certificate(const Value& value, const Run& run) {
    static constexpr Names kKeys{"certain",         "reference",          "witness", "conclusive",
                                 "first_uncertain", "first_out_of_order", "balls",   "events"};
    static constexpr Names kBallKeys{"id", "confirmed", "position", "velocity"};
    static constexpr Names kEventKeys{"confirmed", "time", "position", "velocity"};
    const Fields fields(value, kKeys);
    Certificate certificate;
    certificate.reference = fields.require("reference").text();
    certificate.witness = fields.require("witness").text();
    certificate.conclusive = fields.require("conclusive").boolean();
    const Value balls = fields.require("balls");
    balls.for_each([&](const Value& element) {
        const Fields members(element, kBallKeys);
        const Value id = members.require("id");
        const std::size_t place = certificate.balls.size();
        if (place >= run.scene.balls.size() || id.text() != run.scene.balls[place].id) {
            id.fail("must be in the order of the scene's balls");
        }
        Certificate::BallDigits ball;
        ball.confirmed = members.require("confirmed").boolean();
        if (ball.confirmed) {
            ball.position = members.require("position").number();
            ball.velocity = members.require("velocity").number();
        }
        certificate.balls.push_back(ball);
    });
    if (certificate.balls.size() != run.scene.balls.size()) {
        balls.fail("must have as many elements as the scene has balls");
    }
    fields.require("events").for_each([&](const Value& element) {
        const Fields members(element, kEventKeys);
        Certificate::EventDigits event;
        event.confirmed = members.require("confirmed").boolean();
        if (event.confirmed) {
            event.time = members.require("time").number();
            event.position = members.require("position").number();
            event.velocity = members.require("velocity").number();
        }
        certificate.events.push_back(event);
    });
    const std::size_t count = certificate.events.size();
    certificate.first_uncertain = read_index(fields, "first_uncertain", count);
    certificate.first_out_of_order = read_index(fields, "first_out_of_order", count);
    const Value certain = fields.require("certain");
    if (certain.boolean() != certificate.certain()) {
        certain.fail("must be what its events and balls give");
    }
    return certificate;
}

}  // namespace osculo::io
