// SPDX-License-Identifier: MIT
// Clips that stand on walls: what of them stands straight over a hole that a cut makes in such a wall.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/flat_map.h"
#include "carve/cutter_solid.h"
#include "carve/trim_polygons.h"
#include "carve/wall_hole.h"
#include "carve/wall_section.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "solid/change_solid.h"
#include "solid/face_store.h"

namespace firma {

/// Stops walkers or shots alone, and nothing else: a brush that is there for that.
inline bool is_clip(const FaceRecord& record) {
    const std::uint32_t stops = record.mask & kStopsSolid;
    return stops == kStopsWalk || stops == kStopsShots;
}

/// Takes away what of the clips that stand on one wall lies in it.
struct ClipColumn {
    std::uint32_t wall = 0;
    Cutter cutter;
};

/// Faces do not say which brush they are of. A clip is told by its shape: clip faces that hang together by corners,
/// each behind the planes of all others. It stands on a wall where an edge of it lies on a face of the solid, in the
/// wall's plane, and part of it in front. Which side of a plane a corner lies on is judged in double, to some surface
/// steps.
///
/// Works in pieces of some ten microseconds, but that finding walls, and each wall's clips and hole, is one. Costs the
/// clip faces within kReach of the cutter, where there are any also the facets that the cut takes, and for each plane
/// of these that a clip stands on the cutter's triangles.
class ClipColumns {
public:
    /// Metres: a clip is found where its far side is at most so far from the cutter's box.
    static constexpr double kReach = 8;
    /// Of the faces of a clip that lie farther, so many are known.
    static constexpr std::size_t kMostFar = 64;

    /// What is given is kept alive by the caller.
    /// @param open    the faces that are castable only
    /// @param solid   the solid's faces, before the cut
    /// @param change  what the cut makes of them
    /// @param may_go  all others are part of no clip
    ClipColumns(const FaceStore& open, const FaceStore& solid, const CarveRules& rules, const SolidChange& change,
                const CutterSolid& cutter, std::function<bool(const FaceRecord&)> may_go);

    /// Does one piece of work.
    PolygonTrimmer::End step();

    // Once it is done:
    /// In an order that is the same everywhere.
    const std::vector<ClipColumn>& columns() const { return columns_; }
    /// Whether a face is part of a clip on a wall, and may go: what reaches into a zone that may not be carved stays.
    bool stands_on(std::uint32_t wall, std::uint32_t face) const {
        return walls_[wall].clips.find(face) != FlatMap::kNone;
    }
    /// Whether some of a facet may stand straight over the hole in a wall.
    bool may_be_over(std::uint32_t wall, const FacetPlace& facet) const;

private:
    enum class Phase : std::uint8_t { kClips, kWalls, kNextWall, kEnd };

    /// Facets that the cut takes, in one plane.
    struct Wall {
        WallPlane plane;
        std::vector<FacetPlace> facets;
        FlatMap clips;      ///< ids of faces
        double height = 0;  ///< metres, of the highest of these
        WallHole hole;
    };
    /// Of the clip at hand: a plane that it lies behind.
    struct ClipPlane {
        Vec3 normal, at;
        double width = 0;  ///< of the face that it is of: how well it is known
        bool valid() const;
        double height(const Vec3& p) const { return dot(normal, p - at); }
        double slack(const Vec3& p) const;
    };

    /// Faces that hang together, and the corners of all.
    struct Clip {
        std::vector<FacetPlace> faces;
        std::vector<Vec3> corners;
    };

    void find_clips();
    void find_walls();
    void find_columns(std::uint32_t number);
    void find_clips_on(Wall& wall, std::span<const FacetPlace> over);
    bool takes_of(const WallHole& hole, const Wall& wall);
    ClipPlane plane_of(const FacetPlace& facet);
    const Clip& clip_from(const FacetPlace& seed);
    void grow(const FacetPlace& seed, Clip& clip);
    bool take_in(const FacetPlace& facet, Clip& clip);
    double height_over(const Clip& clip, const WallPlane& wall);
    bool touches(const FacetPlace& facet, const WallPlane& wall);
    bool touches(const GridPoint& from, const GridPoint& to, const WallPlane& wall);
    bool may_lose(const FacetPlace& facet) const;

    const FaceStore &open_, &solid_;
    const CarveRules& rules_;
    const SolidChange& change_;
    const CutterSolid& cutter_;
    const GridBox near_box_;
    const std::function<bool(const FaceRecord&)> may_go_;
    Phase phase_ = Phase::kClips;
    std::vector<FacetPlace> near_;  ///< clip faces that may be part of what a hole takes
    std::vector<Wall> walls_;
    std::uint32_t next_wall_ = 0;
    std::vector<ClipColumn> columns_;
    std::vector<Clip> clips_;
    FlatMap clip_from_;  ///< by the face that one grew from: its number in clips_

    std::vector<FacetPlace> beside_;
    // Of the clip that grows.
    FlatMap in_clip_;
    std::vector<ClipPlane> planes_;
    std::vector<Vec3> loop_;
};

}  // namespace firma
