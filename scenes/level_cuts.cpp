// SPDX-License-Identifier: MIT
// Seeded cuts for a world with rooms.
#include "scenes/level_cuts.h"

#include "firma/rooms.h"
#include "world/world_data.h"

namespace firma::scenes {
namespace {

const CutFamily& family(std::string_view name) {
    for (const CutFamily& family : cut_families())
        if (family.name == name) return family;
    return cut_families()[0];
}

void add_faces(const Node& tree, Level& level) {
    for_each_block(tree, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) {
            if (!face.solid) continue;
            LevelFace& added = level.faces.emplace_back();
            added.first_corner = std::uint32_t(level.corners.size());
            added.corner_count = face.corner_count;
            for (std::size_t k = 0; k < face.corner_count; ++k) {
                level.corners.push_back(std::uint32_t(level.vertices.size()));
                level.vertices.push_back(block.corner(face, k));
            }
        }
    });
}

/// A corner, a point of an edge, or one of the inside.
Vec3 point_of(const std::vector<Vec3>& polygon, Rng& rng) {
    const auto count = std::uint32_t(polygon.size());
    const std::uint32_t k = rng.below(count);
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % count], &c = polygon[(k + 2) % count];
    const double which = rng.uniform(), along = rng.uniform(), in = rng.uniform();
    if (which < 0.25) return a;
    const Vec3 on_edge = a + (b - a) * along;
    return which < 0.5 ? on_edge : on_edge + (c - on_edge) * in;
}

CarveKind other(CarveKind kind) {
    return kind == CarveKind::kCarve ? CarveKind::kFill : CarveKind::kCarve;
}

/// Every fourth one, four times.
void repeat(std::vector<CutOrder>& cuts, Rng& rng) {
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        if (k % 4 == 0) continue;
        cuts[k] = cuts[k - 1];
        if (rng.chance(0.5)) cuts[k].kind = other(cuts[k].kind);
        const bool by_a_step = rng.chance(0.5);
        const double by = by_a_step ? 1 / kInputSteps : rng.uniform(-0.1, 0.1);
        if (rng.chance(0.4)) cuts[k].pose.position.x += by;
        const double scale = rng.uniform(0.9, 1.2);
        if (rng.chance(0.2)) cuts[k].pose.scale *= scale;
    }
}

}  // namespace

CutPlaces cut_places(const World& world) {
    CutPlaces places;
    for (std::uint32_t room = 0; room < world.room_count(); ++room)
        if (const Node* tree = world.data().faces_of(room).tree.get())
            add_faces(*tree, room_info(world, {room})->exterior ? places.outside : places.inside);
    if (places.inside.faces.empty()) places.inside = places.outside;
    if (places.outside.faces.empty()) places.outside = places.inside;
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal)
        for (std::vector<Vec3>& polygon : portal_polygons(world, {portal}))
            places.portals.push_back(std::move(polygon));
    return places;
}

std::vector<CutOrder> level_cuts(const CutPlaces& places, LevelCuts kind, std::uint64_t seed, std::uint64_t index) {
    const std::string_view pattern = kind == LevelCuts::kCorner    ? "our_level_corner"
                                     : kind == LevelCuts::kSnapped ? "our_level_snapped"
                                                                   : "our_level_spread";
    const Level& walls = kind == LevelCuts::kRim ? places.outside : places.inside;
    std::vector<CutOrder> cuts = make_cut_case(family(pattern), seed, index, walls).cuts;
    Rng rng(seed * 0x9E3779B97F4A7C15ull ^ index);
    if (kind == LevelCuts::kRepeated) repeat(cuts, rng);
    for (CutOrder& order : cuts) {
        if (kind == LevelCuts::kPortals && !places.portals.empty())
            order.pose.position = point_of(places.portals[rng.below(std::uint32_t(places.portals.size()))], rng);
        if (kind == LevelCuts::kFilling && rng.chance(0.6)) order.kind = CarveKind::kFill;
        if (kind == LevelCuts::kLarge) order.pose.scale *= rng.uniform(2, 4);
    }
    return cuts;
}

}  // namespace firma::scenes
