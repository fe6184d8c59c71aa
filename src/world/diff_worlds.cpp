// SPDX-License-Identifier: MIT
// What changed between two worlds: first what only one of them has of nodes, rooms and portals, then what is in those.
#include "firma/versions.h"

#include <algorithm>
#include <cmath>

#include "geometry/grid_box.h"
#include "world/block_faces.h"
#include "world/changed_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// But for their rooms.
bool same(const Portal& one, const Portal& two) {
    if (&one == &two) return true;
    if (one.name != two.name || one.material != two.material || one.mask != two.mask) return false;
    const auto polygons = one.polygons(), others = two.polygons();
    return std::equal(polygons.begin(), polygons.end(), others.begin(), others.end(),
                      [](const PortalPolygon& p, const PortalPolygon& q) {
                          return std::equal(p.corners.begin(), p.corners.end(), q.corners.begin(), q.corners.end());
                      });
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
        for (std::vector<FaceInfo>* faces : {&diff_.removed, &diff_.added})
            std::sort(faces->begin(), faces->end(), [](const FaceInfo& a, const FaceInfo& b) {
                return a.id != b.id ? a.id < b.id : a.room < b.room;
            });
        std::sort(diff_.rooms.begin(), diff_.rooms.end());
        diff_.rooms.erase(std::unique(diff_.rooms.begin(), diff_.rooms.end()), diff_.rooms.end());
        sort_tiles();
        return std::move(diff_);
    }

private:
    void compare_faces(const WorldData& before, const WorldData& after) {
        const ChangedFaces faces = changed_faces(before, after);
        for (const ChangedFace& face : faces.removed) add(face, diff_.removed);
        for (const ChangedFace& face : faces.added) add(face, diff_.added);
    }

    void compare_rooms(const WorldData& before, const WorldData& after) {
        before.cells.rooms().for_each_unshared(
            after.cells.rooms(), [&](std::uint32_t room, const auto* one, const auto* two) {
                if (one && two && (*one)->merged_into == (*two)->merged_into) return;
                diff_.rooms.push_back({room});
                for (const auto* its : {one, two})
                    if (its) portals_.insert(portals_.end(), (*its)->portals.begin(), (*its)->portals.end());
            });
    }

    void compare_portals(const WorldData& before, const WorldData& after) {
        before.cells.portals().for_each_unshared(
            after.cells.portals(), [&](std::uint32_t k, const PortalState* one, const PortalState* two) {
                const bool shared = one && two && one->portal.get() == two->portal.get();
                if (!shared || one->closed != two->closed) portals_.push_back({k});
            });
        std::sort(portals_.begin(), portals_.end());
        portals_.erase(std::unique(portals_.begin(), portals_.end()), portals_.end());
        for (const PortalId id : portals_) {
            const PortalState *one = before.cells.portals().find(id.value), *two = after.cells.portals().find(id.value);
            const bool had = one && !one->portal->gone(), has = two && !two->portal->gone();
            if (has && !had) add(id, *two->portal, diff_.portals_added);
            if (had && !has) add(id, *one->portal, diff_.portals_removed);
            if (!had || !has) continue;
            if (one->closed != two->closed) add(id, *two->portal, two->closed ? diff_.closed : diff_.opened);
            if (before.cells.rooms_of(*one->portal) == after.cells.rooms_of(*two->portal) &&
                same(*one->portal, *two->portal))
                continue;
            add(id, *one->portal, diff_.portals_changed);
            add_box(two->portal->box);
        }
    }

    void add(PortalId id, const Portal& portal, std::vector<PortalId>& portals) {
        portals.push_back(id);
        add_box(portal.box);
    }

    void add(const ChangedFace& changed, std::vector<FaceInfo>& faces) {
        const Block& block = *changed.place.block;
        const FaceRecord& face = changed.record();
        faces.push_back(face_info(changed.room, block, face, FaceShape(block, face).polygon));
        if (diff_.rooms.empty() || diff_.rooms.back() != changed.room) diff_.rooms.push_back(changed.room);
        add_box(block.box_of(face));
    }

    void add_box(const GridBox& box) {
        const Vec3 low = to_metres(box.low), high = to_metres(box.high);
        diff_.bounds.add(low);
        diff_.bounds.add(high);
        if (tile_size_ >= kMinTileSize && tile_size_ < INFINITY && !diff_.too_many_tiles) add_tiles(low, high);
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
        if (count > std::int64_t(kMaxTiles)) return give_up_tiles();
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
        if (sorted_ > kMaxTiles) give_up_tiles();
    }

    void give_up_tiles() {
        diff_.too_many_tiles = true;
        diff_.tiles = {};
        sorted_ = 0;
    }

    const double tile_size_;
    std::size_t sorted_ = 0;
    std::vector<PortalId> portals_;  ///< that may have changed
    WorldDiff diff_;
};

}  // namespace

WorldDiff diff_worlds(const World& before, const World& after, double tile_size) {
    Differ differ(tile_size);
    differ.compare(before.data(), after.data());
    return differ.result();
}

}  // namespace firma
