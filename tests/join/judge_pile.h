// SPDX-License-Identifier: MIT
// All that must hold of a pile of brushes made into a world.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "solid/measure_boundary.h"
#include "tests/reference/brush_oracle.h"
#include "world/world_data.h"

namespace firma::reference {

struct PileVerdict {
    std::string fault;   ///< empty: all holds
    bool moved = false;  ///< planes were moved or brushes left out: the volume is that of other brushes, not compared
    std::size_t rooms = 0;
};

/// Of the exact solid, cubic input steps.
inline DoubleDouble solid_volume(const World& world) {
    std::vector<const Block*> roots;
    for (const Ref<const Room>& room : world.data().rooms) roots.push_back(room->tree.get());
    return measure_boundary(take_boundary(roots)).volume;
}

/// A straight way through the air ends in the room that asking directly names.
inline std::string walk(const World& world, const Vec3& from, const Vec3& to) {
    const Location start = locate(world, from), end = locate(world, to);
    if (start.kind != Location::Kind::kRoom || end.kind != Location::Kind::kRoom) return {};
    CastOptions options;
    options.room = start.room;
    std::array<RoomId, 256> passed;
    options.passed = passed;
    const Hit hit = cast(world, {from, 0}, to - from, options);
    if (hit.touched()) return {};
    for (std::size_t k = 0; k < std::min<std::size_t>(hit.rooms_passed, passed.size()); ++k)
        if (passed[k] == end.room) return {};
    return "a way through the air to another room passes no portal into it";
}

inline PileVerdict judge_pile(const BrushLevel& level, std::uint64_t seed, int points, bool exact_volume) {
    PileVerdict verdict;
    BrushWorldReport report;
    const Result<World> made = make_world(level, {}, &report);
    const auto fail = [&](std::string what) {
        verdict.fault = std::move(what);
        return verdict;
    };
    if (!made.ok()) return fail(made.error().text());
    const World& world = made.value();
    verdict.rooms = world.room_count();
    if (const auto fault = check_world(world)) return fail(fault->what);
    if (const auto fault = check_solid(world)) return fail(fault->what);
    if (report.lost_shells > 0) return fail("a shell was lost");
    for (const BrushNote& note : report.notes)
        verdict.moved = verdict.moved || note.what != BrushNote::What::kIdlePortal;
    verdict.moved = verdict.moved || report.planes_moved > 0;
    if (verdict.moved) return verdict;

    if (exact_volume) {
        const Rational want = joined_volume(level);
        const DoubleDouble got = solid_volume(world);
        const Rational off = Rational(got.high) + Rational(got.low) - want;
        // Of some hundred bits, as measure_boundary() says; sums are of up to some thousand terms as large as the
        // world.
        if (abs(off) > want * Rational(1, boost::multiprecision::cpp_int(1) << 80) + Rational(1, 1 << 20))
            return fail("the volume is off by " + std::to_string(off.convert_to<double>()) + " cubic steps of " +
                        std::to_string(want.convert_to<double>()));
    }
    std::mt19937_64 random(seed);
    const Box bounds = world.bounds();
    const auto coordinate = [&](int axis) {
        const double low = bounds.low[axis] - 0.5, high = bounds.high[axis] + 0.5;
        return std::floor((low + (high - low) * (double(random() >> 11) * 0x1p-53)) * 4096) / 4096;
    };
    Vec3 before{0, 0, 0};
    for (int k = 0; k < points; ++k) {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis) point[axis] = coordinate(axis);
        const Rational steps[3] = {Rational(point.x * 4096), Rational(point.y * 4096), Rational(point.z * 4096)};
        const int side = side_of_brushes(level, steps);
        const Location::Kind kind = locate(world, point).kind;
        if (side > 0 && kind == Location::Kind::kRoom) return fail("a point in a brush is said to lie in a room");
        if (side < 0 && kind == Location::Kind::kSolid) return fail("a point in the air is said to lie in the solid");
        if (k > 0)
            if (std::string fault = walk(world, before, point); !fault.empty()) return fail(fault);
        before = point;
    }
    return verdict;
}

}  // namespace firma::reference
