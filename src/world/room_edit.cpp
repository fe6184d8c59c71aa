// SPDX-License-Identifier: MIT
// What a change to the solid does to rooms.
#include "world/room_edit.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"
#include "index/join_nodes.h"
#include "world/join_sheets.h"

namespace firma {
namespace {

template <class Corner>
double polygon_area(std::size_t count, const Corner& corner) {
    const Vec3 first = to_metres(corner(0));
    Vec3 twice{0, 0, 0};
    for (std::size_t k = 2; k < count; ++k)
        twice = twice + cross(to_metres(corner(k - 1)) - first, to_metres(corner(k)) - first);
    return length(twice) / 2;
}

double area_of(const FaceSet& set, const FaceSet::Entry& facet) {
    return polygon_area(facet.corner_count, [&](std::size_t k) { return set.corner(facet, k); });
}

/// A room that a pocket touches.
struct Touch {
    std::uint32_t room = 0;
    double area = 0;  ///< of its walls that went, square metres
};

void add_area(std::vector<Touch>& touches, std::uint32_t room, double area) {
    for (Touch& touch : touches)
        if (touch.room == room) {
            touch.area += area;
            return;
        }
    touches.push_back({room, area});
}

}  // namespace

void RoomEdit::take(std::uint32_t part) {
    TouchedRoom& room = touch(part);
    ++room.taken;
}

void RoomEdit::keep(std::uint32_t part) {
    touch(part).kept = true;
}

RoomEdit::TouchedRoom& RoomEdit::touch(std::uint32_t part) {
    const std::uint32_t room = before_.cells.current_room(part);
    std::uint32_t& known = known_.at(room);
    if (known == FlatMap::kNone) {
        known = std::uint32_t(rooms_.size());
        rooms_.push_back({room, 0, false});
    }
    return rooms_[known];
}

/// Whether a carving took all of a room's walls, and no portal leads out of it: a cavity that is no more.
bool RoomEdit::is_swallowed(const TouchedRoom& room) const {
    const Cells& cells = before_.cells;
    if (room.kept || room.taken == 0 || cells.room(room.room).exterior || !cells.portals_of(room.room).empty())
        return false;
    std::size_t solid = 0;
    const auto count = [&](const auto& self, const Node& node) -> bool {
        if (!node.is_leaf())
            return std::all_of(node.children.begin(), node.children.end(),
                               [&](const Ref<const Node>& child) { return self(self, *child); });
        for (const FaceRecord& face : block_of(node).faces) solid += face.solid;
        return solid <= room.taken;
    };
    return count(count, *before_.faces_of(room.room).tree) && solid == room.taken;
}

void RoomEdit::open(const CutOpening& opening, std::optional<std::uint32_t> shot_from, FaceSet& added) {
    if (opening.air) shot_from = opening.air;
    if (shot_from) shot_from = target_of(*shot_from);
    std::vector<std::uint32_t> swallowed;
    for (const TouchedRoom& room : rooms_)
        if (is_swallowed(room)) swallowed.push_back(room.room);
    std::vector<std::vector<Touch>> touches(opening.pockets);
    for (std::size_t k = 0; k < opening.taken.faces.size(); ++k) {
        const FaceSet::Entry& facet = opening.taken.faces[k];
        add_area(touches[opening.of_taken[k]], target_of(before_.cells.current_room(facet.part)),
                 area_of(opening.taken, facet));
    }
    std::vector<std::uint32_t> room_of_pocket;
    for (const std::vector<Touch>& of_pocket : touches) {
        const Touch* best = nullptr;
        const auto is_cavity = [&](const Touch& touch) {
            return std::find(swallowed.begin(), swallowed.end(), touch.room) != swallowed.end();
        };
        const auto comes_before = [&](const Touch& a, const Touch& b) {
            if (is_cavity(a) != is_cavity(b)) return is_cavity(b);
            if ((shot_from == a.room) != (shot_from == b.room)) return shot_from == a.room;
            return a.area != b.area ? a.area > b.area : a.room < b.room;
        };
        for (const Touch& touch : of_pocket)
            if (!best || comes_before(touch, *best)) best = &touch;
        const std::uint32_t room = opening.air ? *shot_from : best ? best->room : add_new();
        room_of_pocket.push_back(room);
        for (const Touch& touch : of_pocket)
            if (is_cavity(touch) && touch.room != room) merge(touch.room, room);
    }
    for (std::size_t k = 0; k < added.faces.size(); ++k)
        if (opening.of_added[k] != Pockets::kNone) added.faces[k].part = room_of_pocket[opening.of_added[k]];
    take_walls(opening, room_of_pocket);
}

/// What went of other rooms' walls becomes portals: one for each pocket and room, but for what lies beside an open one
/// that an edit made between the same rooms.
void RoomEdit::take_walls(const CutOpening& opening, const std::vector<std::uint32_t>& room_of_pocket) {
    struct Wall {
        std::uint32_t pocket, room, facet;  ///< the first of one face
    };
    const std::vector<FaceSet::Entry>& facets = opening.taken.faces;
    std::vector<Wall> walls;
    for (std::uint32_t k = 0; k < facets.size(); ++k) {
        if (k > 0 && facets[k].owner == facets[k - 1].owner) continue;
        const std::uint32_t room = target_of(before_.cells.current_room(facets[k].part));
        if (room != target_of(room_of_pocket[opening.of_taken[k]])) walls.push_back({opening.of_taken[k], room, k});
    }
    sort_range(walls, [](const Wall& a, const Wall& b) {
        return a.pocket != b.pocket ? a.pocket < b.pocket : a.room != b.room ? a.room < b.room : a.facet < b.facet;
    });
    for (std::size_t first = 0, end = 0; first < walls.size(); first = end) {
        std::vector<Ref<const SolidFace>> sheets;
        for (; end < walls.size() && walls[end].pocket == walls[first].pocket && walls[end].room == walls[first].room;
             ++end)
            sheets.emplace_back(static_cast<const SolidFace*>(facets[walls[end].facet].owner));
        PortalPart part;
        part.rooms = {RoomId{walls[first].room}, RoomId{target_of(room_of_pocket[walls[first].pocket])}};
        part.material = facets[walls[first].facet].material;
        part.made = true;
        add_portal(std::move(part), std::move(sheets));
    }
}

const PortalState& RoomEdit::portal_now(std::uint32_t number) const {
    for (const PortalChange& change : portals_)
        if (change.number == number) return change.state;
    return *before_.cells.portals().find(number);
}

/// Open portals of edits that lead from one room to another, as they are turned, and meet a box.
std::vector<std::uint32_t> RoomEdit::made_portals(const std::array<RoomId, 2>& rooms, const GridBox& box) const {
    std::vector<std::uint32_t> found;
    before_.cells.for_each_portal_where(
        [&](const GridBox& other) { return boxes_meet(box, other); },
        [&](std::uint32_t number, const Portal& portal) {
            if (!portal.made || !portal.is_exact() || before_.cells.is_closed(number)) return;
            const auto now = before_.cells.rooms_of(portal);
            if (target_of(now[0].value) == rooms[0].value && target_of(now[1].value) == rooms[1].value)
                found.push_back(number);
        });
    for (const PortalChange& change : portals_) {
        const Portal& portal = *change.state.portal;
        if (change.number >= before_.cells.portal_count() && portal.made_between == rooms &&
            boxes_meet(portal.box, box))
            found.push_back(change.number);
    }
    sort_range(found);
    return found;
}

/// Sheets beside those of portals that are there become one with them.
void RoomEdit::add_portal(PortalPart part, std::vector<Ref<const SolidFace>> sheets) {
    GridBox box;
    for (const Ref<const SolidFace>& sheet : sheets) box.add(sheet->box);
    const std::uint32_t none = ~0u;
    std::vector<std::uint32_t> portal_of(sheets.size(), none);
    for (const std::uint32_t number : made_portals(part.rooms, box)) {
        const Portal& portal = *portal_now(number).portal;
        for (std::size_t k = 0; k < portal.all_polygons().size(); ++k) {
            if (k > 0 && portal.exact(k) == portal.exact(k - 1)) continue;
            sheets.emplace_back(portal.exact(k));
            portal_of.push_back(number);
        }
    }
    const std::vector<JoinedSheet> joined = join_sheets(sheets);
    std::vector<std::uint32_t> changed;
    const auto owner = [&](const JoinedSheet& sheet) {
        std::uint32_t lowest = none;
        for (const std::uint32_t member : sheet.members) lowest = std::min(lowest, portal_of[member]);
        return lowest;
    };
    for (const JoinedSheet& sheet : joined)
        if (sheet.members.size() > 1)
            for (const std::uint32_t member : sheet.members)
                if (portal_of[member] != none) changed.push_back(portal_of[member]);
    sort_once(changed);
    const auto fill = [&](PortalPart& into, std::uint32_t number) {
        for (const JoinedSheet& sheet : joined) {
            if (owner(sheet) != number) continue;
            const SolidFace& first = *sheets[sheet.members[0]];
            if (sheet.members.size() == 1)
                sheets_.add(first.plane, first.uses, first.loop_ends(), into);
            else
                sheets_.add(first.plane, sheet.uses, sheet.ends, into);
        }
    };
    for (const std::uint32_t number : changed) {
        PortalPart again = portal_now(number).portal->part();
        again.polygons.clear();
        again.exact.clear();
        fill(again, number);
        set_portal(number, Ref<const Portal>(new Portal(std::move(again))), false);
    }
    fill(part, none);
    if (part.polygons.empty()) return;
    set_portal(before_.cells.portal_count() + new_portals_++, Ref<const Portal>(new Portal(std::move(part))), false);
}

namespace {

/// Areas are summed up as whole numbers: so that their order does not matter.
constexpr double kAreaUnits = double(1 << 24);  // a square metre

std::int64_t in_units(double area) {
    return std::int64_t(area * kAreaUnits + 0.5);
}

std::int64_t area_of(const Portal& portal) {
    std::int64_t sum = 0;
    for (const PortalPolygon& polygon : portal.polygons())
        sum += in_units(polygon_area(polygon.corners.size(), [&](std::size_t k) { return polygon.corners[k]; }));
    return sum;
}

std::int64_t walls_of(const Node* tree) {
    std::int64_t sum = 0;
    if (tree)
        for_each_block(*tree, [&](const Block& block) {
            for (const FaceRecord& face : block.faces)
                if (face.solid)
                    sum +=
                        in_units(polygon_area(face.corner_count, [&](std::size_t k) { return block.corner(face, k); }));
        });
    return sum;
}

}  // namespace

/// As the edit has them so far.
std::vector<std::uint32_t> RoomEdit::portals_between(std::uint32_t room, std::uint32_t other) const {
    std::vector<std::uint32_t> found;
    const auto add = [&](std::uint32_t number, std::array<RoomId, 2> rooms) {
        for (RoomId& it : rooms) it = {target_of(it.value)};
        if (portal_now(number).portal->gone() || rooms[0] == rooms[1]) return;
        for (const RoomId it : rooms)
            if (it.value != room && it.value != other) return;
        found.push_back(number);
    };
    const auto add_of = [&](std::uint32_t from) {
        for (const PortalId id : before_.cells.portals_of(from))
            add(id.value, before_.cells.rooms_of(before_.cells.portal(id.value)));
    };
    add_of(room);
    for (const TouchedRoom& from : rooms_)
        if (target_of(from.room) == room) add_of(from.room);
    for (const PortalChange& change : portals_)
        if (change.number >= before_.cells.portal_count()) add(change.number, change.state.portal->made_between);
    sort_once(found);
    return found;
}

/// Walls as they were before the edit.
void RoomEdit::merge_by_share(double share) {
    if (!(share > 0)) return;
    const std::vector<PortalChange> changed = portals_;
    for (const PortalChange& change : changed) {
        if (!change.state.portal->made) continue;
        const auto& between = change.state.portal->made_between;
        const auto now = [&](RoomId room) {
            return target_of(room.value < before_.cells.room_count() ? before_.cells.current_room(room.value)
                                                                     : room.value);
        };
        const std::uint32_t one = now(between[0]), other = now(between[1]);
        if (one == other || one >= before_.cells.room_count() || other >= before_.cells.room_count()) continue;
        std::int64_t open = 0;
        bool closed = false;
        for (const std::uint32_t number : portals_between(one, other)) {
            const PortalState& state = portal_now(number);
            closed |= state.closed;
            if (state.portal->made) open += area_of(*state.portal);
        }
        const std::int64_t walls =
            std::min(walls_of(before_.faces_of(one).tree.get()), walls_of(before_.faces_of(other).tree.get()));
        if (closed || !(double(open) > share * double(walls))) continue;
        for (const std::uint32_t room : {one, other}) touch(room);
        merge_into_lower(one, other);
    }
}

void RoomEdit::divide_portals(CutJob& cut) {
    if (cut.divided_box() == GridBox{}) return;
    std::vector<std::uint32_t> near;
    const GridBox& around = cut.divided_box();
    before_.cells.for_each_portal_where([&](const GridBox& box) { return boxes_meet(box, around); },
                                        [&](std::uint32_t number, const Portal&) { near.push_back(number); });
    sort_range(near);
    for (const std::uint32_t number : near) {
        const Portal& portal = before_.cells.portal(number);
        if (!portal.is_exact()) {
            merge_portal(portal);
            continue;
        }
        if (std::optional<PortalPart> divided = divide_portal(portal, cut, sheets_)) {
            touch_both(portal);  // one that has but portals at the edge lost no face
            set_portal(number, Ref<const Portal>(new Portal(*std::move(divided))), before_.cells.is_closed(number));
        }
    }
}

void RoomEdit::clip_portals(CutJob& cut) {
    std::vector<std::uint32_t> changed;
    const std::vector<CutSheet> left = cut.sheets_left(changed);
    sort_once(changed);
    for (const std::uint32_t number : changed) {
        PortalPart part = before_.cells.portal(number).part();
        part.polygons.clear();
        part.exact.clear();
        for (const CutSheet& sheet : left)
            if (sheet.portal == number) sheets_.add(sheet.plane, sheet.uses, sheet.ends, part);
        const bool closed = !part.polygons.empty() && before_.cells.is_closed(number);
        touch_both(before_.cells.portal(number));
        set_portal(number, Ref<const Portal>(new Portal(std::move(part))), closed);
    }
}

/// Rooms of a portal that changes: each keeps its box, or an index over it and others.
void RoomEdit::touch_both(const Portal& portal) {
    for (const RoomId room : before_.cells.rooms_of(portal)) touch(room.value);
}

void RoomEdit::merge_portal(const Portal& portal) {
    const auto rooms = before_.cells.rooms_of(portal);
    touch_both(portal);
    merge_into_lower(rooms[0].value, rooms[1].value);
}

void RoomEdit::merge_at_portals(const GridBox& box, const std::vector<std::uint32_t>& others) {
    std::vector<std::uint32_t> rooms = others;
    before_.cells.for_each_portal_where([&](const GridBox& other) { return boxes_meet(box, other); },
                                        [&](std::uint32_t, const Portal& portal) {
                                            for (const PortalPolygon& polygon : portal.all_polygons()) {
                                                GridBox own;
                                                for (const GridPoint& corner : polygon.corners) own.add(corner);
                                                if (!boxes_meet(box, own)) continue;
                                                for (const RoomId room : before_.cells.rooms_of(portal))
                                                    rooms.push_back(room.value);
                                            }
                                        });
    sort_once(rooms);
    for (const std::uint32_t room : rooms) {
        touch(room);
        merge_into_lower(room, rooms[0]);
    }
}

void RoomEdit::merge_into_lower(std::uint32_t room, std::uint32_t other) {
    room = target_of(room);
    other = target_of(other);
    merge(std::max(room, other), std::min(room, other));
}

void RoomEdit::merge(std::uint32_t room, std::uint32_t into) {
    room = target_of(room);
    into = target_of(into);
    if (room != into) merged_.emplace_back(room, into);
}

std::uint32_t RoomEdit::target_of(std::uint32_t room) const {
    for (bool found = true; found;) {
        found = false;
        for (const auto& [from, into] : merged_)
            if (from == room) {
                room = into;
                found = true;
            }
    }
    return room;
}

void RoomEdit::set_portal(std::uint32_t number, Ref<const Portal> portal, bool closed) {
    for (PortalChange& change : portals_)
        if (change.number == number) {
            change.state.portal = std::move(portal);
            change.state.closed = closed;
            return;
        }
    portals_.push_back({number, {std::move(portal), closed, {}}});
}

RoomEdit::Target& RoomEdit::target(std::uint32_t room) {
    const auto found = std::find_if(targets_.begin(), targets_.end(), [&](const Target& t) { return t.room == room; });
    if (found != targets_.end()) return *found;
    return targets_.emplace_back(Target{room, {}, {}, kNone});
}

/// With nothing but the solid in one room, both are one index.
bool RoomEdit::shares_the_solids_index() const {
    return sum_of_rooms_ == 1 && before_.faces_of(0).tree.get() == before_.solid.data().faces.root.get();
}

void RoomEdit::start(const SolidEdit& solid, const StoreEdit* open) {
    solid_ = &solid;
    open_ = open;
    targets_.clear();
    edits_.clear();
    next_edit_ = 0;
    sort_range(rooms_, [](const TouchedRoom& a, const TouchedRoom& b) { return a.room < b.room; });
    for (const TouchedRoom& room : rooms_) target(target_of(room.room)).from.push_back(room.room);
    for (std::uint32_t room = before_.cells.room_count(); room < sum_of_rooms_; ++room) target(room);
    end_portals_within();
    sort_range(portals_, [](const PortalChange& a, const PortalChange& b) { return a.number < b.number; });
    if (shares_the_solids_index()) {
        for (Target& it : targets_) it.index = solid.result().data().faces.root;
        return;
    }
    for (Target& it : targets_) {
        std::vector<Ref<const Node>> indices;
        for (const std::uint32_t room : it.from)
            if (const Ref<const Node>& tree = before_.faces_of(room).tree) indices.push_back(tree);
        it.edit = edits_.size();
        edits_.emplace_back(join_opened(indices));
    }
    for (const StoreEdit* store : {&solid.store(), open}) {
        if (!store) continue;
        for (const Block* block : store->removed())
            edits_[target(target_of_part(block->part)).edit].remove(block, block->box());
        for (const Ref<const Node>& leaf : store->added())
            edits_[target(target_of_part(block_of(*leaf).part)).edit].add(leaf);
    }
}

std::size_t RoomEdit::portals_made() const {
    return std::size_t(std::count_if(portals_.begin(), portals_.end(), [&](const PortalChange& change) {
        return change.number >= before_.cells.portal_count();
    }));
}

std::uint32_t RoomEdit::target_of_part(std::uint32_t part) const {
    return target_of(part < before_.cells.room_count() ? before_.cells.current_room(part) : part);
}

bool RoomEdit::step() {
    if (next_edit_ == edits_.size()) return false;
    if (!edits_[next_edit_].step()) ++next_edit_;
    return next_edit_ < edits_.size();
}

namespace {

/// The room with the most portals.
std::uint32_t largest_of(const std::vector<std::uint32_t>& rooms, const Cells& cells) {
    std::uint32_t largest = rooms[0];
    for (const std::uint32_t room : rooms)
        if (cells.portals_of(room).size() > cells.portals_of(largest).size()) largest = room;
    return largest;
}

}  // namespace

/// Portals between rooms that become one are gone: they are looked for in all of these rooms but the one of the most.
void RoomEdit::end_portals_within() {
    const Cells& cells = before_.cells;
    std::erase_if(portals_, [&](const PortalChange& change) {
        const auto& rooms = change.state.portal->made_between;
        return change.number >= cells.portal_count() && target_of(rooms[0].value) == target_of(rooms[1].value);
    });
    std::uint32_t next = cells.portal_count();
    for (PortalChange& change : portals_)
        if (change.number >= cells.portal_count()) change.number = next++;
    for (const Target& it : targets_) {
        if (it.from.size() < 2) continue;
        const std::uint32_t largest = largest_of(it.from, cells);
        for (const std::uint32_t room : it.from) {
            if (room == largest) continue;
            for (const PortalId id : cells.portals_of(room)) {
                const Portal& portal = cells.portal(id.value);
                const std::array<RoomId, 2> rooms = cells.rooms_of(portal);
                if (target_of(rooms[0].value) != target_of(rooms[1].value)) continue;
                PortalPart gone;
                gone.rooms = {RoomId{it.room}, RoomId{it.room}};
                gone.name = portal.name;
                gone.material = portal.material;
                gone.mask = portal.mask;
                gone.made = portal.made;
                set_portal(id.value, Ref<const Portal>(new Portal(std::move(gone))), false);
            }
        }
    }
}

/// The list of portals of a room after the edit.
std::vector<PortalId> RoomEdit::portals_after(const Target& it) const {
    std::vector<PortalId> list;
    for (const std::uint32_t room : it.from) {
        const auto own = before_.cells.portals_of(room);
        list.insert(list.end(), own.begin(), own.end());
    }
    if (it.from.size() > 1) sort_once(list);
    for (const PortalChange& change : portals_) {
        if (change.state.portal->gone()) {
            std::erase(list, PortalId{change.number});
        } else if (change.number >= before_.cells.portal_count()) {
            for (const RoomId room : change.state.portal->made_between)
                if (target_of(room.value) == it.room) list.push_back({change.number});
        }
    }
    return list;
}

/// Portals of before whose terms of the hash may change, where a room's list does.
void RoomEdit::add_affected(const Target& it, std::size_t portals_after, std::vector<PortalId>& affected) const {
    const Cells& cells = before_.cells;
    if (it.from.empty()) return;
    const std::uint32_t largest = largest_of(it.from, cells);
    const auto add = [&](std::uint32_t room) {
        const auto own = cells.portals_of(room);
        affected.insert(affected.end(), own.begin(), own.end());
    };
    for (const std::uint32_t room : it.from)
        if (room != largest) add(room);
    const bool was_crowd = cells.portals_of(largest).size() > Cells::kCrowd, is_crowd = portals_after > Cells::kCrowd;
    const bool names_change = it.from.size() > 1 || largest != it.room;
    if (was_crowd != is_crowd || (names_change && !is_crowd)) add(largest);
}

void RoomEdit::publish(WorldData& next) const {
    std::vector<std::vector<PortalId>> lists;
    std::vector<PortalId> affected, changed;
    for (const Target& it : targets_) {
        lists.push_back(portals_after(it));
        add_affected(it, lists.back().size(), affected);
    }
    for (const PortalChange& change : portals_) {
        changed.push_back({change.number});
        if (change.number < before_.cells.portal_count()) affected.push_back({change.number});
    }
    sort_once(affected);
    next.cells.take_out(affected);
    for (const PortalChange& change : portals_)
        next.cells.set_portal_between(change.number, change.state.portal, change.state.closed);
    if (!changed.empty()) next.cells.index_portals(changed);
    for (std::size_t k = 0; k < targets_.size(); ++k) publish(targets_[k], std::move(lists[k]), changed, next);
    for (const PortalChange& change : portals_)
        if (change.number >= before_.cells.portal_count()) affected.push_back({change.number});
    next.cells.put_in(affected);
}

void RoomEdit::publish(const Target& it, std::vector<PortalId> portals, std::span<const PortalId> changed,
                       WorldData& next) const {
    const Cells& cells = before_.cells;
    Ref<RoomFaces> made(new RoomFaces);
    made->tree = it.edit == kNone ? it.index : edits_[it.edit].result();
    bool exterior = false;
    for (const std::uint32_t room : it.from) {
        made->count += before_.faces_of(room).count;
        made->hash += before_.faces_of(room).hash;
        exterior |= cells.room(room).exterior;
    }
    for (const StoreEdit* store : {&solid_->store(), open_}) {
        if (!store) continue;
        for (const PartChange& change : store->parts()) {
            if (target_of_part(change.part) != it.room) continue;
            made->count += std::size_t(change.faces);
            made->hash += change.hash;
        }
    }
    for (const std::uint32_t room : it.from) {
        if (room == it.room) continue;
        next.set_room(
            room, std::make_shared<const RoomRecord>(RoomRecord{cells.room(room).name, false, it.room, {}, {}, {}, {}}),
            Ref<const RoomFaces>(new RoomFaces));
    }
    const bool is_old = it.from.size() == 1 && it.from[0] == it.room;
    const auto has_changed = [&](PortalId id) { return std::binary_search(portals.begin(), portals.end(), id); };
    if (is_old && std::ranges::equal(cells.portals_of(it.room), portals) &&
        std::none_of(changed.begin(), changed.end(), has_changed)) {
        next.set_room(it.room, cells.record(it.room), Ref<const RoomFaces>(made.get()));
        return;
    }
    RoomRecord record;
    record.merged_into = it.room;
    record.exterior = exterior;
    if (it.room < cells.room_count()) record.name = cells.room(it.room).name;
    record.portals = std::move(portals);
    if (it.from.empty()) {
        next.cells.set_portal_boxes(record);
    } else {
        const std::uint32_t largest = largest_of(it.from, cells);
        std::vector<PortalId> others(changed.begin(), changed.end());
        for (const std::uint32_t room : it.from)
            if (room != largest)
                others.insert(others.end(), cells.portals_of(room).begin(), cells.portals_of(room).end());
        sort_once(others);
        next.cells.set_portal_boxes(record, cells, largest, others);
    }
    next.set_room(it.room, std::make_shared<const RoomRecord>(std::move(record)), Ref<const RoomFaces>(made.get()));
}

}  // namespace firma
