// SPDX-License-Identifier: MIT
// Faces are hashed one by one and the hashes added, so their order does not matter; likewise holes in a face. A loop
// starts at its smallest corner.
#include "solid/hash_boundary.h"

#include <vector>

#include "base/hasher.h"

namespace firma {
namespace {

void add_plane(Hasher& hasher, const Plane& plane) {
    for (const std::int64_t n : plane.normal) hasher.add(std::uint64_t(n));
    hasher.add(std::uint64_t(plane.offset()));
    hasher.add(std::uint64_t(plane.offset() >> 64));
}

std::uint64_t hash_name(const std::string& name) {
    Hasher hasher;
    for (const char c : name) hasher.add(std::uint8_t(c));
    return hasher.value();
}

/// Whether the loop that starts at corner a reads as less than the one from b: one corner may be there twice, where
/// different vertices round to one point.
bool starts_before(const std::vector<GridPoint>& loop, std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const GridPoint &p = loop[(a + k) % loop.size()], &q = loop[(b + k) % loop.size()];
        if (p != q) return p < q;
    }
    return false;
}

std::uint64_t hash_loop(const std::vector<GridPoint>& loop) {
    std::size_t start = 0;
    for (std::size_t k = 1; k < loop.size(); ++k)
        if (loop[k] < loop[start] || (loop[k] == loop[start] && starts_before(loop, k, start))) start = k;
    Hasher hasher;
    hasher.add(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const GridPoint& p = loop[(start + k) % loop.size()];
        hasher.add(std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y));
        hasher.add(std::uint32_t(p.z));
    }
    return hasher.value();
}

}  // namespace

std::uint64_t hash_boundary(const Boundary& boundary, std::span<const std::string> materials) {
    std::vector<std::uint64_t> names;
    for (const std::string& name : materials) names.push_back(hash_name(name));
    const SolidPatch& patch = boundary.patch;
    std::uint64_t sum = 0;
    std::vector<GridPoint> loop;
    for (const PatchFace& face : patch.faces) {
        Hasher hasher;
        add_plane(hasher, face.plane->plane);
        const std::uint32_t material = face.facet.record().material;
        hasher.add(material < names.size() ? names[material] : hash_name(""));
        std::uint64_t outer = 0, holes = 0;
        std::uint32_t first = 0;
        for (const std::uint32_t end : patch.ends(face)) {
            loop.clear();
            for (std::uint32_t k = first; k < end; ++k)
                loop.push_back(patch.vertices[patch.from(patch.uses(face)[k])].point.rounded());
            (first == 0 ? outer : holes) += hash_loop(loop);
            first = end;
        }
        hasher.add(outer);
        hasher.add(holes);
        sum += hasher.value();
    }
    Hasher whole;
    whole.add(patch.faces.size());
    whole.add(sum);
    return whole.value();
}

}  // namespace firma
