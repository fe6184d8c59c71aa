// SPDX-License-Identifier: MIT
// Cells: a partition of the air into rooms, and the portals between them, in persistent pieces. A change copies what it
// changes, however many rooms and portals there are. Rooms and portals name each other by number, never by pointer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/persistent_map.h"
#include "base/pool.h"
#include "base/ref.h"
#include "firma/hit.h"
#include "firma/masks.h"
#include "geometry/grid_box.h"
#include "geometry/polygon_shape.h"
#include "index/box_tree.h"
#include "index/node.h"

namespace firma {

/// What a room is besides its faces.
struct RoomRecord {
    std::string name;
    bool exterior = false;               ///< it reaches to infinity
    std::uint32_t merged_into = 0;       ///< itself; of a room that an edit made part of another: that one
    std::vector<std::uint32_t> portals;  ///< that lead out of it, ascending; without those that are gone
};

/// A volume of air.
struct Room : RefCounted, Pooled {
    std::shared_ptr<const RoomRecord> record;  ///< never null
    Ref<const Node> tree;                      ///< over its faces, of the solid and castable only; null for none
    std::size_t faces = 0;
    std::uint64_t face_hash = 0;  ///< sum of hash_facet()
};

/// A portal on its way into a world: where the air of one room passes into that of another.
struct PortalPart {
    std::array<RoomId, 2> rooms;
    /// Convex, exactly planar, disjoint but for edges, on the surface grid, of 3 to 64 corners each, counter-clockwise
    /// seen from rooms[0]: normals point into it. None at all: a portal that is gone, whose id stays.
    std::vector<std::vector<GridPoint>> polygons;
    std::string name;
    std::uint32_t material = 0;
    std::uint32_t mask = kStopsSolid;  ///< what it stops while closed (masks.h)
    bool open = true;
};

/// A polygon of a portal: a face in the sense of casts.
struct PortalPolygon {
    PolygonShape shape;
    std::span<const GridPoint> corners;
    struct {
        double low[3], high[3];
    } box;  ///< metres
};

/// Nothing in it changes; whether it is closed is kept apart.
class Portal : public RefCounted, public Pooled {
public:
    explicit Portal(PortalPart part);

    const std::array<RoomId, 2> rooms;
    const std::string name;
    const std::uint32_t material, mask;
    GridBox box;  ///< of its polygons

    std::span<const PortalPolygon> polygons() const { return polygons_; }
    bool gone() const { return polygons_.empty(); }
    /// The room on the other side.
    RoomId beyond(RoomId room) const { return rooms[0] == room ? rooms[1] : rooms[0]; }
    /// As it was made, but that it says nothing of being open.
    PortalPart part() const;
    std::size_t bytes() const;

private:
    std::vector<PortalPolygon> polygons_;
    std::vector<GridPoint> corners_;
    std::vector<Vec3> metres_;  ///< the same corners
};

struct PortalState {
    Ref<const Portal> portal;
    bool closed = false;
};

/// Where portals are, for rays and points: around those that there were at first. Portals that went are still in it.
struct PortalBoxes {
    BoxTree tree;
    std::vector<std::uint32_t> portals;  ///< by number in the tree
};

/// A value: copies share everything.
class Cells {
public:
    std::uint32_t room_count() const { return std::uint32_t(rooms_.size()); }
    const Room& room(std::uint32_t number) const { return *rooms_[number]; }
    std::uint32_t portal_count() const { return std::uint32_t(portals_.size()); }
    const Portal& portal(std::uint32_t number) const { return *portals_[number].portal; }
    bool is_closed(std::uint32_t portal) const { return portals_[portal].closed; }
    bool any_closed() const { return closed_ > 0; }
    std::span<const std::uint32_t> portals_of(std::uint32_t room) const { return rooms_[room]->record->portals; }
    /// The room that a room is by now part of: itself, as long as no edit joined it to another.
    std::uint32_t current_room(std::uint32_t room) const {
        for (std::uint32_t into; (into = rooms_[room]->record->merged_into) != room;) room = into;
        return room;
    }
    /// Whether the level says anything of rooms: false for one room, and nothing to say of it.
    bool known() const { return known_; }
    /// A sum over rooms and portals of all that they are, faces included.
    std::uint64_t hash() const { return hash_; }

    /// Calls `function(number, portal)` for the portals whose boxes meet, and perhaps for others; in no order that
    /// means anything. Not for those that are gone.
    template <class Meets, class Function>
    void for_each_portal_where(const Meets& meets, const Function& function) const {
        if (!boxes_) return;
        boxes_->tree.for_each_where(meets, [&](std::uint32_t at) {
            const std::uint32_t number = boxes_->portals[at];
            if (!portal(number).gone()) function(number, portal(number));
            return false;
        });
    }

    void set_known() { known_ = true; }
    void set_room(std::uint32_t number, Ref<const Room> room);
    void set_portal(std::uint32_t number, Ref<const Portal> portal, bool closed);
    /// Once all portals of a level are in.
    void set_boxes();

    const PersistentMap<Ref<const Room>>& rooms() const { return rooms_; }
    const PersistentMap<PortalState>& portals() const { return portals_; }
    const std::shared_ptr<const PortalBoxes>& boxes() const { return boxes_; }

private:
    PersistentMap<Ref<const Room>> rooms_;
    PersistentMap<PortalState> portals_;
    std::shared_ptr<const PortalBoxes> boxes_;
    std::size_t closed_ = 0;
    std::uint64_t hash_ = 0;
    bool known_ = false;
};

/// All that a room is, or a portal: a term of Cells::hash().
std::uint64_t hash_room(std::uint32_t number, const Room& room);
std::uint64_t hash_portal(std::uint32_t number, const PortalState& state);

/// Memory of a record, its name and list with it.
std::size_t bytes_of(const RoomRecord& record);

}  // namespace firma
