// SPDX-License-Identifier: MIT
// What a change to the solid does to rooms: whose air the new air is, which portals come of it, and the cells after it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "carve/cut_job.h"
#include "index/edit_nodes.h"
#include "solid/change_solid.h"
#include "world/portal_sheets.h"
#include "world/world_data.h"

namespace firma {

/// Rooms stay apart. What a carving opens goes to one of the rooms that it touches; where it took walls of others,
/// portals lead there. In a world of one room without a name all of this says "room 0".
class RoomEdit {
public:
    /// @param before  kept alive by the caller, as is all that is given here
    explicit RoomEdit(const WorldData& before) : before_(before), sum_of_rooms_(before.cells.room_count()) {}

    /// A room of which a face goes.
    void take(std::uint32_t part);
    /// A room of which a piece of such a face comes back.
    void keep(std::uint32_t part);
    /// A room that what comes is part of.
    void add_to(std::uint32_t room) { touch(room); }
    /// A room that was not there.
    std::uint32_t add_new() { return sum_of_rooms_++; }

    /// Of a carving that may open several rooms: decides whose air each pocket is, and makes portals of the walls of
    /// others.
    /// @param opening   CutOpening::pockets is above 0
    /// @param shot_from the room that it was made from, if that is known: it comes before others
    /// @param added     gets the parts of the cutter's faces
    void open(const CutOpening& opening, std::optional<std::uint32_t> shot_from, FaceSet& added);
    /// Once portals are made: rooms become one by CarveRules::merge_share.
    void merge_by_share(double share);
    /// A carving divided edges that portals end at: they are divided likewise.
    void divide_portals(CutJob& cut);
    /// Of a fill that met portals (CutJob::clipped()): they lose what it filled.
    void clip_portals(CutJob& cut);
    /// Of a fill of which it is not known what it does to portals: both rooms of each portal that meets a box, and
    /// others that are given, become one.
    void merge_at_portals(const GridBox& box, const std::vector<std::uint32_t>& others);

    /// How many there are anew; once start() was called.
    std::size_t portals_made() const;
    std::size_t rooms_made() const { return sum_of_rooms_ - before_.cells.room_count(); }

    /// Begins to edit the indices of the rooms.
    /// @param open  what is castable only, where that changes; else null
    void start(const SolidEdit& solid, const StoreEdit* open);
    /// Does one piece of work; false once there is none left.
    bool step();

    /// Once step() said false: puts the cells after the edit in place.
    void publish(WorldData& next) const;

private:
    struct TouchedRoom {
        std::uint32_t room = 0;
        std::size_t taken = 0;  ///< facets of it that go
        bool kept = false;      ///< pieces of some come back
    };
    struct PortalChange {
        std::uint32_t number = 0;
        PortalState state;
    };
    /// A room after the edit, and those that become part of it.
    struct Target {
        std::uint32_t room = 0;
        std::vector<std::uint32_t> from;  ///< ascending, itself among them unless it is new
        Ref<const Node> index;            ///< without an edit: that of the solid
        std::size_t edit = 0;             ///< in edits_, or kNone
    };
    static constexpr std::size_t kNone = ~std::size_t(0);

    TouchedRoom& touch(std::uint32_t part);
    void touch_both(const Portal& portal);
    bool shares_the_solids_index() const;
    void take_walls(const CutOpening& opening, const std::vector<std::uint32_t>& room_of_pocket);
    std::vector<std::uint32_t> portals_between(std::uint32_t room, std::uint32_t other) const;
    const PortalState& portal_now(std::uint32_t number) const;
    std::vector<std::uint32_t> made_portals(const std::array<RoomId, 2>& rooms, const GridBox& box) const;
    void add_portal(PortalPart part, std::vector<Ref<const SolidFace>> sheets);
    bool is_swallowed(const TouchedRoom& room) const;
    void merge(std::uint32_t room, std::uint32_t into);
    void merge_into_lower(std::uint32_t room, std::uint32_t other);
    void merge_portal(const Portal& portal);
    std::uint32_t target_of(std::uint32_t room) const;
    std::uint32_t target_of_part(std::uint32_t part) const;
    Target& target(std::uint32_t room);
    void set_portal(std::uint32_t number, Ref<const Portal> portal, bool closed);
    void end_portals_within();
    std::vector<PortalId> portals_after(const Target& it) const;
    void add_affected(const Target& it, std::size_t portals_after, std::vector<PortalId>& affected) const;
    void publish(const Target& it, std::vector<PortalId> portals, std::span<const PortalId> changed,
                 WorldData& next) const;

    const WorldData& before_;
    std::uint32_t sum_of_rooms_;                                   ///< those that are new counted
    std::vector<TouchedRoom> rooms_;                               ///< each once; ascending from start() on
    FlatMap known_;                                                ///< those that are among them
    std::vector<std::pair<std::uint32_t, std::uint32_t>> merged_;  ///< rooms, into which
    std::vector<PortalChange> portals_;                            ///< ascending from start() on
    std::uint32_t new_portals_ = 0;                                ///< numbers given to some
    SheetMaker sheets_;
    std::vector<Target> targets_;
    std::vector<NodeEdit> edits_;
    std::size_t next_edit_ = 0;
    const SolidEdit* solid_ = nullptr;
    const StoreEdit* open_ = nullptr;
};

}  // namespace firma
