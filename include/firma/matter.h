// SPDX-License-Identifier: MIT
// What levels are made of: brick, wood, glass. Each brush or closed mesh piece of a level has a matter, by the names of
// its textures, by what its file says, or by a table that the game gives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/result.h"
#include "firma/vec.h"

namespace firma {

class World;
struct FaceInfo;

/// How something breaks: for what a game shows and hears of it. Edits go by kPane alone: such faces go whole.
enum class FractureStyle : std::uint8_t {
    kChunks,     ///< brick, concrete, rock
    kSplinters,  ///< wood
    kBends,      ///< steel
    kPane,       ///< glass
};

/// The style of a name ("chunks", "splinters", "bends", "pane"); nothing for any other. Never allocates, as
/// fracture_style_name(), which gives "" for what is no style.
[[nodiscard]] FIRMA_EXPORT std::optional<FractureStyle> fracture_style(std::string_view name);
[[nodiscard]] FIRMA_EXPORT std::string_view fracture_style_name(FractureStyle style);

struct Matter {
    std::string name;
    std::string inside;     ///< the material of faces that a cut leaves in it; "": that without a name
    double density = 2400;  ///< kilograms a cubic metre, > 0
    double strength = 3;    ///< megapascals of tension that it bears, >= 0: for games and what breaks off
    /// As CarveZone::hardness: 1 may not be carved, a crater is cut short there; below, a cutter whose centre is
    /// nearest to this matter is shrunk to (1 - hardness) of its scale; 0 is cut as it is.
    double hardness = 0;
    FractureStyle fracture = FractureStyle::kChunks;
    friend bool operator==(const Matter&, const Matter&) = default;
};

/// Which matter a name stands for. `*` in a pattern stands for any letters, also none; case does not matter. A pattern
/// without `/` is compared with what follows the last `/` of a name, one with `/` with the whole name.
struct MatterPattern {
    std::string pattern;
    std::uint32_t matter = 0;  ///< index into MatterTable::matters
    friend bool operator==(const MatterPattern&, const MatterPattern&) = default;
};

/// A table of matters, and which textures are of which.
struct MatterTable {
    /// At least one: the first is that of everything which no pattern fits.
    std::vector<Matter> matters = {Matter{}};
    std::vector<MatterPattern> patterns;  ///< the first that fits counts
    friend bool operator==(const MatterTable&, const MatterTable&) = default;
};

/// More are refused, as are more patterns than this, and texts longer than kMaxMatterText bytes.
inline constexpr std::size_t kMaxMatters = 4096;
inline constexpr std::size_t kMaxMatterText = 255;

/// The built-in table: matter without a name first, with nothing special about it; then brick, concrete, wood, steel,
/// glass, rock, by usual names of textures (docs/matter.md lists them). The same every time.
[[nodiscard]] FIRMA_EXPORT const MatterTable& default_matters();

/// What does not hold of a table, or nothing: no matter at all, too many, a pattern of a matter that is not there, an
/// empty pattern, two matters of one name, a number that is not finite or out of range, a text too long.
[[nodiscard]] FIRMA_EXPORT std::optional<Error> check_matters(const MatterTable& table, const std::string& name = "");

/// The matter of a name (its index); nothing when there is none. Goes through the matters. Never allocates.
[[nodiscard]] FIRMA_EXPORT std::optional<std::uint32_t> matter_named(const MatterTable& table, std::string_view name);
/// The matter that a texture or material is of, by the patterns; 0 where none fits. Goes through the patterns; a name
/// takes the product of its length and the pattern's at most. Never allocates.
[[nodiscard]] FIRMA_EXPORT std::uint32_t matter_of_texture(const MatterTable& table, std::string_view texture);

/// Reads a table as text; docs/formats.md has the form. A matter without a name comes first in it, unless the text says
/// which matter is the default.
/// @param text  the whole file
/// @param name  for messages
/// @return the table, or the first error with file and line: a word that is no key, a number that is none or out of
///         range, a key before the first matter, a name used twice, a matter without a name, more than kMaxMatters
/// Costs the text.
[[nodiscard]] FIRMA_EXPORT Result<MatterTable> read_matters(std::string_view text, const std::string& name);
/// The same from a file, read into memory first.
/// @return kCannotRead with the system's reason; the errors of read_matters()
[[nodiscard]] FIRMA_EXPORT Result<MatterTable> read_matter_file(const std::string& path);

/// The table that a world was made with. As long-lived as the world and its copies.
[[nodiscard]] FIRMA_EXPORT const MatterTable& matters_of(const World& world);
/// One of them; the first where there is no such index.
[[nodiscard]] FIRMA_EXPORT const Matter& matter(const World& world, std::uint32_t index);

/// What a place is made of, whether or not a cut has made air of it since: that of the brush or mesh piece that holds
/// the point. Where several do, one that may not be carved wins, then the one that comes first in the file; of closed
/// meshes inside each other the innermost.
/// @param point  metres; rounded to the surface grid first
/// @return index into MatterTable::matters; where no piece is, that of the rest: of rock that reaches to infinity the
///         matter of the pieces that bound it, else the first of the table; the same for a point that is not finite or
///         lies outside the world
/// Never allocates, where brushes are the pieces. Costs the pieces whose boxes hold the point.
[[nodiscard]] FIRMA_EXPORT std::uint32_t matter_at(const World& world, const Vec3& point);

/// The matter of a face of the level, castable-only ones too: that of its brush or mesh piece, by its source. Of a face
/// that an edit made: what is just behind its middle, see matter_at().
/// @param face  as World::face() gives it; matter_of(world, ref) finds it first
/// @return index into MatterTable::matters; nothing for a face that this world does not have
[[nodiscard]] FIRMA_EXPORT std::optional<std::uint32_t> matter_of(const World& world, const FaceRef& face);

/// Counts of a world's pieces.
struct MatterCounts {
    std::size_t pieces = 0;              ///< that bound solid
    std::size_t protected_pieces = 0;    ///< of these, how many may not be carved
    std::vector<std::size_t> of_matter;  ///< of these, by index of the matter
    std::uint32_t rest = 0;              ///< the matter of what lies in no piece
};
/// Goes through the pieces.
[[nodiscard]] FIRMA_EXPORT MatterCounts count_matters(const World& world);

}  // namespace firma
