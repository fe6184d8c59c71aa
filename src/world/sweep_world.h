// SPDX-License-Identifier: MIT
// The way of a sweep through a world: through each room's index, and from room to room.
//
// By room: rooms wait in the order in which the sweep reaches the portals that lead to them, and the earliest is looked
// into next, until none is reached before what was met so far. A room beyond several portals counts as reached when the
// last of them on the way was, by the best way; of rooms reached at one time the lowest comes first. So which rooms are
// looked into follows from the sweep and the world alone. Closed portals stop the sweep where they are met, and lead on
// all the same: then to nothing but what is met at that very time.
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "base/seldom.h"
#include "cast/cast_sphere_polygon.h"
#include "cast/make_hit.h"
#include "cast/shape_extent.h"
#include "firma/queries.h"
#include "index/sweep_box.h"
#include "index/traverse.h"
#include "world/block_faces.h"
#include "world/particle_triangle.h"
#include "world/reach_portal.h"
#include "world/rooms_on_the_way.h"
#include "world/sweep_lanes.h"
#include "world/world_data.h"

namespace firma {

/// A touch and whose it is: a face's, or a closed portal's.
struct SweepContact {
    Contact contact;
    const Block* block = nullptr;  ///< null: a portal
    std::uint32_t slot = 0;        ///< of a portal: which of its polygons
    std::uint32_t portal = ~0u;
    const FaceLanes* whole = nullptr;  ///< lanes one of which has all that the facet's shape is, or null
    std::uint32_t lane = 0;
    const FaceRecord* record = nullptr;  ///< of a face
    bool through_plane = false;          ///< of a particle and `whole`: told by the lanes, so that what follows is set
    bool away = false;                   ///< whether the path runs along the normal
    Vec3 normal{};                       ///< as of a TriangleCrossing

    const FaceRecord& face() const { return *record; }
    /// In the order of faces by id, then portals.
    bool comes_before(const SweepContact& other) const {
        if (block && other.block) return face().id < other.face().id;
        return block ? true : other.block ? false : portal < other.portal;
    }
};

/// A room that a cast passed into, and the portal.
inline void add_room(RoomTrail& trail, std::uint32_t room, std::uint32_t portal = kNoPortalPassed) {
    if (trail.count < trail.rooms.size()) trail.rooms[trail.count] = {room};
    if (trail.count < trail.portals.size())
        trail.portals[trail.count] = portal == kNoPortalPassed ? PortalId{} : PortalId{portal};
    ++trail.count;
}

struct BoxD {
    double low[3], high[3];
};

/// Taken together by a processor (as GCC and Clang write it): of a point x, y and z; the last is not used.
using PointSteps [[gnu::vector_size(16)]] = std::int32_t;

/// Its coordinates go together, as casts ask for more boxes than for anything else of faces. A call, as inlined it
/// takes registers from the traversal around it, which costs more.
[[gnu::noinline]] inline BoxD box_of_face(const Block& block, const FaceRecord& face) {
    constexpr std::int32_t kLowest = INT32_MIN, kHighest = INT32_MAX;
    PointSteps low{kHighest, kHighest, kHighest, 0}, high{kLowest, kLowest, kLowest, 0};
    block.for_each_corner(face, [&](const GridPoint& corner) {
        const PointSteps p{corner.x, corner.y, corner.z, 0};
        low = p < low ? p : low;
        high = p > high ? p : high;
    });
    const Vec3 a = to_metres({low[0], low[1], low[2]}), b = to_metres({high[0], high[1], high[2]});
    return {{a.x, a.y, a.z}, {b.x, b.y, b.z}};
}

/// What moves: how it meets a polygon, what a touch then looks like, and a simple body around it. Its sweep's radius
/// holds all of it.
struct SphereMover {
    Contact against(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                    CastCounts* counts) const {
        return cast_sweep_polygon(sweep, polygon, sides, latest, counts);
    }
    PolygonHit hit(const Sweep& sweep, const PolygonShape& polygon, const Contact& contact) const {
        return make_hit(sweep, polygon, contact);
    }
    LaneSweep lanes(const Sweep& sweep) const { return LaneSweep(sweep); }
};

/// Goes through one index. `Found` is told of every touch up to `latest` and returns true to end the traversal; it may
/// bring `latest` forward.
template <class Found, class Mover>
class SweepVisitor {
public:
    SweepVisitor(const Sweep& sweep, const Mover& mover, const SweepBox& boxes, const CastOptions& options,
                 Found& found)
        : sweep_(sweep), mover_(mover), boxes_(boxes), options_(options), found_(found) {}

