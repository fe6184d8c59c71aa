// SPDX-License-Identifier: MIT
// The rooms of a saved world. Blocks come with their children before them, so each is complete when it is read, and
// none can be its own child or the child of two.
#include "save/unpack_blocks.h"

#include <algorithm>

#include "geometry/polygon_shape.h"
#include "save/sections.h"
#include "tree/build_blocks.h"

namespace firma {
namespace {

constexpr std::uint32_t kMostBins = 2 * kBlockItems - 1;
constexpr std::uint32_t kMostBlockCorners = kBlockItems * std::uint32_t(kMaxCorners);
constexpr std::size_t kMostFaces = std::size_t(1) << 31;

GridPoint point_at(const std::byte* at) {
    return {read_i32(at), read_i32(at + 4), read_i32(at + 8)};
}

/// A box within the world, of numbers.
bool usable(const BoxF& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(double(box.low[axis]) >= -kWorldRim && box.low[axis] <= box.high[axis] &&
              double(box.high[axis]) <= kWorldRim))
            return false;
    return true;
}

class BlockReader {
public:
    BlockReader(Sections& sections, bool has_exact, std::span<const Ref<SolidFace>> exact, Damage& damage)
        : damage_(damage), exact_(exact) {
        rooms_ = sections.entries(kRoomsSection, 4);
        blocks_ = sections.entries(kBlocksSection, kBlockBytes);
        bins_ = sections.entries(kBinsSection, kBinBytes);
        faces_ = sections.entries(kFacesSection, kFaceBytes);
        vertices_ = sections.entries(kVerticesSection, kPointBytes);
        corners_ = sections.entries(kCornersSection, 2);
        if (has_exact) owners_ = sections.entries(kOwnersSection, 4);
    }

    std::vector<Ref<const Room>> read(std::size_t rooms) {
        std::vector<Ref<const Room>> all;
        if (damage_.error()) return all;
        if (rooms_.count() != rooms) return damage_.report(rooms_.type(), "has not as many entries as rooms"), all;
        if (faces_.count() >= kMostFaces) {
            damage_.report(ErrorCode::kTooLarge, ": section FACE", "a world holds fewer than 2^31 faces");
            return all;
        }
        for (room_ = 0; room_ < rooms; ++room_) {
            Ref<Room> room(new Room);
            if (!read_room(*room)) return {};
            all.emplace_back(room.get());
        }
        check_all_taken();
        return all;
    }

private:
    struct Counts {
        std::uint32_t bins, children, faces, vertices, corners, owners;
    };

    void check_all_taken() {
        for (const Entries* part : {&blocks_, &bins_, &faces_, &vertices_, &corners_, &owners_})
            if (part->left() > 0) damage_.report(part->type(), part->taken(), "belongs to no block and no room");
        for (std::size_t k = 0; k < exact_.size(); ++k)
            if (exact_[k]->facets == 0) damage_.report(kExactFacesSection, k, "has no facets");
    }

    bool read_room(Room& room) {
        const std::uint32_t count = read_u32(rooms_.at(room_));
        if (count > blocks_.left()) return damage_.report(rooms_.type(), room_, "has more blocks than there are");
        for (std::uint32_t k = 0; k < count; ++k)
            if (!read_block()) return false;
        if (waiting_.size() > 1) return damage_.report(rooms_.type(), room_, "its blocks are not one tree");
        if (waiting_.empty()) return true;
        room.tree = std::move(waiting_.back());
        waiting_.clear();
        return true;
    }

    bool fault(const char* reason) { return damage_.report(blocks_.type(), blocks_.taken() - 1, reason); }

    bool read_block() {
        const std::byte* at = blocks_.take(1);
        const Counts count{read_u16(at),     read_u16(at + 2), read_u16(at + 4),
                           read_u16(at + 6), read_u16(at + 8), read_u16(at + 10)};
        if (!check(count)) return false;
        Ref<Block> block(new Block);
        const auto first_child = waiting_.end() - std::ptrdiff_t(count.children);
        block->children.reserve(count.children);
        std::move(first_child, waiting_.end(), std::back_inserter(block->children));
        waiting_.erase(first_child, waiting_.end());
        if (!read_bins(*block, count.bins)) return false;
        std::size_t below = count.faces;
        for (const Ref<const Block>& child : block->children) below += child->faces_below;
        block->faces_below = std::uint32_t(below);
        if (count.faces > 0 && !read_contents(*block, count)) return false;
        waiting_.emplace_back(block.get());
        return true;
    }

    bool check(const Counts& count) {
        if ((count.children == 0) == (count.faces == 0)) return fault("holds both faces and blocks, or neither");
        if (count.children == 1) return fault("holds a single block");
        if (count.children > kBlockItems || count.faces > kBlockItems || count.bins > kMostBins ||
            count.vertices > kMostBlockCorners || count.corners > kMostBlockCorners || count.owners > kBlockItems)
            return fault("holds more than a block can");
        if (count.children > 0 && (count.vertices | count.corners | count.owners) != 0)
            return fault("holds blocks, and yet corners");
        if (count.children > waiting_.size()) return fault("holds more blocks than there are");
        if (count.bins > bins_.left() || count.faces > faces_.left() || count.vertices > vertices_.left() ||
            count.corners > corners_.left() || count.owners > owners_.left())
            return fault("holds more than there is");
        return true;
    }

