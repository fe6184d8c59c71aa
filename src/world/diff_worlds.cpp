// SPDX-License-Identifier: MIT
// What changed between two worlds: first the blocks that only one of them has, then the faces in those.
#include "firma/diff_worlds.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/grid_box.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// A block, and the room that it is of.
struct BlockOfRoom {
    const Block* block;
    RoomId room;
};

bool by_address(const BlockOfRoom& a, const BlockOfRoom& b) {
    return std::less<const Block*>()(a.block, b.block);
}

/// Blocks to look at, the one with most faces first.
class Waiting {
public:
    void add(const BlockOfRoom& block) {
        blocks_.push_back(block);
        std::push_heap(blocks_.begin(), blocks_.end(), fewer);
    }
    std::uint32_t most() const { return blocks_.empty() ? 0 : blocks_[0].block->faces_below; }

    /// Takes out all of so many faces, in order of address: for comparing with another such list, and nothing else.
    std::vector<BlockOfRoom> take(std::uint32_t faces) {
        std::vector<BlockOfRoom> taken;
        while (most() == faces) {
            std::pop_heap(blocks_.begin(), blocks_.end(), fewer);
            taken.push_back(blocks_.back());
            blocks_.pop_back();
        }
        std::sort(taken.begin(), taken.end(), by_address);
        return taken;
    }

private:
    static bool fewer(const BlockOfRoom& a, const BlockOfRoom& b) {
        return a.block->faces_below < b.block->faces_below;
    }

    std::vector<BlockOfRoom> blocks_;
};

struct Slot {
    FaceId id;
    std::uint32_t slot;
    const Block* block;
    RoomId room;

    const FaceRecord& face() const { return block->faces[slot]; }
};

/// Opens blocks that the other world does not have.
void open(const std::vector<BlockOfRoom>& mine, const std::vector<BlockOfRoom>& others, Waiting& waiting,
          std::vector<Slot>& slots) {
    for (const BlockOfRoom& it : mine) {
        if (std::binary_search(others.begin(), others.end(), it, by_address)) continue;
        for (const Ref<const Block>& child : it.block->children) waiting.add({child.get(), it.room});
        for (std::uint32_t slot = 0; slot < it.block->faces.size(); ++slot)
            slots.push_back({it.block->faces[slot].id, slot, it.block, it.room});
    }
}

/// Faces in blocks that only one of two worlds has. A block has more faces than any below it: when those of so many
/// faces are compared, all of them are at hand, whatever level they stand at.
void find_unshared(Waiting& old_blocks, Waiting& new_blocks, std::vector<Slot>& old_faces,
                   std::vector<Slot>& new_faces) {
    while (const std::uint32_t most = std::max(old_blocks.most(), new_blocks.most())) {
        const std::vector<BlockOfRoom> olds = old_blocks.take(most), news = new_blocks.take(most);
        open(olds, news, old_blocks, old_faces);
        open(news, olds, new_blocks, new_faces);
    }
}

const Room* room_at(const WorldData& data, std::uint32_t room) {
    return room < data.rooms.size() ? data.rooms[room].get() : nullptr;
}

std::uint32_t merged_into(const WorldData& data, std::uint32_t room) {
    return data.room_records ? (*data.room_records)[room].merged_into : room;
}

/// Null for none, and for one that is gone.
const Portal* portal_at(const WorldData& data, std::uint32_t portal) {
    if (!data.portals || portal >= data.portals->portals().size()) return nullptr;
    const Portal& it = data.portals->portals()[portal];
    return it.gone() ? nullptr : &it;
}

bool is_closed(const WorldData& data, std::uint32_t portal) {
    return data.closed && data.closed->is_closed[portal];
}

bool same(const PortalSet& a, const Portal& one, const PortalSet& b, const Portal& two) {
    if (one.rooms != two.rooms || one.name != two.name || one.material != two.material || one.mask != two.mask)
        return false;
    const auto polygons = a.polygons_of(one), others = b.polygons_of(two);
    return std::equal(polygons.begin(), polygons.end(), others.begin(), others.end(),
                      [](const PortalPolygon& p, const PortalPolygon& q) {
                          return std::equal(p.corners.begin(), p.corners.end(), q.corners.begin(), q.corners.end());
                      });
}

bool same(const Slot& a, const Slot& b) {
    const FaceRecord &f = a.face(), &g = b.face();
    if (f.source != g.source || f.edit != g.edit || f.material != g.material || f.mask != g.mask ||
        f.two_sided != g.two_sided || f.solid != g.solid || f.corner_count != g.corner_count)
        return false;
    for (std::size_t k = 0; k < f.corner_count; ++k)
        if (a.block->corner(f, k) != b.block->corner(g, k)) return false;
    return true;
}

class Differ {
public:
    explicit Differ(double tile_size) : tile_size_(tile_size) {}

    void compare(const WorldData& before, const WorldData& after) {
        compare_faces(before, after);
        compare_rooms(before, after);
        compare_portals(before, after);
    }

