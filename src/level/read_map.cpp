// SPDX-License-Identifier: MIT
// Reads a Quake .map into a BrushLevel: what the parsed file means.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "firma/brush_level.h"
#include "geometry/exact_plane.h"
#include "geometry/grid_orient.h"
#include "level/brush_builder.h"
#include "level/brush_kinds.h"
#include "level/judge_input.h"
#include "level/message.h"
#include "level/parse_map.h"
#include "level/winding.h"

namespace firma {
namespace {

bool in_line(const GridPoint (&points)[3]) {
    const AreaVector normal = area_vector(to_input(points[0]), to_input(points[1]), to_input(points[2]));
    return normal.x == 0 && normal.y == 0 && normal.z == 0;
}

// What a face is made of by the name of its texture, unless the file's own flags say otherwise.
SideKind kind_of(const MapSide& side) {
    if (const auto kind = kind_by_flags(side.contents, side.flags)) return {SideKind::What::kKnown, *kind};
    return side_kind(side.texture);
}

class MapReader {
public:
    MapReader(MapFile file, BrushBuilder& builder) : file_(std::move(file)), builder_(builder) {}

    std::optional<Error> read() {
        builder_.level.entities = std::move(file_.entities);
        for (const Entity& entity : builder_.level.entities) rules_.push_back(entity_rule(entity.value("classname")));
        // The first is the world, whatever it calls itself.
        rules_[0] = EntityRule::kStatic;
        if (entity_class(0) != "worldspawn")
            builder_.notes.add("the first entity is no worldspawn", line_place(entity(0).line));
        for (const MapBrush& brush : file_.brushes)
            if (auto error = add_brush(brush)) return error;
        for (const MapPatch& patch : file_.patches) add_patch(patch);
        return std::nullopt;
    }

private:
    const Entity& entity(std::uint32_t number) const { return builder_.level.entities[number]; }
    std::string entity_class(std::uint32_t number) const { return std::string(entity(number).value("classname")); }

    std::string line_place(std::uint32_t line) const { return builder_.level.name + ":" + std::to_string(line); }

    // "demo.map:17: entity 0 (worldspawn), brush 3", numbered as editors do.
    std::string place(std::uint32_t line, std::uint32_t in_entity, std::uint32_t number) const {
        const std::string class_name = entity_class(in_entity);
        return line_place(line) + ": entity " + std::to_string(in_entity) +
               (class_name.empty() ? "" : " (" + class_name.substr(0, 40) + ")") + ", brush " + std::to_string(number);
    }

    std::optional<Error> add_brush(const MapBrush& from) {
        Brush brush;
        brush.entity = from.entity;
        brush.line = from.line;
        const std::string at = place(from.line, from.entity, from.number);
        std::vector<BrushBuilder::Side> sides;
        std::vector<SideKind> kinds;
        std::vector<FloatPlane> planes;  // in metres, as in the file
        double inexact = 0;              // metres that a point was moved by
        for (std::uint32_t k = 0; k < from.side_count; ++k) {
            const MapSide& side = file_.sides[from.first_side + k];
            kinds.push_back(kind_of(side));
            brush.detail = brush.detail || (side.contents & bsp_flags::kDetail) != 0;
            // Quake's points run clockwise seen from outside.
            const Vec3 points[3] = {metres(side.points[0]), metres(side.points[2]), metres(side.points[1])};
            BrushBuilder::Side made;
            for (int corner = 0; corner < 3; ++corner) {
                const auto snapped = snap(points[corner]);
                if (!snapped) {
                    const int in_file = corner == 0 ? 0 : 3 - corner;
                    return Error{ErrorCode::kOutOfRange, place(side.line, from.entity, from.number),
                                 "side " + std::to_string(k) + ", point " + std::to_string(in_file) + ": " +
                                     point_fault(side.points[in_file], scale())};
                }
                made.side.points[corner] = *snapped;
                inexact = std::max(inexact, largest(to_metres(*snapped) - points[corner]));
            }
            const auto plane = float_plane(points[0], points[1], points[2]);
            if (in_line(made.side.points) || !plane) {
                builder_.notes.add("side whose three points lie on a line is left out",
                                   place(side.line, from.entity, from.number));
                continue;
            }
            made.side.material = builder_.material(side.texture);
            made.sky = kinds.back().what == SideKind::What::kKnown && kinds.back().kind == BrushKind::kSky;
            made.portal = kinds.back().what == SideKind::What::kKnown && kinds.back().kind == BrushKind::kPortal;
            planes.push_back(*plane);
            sides.push_back(made);
        }
        brush.kind = kind_in_entity(brush_kind(kinds), from, brush.detail);
        if (sides.size() < 4 && brush.kind != BrushKind::kData) {
            builder_.notes.add("brush of fewer than four sides is kept as data", at);
            brush.kind = BrushKind::kData;
        }
        measure(planes, inexact, brush, sides, at);
        builder_.add(brush, sides);
        return std::nullopt;
    }

