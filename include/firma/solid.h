// SPDX-License-Identifier: MIT
// The exact solid: a value of its own. Is it sound, how large is it, is it the same? What of a level can become one?
// And a closed cutter taken away from it or added to it, exactly, by rules; no World is needed. Carving in a World is
// carve.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/hit.h"
#include "firma/result.h"
#include "firma/tree_options.h"
#include "firma/vec.h"

namespace firma {

struct Level;
struct SolidData;
class World;

/// A value: copies are cheap, share everything, and never change. It knows neither rooms nor rules for carving.
/// Copies and questions cost the same however many faces there are, but for bounds(). Dropping the last copy frees what
/// no other solid or world shares, block by block.
class Solid {
public:
    /// Nothing at all is solid.
    FIRMA_EXPORT Solid();
    FIRMA_EXPORT explicit Solid(std::shared_ptr<const SolidData> data);
    Solid(const Solid&) = default;
    Solid& operator=(const Solid&) = default;
    /// Leaves an empty solid behind.
    FIRMA_EXPORT Solid(Solid&& other) noexcept;
    FIRMA_EXPORT Solid& operator=(Solid&& other) noexcept;
    ~Solid() = default;

    /// Facets: what casts meet of it.
    FIRMA_EXPORT std::size_t face_count() const;
    /// What no face separates from infinity is solid.
    FIRMA_EXPORT bool rock_outside() const;
    /// The number of the last edit: how many made it, unless some were given higher ones (CarveOptions::edit). Faces of
    /// the next one say that they come from edit `edits() + 1`.
    FIRMA_EXPORT std::uint32_t edits() const;
    /// Of all faces, metres; empty where there are none. Never allocates. Costs a few walks through the index, more
    /// where many faces reach to within a float's rounding of the bounds.
    FIRMA_EXPORT Box bounds() const;

