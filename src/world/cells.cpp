// SPDX-License-Identifier: MIT
// Rooms and portals in persistent pieces.
#include "world/cells.h"

#include <algorithm>
#include <utility>

#include "base/hasher.h"
#include "geometry/exact_plane.h"
#include "index/edit_nodes.h"
#include "world/add_text.h"

namespace firma {
namespace {

PortalPolygon make_polygon(std::span<const GridPoint> corners, std::span<const Vec3> metres) {
    PortalPolygon polygon;
    polygon.shape = make_shape(metres);
    polygon.corners = corners;
    Box box;
    for (const Vec3& corner : metres) box.add(corner);
    for (int axis = 0; axis < 3; ++axis) {
        polygon.box.low[axis] = box.low[axis];
        polygon.box.high[axis] = box.high[axis];
    }
    return polygon;
}

/// Beside whether a portal is closed.
constexpr std::uint32_t kMadeBit = 2;

std::size_t text_bytes(const std::string& text) {
    return text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0;
}

}  // namespace

Portal::Portal(PortalPart from)
    : made_between(from.rooms),
      name(std::move(from.name)),
      material(from.material),
      mask(from.mask),
      made(from.made),
      exact_(std::move(from.exact)) {
    std::size_t count = 0;
    for (const std::vector<GridPoint>& polygon : from.polygons) count += polygon.size();
    corners_.reserve(count);
    metres_.reserve(count);
    polygons_.reserve(from.polygons.size());
    std::size_t at_polygon = 0;
    for (const std::vector<GridPoint>& polygon : from.polygons) {
        const std::size_t at = corners_.size();
        const bool own = !exact(at_polygon++);
        for (const GridPoint& corner : polygon) {
            corners_.push_back(corner);
            metres_.push_back(to_metres(corner));
            box.add(corner);
            is_exact_ = is_exact_ && (!own || on_input_grid(corner));
        }
        polygons_.push_back(
            make_polygon({corners_.data() + at, polygon.size()}, {metres_.data() + at, polygon.size()}));
    }
    leave_out_those_without_area();
}

void Portal::leave_out_those_without_area() {
    const auto lacks_area = [](const PortalPolygon& polygon) { return !polygon.shape.has_area(); };
    if (std::none_of(polygons_.begin(), polygons_.end(), lacks_area)) return;
    all_ = polygons_;
    std::erase_if(polygons_, lacks_area);
}

PortalPart Portal::part() const {
    PortalPart part;
    part.rooms = made_between;
    part.name = name;
    part.material = material;
    part.mask = mask;
    part.made = made;
    part.exact = exact_;
    for (const PortalPolygon& polygon : all_polygons())
        part.polygons.emplace_back(polygon.corners.begin(), polygon.corners.end());
    return part;
}

std::size_t Portal::bytes() const {
    std::size_t faces = 0;
    for (std::size_t k = 0; k < exact_.size(); ++k)
        if (exact_[k] && (k == 0 || exact_[k].get() != exact_[k - 1].get())) faces += exact_[k]->bytes();
    return faces + pool_size(sizeof *this) + text_bytes(name) +
           (polygons_.capacity() + all_.capacity()) * sizeof(PortalPolygon) +
           exact_.capacity() * sizeof(Ref<const SolidFace>) + corners_.capacity() * sizeof(GridPoint) +
           metres_.capacity() * sizeof(Vec3);
}

std::size_t bytes_of(const RoomRecord& record) {
    return sizeof record + text_bytes(record.name) + record.portals.capacity() * sizeof(PortalId) +
           record.portal_boxes.capacity() * sizeof(GridBox);
}

std::uint64_t Cells::hash_of_portal(std::uint32_t number) const {
    const PortalState& state = portals_[number];
    const Portal& portal = *state.portal;
    std::array<RoomId, 2> rooms = rooms_of(portal);
    for (RoomId& room : rooms)
        if (!portal.gone() && portals_of(room.value).size() > kCrowd) room = {0};
    Hasher hasher;
    hasher.add(number, std::uint32_t(state.closed) | (portal.made ? kMadeBit : 0));
    hasher.add(rooms[0].value, rooms[1].value);
    hasher.add(portal.material, portal.mask);
    add_text(hasher, portal.name);
    for (const PortalPolygon& polygon : portal.all_polygons()) {
        hasher.add(polygon.corners.size());
        for (const GridPoint& p : polygon.corners) {
            hasher.add(p.x, p.y);
            hasher.add(std::uint32_t(p.z));
        }
    }
    return hasher.value();
}

void Cells::set_room(std::uint32_t number, std::shared_ptr<const RoomRecord> record) {
    const std::uint32_t into = record->merged_into;
    if (record->exterior) exterior_ = number;
    rooms_.set(number, std::move(record));
    if (into != number) join(number, into);
}

/// Goes from a room to the root of those joined with it.
/// @return the root's entry
std::uint64_t Cells::find_root(std::uint32_t& room) const {
    for (;;) {
        const std::uint64_t* entry = joined_.find(room);
        if (!entry) return kRoot | room;
        if (*entry & kRoot) return *entry;
        room = std::uint32_t(*entry);
    }
}

std::uint32_t Cells::joined_room(std::uint32_t room) const {
    return std::uint32_t(find_root(room));
}

void Cells::join(std::uint32_t room, std::uint32_t into) {
    const std::uint64_t entry = find_root(room), entry_into = find_root(into);
    if (room == into) return;
    std::uint64_t rank = entry >> 32;  // and kRoot
    const std::uint64_t rank_into = entry_into >> 32;
    if (rank <= rank_into) {
        std::swap(room, into);
        rank = rank_into + (rank == rank_into);
    }
    joined_.set(into, room);
    joined_.set(room, rank << 32 | std::uint32_t(entry_into));
}

void Cells::set_portal(std::uint32_t number, Ref<const Portal> portal, bool closed) {
    if (portals_.find(number)) hash_ -= hash_of_portal(number);
    set_portal_between(number, std::move(portal), closed);
    hash_ += hash_of_portal(number);
}

void Cells::set_portal_between(std::uint32_t number, Ref<const Portal> portal, bool closed) {
    Ref<const Node> leaf;
    if (const PortalState* before = portals_.find(number)) {
        closed_ -= before->closed;
        leaf = before->leaf;
    }
    closed_ += closed;
    portals_.set(number, {std::move(portal), closed, std::move(leaf)});
}

void Cells::index_portals(std::span<const PortalId> portals) {
    NodeEdit edit(portal_index_);
    for (const PortalId id : portals) {
        PortalState state = portals_[id.value];
        if (state.leaf) edit.remove(state.leaf->facets.get(), state.leaf->box);
        state.leaf = {};
        if (!state.portal->gone()) {
            state.leaf = portal_leaf(id.value, state.portal->box);
            edit.add(state.leaf);
        }
        portals_.set(id.value, std::move(state));
    }
    while (edit.step()) {
    }
    portal_index_ = edit.result();
}

void Cells::set_portal_boxes(RoomRecord& record) const {
    record.portal_box = box_of(record.portals);
    record.portal_boxes.clear();
    record.portal_index = {};
    if (record.portals.size() <= kListed) {
        record.portal_boxes.reserve(record.portals.size());
        for (const PortalId id : record.portals) record.portal_boxes.push_back(portal(id.value).box);
        return;
    }
    std::vector<Ref<const Node>> leaves;
    leaves.reserve(record.portals.size());
    for (const PortalId id : record.portals) leaves.push_back(portals_[id.value].leaf);
    record.portal_index = join_nodes(leaves);
}

void Cells::set_portal_boxes(RoomRecord& record, const Cells& before, std::uint32_t room,
                             std::span<const PortalId> changed) const {
    const RoomRecord& old = before.room(room);
    if (record.portals.size() <= kListed || !old.portal_index) return set_portal_boxes(record);
    record.portal_box = box_of(record.portals);
    NodeEdit edit(old.portal_index);
    for (const PortalId id : changed) {
        if (std::binary_search(old.portals.begin(), old.portals.end(), id)) {
            const Ref<const Node>& leaf = before.portals_[id.value].leaf;
            edit.remove(leaf->facets.get(), leaf->box);
        }
        if (std::binary_search(record.portals.begin(), record.portals.end(), id)) edit.add(portals_[id.value].leaf);
    }
    while (edit.step()) {
    }
    record.portal_index = edit.result();
}

void Cells::take_out(std::span<const PortalId> portals) {
    for (const PortalId portal : portals) hash_ -= hash_of_portal(portal.value);
}

void Cells::put_in(std::span<const PortalId> portals) {
    for (const PortalId portal : portals) hash_ += hash_of_portal(portal.value);
}

}  // namespace firma