    BrushKind kind_in_entity(BrushKind own, const MapBrush& from, bool& detail) {
        switch (rules_[from.entity]) {
            case EntityRule::kStatic:
                return own;
            case EntityRule::kDetail:
                detail = true;
                return own;
            case EntityRule::kPortal:
                return BrushKind::kPortal;
            case EntityRule::kMoves:
                break;
        }
        builder_.notes.add("brushes of " + quoted_class(from.entity) + " are kept as data",
                           place(from.line, from.entity, from.number));
        return BrushKind::kData;
    }

    std::string quoted_class(std::uint32_t number) const { return quote(entity(number).value("classname")); }

    // Faces are only needed for the largest side of a portal, and to see what the snap has done where it did anything.
    void measure(std::span<const FloatPlane> planes, double inexact, const Brush& brush,
                 std::vector<BrushBuilder::Side>& sides, const std::string& at) {
        if (inexact == 0 && brush.kind != BrushKind::kPortal) return;
        pairs_ += planes.size() * planes.size();
        if (pairs_ > kMostSidePairs) {
            builder_.notes.add("too many sides in all to measure the snap or find the largest side of a portal", at);
            return;
        }
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const std::vector<Vec3> corners = winding(planes, k, 2 * kWorldRim);
            sides[k].area = area(corners);
            const GridPoint(&points)[3] = sides[k].side.points;
            const auto snapped = float_plane(to_metres(points[0]), to_metres(points[1]), to_metres(points[2]));
            double shift = 0;
            for (const Vec3& corner : corners) {
                if (inexact == 0 || largest(corner) > kWorldRim) continue;  // of a face without an end
                shift = std::max(shift, std::fabs(dot(snapped->normal, corner) - snapped->distance));
            }
            builder_.shift(shift, at);
        }
    }

    void add_patch(const MapPatch& from) {
        PatchSurface surface;
        surface.patch = from.patch;
        surface.place = place(from.line, from.entity, from.number);
        surface.texture = from.texture;
        surface.line = from.line;
        if (rules_[from.entity] == EntityRule::kMoves) {
            builder_.notes.add("patches of " + quoted_class(from.entity) + " are left out", surface.place);
            return;
        }
        MapSide side;
        side.texture = from.texture;
        side.contents = from.contents;
        side.flags = from.flags;
        const SideKind kinds[1] = {kind_of(side)};
        const BrushKind kind = brush_kind(kinds);
        surface.mask = side_mask(kind, kind == BrushKind::kSky);
        builder_.add_patch(std::move(surface));
    }

    double scale() const { return builder_.level.metres_a_unit; }
    Vec3 metres(const Vec3& units) const { return units * scale(); }

    MapFile file_;
    BrushBuilder& builder_;
    std::vector<EntityRule> rules_;  // of the entities
    std::uint64_t pairs_ = 0;        // that the faces cut out so far have taken
};

}  // namespace

Result<BrushLevel> read_map(std::string_view text, std::string name, const ReadOptions& options) {
    if (auto error = judge_options(options, name)) return *std::move(error);
    BrushBuilder builder(name, options.scale == 0 ? kQuakeUnit : options.scale);
    Result<MapFile> file = parse_map(text, name + ":", builder.notes);
    if (!file) return file.error();
    if (file.value().entities.empty()) return Error{ErrorCode::kMalformed, std::move(name), "no entity in the file"};
    MapReader reader(std::move(file).value(), builder);
    if (auto error = reader.read()) return *std::move(error);
    return builder.finish(options.patch_tolerance);
}

}  // namespace firma
