// SPDX-License-Identifier: MIT
// Bytes of a fuzzer's input, taken from the front.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace firma::fuzz {

/// Zeros when none are left.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
    bool empty() const { return size_ == 0; }
    int next() {
        if (size_ == 0) return 0;
        --size_;
        return *data_++;
    }
    /// Any double there is.
    double any_double() {
        std::uint64_t bits = 0;
        for (int k = 0; k < 8; ++k) bits = bits << 8 | std::uint64_t(next());
        return std::bit_cast<double>(bits);
    }
    /// -128 to 127 sixteenths of a power of four, from below the grid's step to beyond the world; now and then any
    /// double.
    double number() {
        const int kind = next();
        if (kind >= 250) return any_double();
        const double mantissa = double(next() - 128) / 16;
        double unit = 1;
        const int power = kind % 32;  // most often near 1
        if (power < 8) unit = 1.0 / double(1 << (2 * power));
        if (power == 30) unit = 1024;
        if (power == 31) unit = 0x1p-13;
        return mantissa * unit;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

}  // namespace firma::fuzz
