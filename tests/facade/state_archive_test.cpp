#include "state_archive.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/scalars.hpp"

namespace osculo::facade {
namespace {

template <class T>
std::string written(T value) {
    StateArchive archive;
    archive(value);
    return archive.bytes();
}

template <class T>
T read(const std::string& bytes) {
    StateArchive archive(bytes);
    T value{};
    archive(value);
    archive.end();
    return value;
}

template <class S>
class ArchivedNumbers : public testing::Test {};
TYPED_TEST_SUITE(ArchivedNumbers, support::AllScalars, support::ScalarName);

TYPED_TEST(ArchivedNumbers, KeepEveryBit) {
    using S = TypeParam;
    const S third = S(1) / S(3);
    for (const S& x :
         {S(0), S(-S(0)), S(1), S(-2.5), third, S(-third), S(third * S(1e-300)),
          S(third * S(1e300)), math::epsilon<S>(), math::never<S>(), S(-math::never<S>())}) {
        const std::string bytes = written(x);
        const S back = read<S>(bytes);
        EXPECT_TRUE(back == x);
        EXPECT_EQ(written(back), bytes);
        if (x == S(0)) {
            EXPECT_EQ(S(1) / back < S(0), S(1) / x < S(0));  // the sign of zero
        }
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            EXPECT_THROW((void)read<S>(bytes.substr(0, size)), BadState);
        }
        EXPECT_THROW((void)read<S>(bytes + '\0'), BadState);
    }
}

template <class S>
class ArchivedWideNumbers : public testing::Test {};
using WideNumbers = testing::Types<support::Digits50, support::Digits100>;
TYPED_TEST_SUITE(ArchivedWideNumbers, WideNumbers, support::ScalarName);

// Any bytes are some number of the types that IEEE has; not so of these.
TYPED_TEST(ArchivedWideNumbers, AreNumbersWhateverTheBytes) {
    using S = TypeParam;
    const std::string bytes = written(S(S(1) / S(3)));
    int refused = 0;
    for (std::size_t place = 0; place < bytes.size(); ++place) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = bytes;
            other[place] = static_cast<char>(other[place] ^ (1 << bit));
            try {
                const S x = read<S>(other);
                EXPECT_TRUE(S(x / x) == S(1) || !math::is_finite<S>(x));
            } catch (const BadState&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 10);
}

TEST(StateArchive, IsTheSameBytesOnEveryMachine) {
    StateArchive archive;
    double x = -2;
    std::uint32_t n = 0x01020304;
    bool yes = true;
    std::vector<std::uint32_t> list{7};
    archive(x, n, yes, list);
    EXPECT_EQ(archive.bytes(), std::string("\0\0\0\0\0\0\0\xC0\4\3\2\1\1\1\0\0\0\0\0\0\0\7\0\0\0",
                                           8 + 4 + 1 + 8 + 4));
}

TEST(StateArchive, RefusesWhatIsNotThere) {
    EXPECT_THROW((void)read<bool>("\2"), BadState);
    EXPECT_THROW((void)read<motion::ClothPhase>("\4"), BadState);
    // A list of 2^60 numbers, of which there are none.
    EXPECT_THROW((void)read<std::vector<double>>(std::string("\0\0\0\0\0\0\0\x10", 8)), BadState);
}

}  // namespace
}  // namespace osculo::facade
