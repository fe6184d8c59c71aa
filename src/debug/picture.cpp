// SPDX-License-Identifier: MIT
// Deflate with matches and the fixed codes: flat colours shrink well by that alone.
// Source: P. Deutsch, RFC 1950 and 1951, 1996; W3C, Portable Network Graphics, 2003.
#include "debug/picture.h"

#include <algorithm>
#include <string_view>

namespace firma::debug {
namespace {

constexpr int kGap = 12;

constexpr std::size_t kWindow = 32768;
constexpr std::size_t kShortestMatch = 3, kLongestMatch = 258;
constexpr int kHashBits = 15;

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = ~0u;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    return ~crc;
}

std::uint32_t adler32(std::string_view bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void append_big_endian(std::string& out, std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) out += char(word >> shift & 0xFF);
}

/// Bits from the lowest up; Huffman codes go in from their highest.
class BitWriter {
public:
    explicit BitWriter(std::string& out) : out_(out) {}

    void bits(std::uint32_t value, int count) {
        held_ |= value << have_;
        for (have_ += count; have_ >= 8; have_ -= 8, held_ >>= 8) out_ += char(held_ & 0xFF);
    }
    void code(std::uint32_t value, int count) {
        for (int bit = count - 1; bit >= 0; --bit) bits(value >> bit & 1, 1);
    }
    void end() {
        if (have_ > 0) bits(0, 8 - have_);
    }

private:
    std::string& out_;
    std::uint32_t held_ = 0;
    int have_ = 0;
};

/// RFC 1951, 3.2.6.
void put_symbol(BitWriter& out, std::uint32_t symbol) {
    if (symbol < 144) {
        out.code(0x30 + symbol, 8);
    } else if (symbol < 256) {
        out.code(0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        out.code(symbol - 256, 7);
    } else {
        out.code(0xC0 + symbol - 280, 8);
    }
}

/// RFC 1951, 3.2.5: codes whose further bits grow by one every `step` codes.
void put_match(BitWriter& out, std::size_t length, std::size_t distance) {
    if (length == kLongestMatch) {
        put_symbol(out, 285);
    } else {
        std::uint32_t code = 257, base = 3;
        int extra = 0;
        while (base + (1u << extra) <= length) {
            base += 1u << extra;
            ++code;
            if (code >= 265) extra = int(code - 261) / 4;
        }
        put_symbol(out, code);
        out.bits(std::uint32_t(length) - base, extra);
    }
    std::uint32_t code = 0, base = 1;
    int extra = 0;
    while (base + (1u << extra) <= distance) {
        base += 1u << extra;
        ++code;
        if (code >= 4) extra = int(code - 2) / 2;
    }
    out.code(code, 5);
    out.bits(std::uint32_t(distance) - base, extra);
}

std::size_t hash_at(std::string_view data, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | static_cast<unsigned char>(data[at + k]);
    return (word * 2654435761u) >> (32 - kHashBits);
}

std::size_t match_length(std::string_view data, std::size_t from, std::size_t at) {
    std::size_t length = 0;
    while (length < kLongestMatch && at + length < data.size() && data[from + length] == data[at + length]) ++length;
    return length;
}

/// One block, each match with the last place where the same three bytes stood.
std::string deflated(std::string_view data) {
    std::string bytes("\x78\x01", 2);
    BitWriter out(bytes);
    out.bits(1, 1);  // the last block,
    out.bits(1, 2);  // of fixed codes
    std::vector<std::size_t> last(std::size_t(1) << kHashBits, data.size());
    for (std::size_t at = 0; at < data.size();) {
        std::size_t length = 0, from = data.size();
        if (at + kShortestMatch <= data.size()) {
            from = last[hash_at(data, at)];
            if (from < at && at - from <= kWindow) length = match_length(data, from, at);
        }
        const std::size_t step = length >= kShortestMatch ? length : 1;
        if (step > 1) {
            put_match(out, length, at - from);
        } else {
            put_symbol(out, static_cast<unsigned char>(data[at]));
        }
        for (const std::size_t next = at + step; at < next; ++at)
            if (at + kShortestMatch <= data.size()) last[hash_at(data, at)] = at;
    }
    put_symbol(out, 256);
    out.end();
    append_big_endian(bytes, adler32(data));
    return bytes;
}

void append_chunk(std::string& out, const std::string& kind, const std::string& data) {
    append_big_endian(out, std::uint32_t(data.size()));
    out += kind + data;
    append_big_endian(out, crc32(kind + data));
}

}  // namespace

Picture side_by_side(const Picture& left, const Picture& right) {
    Picture both(left.width + kGap + right.width, std::max(left.height, right.height), {255, 255, 255});
    const auto put = [&](const Picture& part, int shift) {
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) both.at(x + shift, y) = part.at(x, y);
    };
    put(left, 0);
    put(right, left.width + kGap);
    return both;
}

std::string png_bytes(const Picture& picture) {
    std::string rows;
    for (int y = 0; y < picture.height; ++y) {
        rows += char(0);  // no filter: runs of one colour stay runs
        for (int x = 0; x < picture.width; ++x)
            for (const std::uint8_t part : picture.at(x, y)) rows += char(part);
    }
    std::string head;
    append_big_endian(head, std::uint32_t(picture.width));
    append_big_endian(head, std::uint32_t(picture.height));
    head += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits of red, green and blue
    std::string png("\x89PNG\r\n\x1a\n", 8);
    append_chunk(png, "IHDR", head);
    append_chunk(png, "IDAT", deflated(rows));
    append_chunk(png, "IEND", "");
    return png;
}

}  // namespace firma::debug
