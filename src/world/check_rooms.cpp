// SPDX-License-Identifier: MIT
// Rooms and portals, one by one, the slow and sure way. Sides are sorted by place, not gathered by number: what a fault
// names must not depend on the order of faces.
#include "world/check_rooms.h"

#include <algorithm>
#include <vector>

#include "base/sort.h"
#include "geometry/exact_point.h"
#include "solid/solid_face.h"
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
    explicit RoomChecker(const WorldData& data) : data_(data), cells_(data.cells) {}

    std::optional<WorldFault> check() {
        if (check_cells() || !cells_.known()) return fault_;
        // Without an exact part there is no solid, and nothing closes.
        if (data_.solid.face_count() > 0)
            for (std::uint32_t room = 0; room < cells_.room_count() && !fault_; ++room) check_closed(room);
        return fault_;
    }

    std::optional<WorldFault> check_cells() {
        if (!cells_.known()) {
            if (cells_.room_count() != 1 || cells_.portal_count() > 0) report("rooms have no records", {});
            return fault_;
        }
        check_records();
        if (!fault_) check_portals();
        return fault_;
    }

    std::optional<WorldFault> check_exchange(const WorldData& before, bool cells_shared,
                                             std::span<const FacetPlace> removed, std::span<const FacetPlace> added) {
        std::vector<Exchanged> all;
        for (const FacetPlace& facet : removed)
            all.push_back({cells_.current_room(facet.block->part), false, &facet, nullptr, false});
        for (const FacetPlace& facet : added)
            all.push_back({cells_.current_room(facet.block->part), true, &facet, nullptr, false});
        if (!cells_shared) {
            add_portals(before.cells, false, all);
            add_portals(cells_, true, all);
        }
        sort_range(all, [](const Exchanged& a, const Exchanged& b) { return a.room < b.room; });
        for (std::size_t first = 0, end = 0; first < all.size() && !fault_; first = end) {
            sides_.clear();
            for (end = first; end < all.size() && all[end].room == all[first].room; ++end) {
                const Exchanged& it = all[end];
                if (it.portal)
                    for (const PortalPolygon& polygon : it.portal->all_polygons())
                        add_sides(polygon, it.inward == it.comes);
                else
                    add_sides(*it.facet->block, it.facet->record(), it.comes);
            }
            report_uneven(all[first].room);
        }
        return fault_;
    }

