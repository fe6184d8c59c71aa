// SPDX-License-Identifier: MIT
// What changed between two worlds: first the blocks that only one of them has, then the faces in those.
#include "firma/diff_worlds.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"
#include "geometry/grid_box.h"
#include "tree/unshared_blocks.h"
#include "world/world_data.h"

namespace firma {
namespace {

struct Slot {
    FaceId id;
    std::uint32_t slot;
    const Block* block;

    const FaceRecord& face() const { return block->faces[slot]; }
};

std::vector<Slot> slots_by_id(const std::vector<const Block*>& blocks) {
    std::vector<Slot> slots;
    for (const Block* block : blocks)
        for (std::uint32_t slot = 0; slot < block->faces.size(); ++slot)
            slots.push_back({block->faces[slot].id, slot, block});
    sort_range(slots, [](const Slot& a, const Slot& b) { return a.id < b.id; });
    return slots;
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

    void compare(RoomId room, const Block* before, const Block* after) {
        const UnsharedBlocks unshared = unshared_blocks(before, after);
        const std::vector<Slot> olds = slots_by_id(unshared.before), news = slots_by_id(unshared.after);
        auto come = news.begin();
        for (const Slot& gone : olds) {
            while (come != news.end() && come->id < gone.id) add(room, *come++, diff_.come);
            const bool match = come != news.end() && come->id == gone.id;
            if (match && same(gone, *come)) {
                ++come;
                continue;
            }
            add(room, gone, diff_.gone);
            if (match) add(room, *come++, diff_.come);
        }
        while (come != news.end()) add(room, *come++, diff_.come);
    }

    WorldDiff result() {
        for (std::vector<ChangedFace>* faces : {&diff_.gone, &diff_.come})
            sort_range(*faces, [](const ChangedFace& a, const ChangedFace& b) {
                return a.id != b.id ? a.id < b.id : a.room.value < b.room.value;
            });
        sort_tiles();
        return std::move(diff_);
    }

private:
    void add(RoomId room, const Slot& slot, std::vector<ChangedFace>& faces) {
        const FaceRecord& face = slot.face();
        faces.push_back({face.id, {slot.block, slot.slot}, room, face.source, face.edit, face.material});
        const GridBox box = slot.block->box_of(face);
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
        sort_range(diff_.tiles);
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
    const auto &olds = before.data().rooms, &news = after.data().rooms;
    Differ differ(tile_size);
    for (std::uint32_t room = 0; room < std::max(olds.size(), news.size()); ++room)
        differ.compare({room}, room < olds.size() ? olds[room]->tree.get() : nullptr,
                       room < news.size() ? news[room]->tree.get() : nullptr);
    return differ.result();
}

}  // namespace firma
