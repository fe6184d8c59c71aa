// SPDX-License-Identifier: MIT
// What games' bytes are made of beside whole numbers and texts: points, turns, lengths before content, flags.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>

#include "firma/cutter.h"
#include "firma/hit.h"
#include "firma/vec.h"
#include "log/byte_reader.h"

namespace firma {

inline void put_vec(ByteWriter& out, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) out.f64(v[axis]);
}
inline Vec3 take_vec(ByteReader& in) {
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) v[axis] = in.f64();
    return v;
}

inline void put_turn(ByteWriter& out, const Quaternion& turn) {
    for (const double part : turn) out.f64(part);
}
inline Quaternion take_turn(ByteReader& in) {
    Quaternion turn;
    for (double& part : turn) part = in.f64();
    return turn;
}

/// Infinite where that has a meaning; never NaN.
inline double take_length_of_time(ByteReader& in) {
    const std::size_t where = in.place();
    const double value = std::bit_cast<double>(in.u64());
    if (value == value) return value;
    in.fail_at(where, ErrorCode::kMalformed, "a number that is none");
    return 0;
}

inline void put_numbers(ByteWriter& out, std::initializer_list<double> numbers) {
    for (const double number : numbers) out.f64(number);
}
inline void take_numbers(ByteReader& in, std::initializer_list<double*> numbers) {
    for (double* number : numbers) *number = in.f64();
}

/// One bit each, the first in the lowest.
inline void put_flags(ByteWriter& out, std::initializer_list<bool> flags) {
    unsigned bits = 0, bit = 1;
    for (const bool flag : flags) {
        if (flag) bits |= bit;
        bit <<= 1;
    }
    out.u8(std::uint8_t(bits));
}
inline void take_flags(ByteReader& in, std::initializer_list<bool*> flags) {
    const std::size_t where = in.place();
    unsigned bits = in.u8();
    for (bool* flag : flags) {
        *flag = bits & 1;
        bits >>= 1;
    }
    if (bits != 0) in.fail_at(where, ErrorCode::kMalformed, "flags that mean nothing");
}

/// @param bytes  that each entry has at least
inline std::size_t take_count(ByteReader& in, std::size_t bytes) {
    const std::size_t where = in.place();
    const std::uint64_t count = in.whole();
    if (in.ok() && count > in.left() / bytes)
        in.fail_at(where, ErrorCode::kMalformed, "more entries than bytes follow");
    return in.ok() ? std::size_t(count) : 0;
}

inline std::uint32_t take_u32_whole(ByteReader& in) {
    const std::size_t where = in.place();
    const std::uint64_t value = in.whole();
    if (value > ~std::uint32_t(0)) in.fail_at(where, ErrorCode::kMalformed, "a number beyond 32 bits");
    return in.ok() ? std::uint32_t(value) : 0;
}

/// Its length before it.
inline void put_content(ByteWriter& out, std::span<const std::byte> content) {
    put_whole(out, content.size());
    put_bytes(out, content);
}

inline void put_face_ref(ByteWriter& out, const FaceRef& face) {
    out.u32(face.id.value);
    for (int axis = 0; axis < 3; ++axis) out.i32(face.corner[axis]);
}
inline FaceRef take_face_ref(ByteReader& in) {
    FaceRef face;
    face.id.value = in.u32();
    for (int axis = 0; axis < 3; ++axis) face.corner[axis] = std::int32_t(in.u32());
    return face;
}

}  // namespace firma