private:
    /// A facet or a portal that comes or goes, of a room that has it.
    struct Exchanged {
        std::uint32_t room = 0;
        bool comes = false;
        const FacetPlace* facet = nullptr;
        const Portal* portal = nullptr;
        bool inward = false;  ///< the portal's polygons are wound as seen from this room
    };

    static void add_portals(const Cells& cells, bool come, std::vector<Exchanged>& all) {
        cells.portals().for_each([&](std::uint32_t, const PortalState& state) {
            const std::array<RoomId, 2> rooms = cells.rooms_of(*state.portal);
            for (const bool first : {true, false})
                if (!state.portal->gone())
                    all.push_back({rooms[first ? 0 : 1].value, come, nullptr, state.portal.get(), first});
        });
    }

    void report(std::string what, FaceId face) {
        if (!fault_) fault_ = WorldFault{std::move(what), face};
    }

    void check_records() {
        std::size_t infinite = data_.rock_outside();
        std::vector<std::vector<PortalId>> portals(cells_.room_count());
        cells_.portals().for_each([&](std::uint32_t k, const PortalState& state) {
            for (const RoomId room : cells_.rooms_of(*state.portal)) {
                if (state.portal->gone() || room.value >= portals.size()) continue;
                std::vector<PortalId>& of_room = portals[room.value];
                if (of_room.empty() || of_room.back().value != k) of_room.push_back({k});
            }
        });
        for (std::uint32_t room = 0; room < cells_.room_count(); ++room) {
            const RoomRecord& record = cells_.room(room);
            infinite += record.exterior;
            const std::uint32_t into = record.merged_into;
            if (into >= cells_.room_count()) return report(room_text(room, "is part of one that is not there"), {});
            if (into != room && (data_.faces_of(room).tree || record.exterior))
                return report(room_text(room, "is part of another, and yet not empty"), {});
            if (cells_.current_room(room) != (into == room ? room : cells_.current_room(into)))
                return report(room_text(room, "is not found where it is part of"), {});
            if (portals[room] != record.portals) return report(room_text(room, "does not list its portals"), {});
            if (record.portal_box != cells_.box_of(record.portals))
                return report(room_text(room, "has a wrong box around its portals"), {});
            if (!finds_its_portals(record))
                return report(room_text(room, "does not find its portals by their boxes"), {});
        }
        if (infinite > 1) report("more than one room, or rock as well, reaches to infinity", {});
    }

    /// Its boxes, or its index over them.
    bool finds_its_portals(const RoomRecord& record) const {
        const bool indexed = record.portals.size() > Cells::kListed;
        if (indexed != bool(record.portal_index) || record.portal_boxes.size() != (indexed ? 0 : record.portals.size()))
            return false;
        for (std::size_t k = 0; k < record.portal_boxes.size(); ++k)
            if (record.portal_boxes[k] != cells_.portal(record.portals[k].value).box) return false;
        if (!indexed) return true;
        std::vector<PortalId> found;
        bool stale = false;  // what it was before it changed: the next edit would not find it
        for_each_leaf(record.portal_index, [&](const Ref<const Node>& leaf) {
            found.push_back({static_cast<const IndexedPortal&>(*leaf->facets).number});
            const PortalState* now = cells_.portals().find(found.back().value);
            stale = stale || !now || !now->leaf || now->leaf->facets.get() != leaf->facets.get();
        });
        if (stale) return false;
        std::sort(found.begin(), found.end());
        return found == record.portals;
    }

    void check_portals() {
        std::size_t closed = 0;
        for (std::uint32_t k = 0; k < cells_.portal_count() && !fault_; ++k) {
            const Portal& portal = cells_.portal(k);
            closed += cells_.is_closed(k);
            for (const RoomId room : portal.made_between)
                if (room.value >= cells_.room_count()) return report(portal_text(k, "leads to no room"), {});
            if (portal.gone()) continue;
            const std::array<RoomId, 2> rooms = cells_.rooms_of(portal);
            if (rooms[0] == rooms[1]) return report(portal_text(k, "leads from a room to itself"), {});
            for (const PortalPolygon& polygon : portal.polygons())
                if (check_polygon(polygon.shape.corners) != PolygonFault::kNone)
                    return report(portal_text(k, "has a polygon that is not convex and planar, with area"), {});
            for (std::size_t p = 0; p < portal.all_polygons().size(); ++p)
                if (!portal.exact(p) && !portal.all_polygons()[p].shape.has_area())
                    return report(portal_text(k, "has a polygon that is not convex and planar, with area"), {});
            if (const char* fault = check_exact(portal)) return report(portal_text(k, fault), {});
        }
        if (!fault_ && cells_.any_closed() != (closed > 0)) report("the count of closed portals is wrong", {});
    }

    /// Its exact faces: edges that follow each other, on the face's plane, and facets with the same sides.
    const char* check_exact(const Portal& portal) {
        const auto polygons = portal.all_polygons();
        for (std::size_t first = 0, end = 0; first < polygons.size(); first = end) {
            const SolidFace* face = portal.exact(first);
            for (end = first + 1; face && end < polygons.size() && portal.exact(end) == face;) ++end;
            if (!face) continue;
            sides_.clear();
            for (std::size_t k = first; k < end; ++k) add_sides(polygons[k], true);
            std::size_t at = 0;
            for (const std::uint32_t last : face->loop_ends()) {
                for (const std::size_t start = at; at < last; ++at) {
                    const SolidUse& use = face->uses[at];
                    const SolidVertex& next = face->uses[at + 1 < last ? at + 1 : start].from();
                    if (use.edge().vertex[!use.reversed()].get() != &next &&
                        use.edge().vertex[!use.reversed()]->point.rounded() != next.point.rounded())
                        return "has an exact face whose edges do not follow each other";
                    if (exact_side(face->plane->plane, use.from().point) != 0)
                        return "has an exact face with a corner off its plane";
                    const GridPoint a = use.from().point.rounded(), b = next.point.rounded();
                    if (a != b) sides_.emplace_back(b, a, FaceId{});
                }
            }
            if (uneven_side()) return "has polygons that are no facets of their exact face";
        }
        return nullptr;
    }

    void add_sides(const Block& block, const FaceRecord& face, bool as_wound) {
        for (std::size_t k = 0; k < face.corner_count; ++k) {
            const GridPoint &a = block.corner(face, k), &b = block.corner(face, k + 1u < face.corner_count ? k + 1 : 0);
            if (a == b) continue;  // rounding may leave a facet a side of no length
            as_wound ? sides_.emplace_back(a, b, face.id) : sides_.emplace_back(b, a, face.id);
        }
    }

    void add_sides(const PortalPolygon& polygon, bool as_wound) {
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const GridPoint &a = polygon.corners[k], &b = polygon.corners[polygon.shape.next(k)];
            if (a == b) continue;
            as_wound ? sides_.emplace_back(a, b, FaceId{}) : sides_.emplace_back(b, a, FaceId{});
        }
    }

    /// Around a room, the edges of its solid faces and of its portals, as seen from it, cancel.
    void check_closed(std::uint32_t room) {
        sides_.clear();
        if (const Node* tree = data_.faces_of(room).tree.get())
            for_each_block(*tree, [&](const Block& block) {
                for (const FaceRecord& face : block.faces)
                    if (face.solid) add_sides(block, face, true);
            });
        for (const PortalId id : cells_.portals_of(room)) {
            const Portal& portal = cells_.portal(id.value);
            for (const PortalPolygon& polygon : portal.all_polygons())
                add_sides(polygon, cells_.rooms_of(portal)[0].value == room);
        }
        report_uneven(room);
    }

    void report_uneven(std::uint32_t room) {
        if (const Side* side = uneven_side())
            report(room_text(room, "is not closed by its faces and portals"), side->face);
    }

    /// A side that is not there as often each way; null where there is none.
    const Side* uneven_side() {
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t first = 0, end = 0; first < sides_.size(); first = end) {
            std::int64_t sum = 0;
            for (end = first; end < sides_.size() && sides_[end].along(sides_[first]); ++end)
                sum += sides_[end].down ? -1 : 1;
            if (sum != 0) return &sides_[first];
        }
        return nullptr;
    }

    const WorldData& data_;
    const Cells& cells_;
    std::optional<WorldFault> fault_;
    std::vector<Side> sides_;
};

}  // namespace

std::optional<WorldFault> check_rooms(const World& world) {
    return RoomChecker(world.data()).check();
}

std::optional<WorldFault> check_cells(const WorldData& data) {
    return RoomChecker(data).check_cells();
}

std::optional<WorldFault> check_rooms_exchange(const WorldData& before, const WorldData& after, bool cells_shared,
                                               std::span<const FacetPlace> removed, std::span<const FacetPlace> added) {
    return RoomChecker(after).check_exchange(before, cells_shared, removed, added);
}

}  // namespace firma
