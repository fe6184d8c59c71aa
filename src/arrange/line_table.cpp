// SPDX-License-Identifier: MIT
// All lines that sides of polygons lie on, each once.
//
// Lines are found again by their Pluecker coordinates, which are unique up to a factor: taken modulo a prime and
// divided by the first that is not zero, they are unique. What seems equal is compared exactly.
#include "arrange/line_table.h"

#include <algorithm>
#include <utility>

#include "base/assert.h"
#include "geometry/residues.h"

namespace firma {
namespace {

struct Pluecker {
    std::uint64_t part[6];

    bool vanishes() const {
        return std::all_of(part, part + 6, [](std::uint64_t p) { return p == 0; });
    }
};

/// Where the prime divides all six, which leaves no ratio: of other planes through the line it may not.
Pluecker divided_by_prime(const Plane& a, const Plane& b) {
    Int256 whole[6];
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k) {
        whole[k] = Int256(normal_minor(a, b, i, j));
        whole[3 + k] = product(a.offset(), Int128(b.normal[k])) - product(b.offset(), Int128(a.normal[k]));
    }
    Pluecker line;
    do {
        for (int k = 0; k < 6; ++k) {
            whole[k] = divide(whole[k], kPrime).quotient;
            line.part[k] = residue_of(Int128(divide(whole[k], kPrime).remainder));
        }
    } while (line.vanishes());
    return line;
}

Pluecker pluecker_of(const Plane& a, const Plane& b) {
    Pluecker line;
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k) line.part[k] = residue_of(normal_minor(a, b, i, j));
    const std::uint64_t da = residue_of(a.offset()), db = residue_of(b.offset());
    for (int k = 0; k < 3; ++k)
        line.part[3 + k] = residue_minus(residue_times(da, residue_of(Int128(b.normal[k]))),
                                         residue_times(db, residue_of(Int128(a.normal[k]))));
    return line.vanishes() ? divided_by_prime(a, b) : line;
}

std::uint64_t hash_of(const Plane& a, const Plane& b) {
    const Pluecker line = pluecker_of(a, b);
    std::uint64_t factor = 0;
    for (int k = 0; k < 6 && factor == 0; ++k) factor = line.part[k];
    factor = residue_inverse(factor);
    std::uint64_t hash = table_seed();
    for (const std::uint64_t p : line.part) hash = mix_bits(hash ^ residue_times(p, factor));
    return hash;
}

}  // namespace

std::uint32_t LineTable::add(PlaneId a, PlaneId b, std::uint32_t point) {
    a &= ~1u;
    b &= ~1u;
    if (a > b) std::swap(a, b);
    const std::uint64_t both = std::uint64_t(a) << 32 | b;
    const std::uint32_t known = of_planes_.find(both);
    if (known != FlatMap::kNone) return known;
    const Plane &p = tables_.planes.plane(a), &q = tables_.planes.plane(b);
    for (std::uint64_t key = hash_of(p, q);; key = next_key(key)) {
        std::uint32_t& found = of_hash_.at(key);
        if (found == FlatMap::kNone) {
            found = std::uint32_t(lines_.size());
            Line line{{a, b}, 0, false};
            Int128 most = 0;
            for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k) {
                const Int128 component = normal_minor(p, q, i, j);
                const Int128 size = component < 0 ? -component : component;
                if (size <= most) continue;
                most = size;
                line.axis = k;
                line.ascends = component > 0;
            }
            FIRMA_ASSERT(most > 0, "planes that meet in a line are not parallel");
            lines_.push_back(line);
        } else if (!same(lines_[found], a, b, point)) {
            continue;
        }
        of_planes_.at(both) = found;
        return found;
    }
}

bool LineTable::same(const Line& line, PlaneId a, PlaneId b, std::uint32_t point) const {
    const Plane &p = tables_.planes.plane(line.planes[0]), &q = tables_.planes.plane(line.planes[1]);
    return tables_.points.side(line.planes[0], point) == 0 && tables_.points.side(line.planes[1], point) == 0 &&
           exact_turn(p, q, tables_.planes.plane(a)) == 0 && exact_turn(p, q, tables_.planes.plane(b)) == 0;
}

int LineTable::turn(std::uint32_t index, PlaneId a, PlaneId b) const {
    const Line& line = lines_[index];
    const int i = (line.axis + 1) % 3, j = (line.axis + 2) % 3;
    const Int128 component = normal_minor(tables_.planes.plane(a), tables_.planes.plane(b), i, j);
    return component > 0 ? 1 : component < 0 ? -1 : 0;
}

bool LineTable::runs_along(std::uint32_t line, PlaneId a, PlaneId b) const {
    return turn(line, a, b) > 0;
}

bool LineTable::before(std::uint32_t index, std::uint32_t a, std::uint32_t b) const {
    if (a == b) return false;
    const Line& line = lines_[index];
    const ExactPoint &p = tables_.points.point(a), &q = tables_.points.point(b);
    const double along = q.approximate()[line.axis] - p.approximate()[line.axis];
    if (along > 2 * kApproximation || along < -2 * kApproximation) return along > 0;
    const Plane &f = tables_.planes.plane(line.planes[0]), &t = tables_.planes.plane(line.planes[1]);
    const auto after = [&](const Plane& across) { return (exact_order(f, t, p, across, q) > 0) == line.ascends; };
    if (p.on_grid()) return after(axis_plane(line.axis, p.grid()[line.axis]));
    for (int k = 0; k < 3; ++k)
        if (exact_turn(f, t, *p.plane(k)) != 0) return after(*p.plane(k));
    return false;
}

}  // namespace firma
