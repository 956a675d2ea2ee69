#include <gtest/gtest.h>

#include "osculo/io.hpp"
#include "osculo/presets.hpp"
#include "osculo/simulate.hpp"
#include "random_scene.hpp"

namespace osculo::io {
namespace {

TEST(Msgpack, RoundTripOfScenesIsTheIdentity) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const std::string text = scene_to_json(test::random_scene(seed));
        const Scene scene = scene_from_msgpack(msgpack_from_json(text));
        ASSERT_EQ(scene_to_json(scene), text);
    }
}

TEST(Msgpack, RoundTripOfARunIsTheIdentity) {
    const std::string text = run_to_json(simulate(presets::make("break")));
    const std::string bytes = msgpack_from_json(text);
    EXPECT_LT(bytes.size(), text.size());
    EXPECT_EQ(run_to_json(run_from_msgpack(bytes)), text);
    EXPECT_TRUE(std::holds_alternative<osculo::Run>(scene_or_run_from_msgpack(bytes)));
}

TEST(Msgpack, BrokenInputIsAFormatError) {
    const std::string bytes = msgpack_from_json(scene_to_json(presets::make("box")));
    for (std::size_t length = 0; length < bytes.size(); length += 7) {
        EXPECT_THROW(static_cast<void>(scene_from_msgpack(bytes.substr(0, length))), FormatError)
            << length;
    }
    using namespace std::string_literals;
    EXPECT_THROW(static_cast<void>(scene_from_msgpack("\xc1"s)), FormatError);
    // An array in an array, a million times.
    EXPECT_THROW(static_cast<void>(scene_from_msgpack(std::string(1'000'000, '\x91'))),
                 FormatError);
    // {"schema": NaN}, binary data, text that is not UTF-8
    EXPECT_THROW(static_cast<void>(scene_from_msgpack("\x81\xa6schema\xcb\x7f\xf8\0\0\0\0\0\0"s)),
                 FormatError);
    EXPECT_THROW(static_cast<void>(scene_from_msgpack("\x81\xa6schema\xc4\x01\x01"s)), FormatError);
    EXPECT_THROW(static_cast<void>(scene_from_msgpack("\x81\xa1\xff\x01"s)), FormatError);
    EXPECT_THROW(static_cast<void>(msgpack_from_json("{")), FormatError);
}

TEST(Msgpack, RulesHoldToo) {
    EXPECT_THROW(static_cast<void>(scene_from_msgpack(msgpack_from_json("{\"a\": 1}"))),
                 SceneError);
}

}  // namespace
}  // namespace osculo::io
