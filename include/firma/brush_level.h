// SPDX-License-Identifier: MIT
// A level of convex brushes as read from a .map or a .bsp: planes through points of the grid, entities as they stand,
// and what is no brush as a Level beside it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firma/export.h"
#include "firma/grid.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/texture.h"

namespace firma {

/// What a brush is made of, and so what it stops (level.h).
enum class BrushKind : std::uint8_t {
    kSolid,       ///< joined into the one solid, which can be carved: stops everything but liquid's casts
    kSky,         ///< likewise, and painted with the sky
    kGlass,       ///< stops walk and shots, not sight; castable only
    kPlayerClip,  ///< stops walk; castable only
    kShotClip,    ///< stops shots; castable only
    kLiquid,      ///< its surface meets casts for liquid; castable only
    kPortal,      ///< divides the air into rooms by those of its sides that are marked; no face of it is met
    /// Triggers, fog, origins, brushes of entities that move, and what encloses nothing: kept, met by nothing. It may
    /// have fewer than four sides, or none.
    kData,
};

/// A half space's rim: what lies in front of the plane is outside the brush.
struct BrushSide {
    GridPoint points[3];                 ///< of the input grid, not in line; counter-clockwise seen from outside
    std::uint32_t material = 0;          ///< index into BrushLevel::materials
    std::uint32_t mask = 0;              ///< what its faces stop
    bool portal = false;                 ///< of a kPortal brush: this side is the portal
    std::uint32_t texture = kNoTexture;  ///< index into BrushLevel::textures; sides that share one may become one face
};

/// The common part of its sides' half spaces.
struct Brush {
    std::uint32_t first_side = 0, side_count = 0;  ///< in BrushLevel::sides, behind those of the brush before
    std::uint32_t entity = 0;                      ///< index into BrushLevel::entities, or 0
    BrushKind kind = BrushKind::kSolid;
    bool detail = false;  ///< the author marked it as detail: joined all the same
    /// Of an entity that moves, whose `kind` is kData: what it is in the part that it makes (brush_parts.h).
    BrushKind part_kind = BrushKind::kData;
    std::uint32_t line = 0;  ///< where it begins in the file, from 1; 0 where the format has none
};

/// A part of an entity in a form that is not understood (brushDef2, say): its text, from the word that names the form
/// to the brace that closes the part, without that.
struct UnknownPart {
    std::string text;
    std::uint32_t line = 0;
};

struct Entity {
    std::vector<std::pair<std::string, std::string>> keys;  ///< in the file's order, as written
    std::uint32_t line = 0;
    std::vector<UnknownPart> unknown;  ///< likewise; each has a note

    /// The value of the first such key; "" when there is none. Goes through the keys, up to that one.
    std::string_view value(std::string_view key) const {
        for (const auto& [name, value] : keys)
            if (name == key) return value;
        return {};
    }
};

/// make_world() and divide_rooms() check all of it: whoever fills one by hand gets an Error that names brush, side or
/// face for an index that is not there, a point off the input grid, points in line, a surface that is no convex
/// polygon.
struct BrushLevel {
    std::string name;                    ///< the file's, for messages
    std::vector<Entity> entities;        ///< the first is the world
    std::vector<Brush> brushes;          ///< in the file's order
    std::vector<BrushSide> sides;        ///< a face's source is the index of its side here
    std::vector<std::string> materials;  ///< at least one: "" is the name of none
    /// How textures lie on sides, in the axes of the level. Equal ones should be one: neighbours of different ones do
    /// not merge.
    std::vector<TextureProjection> textures;
    /// What is no brush (patches, drawn surfaces), castable only; with materials of its own. Its faces' sources count
    /// on from sides.size().
    Level surfaces;
    std::vector<std::string> notes;  ///< for people: what was dropped, replaced or not understood, with its place
    /// What the file holds and casts will not meet: what was not understood, brushes and patches of entities that move.
    /// `surfaces` has its own.
    std::vector<Omission> omissions;
    double metres_a_unit = 1.0 / 32;  ///< for numbers in the entities' values, > 0
    /// Metres by which a plane was moved onto the grid, at that corner of its faces where it is most; of a .bsp also by
    /// how much a brush grew when a plane that only touches it was left out. Above 0.001 there is a note.
    double max_shift = 0;
    /// Brushes of an entity with an `origin` are placed from there, as in a .bsp; else all stand where they are.
    bool placed_from_origins = false;
};

/// Where a point entity stands, metres: its `origin`; nothing where it has none, or it is no three numbers with blanks
/// between them. Goes through the entity's keys.
[[nodiscard]] FIRMA_EXPORT std::optional<Vec3> entity_origin(const BrushLevel& level, const Entity& entity);

/// Reads a Quake .map: brushes in the forms Standard, Valve 220, brushDef (Quake 3's brush primitives) and brushDef3
/// (Doom 3's), patches (patchDef2, patchDef3), entities. docs/formats.md says what is kept, dropped and refused.
///
/// @param text  the whole file
/// @param name  for messages
/// @return the level, or the first error with file and line: broken syntax, a number too large, a point outside the
///         world, a brush of more than 1024 sides, no entity at all. Parts it does not know are kept or noted, never an
///         error.
/// Time and memory grow with the text, time also with the square of a brush's sides, up to a limit for the whole file,
/// beyond which it is an error.
[[nodiscard]] FIRMA_EXPORT Result<BrushLevel> read_map(std::string_view text, std::string name,
                                                       const ReadOptions& options = {});

/// Reads the brushes and patches of a Quake 3 .bsp (version 46), of all its models; of the drawn surfaces only patches,
/// those of the first model. Float planes are made exact once each, a plane and its negative together.
///
/// @return the level, or the first error with file, lump and entry.
/// Costs as read_map(), with the size of the file.
[[nodiscard]] FIRMA_EXPORT Result<BrushLevel> read_bsp_brushes(std::span<const std::byte> bytes, std::string name,
                                                               const ReadOptions& options = {});

/// Reads a file by its ending (.map, .bsp): of a .bsp the brushes. All of it is read into memory first.
/// @return kCannotRead with the system's reason; kTooLarge beyond 4 GiB; kUnsupported for other endings; the errors of
///         the readers
/// Costs what these cost.
[[nodiscard]] FIRMA_EXPORT Result<BrushLevel> read_brush_level(const std::string& path,
                                                               const ReadOptions& options = {});

}  // namespace firma
