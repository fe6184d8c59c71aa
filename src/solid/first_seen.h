// SPDX-License-Identifier: MIT
// Where a point lies: in the air or in the solid, by what a ray from it meets first. For any point in metres, and for
// faces in blocks; what a line meets one after the other, from end to end, RoomFinder asks.
#pragma once

#include <cstdint>

#include "cast/contact.h"
#include "geometry/polygon_shape.h"
#include "index/sweep_box.h"
#include "solid/block.h"

namespace firma {

/// What a ray saw first.
struct Seen {
    enum class Kind : std::uint8_t {
        kUnsure,   ///< no ray tells: the point lies in a fold of the surface, or is no usable number
        kSurface,  ///< on a face, exactly
        kAir,      ///< air in front of a face of `part`
        kSolid,    ///< behind a face
        kPolygon,  ///< `number` of SeePolygons, whose front it sees, or its back
        kNothing,  ///< nothing, as far as infinity
    };
    Kind kind = Kind::kUnsure;
    std::uint32_t part = 0;
    std::uint32_t number = 0;
    bool front = false;
};

class FirstSeen;

/// Polygons beside the faces that a ray may meet, either side.
class SeePolygons {
public:
    virtual ~SeePolygons() = default;
    /// Calls `ray.look_at()` for all that it may meet.
    virtual void look(FirstSeen& ray) const = 0;
};

/// A ray, and the first thing it met so far.
class FirstSeen {
public:
    explicit FirstSeen(const Sweep& sweep);

    bool enter(const BoxF& box, double& nearest) const { return boxes_.enters(box, latest_, nearest); }
    template <class AnyBox>
    bool enter(const AnyBox& box) const {
        double nearest;
        return boxes_.enters(box, latest_, nearest);
    }
    bool still(double nearest) const { return nearest <= latest_; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count);

    /// At one time faces count before polygons, and of polygons the lowest number. All of one number are told in turn.
    void look_at(const PolygonShape& polygon, std::uint32_t number);

    /// What to make of it; kUnsure where another ray should be asked.
    Seen judge() const;

private:
    void keep(const Contact& contact);

    const Sweep& sweep_;
    const SweepBox boxes_;
    const double window_;  ///< after the first face: others that rounding may have put behind it
    double latest_;
    double first_side_[2];  ///< when a face was met first from its front, and from behind
    double first_polygon_;  ///< when a polygon was
    Contact best_;
    const Block* block_ = nullptr;  ///< null: a polygon, where anything was met
    std::uint32_t slot_ = 0;
    std::uint32_t number_ = 0;
    const PolygonShape* polygon_ = nullptr;
};

/// Looks along rays in ways that hardly graze anything.
/// @param root      of an index over faces of a solid; null for none
/// @param polygons  null for none
/// A point on a polygon is in front of it. Never allocates. Costs a cast or two.
Seen see_first(const Node* root, const Vec3& point, const SeePolygons* polygons = nullptr);

}  // namespace firma
