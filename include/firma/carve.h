// SPDX-License-Identifier: MIT
// Carving: a closed cutter taken away from the world's solid, or added to it, exactly; the world before stays as it
// was.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firma/chunk.h"
#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/world.h"

namespace firma {

struct [[nodiscard]] CarveResult {
    CarveStatus status = CarveStatus::kRefused;
    World world;  ///< after the edit; the one before unless kDone
    Error error;  ///< for kRefused
    CarveReport report;
    /// For a refusal that should not be possible (cuts or labels that contradict each other): what it takes to see it
    /// again, an .obj with the candidate faces and the cutter. Empty otherwise.
    std::string reproduction;
    /// What came loose and left the world, where that was asked for: in an order that is the same everywhere.
    std::vector<Chunk> chunks;

    bool done() const { return status == CarveStatus::kDone; }
};

struct CarveOptions {
    /// Of the faces that the cutter leaves; a name the world does not know yet is added to its materials. Where it is
    /// empty, faces that a crater leaves have the inside of what it cut (Matter::inside), split where matters meet.
    std::string material;
    /// Where the shot came from, metres, if that is known: what a carving opens between rooms becomes air of the room
    /// that this lies in, where it touches that.
    std::optional<Vec3> from = std::nullopt;
    /// The number of the edit, for worlds that are to agree on it although they may lack others: 0, the one after the
    /// last; or 1 to kMaxEditNumber, above that of every edit made before. The ids of the faces of an edit that is
    /// given its number follow from it, those of the cutter first: up to 1024 depend on no other edit.
    std::uint32_t edit = 0;
    /// Look for pieces that the cut leaves loose: they leave the world within the same edit, and come back as
    /// CarveResult::chunks. Nothing: leave them hanging. See with_anchors() for what holds a piece. A fill leaves
    /// nothing loose; what it puts down free in the air stays there by intent. Ask for it in all edits of a world, or
    /// in none: a piece that was left hanging is not looked for later.
    std::optional<ChunkOptions> chunks{};
};

/// An edit cannot be given a higher number.
inline constexpr std::uint32_t kMaxEditNumber = (std::uint32_t(1) << 21) - 1;

/// Takes a placed cutter away from the solid of a world.
///
/// What is cut are the faces that bound closed solids (Face::solid); of others CarveRules::open_faces says. The result
/// is the closure of the interior of the solid without the cutter, exactly, also of a cutter that touches what it cuts
/// (a vertex on a face, edges that meet, faces in one plane): nothing is moved. It depends on world, cutter, pose and
/// options alone, to the bit. The same cut again is kNothing.
///
/// @param pose  where the cutter goes; its rotation and scale
/// @return kDone with the new world; kNothing; or kRefused with the reason: a cutter or pose that cannot be placed (not
///         finite, outside the world, collapsed on the grid, crossing itself), a rule of the world, more
///         than 2^21 planes where the cutter touches, a part of it of which no line tells on which side it lies, no
///         numbers left (for 2^32 edits, 2^64 versions, 2^31 ids of faces), a number that an edit before it had, or a
///         contradiction (then `reproduction` holds it).
/// The cost grows with the cutter's triangles and with the faces near them (CarveReport::candidate_faces), and with the
/// logarithm of the world's faces. A cutter that touches is cut up to twice, the second time by an arrangement. Where
/// portals are made it also grows with their rooms' lists of portals. CarveOptions::material is searched among the
/// world's materials by name, and a new one copies their list. Takes memory for what is made anew; all else is shared.
/// CarveRules bounds the cost, CarveReport::times tells it. Looking for loose pieces costs the faces that the cut made
/// and those near it; where these are in several groups, also the faces of the smaller pieces, and of the largest until
/// they are known to hang together (CarveReport::faces_searched). A piece that leaves costs its faces.
/// Source: shared vertices by planes as in M. Nehring-Wirxel, P. Trettner, L. Kobbelt, Fast Exact Booleans for Iterated
/// CSG using Octree-Embedded BSPs, 2021.
FIRMA_EXPORT CarveResult carve(const World& world, const Cutter& cutter, const Pose& pose,
                               const CarveOptions& options = {});

/// Adds a placed cutter to the solid, by the same rules and at the same cost. Portals lose what it fills; one that it
/// fills wholly is removed. Among rooms, one that touches no face is also located, corner by corner until one is found
/// in the air (locate()).
FIRMA_EXPORT CarveResult fill(const World& world, const Cutter& cutter, const Pose& pose,
                              const CarveOptions& options = {});

/// One edit in slices: runs for a while, is resumed or dropped, and ends in the same bits as in one go.
///
/// When memory runs out, run() throws std::bad_alloc, as operator new does, and the job is broken: a piece of work that
/// was begun cannot be begun again. From then on run() does nothing and returns true, finished() is true, and result()
/// is a refusal by kNoMemory with the world before. Start another job.
class CarveJob {
public:
    /// Keeps the world and the cutter, and searches the options' material among the world's; all else is left to run().
    FIRMA_EXPORT CarveJob(World world, Cutter cutter, const Pose& pose, const CarveOptions& options = {},
                          CarveKind kind = CarveKind::kCarve);
    /// Frees what the edit made so far, finished or not.
    FIRMA_EXPORT ~CarveJob();
    /// Leaves a job behind that is finished and refused.
    FIRMA_EXPORT CarveJob(CarveJob&&) noexcept;
    FIRMA_EXPORT CarveJob& operator=(CarveJob&&) noexcept;

    /// Goes on for about this long; always does at least one piece of work. With a cutter of some hundred triangles a
    /// piece takes some ten microseconds, seldom more than a hundred; placing a cutter, judging it, gathering,
    /// labelling and tracing are a piece each, and so take longer for one of many thousand.
    /// @param microseconds  INFINITY: to the end
    /// @return true once it is finished
    FIRMA_EXPORT bool run(double microseconds);
    /// Costs nothing to ask, as broken().
    FIRMA_EXPORT bool finished() const;
    /// Whether an exception left run().
    FIRMA_EXPORT bool broken() const;
    /// What came out. Only once finished() (FIRMA_ASSERT), else a refusal by kInvalid. Costs a copy of the handles and
    /// the report; of a contradiction also of its `reproduction`.
    FIRMA_EXPORT CarveResult result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Several edits that become one new version of the world.
class WorldEdit {
public:
    /// Costs two handles to the world.
    FIRMA_EXPORT explicit WorldEdit(World world);

    /// As the functions of the same names, on the world as edited so far; `world` of the result is that world. Each
    /// costs what it costs alone.
    FIRMA_EXPORT CarveResult carve(const Cutter& cutter, const Pose& pose, const CarveOptions& options = {});
    FIRMA_EXPORT CarveResult fill(const Cutter& cutter, const Pose& pose, const CarveOptions& options = {});

    /// The world after all edits, its version one above the first one's; the first one itself when none was done.
    /// Costs the same for every world and every number of edits.
    [[nodiscard]] FIRMA_EXPORT World finish() const;

private:
    World before_, now_;
};

}  // namespace firma
