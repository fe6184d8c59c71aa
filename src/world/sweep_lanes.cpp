// SPDX-License-Identifier: MIT
// A sweep through an index, eight at a time: compiled once for each kind of processor, of which the best is taken.
//
// No products and sums are fused: each kind of processor computes the same bits, so that it looks at the same boxes and
// faces, in the same order.
#include "world/sweep_lanes.h"

#include <array>
#include <atomic>

#include "base/assert.h"
#include "solid/lay_out_faces.h"

#ifdef FIRMA_SIMD

// Those that are worth it, and whose vectors have a size that the compiler knows. A name that this version of Highway
// does not have counts as 0 where these are chosen, and is given that value for what follows.
#if defined(_WIN32)  // GCC does not align what it keeps of wider vectors on the stack there (its bug 54412)
#define FIRMA_TOO_WIDE (HWY_AVX2 | HWY_AVX3)
#else
#define FIRMA_TOO_WIDE 0
#endif
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS                                                                                \
    (HWY_SSE2 | HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX3_ZEN4 | HWY_AVX3_SPR | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | \
     HWY_SVE2_128 | HWY_RVV | FIRMA_TOO_WIDE)
#include <hwy/detect_targets.h>
#ifndef HWY_SSE2
#define HWY_SSE2 0LL
#endif
#ifndef HWY_AVX3_ZEN4
#define HWY_AVX3_ZEN4 0LL
#endif
#ifndef HWY_AVX3_SPR
#define HWY_AVX3_SPR 0LL
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/sweep_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "world/lane_walk.h"

#if HWY_ONCE
namespace firma {
namespace {

/// The best first.
struct Kernels {
    std::array<LaneKernel, 4> all;
    std::size_t count = 0;

    Kernels() {
#if HWY_TARGETS & HWY_AVX3
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
            __builtin_cpu_supports("avx512cd") && has_avx2())
            all[count++] = {"AVX-512", N_AVX3::sweep_lanes, N_AVX3::sweep_lanes_together};
#endif
#if HWY_TARGETS & HWY_AVX2
        if (has_avx2()) all[count++] = {"AVX2", N_AVX2::sweep_lanes, N_AVX2::sweep_lanes_together};
#endif
#if HWY_TARGETS & HWY_SSE4
        if (has_sse4()) all[count++] = {"SSE4", N_SSE4::sweep_lanes, N_SSE4::sweep_lanes_together};
#endif
#if defined(__wasm__)
        all[count++] = {"compiled", HWY_STATIC_DISPATCH(sweep_lanes), nullptr};
#else
        all[count++] = {"compiled", HWY_STATIC_DISPATCH(sweep_lanes), HWY_STATIC_DISPATCH(sweep_lanes_together)};
#endif
    }

private:
#if HWY_ARCH_X86
    [[maybe_unused]] static bool has_sse4() {
        return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
    }
    [[maybe_unused]] static bool has_avx2() {
        return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
    }
#endif
};

const Kernels& kernels() {
    static const Kernels known;
    return known;
}

bool sweep_by_best(const Node& root, LaneQuery& query);
std::atomic<LaneFunction> taken{sweep_by_best};

bool sweep_by_best(const Node& root, LaneQuery& query) {
    const LaneFunction best = kernels().all[0].sweep;
    taken.store(best, std::memory_order_relaxed);
    return best(root, query);
}

}  // namespace

bool lanes_in_use() {
    return taken.load(std::memory_order_relaxed) != nullptr;
}

std::span<const LaneKernel> lane_kernels() {
    return {kernels().all.data(), kernels().count};
}

void take_lane_kernel(const LaneKernel* kernel) {
    taken.store(kernel ? kernel->sweep : nullptr, std::memory_order_relaxed);
}

bool sweep_lanes(const Node& root, LaneQuery& query) {
    return taken.load(std::memory_order_relaxed)(root, query);
}

LanesTogether together_in_use() {
    const LaneFunction single = taken.load(std::memory_order_relaxed);
    for (const LaneKernel& kernel : lane_kernels())
        if (kernel.sweep == single || single == sweep_by_best) return kernel.together;
    return nullptr;
}

}  // namespace firma
#endif

#else  // FIRMA_SIMD

namespace firma {
bool lanes_in_use() {
    return false;
}

std::span<const LaneKernel> lane_kernels() {
    return {};
}

void take_lane_kernel(const LaneKernel*) {}

LanesTogether together_in_use() {
    return nullptr;
}

bool sweep_lanes(const Node&, LaneQuery&) {
    FIRMA_ASSERT(false, "no sweep is usable by lanes");
    return false;
}

}  // namespace firma

#endif
