// SPDX-License-Identifier: MIT
// The World's handle: what it holds, and faces by name.
#include "firma/world.h"

#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "index/statistics.h"
#include "index/traverse.h"
#include "solid/bounds_of.h"
#include "solid/find_neighbour.h"
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

RoomId room_of_block(const WorldData& data, const Block& block) {
    return {data.cells.current_room(block.part)};
}

/// Looks for a face by id, where one of its corners is.
struct FaceFinder {
    const FaceRef wanted;
    const Vec3 corner = to_metres(wanted.corner);
    FacetPlace found{};

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (corner[axis] < double(box.low[axis]) || corner[axis] > double(box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (ref_to(block, slot) == wanted) found = {&block, slot};
        return found.block != nullptr;
    }
};

FacetPlace find_facet(const WorldData& data, const FaceRef& ref) {
    if (!ref.valid()) return {};
    FaceFinder finder{ref};
    for (const Node* root : {data.solid.data().faces.root.get(), data.castable.root.get()})
        if (root && !finder.found.block) traverse(*root, finder);
    return finder.found;
}

void add(TreeStatistics& sum, const TreeStatistics& more) {
    const double inner = double(sum.nodes - sum.leaves), more_inner = double(more.nodes - more.leaves);
    if (inner + more_inner > 0) sum.overlap = (sum.overlap * inner + more.overlap * more_inner) / (inner + more_inner);
    sum.faces += more.faces;
    sum.blocks += more.blocks;
    sum.nodes += more.nodes;
    sum.leaves += more.leaves;
    sum.depth = std::max(sum.depth, more.depth);
    sum.max_leaf_faces = std::max(sum.max_leaf_faces, more.max_leaf_faces);
    sum.bytes += more.bytes;
}

std::shared_ptr<const WorldData> make_empty_world() {
    auto data = std::make_shared<WorldData>();
    data->set_room(0, std::make_shared<const RoomRecord>(), Ref<const RoomFaces>(new RoomFaces));
    data->materials = std::make_shared<std::vector<std::string>>(1);
    return data;
}

/// Never destroyed: worlds may outlive any other object of a program.
const std::shared_ptr<const WorldData>& empty_world() {
    static const auto& empty = *new std::shared_ptr<const WorldData>(make_empty_world());
    return empty;
}

}  // namespace

World::World() : data_(empty_world()) {}
World::World(std::shared_ptr<const WorldData> data) : data_(data ? std::move(data) : empty_world()) {}
World::World(World&& other) noexcept : data_(std::exchange(other.data_, empty_world())) {}
World& World::operator=(World&& other) noexcept {
    data_ = std::exchange(other.data_, empty_world());
    return *this;
}

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
    for (const Node* root : {data_->solid.data().faces.root.get(), data_->castable.root.get()})
        if (root) box.add(bounds_of(*root));
    return box;
}

TreeStatistics World::statistics() const {
    TreeStatistics sum;
    data_->room_faces.for_each([&](std::uint32_t, const Ref<const RoomFaces>& room) {
        if (room->tree) add(sum, tree_statistics(*room->tree));
    });
    return sum;
}

std::optional<Face> World::face(const FaceRef& ref) const {
    const FacetPlace facet = find_facet(*data_, ref);
    if (!facet.block) return {};
    return describe_face(room_of_block(*data_, *facet.block), *facet.block, facet.record());
}

std::optional<FaceInfo> World::face_info(const FaceRef& ref) const {
    const FacetPlace facet = find_facet(*data_, ref);
    if (!facet.block) return {};
    const FaceShape shape(*facet.block, facet.record());
    return firma::face_info(room_of_block(*data_, *facet.block), *facet.block, facet.record(), shape.polygon);
}

std::optional<Face> World::find_face(FaceId id) const {
    std::optional<Face> found;
    for_each_face(*data_, [&](const Block& block, const FaceRecord& face) {
        if (face.id == id) found = describe_face(room_of_block(*data_, block), block, face);
    });
    return found;
}

std::vector<Face> World::faces() const {
    std::vector<Face> all;
    all.reserve(face_count());
    for_each_face(*data_, [&](const Block& block, const FaceRecord& face) {
        all.push_back(describe_face(room_of_block(*data_, block), block, face));
    });
    sort_range(all, [](const Face& a, const Face& b) { return a.id < b.id; });
    return all;
}

std::optional<TextureProjection> texture_of(const World& world, const FaceInfo& face, std::span<const Vec3> corners) {
    const FaceTextures* textures = world.data().textures.get();
    if (!textures || face.source_edit != 0 || corners.empty()) return {};
    const TextureProjection* found = textures->find(face.source, corners);
    return found ? std::optional(*found) : std::nullopt;
}

std::optional<TextureProjection> texture_of(const World& world, const FaceRef& ref) {
    const FacetPlace facet = find_facet(world.data(), ref);
    if (!facet.block) return {};
    const FaceShape shape(*facet.block, facet.record());
    const FaceInfo face =
        face_info(room_of_block(world.data(), *facet.block), *facet.block, facet.record(), shape.polygon);
    return texture_of(world, face, shape.polygon.corners);
}

FaceId other_face(const World& world, const FaceRef& face, std::uint32_t edge) {
    const WorldData& data = world.data();
    const FacetPlace facet = find_facet(data, face);
    if (!facet.block || edge >= facet.record().corner_count) return {};
    const std::uint32_t room = room_of_block(data, *facet.block).value;
    return find_neighbour(*data.faces_of(room).tree, *facet.block, facet.record(), edge);
}

}  // namespace firma
