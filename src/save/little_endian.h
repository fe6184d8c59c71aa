// SPDX-License-Identifier: MIT
// Numbers of fixed width, least significant byte first, whatever the machine: bytes out, bytes in.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace firma {

// Compilers know these for plain loads.
inline std::uint16_t read_u16(const std::byte* at) {
    return std::uint16_t(unsigned(at[0]) | unsigned(at[1]) << 8);
}
inline std::uint32_t read_u32(const std::byte* at) {
    return std::uint32_t(at[0]) | std::uint32_t(at[1]) << 8 | std::uint32_t(at[2]) << 16 | std::uint32_t(at[3]) << 24;
}
inline std::uint64_t read_u64(const std::byte* at) {
    return std::uint64_t(read_u32(at + 4)) << 32 | read_u32(at);
}
inline std::int32_t read_i32(const std::byte* at) {
    return std::int32_t(read_u32(at));
}
inline float read_f32(const std::byte* at) {
    return std::bit_cast<float>(read_u32(at));
}
inline double read_f64(const std::byte* at) {
    return std::bit_cast<double>(read_u64(at));
}

/// Bytes under way.
class ByteWriter {
public:
    void u8(std::uint8_t value) { bytes_.push_back(std::byte(value)); }
    void u16(std::uint16_t value) { put(value, 2); }
    void u32(std::uint32_t value) { put(value, 4); }
    void u64(std::uint64_t value) { put(value, 8); }
    void i32(std::int32_t value) { put(std::uint32_t(value), 4); }
    void f32(float value) { put(std::bit_cast<std::uint32_t>(value), 4); }
    void f64(double value) { put(std::bit_cast<std::uint64_t>(value), 8); }

    std::size_t size() const { return bytes_.size(); }
    const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    void put(std::uint64_t value, std::size_t count) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + count);
        for (std::size_t k = 0; k < count; ++k) bytes_[at + k] = std::byte(value >> 8 * k & 255);
    }

    std::vector<std::byte> bytes_;
};

}  // namespace firma
