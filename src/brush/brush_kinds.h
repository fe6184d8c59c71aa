// SPDX-License-Identifier: MIT
// What brushes are made of, by the names of their textures, their flags and their entities: the tables of that.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "firma/brush_level.h"

namespace firma {

/// Bits of contents and of a surface's flags, as Quake 2 and 3 agree on them where both have them.
/// Source: id Software, Quake III Arena source code, 2005, code/game/surfaceflags.h.
namespace bsp_flags {
inline constexpr std::uint32_t kSolid = 1, kWindow = 2, kLava = 8, kSlime = 16, kWater = 32, kFog = 64,
                               kAreaPortal = 0x8000, kPlayerClip = 0x10000, kMonsterClip = 0x20000, kOrigin = 0x1000000,
                               kDetail = 0x8000000, kTranslucent = 0x20000000, kTrigger = 0x40000000,
                               kNoDrop = 0x80000000;
inline constexpr std::uint32_t kSurfaceSky = 4, kSurfaceHint = 0x100;
}  // namespace bsp_flags

/// What one side says of its brush.
struct SideKind {
    enum class What : std::uint8_t {
        kPlain,    ///< a texture as any other
        kFiller,   ///< caulk, nodraw, skip: says nothing beside others; alone it is solid
        kNothing,  ///< nodrawnonsolid: says nothing beside others; alone it is met by nothing
        kKnown,    ///< `kind` it is
    };
    What what = What::kPlain;
    BrushKind kind = BrushKind::kSolid;
};

/// What decides what a side of a .map is made of.
enum class MapGame : std::uint8_t {
    kNumbers,  ///< contents and flags behind the texture, where they say something, else its name: Quake 2 and others
    kShaders,  ///< the name alone, as shaders do: Quake 3 and what came of it. The numbers are what an editor left
               ///< there
};

/// By what only files of one kind have; in this order: TrenchBroom's comment on the file's format; primitives of games
/// with shaders; textures in a folder `common`, or whose names begin with `textures/`.
///
/// @param format          of that comment; "" where there is none
/// @param has_primitives  brushDef, patchDef2 and their like
/// @param textures        names of textures, as written
MapGame map_game(std::string_view format, bool has_primitives, std::span<const std::string_view> textures);

/// By the texture's name: case does not matter, nor "textures/" and other folders above the last. In games with shaders
/// some names in the folder `common` mean something else than elsewhere.
SideKind side_kind(std::string_view texture, MapGame game = MapGame::kNumbers);

/// By contents and a side's flags; nothing when they have none of the bits that matter here.
std::optional<BrushKind> kind_by_flags(std::uint32_t contents, std::uint32_t flags);

/// A brush's kind: portal when any side is one; else that of the first side that says something.
BrushKind brush_kind(std::span<const SideKind> sides);

/// What a side of a brush stops; `sky` when the side itself is painted with it.
std::uint32_t side_mask(BrushKind brush, bool sky);

/// What an entity does with its brushes.
enum class EntityRule : std::uint8_t {
    kStatic,  ///< part of the world
    kDetail,  ///< part of the world, marked as detail
    kPortal,  ///< portals, whatever their textures
    kMarks,   ///< volumes of ours that mark something: kept as data, as their author means it
    kPasses,  ///< triggers and what is there to be walked through: kept as data, with a note; nothing is lost
    kMoves,   ///< doors, plats: kept as data, with a note; their brushes are left out of the world
};
EntityRule entity_rule(std::string_view classname);

}  // namespace firma