    bool enter(const BoxF& box, double& nearest) {
        ++counts.nodes;
        return boxes_.enters(box, found_.latest, nearest);
    }
    bool still(double nearest) const { return nearest <= found_.latest; }

    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (!(face.mask & options_.mask)) continue;
            ++counts.boxes;
            double nearest;
            if (!boxes_.enters(box_of_face(block, face), found_.latest, nearest)) continue;
            ++counts.faces;
            const FaceShape shape(block, face);
            if (!shape.polygon.has_area()) continue;
            const Sides sides = face.two_sided ? Sides::kBoth : options_.sides;
            const Contact contact = mover_.against(sweep_, shape.polygon, sides, found_.latest, &counts);
            if (contact.touched() && found_({contact, &block, slot, ~0u, nullptr, 0, &face})) return ended = true;
        }
        return false;
    }

    CastCounts counts;
    bool ended = false;

private:
    const Sweep& sweep_;
    [[no_unique_address]] const Mover mover_;
    const SweepBox boxes_;
    const CastOptions& options_;
    Found& found_;
};

/// One cast on its way. What it looks into is handed out index by index: whoever has it goes through that, and asks for
/// the next.
template <class Found, class Mover>
class WorldSweep {
public:
    WorldSweep(const WorldData& data, const Sweep& sweep, const Mover& mover, const CastOptions& options, Found& found)
        : data_(data),
          sweep_(sweep),
          mover_(mover),
          lanes_(mover.lanes(sweep)),
          options_(options),
          found_(found),
          query_(lanes_, options.sides == Sides::kFront, found.latest, this, look_at_facet, options.counts) {
        query_.earliest_only = Found::kEarliestOnly;
    }
    WorldSweep(const WorldSweep&) = delete;
    WorldSweep& operator=(const WorldSweep&) = delete;

    /// From a room on, through every portal that the sweep reaches; without this through all rooms at once.
    /// @param rooms, trail  live as long
    void start_in(std::uint32_t room, RoomsOnTheWay& rooms, RoomTrail& trail) {
        rooms_ = &rooms;
        trail_ = &trail;
        rooms.start(data_.cells.room_count());
        grown_ = grown_radius(sweep_);
        rooms.wait({0, room, kNoPortalPassed, false});
    }

    /// The index to look into next; null: the cast is over.
    const Node* next() {
        const Node* const index = rooms_ ? next_by_room() : next_of_all();
        query_.latest = found_.latest;
        return index;
    }
    void look_into(const Node& index) {
        if (by_lanes())
            ended_ = sweep_lanes(index, query_);
        else
            look_one_by_one(index);
    }

    /// Else look_into() is what looks.
    bool by_lanes() const { return lanes_.usable; }
    LaneQuery& query() { return query_; }
    /// Says that a look by lanes ended the cast.
    void end() { ended_ = true; }

private:
    const Node* next_of_all() {
        if (!began_) indices_ = indices_of(data_);
        began_ = true;
        for (const Node*& each : indices_)
            if (const Node* const index = std::exchange(each, nullptr); index && !ended_) return index;
        if (data_.cells.any_closed()) meet_closed_portals();
        return nullptr;
    }

    const Node* next_by_room() {
        for (;;) {
            if (ended_) return nullptr;
            if (inside_) pass_portals();
            inside_ = false;
            if (ended_ || !rooms_->any()) return nullptr;
            from_ = rooms_->take_first();
            if (from_.reached > found_.latest) return nullptr;
            first_look_ = !rooms_->looked_into(from_.room);
            if (from_.behind && !first_look_) continue;
            if (!from_.behind) {
                add_room(*trail_, from_.room, from_.portal);
                rooms_->mark_passed(from_.room);
            }
            rooms_->mark_looked_into(from_.room);
            inside_ = true;
            if (!first_look_) continue;
            if (const Node* const tree = data_.faces_of(from_.room).tree.get()) return tree;
        }
    }