    const SolidData& data() const { return *data_; }

private:
    std::shared_ptr<const SolidData> data_;
};

/// The closed pieces of a level, by the rules of level_solidity(); other faces are left out.
/// @return errors as make_world()
/// Costs what make_world() of the level costs.
[[nodiscard]] FIRMA_EXPORT Result<Solid> make_solid(const Level& level, const TreeOptions& tree = {});

/// What does not hold of a solid's exact boundary, and where.
struct SolidFault {
    std::string what;
    FaceId face;  ///< one facet of the exact face; not valid() when no face is at fault alone
    Vec3 at;      ///< metres: a corner or an edge's end that shows it
};

/// The first thing that does not hold of the solid's boundary, or nothing: loops close, an outer one first, the right
/// way around, then holes; every edge is used twice, once each way; vertices lie exactly on the planes of their faces
/// and edges; the facets of each face cover it, and all facets together are closed. Says nothing about where the
/// boundary crosses itself. See check_world() for facets one by one.
/// Costs all faces, in time and in memory.
[[nodiscard]] FIRMA_EXPORT std::optional<SolidFault> check_solid(const Solid& solid);
[[nodiscard]] FIRMA_EXPORT std::optional<SolidFault> check_solid(const World& world);

struct SolidMeasures {
    /// Of the exact solid, cubic metres; where rock reaches to infinity, minus the volume of its air.
    double volume = 0;
    /// Of the exact solid's boundary, square metres.
    double area = 0;
    /// As `volume`, but of what casts meet: corners rounded to the surface grid.
    double facet_volume = 0;
    std::size_t faces = 0;   ///< exact ones
    std::size_t facets = 0;  ///< of these
};

/// Measures all faces. Each number is rounded once or twice, from sums of 100 bits and more.
/// Costs all faces, in time and in memory.
[[nodiscard]] FIRMA_EXPORT SolidMeasures measure_solid(const Solid& solid);
[[nodiscard]] FIRMA_EXPORT SolidMeasures measure_solid(const World& world);

/// A hash of the solid's set of points: equal for equal solids, however they came about and however their surface is
/// divided into faces; disjoint edits in any order give the same. Ids, sources, materials and blocks do not count. The
/// same on every machine. It is kept as edits go: asking costs nothing.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_solid(const Solid& solid);
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_solid(const World& world);

/// Whether two solids are the same set of points, exactly: however their surfaces are divided into faces and edges, and
/// whatever made them. Ids, sources, materials and blocks do not count. Two solids without faces are the same if both
/// are air or both are rock; two whose faces are the same are not where only one of them has rock outside. Both are
/// taken as sound (check_solid()).
/// No hash decides that they are the same. Different hashes, see hash_solid(), decide that they are not, at no cost.
/// Else the cost grows with the faces of blocks that only one of them has: nothing for copies, what the edits touched
/// for versions of one solid. Faces of solids that were made apart are compared one by one; equal ones cost some 0.5 us
/// each, others some 3 us.
[[nodiscard]] FIRMA_EXPORT bool same_solid(const Solid& a, const Solid& b);
/// Of what is solid in two worlds: rooms, and faces that are castable only, do not count.
[[nodiscard]] FIRMA_EXPORT bool same_solid(const World& a, const World& b);

/// A cube of 32 m: from (x, y, z) * 32 m to (x + 1, y + 1, z + 1) * 32 m.
struct Region {
    std::int32_t x = 0, y = 0, z = 0;
    friend bool operator==(const Region&, const Region&) = default;
    friend auto operator<=>(const Region&, const Region&) = default;
};

/// The same for what lies in one region.
struct RegionHash {
    Region region;
    std::uint64_t faces = 0;   ///< of all that a world's faces are: those whose lowest corner lies there
    std::uint64_t points = 0;  ///< of the solid's set of points: of its corners there
    friend bool operator==(const RegionHash&, const RegionHash&) = default;
};

/// Of each region with anything in it, in an order that is the same everywhere: where two lists differ, solids do.
/// Kept as edits go: costs the regions that hold or held anything, whatever the faces.
[[nodiscard]] FIRMA_EXPORT std::vector<RegionHash> hash_regions(const Solid& solid);

/// Where a point lies.
enum class Where : std::uint8_t {
    kAir,      ///< in front of the faces that it sees first
    kSolid,    ///< behind them
    kSurface,  ///< on a face that bounds the solid, exactly
    kUnknown,  ///< a number is not finite or too large; or in a fold of the surface that rounding to the grid made (a
               ///< few millionths of a metre wide)
};

/// Where a point lies, by what a ray from it meets first.
/// @param point  metres; may lie outside the world
/// Never allocates. Costs a cast or two; up to eight, and a search of the faces around the point, for one on the
/// surface.
[[nodiscard]] FIRMA_EXPORT Where locate(const Solid& solid, const Vec3& point);

/// Why a piece of a level's surface cannot be carved.
enum class SolidNoteKind : std::uint8_t {
    kOpenEdge,    ///< an edge that is not used equally often each way
    kFoldedEdge,  ///< faces around an edge lie on each other, or do not alternate
    kTwoSided,    ///< a two-sided face
    kOffGrid,     ///< a vertex off the input grid
    kCrossing,    ///< it crosses or touches itself, or another closed piece
    kWrongWay,    ///< turned the wrong way for where it lies: a solid in a solid, or a hollow in the air
    kTooComplex,  ///< closed, but too much lies too close around it to find out about crossings and nesting in time
};

/// A piece of a level's surface, joined by edges, that is castable only, and what shows why.
struct SolidNote {
    SolidNoteKind what = SolidNoteKind::kOpenEdge;
    std::size_t faces = 0;     ///< in the piece, as the level has them
    std::uint32_t source = 0;  ///< index in the file of a face that shows it
    std::uint32_t other = 0;   ///< kCrossing: of the face that it crosses or touches
    Vec3 at;                   ///< metres: a corner of that face; for edges, where it starts
    Vec3 to;                   ///< where the edge ends, for edges; else as `at`
};

struct LevelSolidity {
    std::size_t solid_faces = 0;   ///< of Level::faces
    bool rock_outside = false;     ///< what no face separates from infinity is solid
    std::vector<SolidNote> notes;  ///< one for each piece that is castable only
};

/// What of a level make_world() can make carvable, and why not the rest. Closed pieces can, exactly as snapped: each
/// edge used equally often each way, no crossing, no contact but for common edges and vertices, one-sided faces.
/// @param level  one that make_world() refuses has no solid face and no note
/// Grows with the faces, and with the pairs of them whose boxes meet, up to a limit of so many a face: what would take
/// more is kTooComplex.
[[nodiscard]] FIRMA_EXPORT LevelSolidity level_solidity(const Level& level);

/// A region that resists cutters.
struct CarveZone {
    std::string name;  ///< for messages
    Box box;           ///< metres, closed; widened to the input grid
    /// 1: nothing is changed in it, the cutter is cut short at its box. Below: a cutter whose middle lies in it is
    /// shrunk to (1 - hardness) of its scale, by the hardest such zone. 0 does nothing.
    double hardness = 1;
};

/// Carried by the World. An edit that breaks a rule is refused and says which; the world stays as it was.
struct CarveRules {
    std::vector<CarveZone> zones;
    /// By material (index as in World::material_name); missing ones are 0. In a world of pieces (count_matters()): a
    /// piece of which any side has a material of 1 may not be carved, the cutter is cut short at it; below 1, the
    /// material of most of its sides is as hard as said here, whatever its matter's Matter::hardness. In others, and
    /// for solids: a cut that takes something of a face of 1 is refused, and the face nearest to the cutter's middle
    /// says how far it is shrunk.
    std::vector<double> hardness;

