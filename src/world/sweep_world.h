// SPDX-License-Identifier: MIT
// The walk of a sweep through a world: through each room's tree, and from room to room.
//
// By room: rooms wait in the order in which the sweep reaches the portals that lead to them, and the earliest is looked
// into next, until none is reached before what was met so far. A room beyond several portals counts as reached when the
// last of them on the way was, by the best way; of rooms reached at one time the lowest comes first. So which rooms are
// looked into follows from the sweep and the world alone. Closed portals stop the sweep where they are met, and lead on
// all the same: then to nothing but what is met at that very time.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "cast/cast_sphere_polygon.h"
#include "firma/world.h"
#include "tree/sweep_box.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/each_room.h"
#include "world/reach_portal.h"
#include "world/world_data.h"

namespace firma {

/// A touch and whose it is: a face's, or a closed portal's.
struct SweepContact {
    Contact contact;
    const Block* block = nullptr;  ///< null: a portal
    std::uint32_t slot = 0;        ///< of a portal: which of its polygons
    std::uint32_t room = 0;        ///< of a portal: where it was met from
    std::uint32_t portal = ~0u;

    const FaceRecord& face() const { return block->faces[slot]; }
    /// In the order of faces by id, then portals.
    bool comes_before(const SweepContact& other) const {
        if (block && other.block) return face().id < other.face().id;
        return block ? true : other.block ? false : portal < other.portal;
    }
};

/// The rooms that a cast looked into, in order.
struct RoomsPassed {
    std::uint32_t count = 0;
    std::array<RoomId, kRoomsInHit> first{};
    std::span<RoomId> all;  ///< as far as they fit

    void add(std::uint32_t room) {
        if (count < first.size()) first[count] = {room};
        if (count < all.size()) all[count] = {room};
        ++count;
    }
};

inline BoxD box_of_face(const Block& block, const FaceRecord& face) {
    const auto corners = block.corners_of(face);
    GridPoint low = block.vertices[corners[0]], high = low;
    for (const std::uint16_t corner : corners.subspan(1)) {
        const GridPoint& p = block.vertices[corner];
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    const Vec3 a = to_metres(low), b = to_metres(high);
    return {{a.x, a.y, a.z}, {b.x, b.y, b.z}};
}

/// Walks one room's tree. `Found` is told of every touch up to `latest` and returns true to end the walk; it may bring
/// `latest` forward.
template <class Found>
class SweepVisitor {
public:
    SweepVisitor(const Sweep& sweep, const CastOptions& options, std::uint32_t room, Found& found)
        : sweep_(sweep), boxes_(sweep), options_(options), room_(room), found_(found) {}

    bool enter(const Bin& bin, double& nearest) {
        ++counts.bins;
        return boxes_.enters(bin.box, found_.latest, nearest);
    }
    bool still(double nearest) const { return nearest <= found_.latest; }

    bool faces(const Block& block, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (!(face.mask & options_.mask)) continue;
            ++counts.boxes;
            double nearest;
            if (!boxes_.enters(box_of_face(block, face), found_.latest, nearest)) continue;
            ++counts.faces;
            const FaceShape shape(block, face);
            const Sides sides = face.two_sided ? Sides::kBoth : options_.sides;
            const Contact contact = cast_sweep_polygon(sweep_, shape.polygon, sides, found_.latest, &counts);
            if (contact.touched() && found_({contact, &block, slot, room_})) return ended = true;
        }
        return false;
    }

    CastCounts counts;
    bool ended = false;

private:
    const Sweep& sweep_;
    const SweepBox boxes_;
    const CastOptions& options_;
    const std::uint32_t room_;
    Found& found_;
};

/// One cast on its way.
template <class Found>
class WorldSweep {
public:
    WorldSweep(const WorldData& data, const Sweep& sweep, const CastOptions& options, Found& found)
        : data_(data), sweep_(sweep), options_(options), found_(found) {}