    FIRMA_SELDOM void look_one_by_one(const Node& index) {
        SweepVisitor<Found, Mover> visitor(sweep_, mover_, boxes(), options_, found_);
        traverse(index, visitor);
        ended_ = visitor.ended;
        if (options_.counts) {
            options_.counts->nodes += visitor.counts.nodes;
            options_.counts->boxes += visitor.counts.boxes;
            options_.counts->faces += visitor.counts.faces;
            options_.counts->precise += visitor.counts.precise;
        }
    }

    static bool look_at_facet(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane) {
        WorldSweep& it = *static_cast<WorldSweep*>(query.whose);
        const std::uint32_t slot = lanes.slot(lane);
        const FaceRecord* const record = lanes.faces + slot;
        __builtin_prefetch(record);  // what a hit tells of it, far from the lanes
        query.met = false;
        if (!(lanes.mask_of_all & it.options_.mask) && !(record->mask & it.options_.mask)) return false;
        if (query.counts) ++query.counts->faces;
        const TriangleCrossing& crossing = query.crossing;
        if (!crossing.known) return it.ask_polygon(query, lanes, lane, slot);
        query.met = crossing.open == 0 || line_passes(it.sweep_, it.whole_path_, lanes, lane, crossing.open,
                                                      crossing.away ? 1 : -1, query.through_edge);
        if (!query.met) return false;
        const auto touch = [&] {
            return SweepContact{{Status::kHit, Feature::kFace, 0, crossing.t},
                                lanes.block,
                                slot,
                                ~0u,
                                &lanes,
                                lane,
                                record,
                                true,
                                crossing.away,
                                crossing.normal};
        };
        bool ends = false;
        if constexpr (Found::kEarliestOnly) {  // made where it is kept, and only then
            if (!it.found_.is_earlier(crossing.t, *record)) return false;
            it.found_.keep(touch());
        } else {
            ends = it.found_(touch());
        }
        query.latest = it.found_.latest;
        return ends;
    }

    /// Apart: a polygon takes much of the stack.
    [[gnu::noinline]] bool ask_polygon(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane,
                                       std::uint32_t slot) {
        SweepContact met{{}, lanes.block, slot};
        met.record = lanes.faces + slot;
        const Sides sides = lanes.two_sided >> lane & 1 ? Sides::kBoth : options_.sides;
        bool ends = false;
        if (lanes.whole >> lane & 1) {
            met.whole = &lanes;
            met.lane = lane;
            ends = meet(query, LaneShape(lanes, lane).polygon, sides, met);
        } else {
            ends = meet(query, FaceShape(*lanes.block, met.face()).polygon, sides, met);
        }
        query.latest = found_.latest;
        return ends;
    }

    bool meet(LaneQuery& query, const PolygonShape& polygon, Sides sides, SweepContact& met) {
        if (!polygon.has_area()) return false;
        met.contact = mover_.against(sweep_, polygon, sides, found_.latest, query.counts);
        return met.contact.touched() && found_(met);
    }

    /// Meets the closed portals of the room that it is in, and puts the rooms beyond all portals reached in the list of
    /// those that wait.
    void pass_portals() {
        const WaitingRoom& from = from_;
        RoomsOnTheWay& rooms = *rooms_;
        // A large hall may have dozens; most are nowhere near.
        data_.cells.for_each_portal_of(from.room, path_box(), [&](std::uint32_t index) {
            const Portal& portal = data_.cells.portal(index);
            const std::uint32_t beyond = data_.cells.beyond(portal, from.room);
            const bool closed = stops(index, portal), behind = from.behind || closed;
            // Once, from whichever of its rooms comes first.
            if (closed && first_look_ && !rooms.looked_into(beyond) && meet_portal(index, portal)) return true;
            double reached = 0;
            if (behind ? rooms.looked_into(beyond) : rooms.passed(beyond)) return false;
            if (!reaches(portal, reached)) return false;
            rooms.wait({reached > from.reached ? reached : from.reached, beyond, index, behind});
            return false;
        });
    }

