// SPDX-License-Identifier: MIT
// A body that turns by itself.
#include "body/free_spin.h"

// g++ 12 makes vfmaddsub of the lines of a turn where the processor has it, whatever -ffp-contract says, and so other
// bits. It does so where it makes vectors of neighbouring lines.
#if defined(__GNUC__) && !defined(__clang__)
#define FIRMA_LINE_BY_LINE __attribute__((noinline, optimize("no-tree-slp-vectorize")))
#else
#define FIRMA_LINE_BY_LINE
#endif

namespace firma {
namespace {

/// Radians that a body turns in one go. What turns farther at once may gain energy, ever more of it.
constexpr double kMostTurn = 0.8;
/// Of a step: what spins faster than they allow goes farther in each.
constexpr int kMostGoes = 64;

/// The momentum in the body's frame, and the turn of the frame so far.
struct State {
    Vec3 momentum;
    Quaternion rotation;
    const Vec3& inertia;

    /// About one of its axes, at the pace of the momentum along it.
    FIRMA_LINE_BY_LINE void turn(int axis, double seconds) {
        const double angle = momentum[axis] / inertia[axis] * seconds;
        const SineCosine whole = sine_cosine(angle), half = sine_cosine(angle * 0.5);
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        const double a = momentum[next], b = momentum[last];
        momentum[next] = whole.cosine * a + whole.sine * b;
        momentum[last] = whole.cosine * b - whole.sine * a;
        Quaternion step{0, 0, 0, half.cosine};
        step[std::size_t(axis)] = half.sine;
        rotation = compose(rotation, step);
    }
};

}  // namespace

Spinning spin_freely(const Spinning& from, const Vec3& inertia, double seconds) {
    const Vec3 own = matrix_of(from.rotation).back(from.spin);
    if (inertia.x == inertia.y && inertia.y == inertia.z)
        return {normalised(compose(turn_by(from.spin * seconds), from.rotation)), from.spin};
    State state{{own.x * inertia.x, own.y * inertia.y, own.z * inertia.z}, from.rotation, inertia};
    const double angle = length(from.spin) * seconds;
    const int goes = angle < kMostTurn * kMostGoes ? 1 + int(angle * (1 / kMostTurn)) : kMostGoes;
    const double each = seconds / goes;
    for (int k = 0; k < goes; ++k) {
        state.turn(0, each * 0.5);
        state.turn(1, each * 0.5);
        state.turn(2, each);
        state.turn(1, each * 0.5);
        state.turn(0, each * 0.5);
    }
    const Quaternion rotation = normalised(state.rotation);
    const Vec3 spin{state.momentum.x / inertia.x, state.momentum.y / inertia.y, state.momentum.z / inertia.z};
    return {rotation, matrix_of(rotation) * spin};
}

}  // namespace firma
