// SPDX-License-Identifier: MIT
// The World's handle: what it holds, and faces by name.
#include "firma/world.h"

#include <algorithm>

#include "base/sort.h"
#include "tree/statistics.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

template <class Function>
void for_each_tree(const WorldData& data, const Function& function) {
    for (const Ref<const Room>& room : data.rooms)
        if (room->tree) function(*room->tree);
}

template <class Function>
void for_each_face(const WorldData& data, const Function& function) {
    for_each_tree(data, [&](const Block& root) {
        for_each_face_block(root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) function(root, block, face);
        });
    });
}

/// Looks for a block, by a corner of one of its faces.
struct BlockVisitor {
    const Block* wanted;
    Vec3 corner;
    bool found = false;

    bool enter(const Bin& bin, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (corner[axis] < double(bin.box.low[axis]) || corner[axis] > double(bin.box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool faces(const Block& block, std::uint32_t, std::uint32_t) { return found = &block == wanted; }
};

/// The root of the tree that holds a block; null when none does.
const Block* root_above(const WorldData& data, const Block& block, const FaceRecord& face) {
    BlockVisitor visitor{&block, to_metres(block.corner(face, 0))};
    for (const Ref<const Room>& room : data.rooms) {
        if (room->tree) visit(*room->tree, visitor);
        if (visitor.found) return room->tree.get();
    }
    return nullptr;
}

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
    data->rooms.push_back(Ref<const Room>(new Room));  // owned before the list grows, which may throw
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
    return data_->face_count;
}
std::size_t World::room_count() const {
    return data_->rooms.size();
}
const Tolerance& World::tolerance() const {
    return data_->tolerance;
}

const std::string& World::material_name(std::uint32_t material) const {
    static const std::string none;
    return material < data_->materials->size() ? (*data_->materials)[material] : none;
}

Box World::bounds() const {
    Box box;
    for_each_tree(*data_, [&](const Block& root) {
        for_each_face_block(root, [&](const Block& block) {
            for (const GridPoint& vertex : block.vertices) box.add(to_metres(vertex));
        });
    });
    return box;
}

TreeStatistics World::statistics() const {
    TreeStatistics sum;
    for_each_tree(*data_, [&](const Block& root) { add(sum, tree_statistics(root)); });
    return sum;
}

Face World::face(FaceRef ref) const {
    const auto& block = *static_cast<const Block*>(ref.block);
    FIRMA_ASSERT(ref.valid() && ref.slot < block.faces.size(), "a FaceRef must come from a hit of this World");
    const FaceRecord& record = block.faces[ref.slot];
    const Block* root = root_above(*data_, block, record);
    FIRMA_ASSERT(root != nullptr, "a FaceRef must come from a hit of this World");
    return root ? describe_face(*root, block, record) : describe_face(block, record);
}

std::optional<Face> World::find_face(FaceId id) const {
    std::optional<Face> found;
    for_each_face(*data_, [&](const Block& root, const Block& block, const FaceRecord& face) {
        if (face.id == id) found = describe_face(root, block, face);
    });
    return found;
}

std::vector<Face> World::faces() const {
    std::vector<Face> all;
    all.reserve(face_count());
    for_each_face(*data_, [&](const Block& root, const Block& block, const FaceRecord& face) {
        all.push_back(describe_face(root, block, face));
    });
    sort_range(all, [](const Face& a, const Face& b) { return a.id < b.id; });
    return all;
}

}  // namespace firma
