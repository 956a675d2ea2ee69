#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "facade/simulation_state.hpp"
#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/version.hpp"
#include "support/simulations.hpp"

namespace osculo::io {
namespace {

using osculo::test::expect_same;
using osculo::test::simulations;

// Stopped by time and by events in turn, kept, restored, and played on from there.
TEST(Snapshot, PlaysOnAsIfItHadNeverStopped) {
    for (const auto& [given, precision] : simulations()) {
        const Scene scene = scene_from_json(scene_to_json(given));  // no numbers of unused laws
        const Options options{.precision = precision};
        SCOPED_TRACE(choose_engine(scene, options).name);
        const osculo::Run whole = simulate(scene, options);
        Simulation simulation(scene, options);
        std::vector<std::string> left_behind;
        for (int part = 0; part < 7; ++part) {
            Limits limits = scene.limits;
            if (part % 2 == 0) {
                limits.events = std::max<std::uint64_t>(
                    1, whole.event_count * static_cast<std::uint64_t>(part) / 7);
            } else {
                limits.time = whole.time * part / 7;
            }
            if (part > 0) simulation.play(limits);  // the first one has not been played
            left_behind.push_back(simulation_to_snapshot(simulation));
            simulation = simulation_from_snapshot(left_behind.back());
            EXPECT_EQ(simulation_to_snapshot(simulation), left_behind.back());
        }
        EXPECT_EQ(simulation.play(), whole.status);
        expect_same(simulation.result(), whole);
        for (const std::string& bytes : left_behind) {
            Simulation other = simulation_from_snapshot(bytes);
            EXPECT_EQ(other.play(), whole.status);
            expect_same(other.result(), whole);
        }
        // At its end there is nothing more to play.
        simulation = simulation_from_snapshot(simulation_to_snapshot(simulation));
        EXPECT_EQ(simulation.play(), whole.status);
        expect_same(simulation.result(), whole);
    }
}

TEST(Snapshot, KeepsWhatTheOptionsAskFor) {
    const Scene scene = presets::make("break");
    for (const Record record : {Record::none, Record::events, Record::pieces}) {
        for (const bool checked : {false, true}) {
            const Options options{.record = record, .audit = checked, .certify = checked};
            Simulation simulation(scene, options);
            simulation.play({0.3, 1000});
            simulation = simulation_from_snapshot(simulation_to_snapshot(simulation));
            EXPECT_EQ(simulation.options().record, record);
            EXPECT_EQ(simulation.time(),
                      simulation_from_snapshot(simulation_to_snapshot(simulation)).time());
            simulation.play();
            const osculo::Run whole = simulate(scene, options);
            expect_same(simulation.result(), whole);
            EXPECT_EQ(run_to_json(simulation.result()), run_to_json(whole));
        }
    }
}

TEST(Snapshot, GrowsWithWhatIsRecordedOnly) {
    Scene scene = presets::make("gas");
    scene.limits = {1e6, 1'000'000};
    Simulation simulation(scene, {.record = Record::none});
    simulation.play({1e6, 10});
    const std::string early = simulation_to_snapshot(simulation);
    simulation.play({1e6, 100'000});
    EXPECT_EQ(simulation.event_count(), 100'000U);
    EXPECT_NEAR(static_cast<double>(simulation_to_snapshot(simulation).size()),
                static_cast<double>(early.size()), 64);
    EXPECT_EQ(simulation_from_snapshot(simulation_to_snapshot(simulation)).event_count(), 100'000U);
}

TEST(Snapshot, OfAnotherTimeGoesOnPastTheOldLimit) {
    Scene scene = osculo::test::pulling_scene(RollingMotion{0.01});
    scene.limits.time = 0.2;
    Simulation simulation(scene);
    simulation.play();
    simulation = simulation_from_snapshot(simulation_to_snapshot(simulation));
    scene.limits.time = 1;
    simulation.set_limits(scene.limits);
    simulation = simulation_from_snapshot(simulation_to_snapshot(simulation));
    EXPECT_EQ(simulation.limits(), scene.limits);
    simulation.play();
    expect_same(simulation.result(), simulate(scene));
}

// A ball that loses nine tenths of its normal speed at each bounce along the inside of a circle.
TEST(Snapshot, RemembersHowOftenNoTimeHasPassed) {
    Scene scene;
    scene.arcs = {{"circle", {0, 0}, 10}};
    scene.balls = {osculo::test::ball("a", {5, 0}, {0.3, 1}, 1)};
    scene.impacts.ball_cushion.restitution = 0.1;
    scene.limits.time = 1000;
    const osculo::Run whole = simulate(scene);
    EXPECT_EQ(whole.status, Status::zeno);
    Simulation simulation(scene);
    for (std::uint64_t events = 1; simulation.play({1000, events}) == Status::event_limit;
         ++events) {
        simulation = simulation_from_snapshot(simulation_to_snapshot(simulation));
    }
    simulation.play();
    expect_same(simulation.result(), whole);
}

std::string error_of(const std::string& bytes) {
    try {
        static_cast<void>(simulation_from_snapshot(bytes));
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

TEST(Snapshot, ThatIsDamagedIsAFormatError) {
    Simulation simulation(osculo::test::pulling_scene(UniformMotion{}));
    simulation.play({60, 6});
    const std::string bytes = simulation_to_snapshot(simulation);
    ASSERT_EQ(error_of(bytes), "");
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_NE(error_of(bytes.substr(0, length)), "") << length;
    }
    std::mt19937_64 random(7);
    for (std::size_t place = 0; place < bytes.size(); ++place) {
        std::string other = bytes;
        other[place] = static_cast<char>(other[place] ^ (1 + random() % 255));
        ASSERT_NE(error_of(other), "") << place;
    }
    EXPECT_NE(error_of(bytes + "x"), "");
    EXPECT_EQ(error_of(""), "is no snapshot");
    EXPECT_EQ(error_of("{}"), "is no snapshot");
    EXPECT_EQ(error_of("osculo/snapshot-9 a b"),
              "must be osculo/snapshot-1, but it is osculo/snapshot-9");
    EXPECT_FALSE(is_snapshot("{\"schema\": \"osculo/scene-1\"}"));
    EXPECT_TRUE(is_snapshot(bytes));
}

// What comes after the first line, with the line that belongs to it.
std::string sealed(const std::string& json, const std::string& state) {
    // CRC-64/XZ, bit by bit.
    const std::string content = json + state;
    std::uint64_t sum = ~std::uint64_t(0);
    for (const char c : content) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) * 0xC96C5795D7870F42);
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016lx", static_cast<unsigned long>(~sum));
    return "osculo/snapshot-1 " + std::string(text) + ' ' + std::to_string(json.size()) + '\n' +
           content;
}

TEST(Snapshot, OfAnotherVersionOrEngineIsRefused) {
    const Scene scene = presets::make("cradle");
    const Simulation simulation(scene);
    const std::string bytes = simulation_to_snapshot(simulation);
    const std::string state = SimulationState::save(simulation);
    const std::size_t begin = bytes.find('\n') + 1;
    const std::string json = bytes.substr(begin, bytes.size() - begin - state.size());
    ASSERT_EQ(sealed(json, state), bytes);
    const auto with = [&](const std::string& old, const std::string& other) {
        std::string changed = json;
        changed.replace(changed.find(old), old.size(), other);
        return sealed(changed, state);
    };
    EXPECT_EQ(error_of(with(kVersion, "9.8.7")),
              std::string("is of osculo 9.8.7, and this is ") + kVersion +
                  ": another version cannot play it on bit for bit");
    const std::string engine = choose_engine(scene).name;
    EXPECT_THROW(static_cast<void>(simulation_from_snapshot(with(engine, "another"))), SceneError);
    EXPECT_THROW(static_cast<void>(simulation_from_snapshot(with("\"audit\"", "\"adit\""))),
                 SceneError);
    EXPECT_THROW(static_cast<void>(simulation_from_snapshot(with("osculo/scene-1", "x"))),
                 SceneError);
    EXPECT_EQ(error_of(sealed(json, state + "x")), "the state is damaged");
    EXPECT_EQ(error_of(sealed(json, "")), "the state is damaged");
}

// A state with a checksum that fits but not what an engine writes: refused, or else some state.
TEST(Snapshot, ThatIsForgedEndsNothing) {
    std::mt19937_64 random(11);
    int refused = 0;
    int taken = 0;
    for (const auto& [scene, precision] : simulations()) {
        const Options options{.precision = precision};
        SCOPED_TRACE(choose_engine(scene, options).name);
        Simulation simulation(scene, options);
        simulation.play({scene.limits.time, 12});
        const std::string state = SimulationState::save(simulation);
        for (int k = 0; k < 60; ++k) {
            std::string other = state;
            for (int flips = 0; flips < 3; ++flips) {
                other[random() % other.size()] = static_cast<char>(random());
            }
            try {
                Simulation forged = SimulationState::restore(scene, options, other);
                EXPECT_EQ(SimulationState::save(forged).size(), other.size());
                forged.play({scene.limits.time, forged.event_count() + 50});
                static_cast<void>(forged.result());
                ++taken;
            } catch (const facade::BadState&) {
                ++refused;
            } catch (const SceneError&) {  // of its limits
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(taken, 50);
}

}  // namespace
}  // namespace osculo::io
