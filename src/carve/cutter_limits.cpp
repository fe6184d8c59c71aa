// SPDX-License-Identifier: MIT
// What a cutter may take.
#include "carve/cutter_limits.h"

#include <algorithm>

#include "carve/nearest_facet.h"
#include "carve/reaches_into.h"
#include "solid/solid_data.h"

namespace firma {

double CutterLimits::hardness_at_middle() const {
    const Vec3 middle = (to_metres(cutter.box.low) + to_metres(cutter.box.high)) * 0.5;
    return std::max(hardness_of_zones(middle), hardness_of_matter(middle));
}

double CutterLimits::hardness_of_zones(const Vec3& middle) const {
    double hardest = 0;
    for (const CarveZone& zone : rules.zones) {
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
            inside = inside && middle[axis] >= zone.box.low[axis] && middle[axis] <= zone.box.high[axis];
        if (inside && zone.hardness < 1) hardest = std::max(hardest, zone.hardness);
    }
    return hardest;
}

double CutterLimits::hardness_of_matter(const Vec3& middle) const {
    const MatterPieces* pieces = terms.matters.pieces;
    const auto is_between = [](double h) { return h > 0 && h < 1; };
    const bool given = std::any_of(rules.hardness.begin(), rules.hardness.end(), is_between);
    const bool known = pieces && std::any_of(pieces->table.matters.begin(), pieces->table.matters.end(),
                                             [&](const Matter& matter) { return is_between(matter.hardness); });
    if (fills || (!given && !known)) return 0;
    // What is farther than the cutter reaches does not matter: it takes nothing there.
    const std::optional<NearestFacet> near =
        nearest_facet(solid.data().faces.root.get(), middle, cutter.box.longest_extent() * 2);
    double hardness = 0;
    const std::uint32_t material = near ? near->place.record().material : ~0u;
    if (near && material < rules.hardness.size()) hardness = rules.hardness[material];
    if (pieces && pieces->pieces.empty()) {
        if (!(hardness > 0)) hardness = hardness_of_rest(*pieces, &rules);
    } else if (pieces) {
        const bool in_solid = locate(solid, middle) == Where::kSolid;
        if (!in_solid && !near) return 0;
        constexpr double kBehindFacet = 1.0 / 1024;  // metres
        const std::optional<GridPoint> at = snap(in_solid ? middle : near->at - near->normal * kBehindFacet);
        if (!at) return 0;
        const std::optional<std::uint32_t> piece = piece_at(*pieces, *at, &rules);
        hardness = piece ? hardness_of(*pieces, pieces->pieces[*piece], &rules) : hardness_of_rest(*pieces, &rules);
    }
    return is_between(hardness) ? hardness : 0;
}

std::vector<CutShield> CutterLimits::shields() const {
    std::vector<CutShield> found;
    for (const CarveZone& zone : rules.zones) {
        if (!(zone.hardness >= 1) || !reaches_into(cutter, zone.box)) continue;
        if (std::optional<Cutter> box = box_shield(zone.box, cutter.box))
            found.push_back({*std::move(box), "zone " + zone.name});
    }
    const MatterPieces* pieces = terms.matters.pieces;
    if (fills || !pieces || !terms.solid_of || !any_hard(*pieces, &rules)) return found;
    std::vector<std::uint32_t> near;
    pieces->tree.for_each_meeting(cutter.box, [&](std::uint32_t number) {
        if (hardness_of(*pieces, pieces->pieces[number], &rules) >= 1) near.push_back(number);
        return false;
    });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t number : near) {
        const MatterPiece& piece = pieces->pieces[number];
        const std::optional<Solid> of_piece = terms.solid_of(piece);
        if (!of_piece) continue;
        Result<Cutter> body = cutter_from_solid(*of_piece);
        if (!body) continue;
        const bool by_matter = pieces->table.matters[piece.matter].hardness >= 1;
        found.push_back({std::move(body).value(), by_matter ? "matter " + pieces->table.matters[piece.matter].name
                                                            : "material " + material_name(piece.look)});
    }
    return found;
}

std::optional<std::string> CutterLimits::taken_and_hard(const SolidPatch& patch, const NewLoops& loops) const {
    const MatterPieces* pieces = terms.matters.pieces;
    const bool has_pieces = pieces && !pieces->pieces.empty();
    const bool rest_is_hard = pieces && hardness_of_rest(*pieces, &rules) >= 1;
    if (has_pieces && !rest_is_hard) return std::nullopt;
    for (const std::uint32_t face : loops.gone) {
        const FaceRecord& record = patch.faces[face].facet.record();
        const std::uint32_t material = record.material;
        if (!has_pieces && material < rules.hardness.size() && rules.hardness[material] >= 1)
            return "material " + material_name(material);
        if (!rest_is_hard || record.edit != 0) continue;
        if (!has_pieces || pieces->of_source(record.source) == pieces->rest)
            return "matter " + pieces->table.matters[pieces->rest].name;
    }
    return std::nullopt;
}

std::string CutterLimits::material_name(std::uint32_t material) const {
    if (terms.materials && material < terms.materials->size()) return (*terms.materials)[material];
    return std::to_string(material);
}

}  // namespace firma
