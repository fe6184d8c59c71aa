// SPDX-License-Identifier: MIT
// What of a level is made of what.
#include "solid/matter_pieces.h"

#include <algorithm>

#include "base/hasher.h"
#include "base/sort.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

void add_name(Hasher& hasher, const std::string& text) {
    hasher.add(text.size());
    for (const char letter : text) hasher.add(static_cast<unsigned char>(letter));
}

std::uint64_t hash_of(const MatterPieces& all) {
    Hasher hasher;
    hasher.add(all.table.matters.size());
    for (const Matter& matter : all.table.matters) {
        add_name(hasher, matter.name);
        add_name(hasher, matter.inside);
        hasher.add(matter.density);
        hasher.add(matter.strength);
        hasher.add(matter.hardness);
        hasher.add(std::uint32_t(matter.fracture));
    }
    hasher.add(all.table.patterns.size());
    for (const MatterPattern& it : all.table.patterns) {
        add_name(hasher, it.pattern);
        hasher.add(it.matter);
    }
    hasher.add(all.rest, all.rest_look);
    hasher.add(all.pieces.size(), all.sources.size());
    for (const MatterPiece& piece : all.pieces) {
        hasher.add(piece.matter, piece.look);
        hasher.add(std::uint32_t(piece.sky), piece.plane_count);
        for (const Ref<const SolidPlane>& plane : all.planes_of(piece)) {
            for (const std::int64_t n : plane->plane.normal) hasher.add(n);
            hasher.add(plane->plane.offset_low);
            hasher.add(plane->plane.offset_high);
        }
        hasher.add(piece.material_count);
        for (const std::uint32_t material : all.materials_of(piece)) hasher.add(material);
        if (piece.mesh) hasher.add(hash_solid(*piece.mesh));
    }
    for (const MatterOfSources& it : all.sources) hasher.add(it.first, it.matter);
    return hasher.value();
}

double given_by(const CarveRules* rules, std::uint32_t material) {
    return rules && material < rules->hardness.size() ? rules->hardness[material] : 0;
}

}  // namespace

void MatterPieces::finish() {
    std::vector<GridBox> boxes;
    boxes.reserve(pieces.size());
    same = true;
    any_sky = false;
    for (const MatterPiece& piece : pieces) {
        boxes.push_back(piece.box);
        same = same && piece.matter == rest;
        any_sky = any_sky || piece.sky;
    }
    // Where bodies are all that is solid, nothing is rest.
    if (!same && !pieces.empty())
        same = std::all_of(pieces.begin(), pieces.end(), [&](const MatterPiece& piece) {
            return piece.plane_count > 0 && piece.matter == pieces[0].matter;
        });
    tree = BoxTree(boxes);
    hash = hash_of(*this);
}

std::uint32_t MatterPieces::of_source(std::uint32_t source) const {
    const auto after = std::upper_bound(sources.begin(), sources.end(), source,
                                        [](std::uint32_t s, const MatterOfSources& it) { return s < it.first; });
    return after == sources.begin() ? 0 : std::prev(after)->matter;
}

std::size_t MatterPieces::bytes() const {
    std::size_t sum = sizeof *this + pieces.capacity() * sizeof(MatterPiece) + planes.capacity() * sizeof planes[0] +
                      materials.capacity() * sizeof materials[0] + sources.capacity() * sizeof sources[0] +
                      tree.bytes() + table.matters.capacity() * sizeof(Matter) +
                      table.patterns.capacity() * sizeof(MatterPattern);
    // Neighbours share planes: each is counted where it is used first.
    std::vector<const SolidPlane*> each;
    for (const Ref<const SolidPlane>& plane : planes) each.push_back(plane.get());
    sort_range(each);
    sum += std::size_t(std::unique(each.begin(), each.end()) - each.begin()) * pool_size(sizeof(SolidPlane));
    return sum;
}

bool says_nothing(const MatterPieces& pieces) {
    return pieces.pieces.empty() && pieces.sources.empty() && pieces.rest == 0 && pieces.table == default_matters();
}

double hardness_of(const MatterPieces& pieces, const MatterPiece& piece, const CarveRules* rules) {
    if (rules)
        for (const std::uint32_t material : pieces.materials_of(piece))
            if (given_by(rules, material) >= 1) return 1;
    // What the rules say of the sky's material counts: also that it can be carved.
    if (piece.sky && !(rules && piece.look < rules->hardness.size())) return 1;
    const double given = given_by(rules, piece.look);
    return given > 0 ? given : pieces.table.matters[piece.matter].hardness;
}

double hardness_of_rest(const MatterPieces& pieces, const CarveRules* rules) {
    const double given = given_by(rules, pieces.rest_look);
    return given > 0 ? given : pieces.table.matters[pieces.rest].hardness;
}

bool any_hard(const MatterPieces& pieces, const CarveRules* rules) {
    const auto positive = [](double h) { return h > 0; };
    return pieces.any_sky || (rules && std::any_of(rules->hardness.begin(), rules->hardness.end(), positive)) ||
           std::any_of(pieces.table.matters.begin(), pieces.table.matters.end(),
                       [&](const Matter& matter) { return positive(matter.hardness); });
}

/// Of 53 + 32 bits a product, and an offset of 78 with 6 more.
int side_of_plane(const Plane& plane, const GridPoint& point) {
    Int128 sum = plane.offset() * kSurfacePerInput;
    for (int axis = 0; axis < 3; ++axis) sum += Int128(plane.normal[axis]) * point[axis];
    return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

bool holds(const MatterPieces& pieces, const MatterPiece& piece, const GridPoint& point) {
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < piece.box.low[axis] || point[axis] > piece.box.high[axis]) return false;
    for (const Ref<const SolidPlane>& plane : pieces.planes_of(piece))
        if (side_of_plane(plane->plane, point) > 0) return false;
    if (!piece.mesh) return piece.plane_count > 0;
    const Where where = locate(*piece.mesh, to_metres(point));
    return where == Where::kSolid || where == Where::kSurface;
}

std::optional<std::uint32_t> piece_at(const MatterPieces& pieces, const GridPoint& point, const CarveRules* rules) {
    std::optional<std::uint32_t> best;
    bool is_hard = false;
    const bool ask = any_hard(pieces, rules);
    GridBox at;
    at.add(point);
    pieces.tree.for_each_meeting(at, [&](std::uint32_t number) {
        const MatterPiece& piece = pieces.pieces[number];
        const bool hard = ask && hardness_of(pieces, piece, rules) >= 1;
        if (best && (is_hard != hard ? is_hard : *best < number)) return false;
        if (!holds(pieces, piece, point)) return false;
        best = number;
        is_hard = hard;
        return false;
    });
    return best;
}

}  // namespace firma
