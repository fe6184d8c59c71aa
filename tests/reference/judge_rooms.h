// SPDX-License-Identifier: MIT
// Judges the rooms of a world by ways other than the library's: edges that cancel around each room, solid angles that
// say which room's boundary surrounds a point, ways through portals.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "firma/rooms.h"
#include "firma/world.h"
#include "solid/solid_patch.h"

namespace firma::reference {

/// All that a Hit says of what was met, and where.
bool same_hit(const Hit& a, const Hit& b);

/// The first directed edge of a room's solid facets and portals, as seen from it, that is not used as often the other
/// way; empty when around every room all are.
std::string unclosed_room(const World& world);

/// By room: whether no way leads from it to the exterior, all doors open. In a world of one room, whether it is
/// surrounded by rock.
std::vector<bool> closed_rooms(const World& world);

/// What bounds each room, gathered once for many points.
class RoomBounds {
public:
    explicit RoomBounds(const World& world);

    /// Where the solid angles of all facets and portals put a point, and whether locate() says so too. In double, for
    /// points well clear of all faces. A room whose box the point is not in is left out: what is closed
    /// (unclosed_room()) winds around nothing there.
    /// @param found  where that is, when given
    /// @return what is wrong: in two rooms at once, or not where locate() has it; else empty
    std::string judge(const Vec3& point, Location* found = nullptr) const;

private:
    struct Bounds {
        std::vector<FacetPlace> facets;
        std::vector<std::vector<Vec3>> portals;  ///< fronts look into the room
        Box box;                                 ///< around both
        bool exterior = false;
    };
    const World& world_;
    std::vector<Bounds> rooms_;
};

/// A straight way through the air ends in the room that asking directly names, and none ends in the solid.
/// @return what is wrong; empty also where a face is in the way
std::string judge_way(const World& world, const Vec3& from, const Vec3& to);

/// A cast from a start in the air, clear of all faces, is the same by room as against all faces.
/// @param rooms_passed  how many the cast by room went through; 0 when the start is none to be judged
/// @return what is wrong
std::string judge_cast_by_room(const World& world, const Sphere& sphere, const Vec3& path, std::uint32_t& rooms_passed);

}  // namespace firma::reference