    bool read_bins(Block& block, std::uint32_t count) {
        const std::size_t before = bins_.taken();
        const std::byte* at = bins_.take(count);
        block.bins.resize(count);
        for (std::uint32_t k = 0; k < count; ++k, at += kBinBytes) {
            Bin& bin = block.bins[k];
            for (int axis = 0; axis < 3; ++axis) {
                bin.box.low[axis] = read_f32(at + 4 * axis);
                bin.box.high[axis] = read_f32(at + 12 + 4 * axis);
            }
            bin.first = read_u32(at + 24);
            bin.count = read_u32(at + 28);
            if (!usable(bin.box)) return damage_.report(bins_.type(), before + k, "its box is none within the world");
        }
        next_item_ = 0;
        int depth = 0;
        const std::uint32_t end = walk_bins(block, 0, 0, depth);
        const std::size_t items = block.holds_blocks() ? block.children.size() : 0;
        if (end != count || (items > 0 && next_item_ != items))
            return fault("its bins are not one tree over its items");
        if (depth > kDeepestTree) return fault("makes a tree deeper than trees are");
        block.depth = std::uint16_t(depth);
        return true;
    }

    /// Goes through the bins in the order in which they must stand, each once; items likewise.
    /// @return where this subtree ends; 0 when it is none
    std::uint32_t walk_bins(const Block& block, std::uint32_t index, int above, int& deepest) {
        if (index >= block.bins.size()) return 0;
        const Bin& bin = block.bins[index];
        if (!bin.is_leaf()) {
            if (walk_bins(block, index + 1, above + 1, deepest) != bin.first || bin.first == 0) return 0;
            return walk_bins(block, bin.first, above + 1, deepest);
        }
        if (bin.first != next_item_ || bin.count > kBlockItems) return 0;
        next_item_ += bin.count;
        int depth = above;
        if (block.holds_blocks()) {
            if (bin.count != 1 || bin.first >= block.children.size()) return 0;
            depth += block.children[bin.first]->depth;
        }
        deepest = std::max(deepest, depth);
        return index + 1;
    }

    bool read_contents(Block& block, const Counts& count) {
        if (next_item_ != count.faces) return fault("its bins are not one tree over its items");
        const std::byte* at = vertices_.take(count.vertices);
        block.vertices.resize(count.vertices);
        for (std::uint32_t k = 0; k < count.vertices; ++k) block.vertices[k] = point_at(at + kPointBytes * k);
        const std::size_t first_corner = corners_.taken();
        at = corners_.take(count.corners);
        block.corner_vertices.resize(count.corners);
        for (std::uint32_t k = 0; k < count.corners; ++k) {
            block.corner_vertices[k] = read_u16(at + 2 * k);
            if (block.corner_vertices[k] >= count.vertices)
                return damage_.report(corners_.type(), first_corner + k, "names a vertex that is not there");
        }
        return read_owners(block, count.owners) && read_faces(block, count.faces);
    }

    bool read_owners(Block& block, std::uint32_t count) {
        block.owners.reserve(count);
        owner_numbers_.clear();
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t entry = owners_.taken();
            const std::uint32_t owner = read_u32(owners_.take(1));
            if (owner >= exact_.size())
                return damage_.report(owners_.type(), entry, "names an exact face that is not there");
            owner_numbers_.push_back(owner);
            block.owners.emplace_back(exact_[owner].get());
        }
        return true;
    }

    bool read_faces(Block& block, std::uint32_t count) {
        block.faces.reserve(count);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::size_t entry = faces_.taken();
            const std::byte* at = faces_.take(1);
            FaceRecord face;
            face.id = {read_u32(at)};
            face.source = read_u32(at + 4);
            face.edit = read_u32(at + 8);
            face.material = read_u32(at + 12);
            face.mask = read_u32(at + 16);
            face.first_corner = read_u16(at + 20);
            face.owner = read_u16(at + 22);
            face.corner_count = std::uint8_t(at[24]);
            const auto flags = std::uint8_t(at[25]);
            face.two_sided = flags & kTwoSidedFace;
            face.solid = flags & kSolidFace;
            if (const char* reason = refusal(block, face)) return damage_.report(faces_.type(), entry, reason);
            if (flags > (kTwoSidedFace | kSolidFace) || read_u16(at + 26) != 0)
                return damage_.report(faces_.type(), entry, "has flags that are not of version 1");
            if (face.owner != kNoOwner) ++exact_[owner_numbers_[face.owner]]->facets;
            block.faces.push_back(face);
        }
        return true;
    }

    /// Why a face cannot be kept, or null.
    const char* refusal(const Block& block, const FaceRecord& face) const {
        if (face.corner_count < 3 || face.corner_count > kMaxCorners) return "does not have 3 to 64 corners";
        if (std::size_t(face.first_corner) + face.corner_count > block.corner_vertices.size())
            return "has corners that are not there";
        if (face.owner != kNoOwner && face.owner >= block.owners.size()) return "has an exact face that is not there";
        if (face.owner != kNoOwner && !face.solid) return "bounds no solid, and yet has an exact face";
        return nullptr;
    }

    Damage& damage_;
    std::span<const Ref<SolidFace>> exact_;
    Entries rooms_, blocks_, bins_, faces_, vertices_, corners_, owners_;
    std::size_t room_ = 0;
    std::vector<Ref<const Block>> waiting_;  ///< complete, and in no other block yet
    std::vector<std::uint32_t> owner_numbers_;
    std::uint32_t next_item_ = 0;
};

}  // namespace

std::vector<Ref<const Room>> unpack_rooms(Sections& sections, std::size_t rooms, bool has_exact,
                                          std::span<const Ref<SolidFace>> exact, Damage& damage) {
    return BlockReader(sections, has_exact, exact, damage).read(rooms);
}

}  // namespace firma
