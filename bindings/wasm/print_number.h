// SPDX-License-Identifier: MIT
// Numbers in decimals as printf writes them, without printf: that would bring in all of stdio.
//
// A double is m * 2^e. Its decimals are worked out exactly, nine in a word: before the point by doubling, behind it by
// halving. Source: the C library musl, src/stdio/vfprintf.c, fmt_fp(), by Rich Felker and others.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace firma {

/// What print_number() writes at most: sign, 309 digits, point, digits behind it.
inline constexpr int kLongestNumber = 360;

/// All digits of a finite number, exactly.
class DecimalDigits {
public:
    explicit DecimalDigits(double value) {
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
        const int field = int(bits >> 52 & 0x7FF);
        std::uint64_t whole = (bits & ((std::uint64_t(1) << 52) - 1)) | std::uint64_t(field != 0) << 52;
        int exponent = (field != 0 ? field : 1) - 1075;
        for (std::uint32_t* word = words_ + kPoint; whole != 0; whole /= kBase) *--word = std::uint32_t(whole % kBase);
        for (; exponent > 0; --exponent) double_all();
        for (; exponent < 0; ++exponent) halve_all();
    }

    /// The digit that stands for 10^place, from 0.
    int digit(int place) const {
        const int word = kPoint - 1 - (place >= 0 ? place / 9 : (place - 8) / 9);
        if (word < 0 || word >= kWords) return 0;
        std::uint32_t value = words_[word];
        for (int k = place - 9 * (kPoint - 1 - word); k > 0; --k) value /= 10;
        return int(value % 10);
    }
    /// The place of the first digit that is not 0; `lowest` when there is none above it.
    int first(int lowest) const {
        int place = 9 * kPoint - 1;
        while (place > lowest && digit(place) == 0) --place;
        return place;
    }
    /// Rounds to places from `last` on, half to even. Digits below stay: nobody asks for them.
    void round(int last) {
        bool above = digit(last - 1) > 5, half = digit(last - 1) == 5;
        for (int place = last - 2; half && !above && place >= -9 * (kWords - kPoint); --place)
            above = digit(place) != 0;
        if (!above && !(half && digit(last) % 2 == 1)) return;
        int word = kPoint - 1 - (last >= 0 ? last / 9 : (last - 8) / 9);
        std::uint32_t step = 1;
        for (int k = last - 9 * (kPoint - 1 - word); k > 0; --k) step *= 10;
        for (words_[word] += step; words_[word] >= kBase; ++words_[word]) words_[word--] -= kBase;
    }

private:
    static constexpr std::uint32_t kBase = 1000000000;
    static constexpr int kPoint = 36;            // words before the point: 324 digits
    static constexpr int kWords = kPoint + 120;  // and 1,080 behind it

    void double_all() {
        std::uint32_t carry = 0;
        for (int k = kPoint; k-- > 0;) {
            const std::uint32_t twice = 2 * words_[k] + carry;
            carry = twice >= kBase;
            words_[k] = twice - carry * kBase;
        }
    }
    void halve_all() {
        std::uint32_t carry = 0;
        for (std::uint32_t& word : words_) {
            const std::uint32_t rest = word & 1;
            word = (word + carry * kBase) / 2;
            carry = rest;
        }
    }

    std::uint32_t words_[kWords] = {};
};

/// As printf's "%.*f" (fixed) or "%.*g".
/// @param digits  behind the point, or of all; 1 .. 40
/// @param text    kLongestNumber bytes
/// @return how many were written
inline int print_number(double value, int digits, bool fixed, char* text) {
    char* at = text;
    const auto put = [&](const char* word) {
        while (*word) *at++ = *word++;
    };
    if (std::signbit(value)) *at++ = '-';
    if (!std::isfinite(value)) {
        put(std::isnan(value) ? "nan" : "inf");
        return int(at - text);
    }
    DecimalDigits decimals(std::fabs(value));
    int last = -digits, exponent = 0;
    bool scientific = false;
    if (fixed) {
        decimals.round(last);
    } else {
        const int lowest = -9 * 120;
        exponent = value == 0 ? 0 : decimals.first(lowest);
        decimals.round(exponent - digits + 1);
        if (value != 0) exponent = decimals.first(lowest);
        last = exponent - digits + 1;
        scientific = exponent < -4 || exponent >= digits;
        while (last < (scientific ? exponent : 0) && decimals.digit(last) == 0) ++last;
        if (!scientific && last > 0) last = 0;
    }
    const int start = scientific ? exponent : decimals.first(0);
    const int unit = scientific ? exponent : 0;  // the place before the point
    for (int place = start; place >= last; --place) {
        if (place == unit - 1) *at++ = '.';
        *at++ = char('0' + decimals.digit(place));
    }
    if (scientific) {
        put(exponent < 0 ? "e-" : "e+");
        const int size = exponent < 0 ? -exponent : exponent;
        if (size >= 100) *at++ = char('0' + size / 100);
        *at++ = char('0' + size / 10 % 10);
        *at++ = char('0' + size % 10);
    }
    return int(at - text);
}

}  // namespace firma
