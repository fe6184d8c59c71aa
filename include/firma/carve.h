// SPDX-License-Identifier: MIT
// Carving: a closed cutter taken away from the world's solid, or added to it, exactly; the world before stays as it
// was.
#pragma once

#include <memory>
#include <string>

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

    bool done() const { return status == CarveStatus::kDone; }
};

struct CarveOptions {
    /// Of the faces that the cutter leaves; a name the world does not know yet is added to its materials. Where it is
    /// empty, faces that a crater leaves have the inside of what it cut (Matter::inside), split where matters meet.
    std::string material;
};

/// Takes a placed cutter away from the solid of a world.
///
/// What is cut are the faces that bound closed solids (Face::solid); others are left as they are. The result is the
/// closure of the interior of the solid without the cutter, exactly, also of a cutter that touches what it cuts (a
/// vertex on a face, edges that meet, faces in one plane): nothing is moved. It depends on world, cutter, pose and
/// options alone, to the bit. The same cut again is kNothing.
///
/// @param pose  where the cutter goes; its rotation and scale
/// @return kDone with the new world; kNothing; or kRefused with the reason: a cutter or pose that cannot be placed (not
///         finite, outside the world, collapsed on the grid, crossing itself), a rule of the world, more
///         than 2^21 planes where the cutter touches, a part of it of which no line tells on which side it lies, no
///         numbers left (for 2^32 edits, 2^64 versions, 2^32 ids of faces), or a contradiction (then `reproduction`
///         holds it).
/// The cost grows with the cutter's triangles and with the faces near them (CarveReport::candidate_faces), and with the
/// logarithm of the world's faces. A cutter that touches is cut up to twice, the second time by an arrangement. Where
/// rooms are joined it also grows with these rooms' portals. CarveOptions::material is searched among the world's
/// materials by name, and a new one copies their list. Takes memory for what is made anew; all else is shared.
/// CarveRules bounds the cost, CarveReport::times tells it.
/// Source: shared vertices by planes as in M. Nehring-Wirxel, P. Trettner, L. Kobbelt, Fast Exact Booleans for Iterated
/// CSG using Octree-Embedded BSPs, 2021.
FIRMA_EXPORT CarveResult carve(const World& world, const Cutter& cutter, const Pose& pose,
                               const CarveOptions& options = {});

/// Adds a placed cutter to the solid, by the same rules and at the same cost. Among rooms, one that touches no face is
/// also located, corner by corner until one is found in the air (locate()).
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
