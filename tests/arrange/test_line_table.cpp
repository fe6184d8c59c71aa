// SPDX-License-Identifier: MIT
// One line has one number, whichever planes name it.
#include "arrange/line_table.h"

#include <gtest/gtest.h>

#include "scenes/rng.h"

namespace firma {
namespace {

InputPoint random_point(scenes::Rng& rng, std::int32_t reach) {
    const auto coordinate = [&] { return std::int32_t(rng.below(2 * std::uint32_t(reach) + 1)) - reach; };
    const std::int32_t x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
}

TEST(LineTable, HasALineOnceWhateverPlanesNameIt) {
    scenes::Rng rng(1);
    for (const std::int32_t reach : {3, 1 << 10, (1 << 24) - 1}) {
        ExactTables tables;
        LineTable lines(tables);
        std::vector<std::pair<InputPoint, InputPoint>> known;
        for (int k = 0; k < 50; ++k) {
            const InputPoint a = random_point(rng, reach), b = random_point(rng, reach);
            if (a == b) continue;
            std::uint32_t number = ~0u;
            for (int pair = 0; pair < 8; ++pair) {
                const Plane p = plane_through(a, b, random_point(rng, reach)),
                            q = plane_through(b, a, random_point(rng, reach));
                if (!p.valid() || !q.valid() || exact_parallel(p, q)) continue;
                const std::uint32_t found =
                    lines.add(tables.planes.add(p), tables.planes.add(q), tables.points.add(pair % 2 ? a : b));
                if (number == ~0u) number = found;
                EXPECT_EQ(found, number);
            }
        }
    }
}

/// Planes of which all six coordinates of the line are multiples of 2^61 - 1, and others through the same line.
TEST(LineTable, HasLinesOnceThatThePrimeDivides) {
    const auto plane = [](std::int64_t x, std::int64_t y, std::int64_t z, const InputPoint& through) {
        const std::int64_t normal[3] = {x, y, z};
        return plane_of_numbers(normal, -(Int128(x) * through.x + Int128(y) * through.y + Int128(z) * through.z));
    };
    for (const InputPoint at : {InputPoint{0, 0, 0}, InputPoint{7, -5, 11}, InputPoint{1 << 24, -(1 << 24), 12345}}) {
        ExactTables tables;
        LineTable lines(tables);
        const PlaneId p = tables.planes.add(plane(std::int64_t(1) << 31, 1, -1, at)),
                      q = tables.planes.add(plane(1, std::int64_t(1) << 30, -(std::int64_t(1) << 30), at)),
                      r = tables.planes.add(plane(0, 1, -1, at)), s = tables.planes.add(plane(1, 1, -1, at));
        const std::uint32_t point = tables.points.add(at);
        const std::uint32_t line = lines.add(p, q, point);
        EXPECT_EQ(lines.add(r, s, point), line);
        EXPECT_EQ(lines.add(p, s, point), line);
        EXPECT_EQ(lines.add(q, p, point), line);
        EXPECT_EQ(lines.size(), 1u);
    }
}

}  // namespace
}  // namespace firma
