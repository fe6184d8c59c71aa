// SPDX-License-Identifier: MIT
// Cells: a partition of the air into rooms, and the portals between them, in persistent pieces. A change copies what it
// changes, however many rooms and portals there are. Rooms and portals name each other by number, never by pointer, and
// know no faces: room_faces.h.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/persistent_map.h"
#include "base/pool.h"
#include "base/ref.h"
#include "firma/hit.h"
#include "firma/level.h"
#include "geometry/grid_box.h"
#include "geometry/polygon_shape.h"
#include "index/box_tree.h"
#include "solid/solid_face.h"
#include "world/portal_index.h"

namespace firma {

/// A volume of air.
struct RoomRecord {
    std::string name;
    bool exterior = false;              ///< it reaches to infinity
    std::uint32_t merged_into = 0;      ///< itself; of a room that an edit made part of another: that one
    std::vector<PortalId> portals;      ///< that lead out of it, ascending; without those that are gone
    std::vector<GridBox> portal_boxes;  ///< of each; none at all where `portal_index` is set
    GridBox portal_box;                 ///< around these: Cells::box_of()
    Ref<const Node> portal_index;       ///< over them, where they are a crowd; else null
};

/// A portal on its way into a world: where the air of one room passes into that of another.
struct PortalPart {
    std::array<RoomId, 2> rooms;
    /// Convex, exactly planar, disjoint but for edges, on the surface grid, of 3 to 64 corners each, counter-clockwise
    /// seen from rooms[0]: normals point into it. None at all: a portal that is gone, whose id stays.
    std::vector<std::vector<GridPoint>> polygons;
    /// The exact face that each polygon is a facet of, those of one face in a row; null for one that is its own, with
    /// corners on the input grid. Empty: all are.
    std::vector<Ref<const SolidFace>> exact;
    std::string name;
    std::uint32_t material = 0;
    std::uint32_t mask = kStopsSolid;  ///< what it stops while closed (firma/level.h)
    bool open = true;
    bool made = false;  ///< by an edit
};

/// A polygon of a portal: a face in the sense of casts.
struct PortalPolygon {
    PolygonShape shape;
    std::span<const GridPoint> corners;
    struct {
        double low[3], high[3];
    } box;  ///< metres
};

/// Nothing in it changes; whether it is closed is kept apart, and what its rooms became part of: Cells::rooms_of().
class Portal : public RefCounted, public Pooled {
public:
    explicit Portal(PortalPart part);

    const std::array<RoomId, 2> made_between;
    const std::string name;
    const std::uint32_t material, mask;
    const bool made;  ///< by an edit
    GridBox box;      ///< of its polygons

    /// Those with area.
    std::span<const PortalPolygon> polygons() const { return polygons_; }
    /// Also those that rounding left without, of folded faces; as they were given.
    std::span<const PortalPolygon> all_polygons() const { return all_.empty() ? polygons_ : all_; }
    /// Of one of all_polygons(): the face that it is a facet of; null for one that is its own.
    const SolidFace* exact(std::size_t polygon) const { return exact_.empty() ? nullptr : exact_[polygon].get(); }
    /// Whether all of its polygons have an exact form, as those of files of before may not.
    bool is_exact() const { return is_exact_; }
    bool gone() const { return all_polygons().empty(); }
    /// As it was made, but that it says nothing of being open.
    PortalPart part() const;
    std::size_t bytes() const;

private:
    void leave_out_those_without_area();

    std::vector<PortalPolygon> polygons_;
    std::vector<PortalPolygon> all_;  ///< empty where each has area
    std::vector<Ref<const SolidFace>> exact_;
    bool is_exact_ = true;
    std::vector<GridPoint> corners_;
    std::vector<Vec3> metres_;  ///< the same corners
};

struct PortalState {
    Ref<const Portal> portal;
    bool closed = false;
    Ref<const Node> leaf;  ///< of the index over portals; null for one that is gone
};

/// A value: copies share everything.
class Cells {
public:
    /// So many portals of a room are gone through one by one; more have an index.
    static constexpr std::size_t kListed = 16;
    /// Portals of rooms that have more are hashed without the room's number.
    static constexpr std::size_t kCrowd = 64;

