// SPDX-License-Identifier: MIT
// The World's handle: what it holds, and faces by name.
#include "firma/world.h"

#include <algorithm>

#include "base/sort.h"
#include "index/statistics.h"
#include "index/traverse.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

template <class Function>
void for_each_face(const WorldData& data, const Function& function) {
    for_each_block_of(data, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) function(block, face);
    });
}

const Node& root_of(const WorldData& data, const Block& block) {
    return *data.faces_of(data.cells.current_room(block.part)).tree;
}

/// Looks for a block, by a corner of one of its faces. Its address alone is compared.
struct BlockVisitor {
    const void* wanted;
    Vec3 corner;
    const Block* found = nullptr;

    bool enter(const Bin& bin, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (corner[axis] < double(bin.box.low[axis]) || corner[axis] > double(bin.box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t, std::uint32_t) {
        if (&facets == wanted) found = &as_block(facets);
        return found != nullptr;
    }
};

void add(TreeStatistics& sum, const TreeStatistics& more) {
    const double inner = double(sum.bins - sum.leaf_bins), more_inner = double(more.bins - more.leaf_bins);
    if (inner + more_inner > 0) sum.overlap = (sum.overlap * inner + more.overlap * more_inner) / (inner + more_inner);
    sum.faces += more.faces;
    sum.blocks += more.blocks;
    sum.bins += more.bins;
    sum.leaf_bins += more.leaf_bins;
    sum.depth = std::max(sum.depth, more.depth);
    sum.largest_bin = std::max(sum.largest_bin, more.largest_bin);
    sum.bytes += more.bytes;
}

std::shared_ptr<const WorldData> empty_world() {
    auto data = std::make_shared<WorldData>();
    data->set_room(0, std::make_shared<const RoomRecord>(), Ref<const RoomFaces>(new RoomFaces));
    data->materials = std::make_shared<std::vector<std::string>>(1);
    return data;
}

}  // namespace

World::World() : data_(empty_world()) {}
World::World(std::shared_ptr<const WorldData> data) : data_(std::move(data)) {}

std::uint64_t World::version() const {
    return data_->version;
}
std::size_t World::face_count() const {
    return data_->face_count();
}
std::size_t World::room_count() const {
    return data_->cells.room_count();
}
const Tolerance& World::tolerance() const {
    return data_->tolerance;
}

const std::string& World::material_name(std::uint32_t material) const {
    static const std::string none;
    return material < data_->materials->size() ? (*data_->materials)[material] : none;
}

const Solid& World::solid() const {
    return data_->solid;
}

Box World::bounds() const {
    Box box;
    for_each_block_of(*data_, [&](const Block& block) {
        for (const GridPoint& vertex : block.vertices) box.add(to_metres(vertex));
    });
    return box;
}

TreeStatistics World::statistics() const {
    TreeStatistics sum;
    data_->room_faces.for_each([&](std::uint32_t, const Ref<const RoomFaces>& room) {
        if (room->tree) add(sum, tree_statistics(*room->tree));
    });
    return sum;
}

Face World::face(const FaceRef& ref) const {
    if (!ref.valid()) return {};
    BlockVisitor visitor{ref.block, to_metres(GridPoint{ref.at[0], ref.at[1], ref.at[2]})};
    for (const Node* root : {data_->solid.data().faces.root.get(), data_->castable.root.get()})
        if (root && !visitor.found) traverse(*root, visitor);
    const Block* block = visitor.found;
    if (!block || ref.slot >= block->faces.size() || block->faces[ref.slot].id != ref.id) return {};
    return describe_face(root_of(*data_, *block), *block, block->faces[ref.slot]);
}

std::optional<Face> World::find_face(FaceId id) const {
    std::optional<Face> found;
    for_each_face(*data_, [&](const Block& block, const FaceRecord& face) {
        if (face.id == id) found = describe_face(root_of(*data_, block), block, face);
    });
    return found;
}

std::vector<Face> World::faces() const {
    std::vector<Face> all;
    all.reserve(face_count());
    for_each_face(*data_, [&](const Block& block, const FaceRecord& face) {
        all.push_back(describe_face(root_of(*data_, block), block, face));
    });
    sort_range(all, [](const Face& a, const Face& b) { return a.id < b.id; });
    return all;
}

}  // namespace firma