    /// Around all that the sphere may touch up to the latest time; what lies outside, SweepBox would not enter.
    GridBox path_box() const {
        constexpr double kRounding = 2;  // steps: of these sums, and as fractions are cut off
        const double grown = grown_ * kSurfaceSteps + kRounding;
        const Vec3 last = sweep_.at(found_.latest);
        const auto step = [](double at) { return std::int32_t(std::clamp(at, double(INT32_MIN), double(INT32_MAX))); };
        GridBox box;
        for (int axis = 0; axis < 3; ++axis) {
            const double one = sweep_.start[axis] * kSurfaceSteps, other = last[axis] * kSurfaceSteps;
            box.low[axis] = step(std::min(one, other) - grown);
            box.high[axis] = step(std::max(one, other) + grown);
        }
        return box;
    }

    bool stops(std::uint32_t index, const Portal& portal) const {
        return data_.cells.any_closed() && data_.cells.is_closed(index) && (portal.mask & options_.mask);
    }

    bool reaches(const Portal& portal, double& reached) {
        bool any = false;
        for (const PortalPolygon& polygon : portal.polygons()) {
            count_box();
            double nearest;
            if (!boxes().enters(polygon.box, found_.latest, nearest)) continue;
            if (!reaches_portal(sweep_, polygon.shape, grown_, found_.latest, nearest)) continue;
            if (!any || nearest < reached) reached = nearest;
            any = true;
        }
        return any;
    }

    FIRMA_SELDOM void meet_closed_portals() {
        if (ended_) return;
        const auto meets = [&](const GridBox& box) {
            const Vec3 low = to_metres(box.low), high = to_metres(box.high);
            double nearest;
            return boxes().enters(BoxD{{low.x, low.y, low.z}, {high.x, high.y, high.z}}, found_.latest, nearest);
        };
        data_.cells.for_each_portal_where(meets, [&](std::uint32_t index, const Portal& portal) {
            if (!ended_ && stops(index, portal)) meet_portal(index, portal);
        });
    }

    /// A closed portal counts once, however many polygons it has: by the one met first.
    /// @return whether this ended the cast
    FIRMA_SELDOM bool meet_portal(std::uint32_t index, const Portal& portal) {
        SweepContact first;
        first.portal = index;
        const auto polygons = portal.polygons();
        for (std::uint32_t k = 0; k < polygons.size(); ++k) {
            count_box();
            double nearest;
            if (!boxes().enters(polygons[k].box, found_.latest, nearest)) continue;
            const Contact contact =
                mover_.against(sweep_, polygons[k].shape, Sides::kBoth, found_.latest, options_.counts);
            if (!contact.touched() || (first.contact.touched() && contact.t >= first.contact.t)) continue;
            first.contact = contact;
            first.slot = k;
        }
        return ended_ = first.contact.touched() && found_(first);
    }

    /// Made once something asks: with lanes, a cast that reaches no portal does not.
    [[gnu::noinline]] const SweepBox& boxes() {
        if (!boxes_) boxes_.emplace(sweep_);
        return *boxes_;
    }

    void count_box() {
        if (options_.counts) ++options_.counts->boxes;
    }

    const WorldData& data_;
    const Sweep& sweep_;
    [[no_unique_address]] const Mover mover_;
    LaneSweep lanes_;
    std::optional<SweepBox> boxes_;
    const CastOptions& options_;
    Found& found_;
    bool ended_ = false;

    std::optional<WholePath> whole_path_;
    LaneQuery query_;
    // Of all rooms at once.
    bool began_ = false;
    std::array<const Node*, 2> indices_;  ///< those left, once it began

    // By room.
    RoomsOnTheWay* rooms_ = nullptr;
    RoomTrail* trail_ = nullptr;
    WaitingRoom from_{};       ///< where it is
    bool inside_ = false;      ///< its portals are still to be passed
    bool first_look_ = false;  ///< its faces had not been looked at before
    double grown_ = 0;         ///< the sweep's radius and more, as portals are reached
};

}  // namespace firma
