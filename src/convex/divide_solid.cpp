// SPDX-License-Identifier: MIT
// The parts that a plane leaves of a solid: what it cut without need is joined again.
//
// A cap has a polygon wherever the plane went through the solid. Those where a reflex edge lies are needed; over the
// others the two sides are one again, as long as that does not join, around a ring, what a needed one keeps apart.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/disjoint_sets.h"
#include "convex/split_sides.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u, kSeveral = ~0u - 1;

/// One half's connected parts, and which of them has a side between two points.
struct HalfParts {
    std::vector<FaceSides> parts;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> part_at;

    std::uint32_t at(std::uint32_t from, std::uint32_t to) const {
        const auto found = part_at.find({from, to});
        return found == part_at.end() ? kNone : found->second;
    }
};

bool find_parts(ConvexSpace& space, const FaceSides& sides, HalfParts& half) {
    SolidSides solid;
    if (!pair_sides(space, sides, solid)) return false;
    std::uint32_t count = 0;
    const std::vector<std::uint32_t> part = parts_of_sides(space, solid, count);
    half.parts.resize(count);
    for (std::size_t k = 0; k < solid.size(); ++k) {
        const FaceSide& side = solid.sides[k];
        half.parts[part[k]].push_back(side);
        const auto [known, fresh] = half.part_at.try_emplace({side.from, side.to}, part[k]);
        if (!fresh && known->second != part[k]) known->second = kSeveral;
    }
    return true;
}

/// Polygons of the cap that share a point are one here.
class CapRegions {
public:
    CapRegions(const ConvexSpace& space, const SidesSplit& split, PlaneId by) : space_(space), split_(split) {
        const FaceSides& cap = split.cap;
        DisjointSets sets(cap.size());
        std::map<std::uint32_t, std::uint32_t> side_at;
        for (std::uint32_t k = 0; k < cap.size(); ++k)
            for (const std::uint32_t point : {cap[k].from, cap[k].to}) {
                const auto [known, fresh] = side_at.try_emplace(point, k);
                if (!fresh) sets.join(k, known->second);
            }
        std::vector<std::uint32_t> number(cap.size(), kNone);
        for (std::uint32_t k = 0; k < cap.size(); ++k) {
            if (sets.find(k) == k) {
                number[k] = std::uint32_t(regions.size());
                regions.emplace_back();
            }
            regions[number[sets.find(k)]].push_back(k);
        }
        for (const std::vector<std::uint32_t>& region : regions) has_holes_ |= !runs_left(region, by);
    }

    /// Whether some may be a hole in another: then no polygon is known to be whole.
    bool has_holes() const { return has_holes_; }

    std::vector<std::vector<std::uint32_t>> regions;  ///< sides of the cap

private:
    bool runs_left(const std::vector<std::uint32_t>& region, PlaneId by) const {
        const FlatView view = space_.plane(by).front_view();
        const int u = view.u(), v = view.v();
        const auto at = [&](std::uint32_t point) { return space_.point(point).approximate(); };
        const Vec3 apex = at(split_.cap[region[0]].from);
        double area = 0, size = 0;
        for (const std::uint32_t k : region) {
            const Vec3 a = at(split_.cap[k].from) - apex, b = at(split_.cap[k].to) - apex;
            area += a[u] * b[v] - a[v] * b[u];
            size += std::max(a[u] * b[v], -a[u] * b[v]) + std::max(a[v] * b[u], -a[v] * b[u]);
        }
        return area > size * 1e-6;
    }

    const ConvexSpace& space_;
    const SidesSplit& split_;
    bool has_holes_ = false;
};

struct Seam {
    const std::vector<std::uint32_t>* sides = nullptr;
    std::uint32_t front = 0, back = 0;  ///< parts, those behind counted on from those in front
    bool needed = false;
};

/// @return false where it is not clear which parts meet at a polygon of the cap
bool find_seams(const SidesSplit& split, const CapRegions& cap, const HalfParts& front, const HalfParts& back,
                std::vector<Seam>& seams) {
    for (const std::vector<std::uint32_t>& region : cap.regions) {
        Seam seam{&region, kNone, kNone, false};
        for (const std::uint32_t k : region) {
            const FaceSide& side = split.cap[k];
            const std::uint32_t in_front = front.at(side.from, side.to), behind = back.at(side.to, side.from);
            if (in_front >= kSeveral || behind >= kSeveral) return false;
            if (seam.front != kNone && (seam.front != in_front || seam.back != behind)) return false;
            seam.front = in_front;
            seam.back = behind;
            seam.needed = seam.needed || split.resolves[k];
        }
        seam.back += std::uint32_t(front.parts.size());
        seams.push_back(seam);
    }
    return true;
}

}  // namespace

bool divide_solid(ConvexSpace& space, const SolidSides& solid, PlaneId plane, std::vector<FaceSides>& parts) {
    SidesSplit split;
    HalfParts front, back;
    if (!split_sides(space, solid, plane, split) || !find_parts(space, split.front, front) ||
        !find_parts(space, split.back, back))
        return false;
    std::vector<FaceSides> all = std::move(front.parts);
    front.parts.resize(all.size());
    for (FaceSides& part : back.parts) all.push_back(std::move(part));
    DisjointSets sets(all.size());
    const CapRegions cap(space, split, plane);
    std::vector<Seam> seams;
    FaceSides joined;
    if (!cap.has_holes() && find_seams(split, cap, front, back, seams)) {
        for (const Seam& seam : seams) {
            if (seam.needed) continue;
            const std::uint32_t a = sets.find(seam.front), b = sets.find(seam.back);
            const bool keeps = std::all_of(seams.begin(), seams.end(), [&](const Seam& other) {
                if (!other.needed) return true;
                const auto p = sets.find(other.front), q = sets.find(other.back);
                return !((p == a && q == b) || (p == b && q == a));
            });
            if (!keeps) continue;
            sets.join(a, b);
            // The cap of each half once more, the other way around.
            for (const std::uint32_t k : *seam.sides) {
                const FaceSide& side = split.cap[k];
                all[seam.front].push_back({from_behind(plane), side.from, side.to});
                all[seam.back].push_back({plane, side.to, side.from});
            }
        }
    }
    parts.clear();
    std::vector<std::size_t> place(all.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) {
        const std::uint32_t first = sets.find(k);
        if (first == k) {
            place[k] = parts.size();
            parts.emplace_back();
        }
        FaceSides& part = parts[place[first]];
        part.insert(part.end(), all[k].begin(), all[k].end());
    }
    for (FaceSides& part : parts) {
        settle_sides(part);
        straighten_sides(space, part);
    }
    return true;
}

}  // namespace firma