    /// Through the trees of all rooms.
    void ask_all() {
        if (data_.rooms.size() == 1) {
            if (const Block* tree = data_.rooms[0]->tree.get()) look_into(0, *tree);
        } else {
            const SweepBox boxes(sweep_);
            for_each_room_nearest_first(
                data_, [&](const auto& box, double& nearest) { return boxes.enters(box, found_.latest, nearest); },
                [&](double nearest) { return nearest <= found_.latest; },
                [&](std::uint32_t room, const Block& tree) {
                    look_into(room, tree);
                    return ended_;
                });
        }
        if (data_.closed) meet_closed_portals();
    }

    /// From a room on, through every portal that the sweep reaches; false where it gave up on that, and all rooms are
    /// to be asked.
    bool ask_from(std::uint32_t start, RoomsPassed& passed) {
        if (data_.rooms.size() > kMostRooms) return false;
        std::fill_n(looked_into_, (data_.rooms.size() + 63) / 64, 0);
        std::fill_n(passed_, (data_.rooms.size() + 63) / 64, 0);
        grown_ = grown_radius(sweep_);
        const SweepBox boxes(sweep_);
        waiting_[0] = {0, start, false};
        count_ = 1;
        while (count_ > 0 && !ended_) {
            const Waiting next = take_first();
            if (next.reached > found_.latest) break;
            const bool first_look = !has(looked_into_, next.room);
            if (next.behind && !first_look) continue;
            if (!next.behind) passed.add(next.room), add(passed_, next.room);
            add(looked_into_, next.room);
            const Block* tree = data_.rooms[next.room]->tree.get();
            if (first_look && tree) look_into(next.room, *tree);
            if (!ended_ && data_.portals && !pass_portals(next, first_look, boxes)) return false;
        }
        return true;
    }

private:
    /// Worlds of more are asked in all rooms.
    static constexpr std::size_t kMostRooms = 4096;
    /// With more rooms waiting than this, all are asked.
    static constexpr std::size_t kMostWaiting = 256;

    /// A room that was reached only by meeting a closed portal lies `behind` it: of its faces, those at the portal's
    /// rim may be met at the same time, and the lowest id counts; but the sweep did not pass into it.
    struct Waiting {
        double reached;
        std::uint32_t room;
        bool behind;
    };

    static void add(std::uint64_t* marks, std::uint32_t room) { marks[room / 64] |= std::uint64_t(1) << room % 64; }
    static bool has(const std::uint64_t* marks, std::uint32_t room) { return marks[room / 64] >> room % 64 & 1; }

    void look_into(std::uint32_t room, const Block& tree) {
        SweepVisitor<Found> visitor(sweep_, options_, room, found_);
        visit(tree, visitor);
        ended_ = visitor.ended;
        if (options_.counts) {
            options_.counts->bins += visitor.counts.bins;
            options_.counts->boxes += visitor.counts.boxes;
            options_.counts->faces += visitor.counts.faces;
            options_.counts->precise += visitor.counts.precise;
        }
    }

    Waiting take_first() {
        std::size_t first = 0;
        for (std::size_t k = 1; k < count_; ++k) {
            const Waiting &a = waiting_[k], &b = waiting_[first];
            if (a.reached != b.reached ? a.reached < b.reached : a.behind != b.behind ? b.behind : a.room < b.room)
                first = k;
        }
        const Waiting taken = waiting_[first];
        waiting_[first] = waiting_[--count_];
        return taken;
    }

    /// Meets the closed portals of a room, and puts the rooms beyond all portals reached in the list of those that
    /// wait.
    /// @return false when the list is full
    bool pass_portals(const Waiting& from, bool first_look, const SweepBox& boxes) {
        const GridBox around = box_of_sweep();
        for (const std::uint32_t index : data_.portals->portals_of(from.room)) {
            const Portal& portal = data_.portals->portals()[index];
            // A large hall may have dozens; most are nowhere near.
            if (!boxes_meet(portal.box, around)) continue;
            const std::uint32_t beyond = portal.beyond({from.room}).value;
            const bool closed = stops(index, portal), behind = from.behind || closed;
            // Once, from whichever of its rooms comes first.
            if (closed && first_look && !has(looked_into_, beyond) && meet_portal(index, portal, from.room, boxes))
                return true;
            double reached = 0;
            if (has(behind ? looked_into_ : passed_, beyond) || !reaches(portal, boxes, reached)) continue;
            if (!wait({reached > from.reached ? reached : from.reached, beyond, behind})) return false;
        }
        return true;
    }

