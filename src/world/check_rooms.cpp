// SPDX-License-Identifier: MIT
// Rooms and portals, one by one, the slow and sure way.
#include "world/check_rooms.h"

#include <algorithm>
#include <vector>

#include "tree/visit.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A directed edge, its lower end first; whether it leads there.
struct Side {
    GridPoint low, high;
    bool down = false;
    FaceId face;  ///< not valid of a portal

    Side(const GridPoint& from, const GridPoint& to, FaceId of)
        : low(std::min(from, to)), high(std::max(from, to)), down(to < from), face(of) {}
    bool along(const Side& other) const { return low == other.low && high == other.high; }
    friend bool operator<(const Side& a, const Side& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.face < b.face;
    }
};

std::string portal_text(std::size_t portal, const char* what) {
    return "portal " + std::to_string(portal) + " " + what;
}
std::string room_text(std::size_t room, const char* what) {
    return "room " + std::to_string(room) + " " + what;
}

class RoomChecker {
public:
    explicit RoomChecker(const WorldData& data) : data_(data) {}

    std::optional<WorldFault> check() {
        if (!data_.room_records) {
            if (data_.rooms.size() != 1 || data_.portals) report("rooms have no records", {});
        } else {
            check_records(*data_.room_records);
        }
        if (!fault_ && data_.portals) check_portals(*data_.portals);
        if (!fault_ && data_.closed && !data_.portals) report("portals that are not there are closed", {});
        // Without an exact part there is no solid, and nothing closes.
        if (!fault_ && data_.room_records && has_solid())
            for (std::uint32_t room = 0; room < data_.rooms.size() && !fault_; ++room) check_closed(room);
        return fault_;
    }

private:
    void report(std::string what, FaceId face) {
        if (!fault_) fault_ = WorldFault{std::move(what), face};
    }

    void check_records(const std::vector<RoomRecord>& records) {
        if (records.size() != data_.rooms.size()) return report("there are not as many records as rooms", {});
        std::size_t infinite = data_.rock_outside;
        for (std::size_t room = 0; room < records.size(); ++room) {
            infinite += records[room].exterior;
            const std::uint32_t into = records[room].merged_into;
            if (into > room) return report(room_text(room, "is part of a higher one"), {});
            if (into != room && (data_.rooms[room]->tree || records[room].exterior))
                return report(room_text(room, "is part of another, and yet not empty"), {});
        }
        if (infinite > 1) report("more than one room, or rock as well, reaches to infinity", {});
    }

    void check_portals(const PortalSet& portals) {
        if (data_.closed && data_.closed->is_closed.size() != portals.portals().size())
            return report("there are not as many doors as portals", {});
        for (std::size_t k = 0; k < portals.portals().size() && !fault_; ++k) {
            const Portal& portal = portals.portals()[k];
            for (const RoomId room : portal.rooms)
                if (room.value >= data_.rooms.size()) return report(portal_text(k, "leads to no room"), {});
            if (portal.gone()) continue;
            if (portal.rooms[0] == portal.rooms[1]) return report(portal_text(k, "leads from a room to itself"), {});
            for (const RoomId room : portal.rooms)
                if ((*data_.room_records)[room.value].merged_into != room.value)
                    return report(portal_text(k, "leads to a room that is part of another"), {});
            for (const PortalPolygon& polygon : portals.polygons_of(portal))
                if (check_polygon(polygon.shape.corners) != PolygonFault::kNone)
                    return report(portal_text(k, "has a polygon that is not convex and planar, with area"), {});
        }
    }

    bool has_solid() const {
        bool any = false;
        for (const Ref<const Room>& room : data_.rooms)
            if (room->tree)
                for_each_face_block(*room->tree, [&](const Block& block) {
                    for (const FaceRecord& face : block.faces) any |= face.solid;
                });
        return any;
    }

    void add_sides(const Block& block, const FaceRecord& face) {
        for (std::size_t k = 0; k < face.corner_count; ++k)
            sides_.emplace_back(block.corner(face, k), block.corner(face, k + 1u < face.corner_count ? k + 1 : 0),
                                face.id);
    }

    void add_sides(const PortalPolygon& polygon, bool as_wound) {
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const GridPoint &a = polygon.corners[k], &b = polygon.corners[polygon.shape.next(k)];
            as_wound ? sides_.emplace_back(a, b, FaceId{}) : sides_.emplace_back(b, a, FaceId{});
        }
    }

    /// Around a room, the edges of its solid faces and of its portals, as seen from it, cancel.
    void check_closed(std::uint32_t room) {
        sides_.clear();
        if (data_.rooms[room]->tree)
            for_each_face_block(*data_.rooms[room]->tree, [&](const Block& block) {
                for (const FaceRecord& face : block.faces)
                    if (face.solid) add_sides(block, face);
            });
        if (data_.portals)
            for (const std::uint32_t index : data_.portals->portals_of(room)) {
                const Portal& portal = data_.portals->portals()[index];
                for (const PortalPolygon& polygon : data_.portals->polygons_of(portal))
                    add_sides(polygon, portal.rooms[0].value == room);
            }
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t first = 0, end = 0; first < sides_.size(); first = end) {
            std::int64_t sum = 0;
            for (end = first; end < sides_.size() && sides_[end].along(sides_[first]); ++end)
                sum += sides_[end].down ? -1 : 1;
            if (sum != 0) return report(room_text(room, "is not closed by its faces and portals"), sides_[first].face);
        }
    }

    const WorldData& data_;
    std::optional<WorldFault> fault_;
    std::vector<Side> sides_;
};

}  // namespace

std::optional<WorldFault> check_rooms(const World& world) {
    return RoomChecker(world.data()).check();
}

}  // namespace firma
