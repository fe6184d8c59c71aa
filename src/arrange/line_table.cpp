// SPDX-License-Identifier: MIT
// All lines that sides of polygons lie on, each once.
//
// Lines are found again by their Pluecker coordinates, which are unique up to a factor: taken modulo a prime and
// divided by the first that is not zero, they are unique. What seems equal is compared exactly.
#include "arrange/line_table.h"

#include <utility>

#include "base/assert.h"

namespace firma {
namespace {

constexpr std::uint64_t kPrime = (std::uint64_t(1) << 61) - 1;

/// 2^61 is 1 modulo the prime, so the pieces of 61 bits add up: a division of 128 bits is a call of a library.
std::uint64_t reduced(Unsigned128 value) {
    std::uint64_t sum =
        std::uint64_t(value & kPrime) + std::uint64_t(value >> 61 & kPrime) + std::uint64_t(value >> 122);
    sum = (sum & kPrime) + (sum >> 61);
    return sum >= kPrime ? sum - kPrime : sum;
}
std::uint64_t modulo(Int128 value) {
    const std::uint64_t rest = reduced(value < 0 ? -Unsigned128(value) : Unsigned128(value));
    return value < 0 && rest != 0 ? kPrime - rest : rest;
}
std::uint64_t times(std::uint64_t a, std::uint64_t b) {
    return reduced(Unsigned128(a) * b);
}
std::uint64_t minus(std::uint64_t a, std::uint64_t b) {
    return a >= b ? a - b : a + kPrime - b;
}
/// By Fermat: a^(p - 2).
std::uint64_t inverse(std::uint64_t a) {
    std::uint64_t result = 1;
    for (std::uint64_t power = kPrime - 2; power != 0; power >>= 1) {
        if (power & 1) result = times(result, a);
        a = times(a, a);
    }
    return result;
}

std::uint64_t hash_of(const Plane& a, const Plane& b) {
    std::uint64_t part[6];
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k) part[k] = modulo(normal_minor(a, b, i, j));
    const std::uint64_t da = modulo(a.offset()), db = modulo(b.offset());
    for (int k = 0; k < 3; ++k) part[3 + k] = minus(times(da, modulo(b.normal[k])), times(db, modulo(a.normal[k])));
    std::uint64_t factor = 0;
    for (int k = 0; k < 3 && factor == 0; ++k) factor = part[k];
    factor = inverse(factor);
    std::uint64_t hash = table_seed();
    for (const std::uint64_t p : part) hash = mix_bits(hash ^ times(p, factor));
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
