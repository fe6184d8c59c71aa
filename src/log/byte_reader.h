// SPDX-License-Identifier: MIT
// Hostile bytes taken one after the other; the first thing that is wrong is kept, with the byte where it was found. And
// whole numbers in as many bytes as they need.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "firma/result.h"
#include "save/little_endian.h"

namespace firma {

/// Seven bits a byte, the lowest first; the highest bit says that more follow.
inline void put_whole(ByteWriter& out, std::uint64_t value) {
    for (; value >= 128; value >>= 7) out.u8(std::uint8_t(value | 128));
    out.u8(std::uint8_t(value));
}
/// Small ones of either sign in few bytes.
inline void put_signed(ByteWriter& out, std::int64_t value) {
    put_whole(out, std::uint64_t(value) << 1 ^ std::uint64_t(value >> 63));
}
inline void put_bytes(ByteWriter& out, std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) out.u8(std::uint8_t(byte));
}
/// Its length before it.
inline void put_text(ByteWriter& out, const std::string& text) {
    put_whole(out, text.size());
    for (const char c : text) out.u8(static_cast<unsigned char>(c));
}

/// Once something was wrong, all that is taken is zero, and nothing is left.
class ByteReader {
public:
    /// @param name   for messages; lives as long as this
    /// @param first  the place of the first byte in the file
    ByteReader(std::span<const std::byte> bytes, const std::string& name, std::size_t first = 0)
        : bytes_(bytes), name_(name), first_(first) {}

    bool ok() const { return !error_; }
    const std::optional<Error>& error() const { return error_; }
    std::size_t left() const { return bytes_.size() - at_; }
    bool at_end() const { return left() == 0; }
    /// In the file, of the byte that is taken next.
    std::size_t place() const { return first_ + at_; }
    const std::string& name() const { return name_; }

    /// @return false, for the caller to return
    bool fail(ErrorCode code, std::string reason) { return fail_at(place(), code, std::move(reason)); }
    bool fail(std::string reason) { return fail(ErrorCode::kMalformed, std::move(reason)); }
    bool fail_at(std::size_t where, ErrorCode code, std::string reason) {
        return fail(Error{code, name_ + (name_.empty() ? "byte " : ": byte ") + std::to_string(where), reason});
    }
    bool fail(Error error) {
        if (!error_) error_ = std::move(error);
        at_ = bytes_.size();
        return false;
    }

    std::span<const std::byte> bytes(std::uint64_t count) {
        if (count > left()) {
            fail(error_ ? "" : "it ends before what it says follows");
            return {};
        }
        at_ += std::size_t(count);
        return bytes_.subspan(at_ - std::size_t(count), std::size_t(count));
    }
    std::uint8_t u8() {
        const auto taken = bytes(1);
        return taken.empty() ? 0 : std::uint8_t(taken[0]);
    }
    std::uint32_t u32() {
        const auto taken = bytes(4);
        return taken.empty() ? 0 : read_u32(taken.data());
    }
    std::uint64_t u64() {
        const auto taken = bytes(8);
        return taken.empty() ? 0 : read_u64(taken.data());
    }
    std::int16_t i16() {
        const auto taken = bytes(2);
        return taken.empty() ? std::int16_t(0) : std::int16_t(read_u16(taken.data()));
    }
    /// A finite one.
    double f64() {
        const std::size_t where = place();
        const double value = std::bit_cast<double>(u64());
        if (value - value == 0) return value;
        fail_at(where, ErrorCode::kMalformed, "a number is not finite");
        return 0;
    }
    /// As put_whole() writes it, in no more bytes than it needs.
    std::uint64_t whole() {
        const std::size_t where = place();
        std::uint64_t value = 0;
        for (int shift = 0;; shift += 7) {
            const std::uint8_t byte = u8();
            if (!ok()) return 0;
            if ((shift == 63 && byte > 1) || (shift > 0 && byte == 0)) {
                fail_at(where, ErrorCode::kMalformed, "a number has more bytes than it needs");
                return 0;
            }
            value |= std::uint64_t(byte & 127) << shift;
            if (byte < 128) return value;
        }
    }
    std::int64_t signed_whole() {
        const std::uint64_t value = whole();
        return std::int64_t(value >> 1) ^ -std::int64_t(value & 1);
    }
    std::string text() {
        const auto taken = bytes(whole());
        return {reinterpret_cast<const char*>(taken.data()), taken.size()};
    }
    /// So many bytes, as a reader of their own.
    ByteReader part(std::uint64_t count) {
        const std::size_t where = place();
        const std::span<const std::byte> taken = bytes(count);
        ByteReader reader(taken, name_, where);
        reader.error_ = error_;
        return reader;
    }

private:
    std::span<const std::byte> bytes_;
    const std::string& name_;
    std::size_t first_ = 0, at_ = 0;
    std::optional<Error> error_;
};

}  // namespace firma