    std::uint32_t room_count() const { return std::uint32_t(rooms_.size()); }
    const RoomRecord& room(std::uint32_t number) const { return *rooms_[number]; }
    const std::shared_ptr<const RoomRecord>& record(std::uint32_t room) const { return rooms_[room]; }
    std::uint32_t portal_count() const { return std::uint32_t(portals_.size()); }
    const Portal& portal(std::uint32_t number) const { return *portals_[number].portal; }
    bool is_closed(std::uint32_t portal) const { return portals_[portal].closed; }
    bool any_closed() const { return closed_ > 0; }
    std::span<const PortalId> portals_of(std::uint32_t room) const { return rooms_[room]->portals; }
    /// Calls `function(portal)` for the portals of a room whose boxes meet one, and perhaps for others near it; in no
    /// order that means anything, until it returns true.
    template <class Function>
    void for_each_portal_of(std::uint32_t room, const GridBox& box, const Function& function) const {
        const RoomRecord& record = *rooms_[room];
        if (record.portal_index) {
            for_each_portal_meeting(*record.portal_index, box, function);
            return;
        }
        for (std::size_t k = 0; k < record.portals.size(); ++k)
            if (boxes_meet(record.portal_boxes[k], box) && function(record.portals[k].value)) return;
    }
    /// A record's boxes and index, once its portals are set and indexed.
    void set_portal_boxes(RoomRecord& record) const;
    /// The same after an edit: an index is changed, not made anew.
    /// @param before   the cells before it
    /// @param room     the record's, of before; of several that became one, one of them
    /// @param changed  portals that were added, changed or removed, and those of the others; each once
    void set_portal_boxes(RoomRecord& record, const Cells& before, std::uint32_t room,
                          std::span<const PortalId> changed) const;
    /// Around portals.
    GridBox box_of(std::span<const PortalId> portals) const {
        GridBox box;
        for (const PortalId portal : portals) box.add(this->portal(portal.value).box);
        return box;
    }
    /// The room that a room is by now part of: itself, as long as no edit joined it to another. In as many steps as the
    /// logarithm of the rooms joined.
    std::uint32_t current_room(std::uint32_t room) const { return joined_.empty() ? room : joined_room(room); }
    /// The rooms that a portal joins by now; of one that is gone those that it was given last.
    std::array<RoomId, 2> rooms_of(const Portal& portal) const {
        if (joined_.empty() || portal.gone()) return portal.made_between;
        return {RoomId{current_room(portal.made_between[0].value)}, RoomId{current_room(portal.made_between[1].value)}};
    }
    /// The room on the other side of a portal.
    std::uint32_t beyond(const Portal& portal, std::uint32_t room) const {
        const std::uint32_t first = current_room(portal.made_between[0].value);
        return first == room ? current_room(portal.made_between[1].value) : first;
    }
    /// The room that reaches to infinity, by now; nothing where rock does.
    std::optional<std::uint32_t> exterior() const {
        return exterior_ ? std::optional(current_room(*exterior_)) : std::nullopt;
    }
    /// Whether the level says anything of rooms: false for one room, and nothing to say of it.
    bool known() const { return known_; }
    /// A sum over portals of all that they are.
    std::uint64_t hash() const { return hash_; }

    /// Calls `function(number, portal)` for the portals whose boxes meet, and perhaps for others; in no order that
    /// means anything. Not for those that are gone.
    template <class Meets, class Function>
    void for_each_portal_where(const Meets& meets, const Function& function) const {
        if (!portal_index_) return;
        for_each_indexed_portal(*portal_index_, meets, [&](std::uint32_t number) {
            if (meets(portal(number).box)) function(number, portal(number));
            return false;
        });
    }

    void set_known() { known_ = true; }
    /// Of a world: WorldData::set_room(), which keeps the sum over rooms.
    void set_room(std::uint32_t number, std::shared_ptr<const RoomRecord> record);
    /// A new portal, or another in its place. Its term of the hash is exchanged; it is not indexed yet.
    void set_portal(std::uint32_t number, Ref<const Portal> portal, bool closed);
    /// Its term of the hash stays out: between take_out() and put_in().
    void set_portal_between(std::uint32_t number, Ref<const Portal> portal, bool closed);
    /// Portals that were set since: takes what they were out of the index, and puts them in as they are.
    void index_portals(std::span<const PortalId> portals);
    /// A portal's term of hash(). It names the portal's rooms, but for those of more than kCrowd portals: so that
    /// joining such a room to another changes few terms. Which they are follows from where the portal lies.
    std::uint64_t hash_of_portal(std::uint32_t number) const;
    /// Around set_room() where numbers or lists of portals change: takes terms out, and puts them in as they are then.
    void take_out(std::span<const PortalId> portals);
    void put_in(std::span<const PortalId> portals);

    const PersistentMap<std::shared_ptr<const RoomRecord>>& rooms() const { return rooms_; }
    const PersistentMap<PortalState>& portals() const { return portals_; }
    const PersistentMap<std::uint64_t>& joined() const { return joined_; }
    const Ref<const Node>& portal_index() const { return portal_index_; }

private:
    static constexpr std::uint64_t kRoot = std::uint64_t(1) << 63;

    std::uint32_t joined_room(std::uint32_t room) const;
    std::uint64_t find_root(std::uint32_t& room) const;
    void join(std::uint32_t room, std::uint32_t into);

    PersistentMap<std::shared_ptr<const RoomRecord>> rooms_;
    PersistentMap<PortalState> portals_;
    /// Disjoint sets of rooms joined: the next one on the way to the root; of a root kRoot, its rank times 2^32, and
    /// which room they are now. Without rooms that were never joined.
    /// Source: R. Tarjan, Efficiency of a good but not linear set union algorithm, 1975: union by rank.
    PersistentMap<std::uint64_t> joined_;
    Ref<const Node> portal_index_;           ///< over those that are not gone; null for none
    std::optional<std::uint32_t> exterior_;  ///< as it was when it was set
    std::size_t closed_ = 0;
    std::uint64_t hash_ = 0;
    bool known_ = false;
};

/// Memory of a record, its name and list with it.
std::size_t bytes_of(const RoomRecord& record);

}  // namespace firma
