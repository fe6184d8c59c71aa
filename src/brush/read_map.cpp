// SPDX-License-Identifier: MIT
// Reads a Quake .map into a BrushLevel: what the parsed file means.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brush/brush_builder.h"
#include "brush/brush_kinds.h"
#include "brush/map_planes.h"
#include "brush/map_texture.h"
#include "brush/parse_map.h"
#include "firma/brush_level.h"
#include "level/judge_input.h"
#include "level/message.h"

namespace firma {
namespace {

constexpr double kFarthest = 1.7320508075688772 * kWorldRim;  // metres from the origin to the world's corners, about

MapGame game_of(const MapFile& file) {
    std::vector<std::string_view> textures;
    for (const MapSide& side : file.sides) textures.push_back(side.texture);
    for (const MapPatch& patch : file.patches) textures.push_back(patch.texture);
    return map_game(file.format, file.has_primitives, textures);
}

// Whether an entity of a Doom 3 file turns what belongs to it.
bool is_turned(const Entity& entity) {
    const std::string_view rotation = entity.value("rotation");
    if (!rotation.empty() && rotation != "1 0 0 0 1 0 0 0 1") return true;
    for (const char* const key : {"angle", "angles"}) {
        const std::string_view value = entity.value(key);
        if (value.find_first_not_of("0. ") != std::string_view::npos) return true;
    }
    return false;
}

class MapReader {
public:
    MapReader(MapFile file, BrushBuilder& builder) : file_(std::move(file)), builder_(builder), game_(game_of(file_)) {}

    std::optional<Error> read() {
        // Before anything is moved: projections are of the file's own places, in Doom 3 too.
        for (const MapSide& side : file_.sides)
            textures_.push_back(texture_of_side(side, builder_.level.metres_a_unit));
        builder_.level.entities = std::move(file_.entities);
        for (const Entity& entity : builder_.level.entities) rules_.push_back(entity_rule(entity.value("classname")));
        // The first is the world, whatever it calls itself.
        rules_[0] = EntityRule::kStatic;
        if (entity_class(0) != "worldspawn")
            builder_.notes.add("the first entity is no worldspawn", line_place(entity(0).line));
        if (file_.has_version) place_by_origins();
        if (auto error = judge_points()) return error;
        make_planes();
        for (const MapBrush& brush : file_.brushes) add_brush(brush);
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

    // In Doom 3's files what belongs to an entity is placed relative to the entity's origin.
    void place_by_origins() {
        std::vector<Vec3> origins(builder_.level.entities.size());
        for (std::uint32_t k = 1; k < origins.size(); ++k) {
            const std::optional<Vec3> metres = entity_origin(builder_.level, entity(k));
            if (metres) origins[k] = *metres * (1 / builder_.level.metres_a_unit);
        }
        for (const MapBrush& brush : file_.brushes) {
            const Vec3& origin = origins[brush.entity];
            for (MapSide& side : std::span(file_.sides).subspan(brush.first_side, brush.side_count)) {
                for (Vec3& point : side.points) point = point + origin;
                if (side.plane) side.plane->distance += dot(side.plane->normal, origin);
            }
        }
        for (MapPatch& patch : file_.patches)
            for (Vec3& point : patch.patch.control) point = point + origins[patch.entity];
        for (std::uint32_t k = 1; k < origins.size(); ++k)
            if (rules_[k] != EntityRule::kPasses && is_turned(entity(k))) rules_[k] = EntityRule::kMoves;
    }

    // What a face is made of by the name of its texture, unless the file's own flags say otherwise in a game whose do.
    SideKind kind_of(std::string_view texture, std::uint32_t contents, std::uint32_t flags) const {
        if (game_ == MapGame::kNumbers)
            if (const auto kind = kind_by_flags(contents, flags)) return {SideKind::What::kKnown, *kind};
        return side_kind(texture, game_);
    }
    SideKind kind_of(const MapSide& side) const { return kind_of(side.texture, side.contents, side.flags); }

    std::optional<Error> judge_points() const {
        for (const MapBrush& brush : file_.brushes) {
            for (std::uint32_t k = 0; k < brush.side_count; ++k) {
                const MapSide& side = file_.sides[brush.first_side + k];
                if (side.plane && !(std::fabs(side.plane->distance) * builder_.level.metres_a_unit < kFarthest)) {
                    return Error{ErrorCode::kOutOfRange, place(side.line, brush.entity, brush.number),
                                 "side " + std::to_string(k) + ": its plane lies outside the world"};
                }
                for (int corner = 0; corner < 3; ++corner) {
                    if (snap(side.points[corner] * builder_.level.metres_a_unit)) continue;
                    return Error{ErrorCode::kOutOfRange, place(side.line, brush.entity, brush.number),
                                 "side " + std::to_string(k) + ", point " + std::to_string(corner) + ": " +
                                     point_fault(side.points[corner], builder_.level.metres_a_unit)};
                }
            }
        }
        return std::nullopt;
    }

    void make_planes() {
        std::vector<bool> wants_area;  // which side of a portal is the largest
        for (const MapBrush& brush : file_.brushes) {
            wants_area.push_back(rules_[brush.entity] == EntityRule::kPortal ||
                                 brush_kind(kinds_of(brush)) == BrushKind::kPortal);
        }
        planes_ = make_map_planes(file_, builder_.level.metres_a_unit, wants_area);
        if (planes_.complete) return;
        builder_.notes.add("too many sides to look at all faces: planes off the grid and portals may be rough",
                           builder_.level.name);
    }

    std::vector<SideKind> kinds_of(const MapBrush& brush) const {
        std::vector<SideKind> kinds;
        for (std::uint32_t k = 0; k < brush.side_count; ++k)
            kinds.push_back(kind_of(file_.sides[brush.first_side + k]));
        return kinds;
    }

    void add_brush(const MapBrush& from) {
        Brush brush;
        brush.entity = from.entity;
        brush.line = from.line;
        const std::string at = place(from.line, from.entity, from.number);
        const std::vector<SideKind> kinds = kinds_of(from);
        std::vector<BrushBuilder::Side> sides;
        for (std::uint32_t k = 0; k < from.side_count; ++k) {
            const MapSide& side = file_.sides[from.first_side + k];
            const MapPlane& plane = planes_.of_side[from.first_side + k];
            brush.detail = brush.detail || (side.contents & bsp_flags::kDetail) != 0;
            if (!plane.valid) {
                builder_.notes.leave_out("side whose three points lie on a line is left out",
                                         "sides whose three points lie on a line",
                                         place(side.line, from.entity, from.number));
                continue;
            }
            BrushBuilder::Side& made = sides.emplace_back();
            std::copy(std::begin(plane.points), std::end(plane.points), std::begin(made.side.points));
            made.side.material = builder_.material(side.texture);
            made.sky = kinds[k].what == SideKind::What::kKnown && kinds[k].kind == BrushKind::kSky;
            made.portal = kinds[k].what == SideKind::What::kKnown && kinds[k].kind == BrushKind::kPortal;
            made.area = plane.area;
            if (const auto& texture = textures_[from.first_side + k]; texture && is_drawn(kinds[k]))
                made.side.texture = builder_.texture(*texture);
            builder_.shift(plane.shift, at);
        }
        brush.kind = kind_in_entity(brush_kind(kinds), from, brush.detail);
        if (rules_[from.entity] == EntityRule::kMoves && sides.size() >= 4) brush.part_kind = brush_kind(kinds);
        if (sides.size() < 4 && brush.kind != BrushKind::kData) {
            builder_.notes.leave_out("brush of fewer than four sides is kept as data",
                                     "brushes of fewer than four sides", at);
            brush.kind = BrushKind::kData;
        }
        builder_.add(brush, sides);
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
            case EntityRule::kMarks:
                return BrushKind::kData;
            case EntityRule::kPasses:
            case EntityRule::kMoves:
                break;
        }
        const std::string brushes = "brushes of " + quoted_class(from.entity), note = brushes + " are kept as data";
        const std::string at = place(from.line, from.entity, from.number);
        if (rules_[from.entity] == EntityRule::kPasses || own == BrushKind::kData)
            builder_.notes.add(note, at);
        else
            builder_.notes.leave_out(note, brushes, at);
        return BrushKind::kData;
    }