    std::size_t max_faces = std::size_t(1) << 30;  ///< in the world after an edit
    std::size_t max_candidate_faces = 4'000'000;   ///< exact faces that one edit may meet
    std::size_t max_new_faces = 4'000'000;         ///< facets that one edit may make
    std::size_t max_cutter_triangles = 1'000'000;  ///< of one cutter
    /// Of two triangles of the cutter, or of one and a face of the world, tested by one edit: to judge the cutter, to
    /// cut, and to cut again where the cutter touches. Going through all corners of a face counts once for every 64.
    std::size_t max_pairs = 20'000'000;
    std::size_t max_corners = 20'000;  ///< of one new face; dividing it into facets takes their square
    double max_cutter_size = 16384;    ///< metres along any axis, once placed

    /// Rooms become one where open portals that carvings made between them are larger than this share of the walls of
    /// the room that has less of them; never where a closed portal lies between them. 0: rooms stay apart. Above, an
    /// edit that makes a portal also costs the faces of the rooms that it leads to. Has no effect on solids alone.
    double merge_share = 0;

    /// Of a world: whether a carving also takes, of faces that bound no solid (sheets, decals, clips, glass), what lies
    /// in the cutter, of clips what stands straight over the hole in a wall, and what lies in a piece that comes loose
    /// or is held by it alone. Liquids stay, and what else stops neither walkers nor shots nor sight. Off: all of them
    /// stay.
    bool open_faces = true;
};

enum class CarveKind : std::uint8_t { kCarve, kFill };

enum class CarveStatus : std::uint8_t {
    kDone,
    kNothing,  ///< the cutter met nothing to take away (or, filling, nothing to fill): all is as it was.
               ///< CarveReport::faces_castable_only says whether it met faces that the edit does not change
    kRefused,  ///< `error` says why; all is as it was
};

/// What an edit did, and what it cost.
struct CarveReport {
    std::size_t candidate_faces = 0;  ///< exact faces near the cutter: in its box, without what is clear of it
    std::size_t faces_cut = 0;        ///< of these, how many the cutter's surface crosses
    std::size_t faces_removed = 0;    ///< facets that casts met before and meet no more
    std::size_t faces_added = 0;      ///< facets that casts meet from now on
    /// That reach into the cutter and are left as they are: liquids, what may not be carved, all others that bound no
    /// solid where CarveRules::open_faces says so, and by fills.
    std::size_t faces_castable_only = 0;
    // Of a world, of faces that bound no solid (`faces_removed` and `faces_added` count these, too):
    std::size_t open_trimmed = 0;  ///< of which the cutter, or a piece that came loose, took a part
    std::size_t open_removed = 0;  ///< that went whole, those of panes too
    std::size_t panes = 0;         ///< panes that went whole, each with all its faces
    std::size_t clips = 0;         ///< of those trimmed and removed: that stop walkers alone, or shots alone
    std::size_t portals = 0;       ///< of a world: that it made
    std::size_t rooms = 0;         ///< likewise
    int retries = 0;               ///< always 0, as no cutter is moved
    double scale = 1;              ///< what zones and matters left of the cutter's scale
    std::size_t cut_short = 0;     ///< zones and pieces that may not be carved, and took part of the cutter
    double volume = 0;             ///< cubic metres taken from the solid; negative when it was added to

