// SPDX-License-Identifier: MIT
// Eight floats side by side, as all kernels of lanes compute with them; compiled once for each kind of processor.
#include <hwy/highway.h>

#include <cmath>
#include <cstdint>

#if defined(FIRMA_LANE_VECTORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRMA_LANE_VECTORS_H
#undef FIRMA_LANE_VECTORS_H
#else
#define FIRMA_LANE_VECTORS_H
#endif

HWY_BEFORE_NAMESPACE();
namespace firma::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::uint32_t kLanes = 8;
constexpr float kRoundoff = 0x1p-24f;
constexpr float kLess = 1 - 16 * kRoundoff, kMore = 1 + 16 * kRoundoff;

const hn::CappedTag<float, kLanes> kFloats;
using Floats = hn::Vec<decltype(kFloats)>;
const hn::Rebind<std::int16_t, decltype(kFloats)> kShorts;
const hn::Rebind<std::int32_t, decltype(kFloats)> kInts;
constexpr std::uint32_t kAtOnce = std::uint32_t(hn::MaxLanes(kFloats));

HWY_INLINE Floats all(float x) {
    return hn::Set(kFloats, x);
}
HWY_INLINE Floats add(Floats a, Floats b) {
    return hn::Add(a, b);
}
HWY_INLINE Floats dot(const Floats* a, const Floats* b) {
    return add(add(hn::Mul(a[0], b[0]), hn::Mul(a[1], b[1])), hn::Mul(a[2], b[2]));
}
HWY_INLINE void cross(const Floats* a, const Floats* b, Floats* c) {
    c[0] = hn::Sub(hn::Mul(a[1], b[2]), hn::Mul(a[2], b[1]));
    c[1] = hn::Sub(hn::Mul(a[2], b[0]), hn::Mul(a[0], b[2]));
    c[2] = hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
}
HWY_INLINE unsigned bits(hn::Mask<decltype(kFloats)> mask) {
#if HWY_TARGET == HWY_WASM  // Highway has several instructions here, and no doubles
    return wasm_i32x4_bitmask(mask.raw);
#else
    std::uint8_t bytes[8];
    hn::StoreMaskBits(kFloats, mask, bytes);
    return bytes[0];
#endif
}

}  // namespace firma::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