    std::string quoted_class(std::uint32_t number) const { return quote(entity(number).value("classname")); }

    void add_patch(const MapPatch& from) {
        PatchSurface surface;
        surface.patch = from.patch;
        surface.uvs = from.uvs;
        surface.place = place(from.line, from.entity, from.number);
        surface.texture = from.texture;
        surface.line = from.line;
        const EntityRule rule = rules_[from.entity];
        if (rule == EntityRule::kMoves || rule == EntityRule::kMarks || rule == EntityRule::kPasses) {
            const std::string patches = "patches of " + quoted_class(from.entity), note = patches + " are left out";
            if (rule == EntityRule::kMoves)
                builder_.notes.leave_out(note, patches, surface.place);
            else
                builder_.notes.add(note, surface.place);
            return;
        }
        const SideKind kinds[1] = {kind_of(from.texture, from.contents, from.flags)};
        const BrushKind kind = brush_kind(kinds);
        surface.mask = side_mask(kind, kind == BrushKind::kSky);
        builder_.add_patch(std::move(surface));
    }

    // Tools' textures lie as they happened to: that shall not keep neighbours apart. The sky is drawn from afar.
    static bool is_drawn(const SideKind& kind) {
        if (kind.what == SideKind::What::kPlain) return true;
        return kind.what == SideKind::What::kKnown &&
               (kind.kind == BrushKind::kSolid || kind.kind == BrushKind::kGlass || kind.kind == BrushKind::kLiquid);
    }

    MapFile file_;
    std::vector<std::optional<TextureProjection>> textures_;  // of its sides
    BrushBuilder& builder_;
    MapGame game_;
    std::vector<EntityRule> rules_;  // of the entities
    MapPlanes planes_;
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