    // Of pieces that came loose, where they were looked for (CarveOptions::chunks): beside `volume`.
    std::size_t chunks = 0;          ///< that are in CarveResult::chunks
    double chunk_volume = 0;         ///< cubic metres of these
    std::size_t crumbs = 0;          ///< too small for that: removed, too
    double crumb_volume = 0;         ///< cubic metres of these
    std::size_t faces_searched = 0;  ///< exact faces read beyond the candidates, to find out what is loose

    /// Where the time went, microseconds.
    struct Times {
        double place = 0;   ///< cutter turned, snapped, checked
        double gather = 0;  ///< faces taken out of the tree
        double cut = 0;     ///< faces against triangles
        double label = 0;   ///< inside and outside
        double trace = 0;   ///< loops of new faces
        double facets = 0;  ///< what casts meet
        double chunks = 0;  ///< looking for loose pieces, and making solids of them
        double tree = 0;    ///< new blocks
        FIRMA_INLINE double total() const { return place + gather + cut + label + trace + facets + chunks + tree; }
    } times;
};

/// What became of a solid.
struct [[nodiscard]] SolidResult {
    CarveStatus status = CarveStatus::kRefused;
    Solid solid;         ///< after the edit; the one before unless kDone
    Error error;         ///< for kRefused
    CarveReport report;  ///< as of a world
    std::string
        reproduction;  ///< for a refusal that should not be possible: an .obj with what it takes to see it again

    bool done() const { return status == CarveStatus::kDone; }
};

struct SolidCutOptions {
    std::uint32_t material = 0;         ///< of the faces that the cutter leaves
    const CarveRules* rules = nullptr;  ///< null: none
};

/// A cutter that is a solid, one that cuts have made too; its mesh is that of its facets, see Solid::face_count().
///
/// Placed at scale 1 by one of the 24 turns of the axes, to within 2^-40, it cuts exactly: its position is snapped to
/// the input grid, and all its planes and vertices are turned and moved with it. At any other pose it is the solid that
/// its facets bound once each corner is turned, scaled and snapped to the input grid; triangles that lose their area
/// there are left out, and where what is left crosses or touches itself beyond its edges and vertices it is refused,
/// with the place. Faces that it leaves in a solid name as their source the number of its face, in order of ids.
///
/// @param name  for messages
/// @return the cutter; kInvalid for a solid of no face or with rock outside; kTooLarge beyond kMaxCutterTriangles
/// Costs its facets, which are copied; cuts cost what those of a mesh that touches cost, and a copy of its faces.
[[nodiscard]] FIRMA_EXPORT Result<Cutter> cutter_from_solid(const Solid& solid, std::string name = "");

/// Takes a placed cutter away from a solid, by the rules of carve(): the faces of the result are those that a world
/// around the solid would have.
/// Costs what carve() costs, less what that does to rooms: it grows with the cutter's triangles and with the faces near
/// them, not with the solid.
[[nodiscard]] FIRMA_EXPORT SolidResult subtract(const Solid& solid, const Cutter& cutter, const Pose& pose,
                                                const SolidCutOptions& options = {});

/// Adds a placed cutter to a solid, by the same rules and at the same cost.
[[nodiscard]] FIRMA_EXPORT SolidResult unite(const Solid& solid, const Cutter& cutter, const Pose& pose,
                                             const SolidCutOptions& options = {});

}  // namespace firma
