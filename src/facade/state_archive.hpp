#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "bad_state.hpp"
#include "osculo/motion/rim_paper.hpp"
#include "state_members.hpp"

namespace osculo::facade {

/// The state of an engine as bytes. What an engine shows to it (Engine::archive) is appended to the
/// bytes, or else taken from them: one list of everything serves both ways. The bytes are the same
/// on every machine; numbers keep every bit.
class StateArchive {
public:
    /// Writes.
    StateArchive() = default;
    /// Reads. The bytes must stay.
    explicit StateArchive(std::string_view bytes) : reads_(true), rest_(bytes) {}

    template <class... Values>
    void operator()(Values&... values) {
        (archive(values), ...);
    }

    /// Throws BadState unless it is true, as it is of everything that is written.
    static void require(bool is_so) {
        if (!is_so) throw BadState();
    }
    /// To be called when everything has been read.
    void end() const { require(rest_.empty()); }

    /// What was written.
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    template <class T>
    void archive(T& value) {
        if constexpr (requires { value.archive(*this); }) {
            value.archive(*this);
        } else if constexpr (requires { members(value); }) {
            std::apply([this](auto&... each) { (*this)(each...); }, members(value));
        } else {
            plain(value);
        }
    }

    // Integers from their lowest byte on; floating-point numbers as IEEE has them.
    template <class T>
    void plain(T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_same_v<T, math::Quad>,
                      "osculo: say in state_members.hpp what this type consists of");
        constexpr bool is_x87 =
            std::is_same_v<T, long double> && std::numeric_limits<long double>::digits == 64;
        constexpr std::size_t kSize = is_x87 ? 10 : sizeof(T);
        std::array<unsigned char, sizeof(T)> bytes{};
        std::memcpy(bytes.data(), &value, sizeof(T));
        const std::span<unsigned char> used(bytes.data(), kSize);
        if (std::endian::native == std::endian::big) std::ranges::reverse(used);
        raw(used);
        if (!reads_) return;
        if (std::endian::native == std::endian::big) std::ranges::reverse(used);
        std::memcpy(&value, bytes.data(), sizeof(T));
    }
    void plain(bool& value) {
        std::uint8_t byte = value ? 1 : 0;
        plain(byte);
        require(byte <= 1);
        value = byte == 1;
    }
    void plain(motion::ClothPhase& phase) {
        auto byte = static_cast<std::uint8_t>(phase);
        plain(byte);
        require(byte <= static_cast<std::uint8_t>(motion::ClothPhase::sliding));
        phase = static_cast<motion::ClothPhase>(byte);
    }
    void plain(engine::ClusterMark& mark) {
        std::uint32_t number = mark.number;
        bool well_posed = mark.well_posed;
        (*this)(number, well_posed);
        mark.number = number & 0x7FFFFFFFU;
        mark.well_posed = well_posed;
    }
    template <class Backend, boost::multiprecision::expression_template_option Templates>
    void plain(boost::multiprecision::number<Backend, Templates>& number) {
        auto& backend = number.backend();
        auto& bits = backend.bits();
        auto exponent = std::int64_t(backend.exponent());
        bool sign = backend.sign();
        auto limbs = static_cast<std::uint8_t>(bits.size());
        (*this)(exponent, sign, limbs);
        require(exponent >= Backend::min_exponent && exponent <= Backend::exponent_nan);
        require(limbs >= 1 && limbs <= std::decay_t<decltype(bits)>::internal_limb_count);
        bits.resize(limbs, limbs);
        for (unsigned k = 0; k < limbs; ++k) (*this)(bits.limbs()[k]);
        bits.normalize();
        const bool is_plain = exponent <= Backend::max_exponent;  // not 0, infinite or not a number
        require(bits.sign() == false && is_plain == !eval_is_zero(bits));
        require(!is_plain || eval_msb(bits) == Backend::bit_count - 1);
        backend.exponent() = static_cast<typename Backend::exponent_type>(exponent);
        backend.sign() = sign;
    }
    template <class S, int N>
    void plain(Eigen::Matrix<S, N, 1>& vector) {
        for (int k = 0; k < N; ++k) archive(vector[k]);
    }
    template <class T, std::size_t N>
    void plain(std::array<T, N>& values) {
        for (T& value : values) archive(value);
    }
    template <class T>
    void plain(std::vector<T>& values) {
        std::uint64_t size = values.size();
        plain(size);
        require(!reads_ || size <= rest_.size());  // each takes a byte or more
        values.resize(size);
        for (T& value : values) archive(value);
    }

    /// A stay in a rim follows from its start, and is shared by all states of it.
    template <class Stay>
    void plain(std::shared_ptr<const Stay>& stay) {
        // 0: none; otherwise the number of one that has been before, or the next one.
        std::uint64_t number = 0;
        if (stay) number = numbers_.try_emplace(stay.get(), stays_.size() + 1).first->second;
        plain(number);
        require(number <= stays_.size() + 1);
        if (number == 0) {
            stay = nullptr;
        } else if (number <= stays_.size()) {
            stay = std::static_pointer_cast<const Stay>(stays_[number - 1]);
        } else {
            begin_stay(stay);
            stays_.push_back(stay);
        }
    }
    template <class S>
    void begin_stay(std::shared_ptr<const motion::RimPaperMotion<S>>& stay) {
        geometry::Rim<S> rim{};
        S gravity{0}, radius{0};
        motion::ParabolicPath<S> start{};
        if (stay) {
            rim = stay->rim();
            gravity = stay->gravity();
            radius = stay->radius();
            start = stay->at(S(0));
        }
        (*this)(rim.center, rim.radius, gravity, radius, start.position, start.velocity);
        if (!reads_) return;
        require(gravity > S(0) && radius > S(0) && rim.radius > radius);
        stay = std::make_shared<const motion::RimPaperMotion<S>>(rim, gravity, radius,
                                                                 start.position, start.velocity);
    }

    void raw(std::span<unsigned char> bytes) {
        if (!reads_) {
            bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            return;
        }
        require(bytes.size() <= rest_.size());
        std::memcpy(bytes.data(), rest_.data(), bytes.size());
        rest_.remove_prefix(bytes.size());
    }

    bool reads_ = false;
    std::string bytes_;
    std::string_view rest_;
    std::vector<std::shared_ptr<const void>> stays_;
    std::unordered_map<const void*, std::uint64_t> numbers_;  ///< of those that are written
};

}  // namespace osculo::facade