    /// Around all that the sphere may touch up to the latest time; what lies outside, SweepBox would not enter.
    GridBox box_of_sweep() const {
        const auto in_steps = [](double metres) {
            return std::int32_t(std::clamp(metres * kSurfaceSteps, double(INT32_MIN), double(INT32_MAX)));
        };
        constexpr double kRounding = 2 / kSurfaceSteps;  // of these sums, and of conversion toward zero
        const double grown = grown_ + kRounding;
        const Vec3 last = sweep_.at(found_.latest);
        GridBox box;
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = in_steps(std::min(sweep_.start[axis], last[axis]) - grown);
            box.high[axis] = in_steps(std::max(sweep_.start[axis], last[axis]) + grown);
        }
        return box;
    }

    bool stops(std::uint32_t index, const Portal& portal) const {
        return data_.closed && data_.closed->is_closed[index] && (portal.mask & options_.mask);
    }

    bool reaches(const Portal& portal, const SweepBox& boxes, double& reached) {
        bool any = false;
        for (const PortalPolygon& polygon : data_.portals->polygons_of(portal)) {
            count_box();
            double nearest;
            if (!boxes.enters(polygon.box, found_.latest, nearest)) continue;
            if (!reaches_portal(sweep_, polygon.shape, grown_, found_.latest, nearest)) continue;
            if (!any || nearest < reached) reached = nearest;
            any = true;
        }
        return any;
    }

    bool wait(const Waiting& more) {
        for (std::size_t k = 0; k < count_; ++k)
            if (waiting_[k].room == more.room && waiting_[k].behind == more.behind) {
                if (more.reached < waiting_[k].reached) waiting_[k].reached = more.reached;
                return true;
            }
        if (count_ == kMostWaiting) return false;
        waiting_[count_++] = more;
        return true;
    }

    void meet_closed_portals() {
        if (ended_) return;
        const SweepBox boxes(sweep_);
        for (const std::uint32_t index : data_.closed->all) {
            const Portal& portal = data_.portals->portals()[index];
            if (!(portal.mask & options_.mask)) continue;
            if (meet_portal(index, portal, portal.rooms[0].value, boxes)) return;
        }
    }

    /// A closed portal counts once, however many polygons it has: by the one met first.
    /// @return whether this ended the cast
    bool meet_portal(std::uint32_t index, const Portal& portal, std::uint32_t room, const SweepBox& boxes) {
        SweepContact first;
        first.room = room;
        first.portal = index;
        const auto polygons = data_.portals->polygons_of(portal);
        for (std::uint32_t k = 0; k < polygons.size(); ++k) {
            count_box();
            double nearest;
            if (!boxes.enters(polygons[k].box, found_.latest, nearest)) continue;
            const Contact contact =
                cast_sweep_polygon(sweep_, polygons[k].shape, Sides::kBoth, found_.latest, options_.counts);
            if (!contact.touched() || (first.contact.touched() && contact.t >= first.contact.t)) continue;
            first.contact = contact;
            first.slot = k;
        }
        return ended_ = first.contact.touched() && found_(first);
    }

    void count_box() {
        if (options_.counts) ++options_.counts->boxes;
    }

    const WorldData& data_;
    const Sweep& sweep_;
    const CastOptions& options_;
    Found& found_;
    bool ended_ = false;

    double grown_ = 0;
    std::size_t count_ = 0;
    std::array<Waiting, kMostWaiting> waiting_;  // this and the marks are written before they are read
    std::uint64_t looked_into_[kMostRooms / 64], passed_[kMostRooms / 64];
};

}  // namespace firma