    WorldDiff result() {
        for (std::vector<ChangedFace>* faces : {&diff_.gone, &diff_.come})
            std::sort(faces->begin(), faces->end(), [](const ChangedFace& a, const ChangedFace& b) {
                return a.id != b.id ? a.id < b.id : a.room < b.room;
            });
        std::sort(diff_.rooms.begin(), diff_.rooms.end());
        diff_.rooms.erase(std::unique(diff_.rooms.begin(), diff_.rooms.end()), diff_.rooms.end());
        sort_tiles();
        return std::move(diff_);
    }

private:
    void compare_faces(const WorldData& before, const WorldData& after) {
        Waiting old_blocks, new_blocks;
        for (std::uint32_t room = 0; room < std::max(before.rooms.size(), after.rooms.size()); ++room) {
            const Room *old_room = room_at(before, room), *new_room = room_at(after, room);
            const Block* old_tree = old_room ? old_room->tree.get() : nullptr;
            const Block* new_tree = new_room ? new_room->tree.get() : nullptr;
            if (old_tree == new_tree) continue;
            if (old_tree) old_blocks.add({old_tree, {room}});
            if (new_tree) new_blocks.add({new_tree, {room}});
        }
        std::vector<Slot> olds, news;
        find_unshared(old_blocks, new_blocks, olds, news);
        const auto by_id = [](const Slot& a, const Slot& b) { return a.id < b.id; };
        std::sort(olds.begin(), olds.end(), by_id);
        std::sort(news.begin(), news.end(), by_id);
        auto come = news.begin();
        for (const Slot& gone : olds) {
            while (come != news.end() && come->id < gone.id) add(*come++, diff_.come);
            const bool match = come != news.end() && come->id == gone.id;
            if (match && same(gone, *come)) {
                ++come;
                continue;
            }
            add(gone, diff_.gone);
            if (match) add(*come++, diff_.come);
        }
        while (come != news.end()) add(*come++, diff_.come);
    }

    void compare_rooms(const WorldData& before, const WorldData& after) {
        for (std::uint32_t room = 0; room < std::max(before.rooms.size(), after.rooms.size()); ++room) {
            const bool in_both = room_at(before, room) && room_at(after, room);
            if (!in_both || merged_into(before, room) != merged_into(after, room)) diff_.rooms.push_back({room});
        }
    }

    void compare_portals(const WorldData& before, const WorldData& after) {
        if (before.portals == after.portals && before.closed == after.closed) return;
        const auto count = [](const WorldData& data) { return data.portals ? data.portals->portals().size() : 0; };
        for (std::uint32_t k = 0; k < std::max(count(before), count(after)); ++k) {
            const Portal *one = portal_at(before, k), *two = portal_at(after, k);
            if (!one && !two) continue;
            if (!one) add({k}, *two, diff_.portals_come);
            if (!two) add({k}, *one, diff_.portals_gone);
            if (!one || !two) continue;
            if (is_closed(before, k) != is_closed(after, k))
                add({k}, *two, is_closed(after, k) ? diff_.closed : diff_.opened);
            if (before.portals == after.portals || same(*before.portals, *one, *after.portals, *two)) continue;
            add({k}, *one, diff_.portals_changed);
            add_box(two->box);
        }
    }

    void add(PortalId id, const Portal& portal, std::vector<PortalId>& portals) {
        portals.push_back(id);
        add_box(portal.box);
    }

    void add(const Slot& slot, std::vector<ChangedFace>& faces) {
        const FaceRecord& face = slot.face();
        faces.push_back({face.id, {slot.block, slot.slot}, slot.room, face.source, face.edit, face.material});
        if (diff_.rooms.empty() || diff_.rooms.back() != slot.room) diff_.rooms.push_back(slot.room);
        add_box(slot.block->box_of(face));
    }

    void add_box(const GridBox& box) {
        const Vec3 low = to_metres(box.low), high = to_metres(box.high);
        diff_.bounds.add(low);
        diff_.bounds.add(high);
        if (tile_size_ >= kLeastTile && tile_size_ < INFINITY && !diff_.too_many_tiles) add_tiles(low, high);
    }

    void add_tiles(const Vec3& low, const Vec3& high) {
        // 64 bits: the last tile may be the last number of 32 bits, and a box holds many more than that.
        std::array<std::int64_t, 3> from, to;
        std::int64_t count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            from[axis] = std::int64_t(std::floor(low[axis] / tile_size_));
            to[axis] = std::int64_t(std::floor(high[axis] / tile_size_));
            count *= to[axis] - from[axis] + 1;  // below 2^19 an axis: the world is 2^14 m wide
        }
        if (count > std::int64_t(kMostTiles)) return give_up_tiles();
        for (std::int64_t x = from[0]; x <= to[0]; ++x)
            for (std::int64_t y = from[1]; y <= to[1]; ++y)
                for (std::int64_t z = from[2]; z <= to[2]; ++z)
                    diff_.tiles.push_back({std::int32_t(x), std::int32_t(y), std::int32_t(z)});
        if (diff_.tiles.size() > 2 * sorted_ + 1000) sort_tiles();  // many faces, few tiles
    }

    void sort_tiles() {
        std::sort(diff_.tiles.begin(), diff_.tiles.end());
        diff_.tiles.erase(std::unique(diff_.tiles.begin(), diff_.tiles.end()), diff_.tiles.end());
        sorted_ = diff_.tiles.size();
        if (sorted_ > kMostTiles) give_up_tiles();
    }

    void give_up_tiles() {
        diff_.too_many_tiles = true;
        diff_.tiles = {};
        sorted_ = 0;
    }

    const double tile_size_;
    std::size_t sorted_ = 0;
    WorldDiff diff_;
};

}  // namespace

WorldDiff diff_worlds(const World& before, const World& after, double tile_size) {
    Differ differ(tile_size);
    differ.compare(before.data(), after.data());
    return differ.result();
}

}  // namespace firma
