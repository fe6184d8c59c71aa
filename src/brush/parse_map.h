// SPDX-License-Identifier: MIT
// The grammar of .map files and of a .bsp's entities: what the file says, without any meaning.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brush/note_list.h"
#include "brush/winding.h"
#include "firma/brush_level.h"
#include "firma/vec.h"
#include "level/patch.h"

namespace firma {

/// No brush has more sides: that of the most seen has some hundred, and joining takes time that grows with their
/// square.
inline constexpr std::uint32_t kMostBrushSides = 1024;

/// How a side's texture lies, as it is written.
struct MapAlignment {
    enum class Form : std::uint8_t {
        kStandard,  ///< u[3], v[3]: offsets in texels; rotation in degrees, texels of scale[0] and scale[1] units
        kAxes,      ///< Valve 220: u and v are axes with offsets in texels; scale likewise, rotation says nothing
        kMatrix,    ///< brush primitives: u[0..2] and v[0..2] are rows of a matrix, in repeats
    };
    Form form = Form::kStandard;
    double u[4] = {0, 0, 0, 0}, v[4] = {0, 0, 0, 0};
    double rotation = 0, scale[2] = {1, 1};
};

/// A half space as three points in the file's units, clockwise seen from outside; of a brushDef3 as a plane.
struct MapSide {
    Vec3 points[3];
    std::optional<FloatPlane> plane;  ///< in the file's units, its normal 1 long; then there are no points
    std::string texture;
    MapAlignment alignment;
    std::uint32_t contents = 0, flags = 0;  ///< 0 where the file has none
    std::uint32_t line = 0;
};

struct MapBrush {
    std::uint32_t first_side = 0, side_count = 0;  ///< in MapFile::sides
    std::uint32_t entity = 0;
    std::uint32_t number = 0;  ///< within its entity, from 0, as editors count: patches and unknown ones too
    std::uint32_t line = 0;
};

struct MapPatch {
    Patch patch;  ///< in the file's units
    Patch uvs;    ///< of its control points: x and y are u and v, in repeats
    std::string texture;
    std::uint32_t contents = 0, flags = 0;
    std::uint32_t entity = 0, number = 0, line = 0;
};

struct MapFile {
    /// What TrenchBroom writes at the top: "// Format: Quake3". Empty where there is no such comment.
    std::string format;
    bool has_version = false;     ///< it begins with "Version", as Doom 3's do
    bool has_primitives = false;  ///< brushDef, brushDef3, patchDef2 or patchDef3, which only games with shaders have
    std::vector<Entity> entities;
    std::vector<MapBrush> brushes;
    std::vector<MapSide> sides;
    std::vector<MapPatch> patches;
};

/// @param text   a whole file
/// @param place  what stands before the line's number in messages: "demo.map:" or "demo.bsp: lump 0 (entities), line "
/// @param notes  gets what was not understood
/// @return the first thing that breaks the grammar (kMalformed), a number beyond the doubles (kOutOfRange), or a brush
///         of too many sides or a text of more than 4 GiB (kTooLarge). Memory is in proportion to the text.
Result<MapFile> parse_map(std::string_view text, std::string_view place, NoteList& notes);

}  // namespace firma
