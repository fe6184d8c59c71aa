// SPDX-License-Identifier: MIT
// Faces in blocks, counted and hashed.
#include "solid/face_store.h"

#include <algorithm>

#include "solid/hash_facet.h"

namespace firma {

void FaceSums::add(const FaceSet& set, const FaceSet::Entry& face) {
    GridPoint lowest = set.corner(face, 0);
    for (std::uint32_t k = 1; k < face.corner_count; ++k) lowest = std::min(lowest, set.corner(face, k));
    change(face.part, lowest, hash_facet(set, face), 1);
}

void FaceSums::change(const Block& block, const FaceRecord& face, std::int64_t sign) {
    change(block.part, lowest_corner(block, face), hash_facet(block, face), sign);
}

void FaceSums::change(std::uint32_t of_part, const GridPoint& lowest, std::uint64_t hash, std::int64_t sign) {
    const std::uint64_t term = sign > 0 ? hash : -hash;
    PartChange& change = part(of_part);
    change.faces += sign;
    change.hash += term;
    count_ += sign;
    hash_ += term;
    regions_.add(region_of_(lowest), term);
}

PartChange& FaceSums::part(std::uint32_t part) {
    if (last_part_ < parts_.size() && parts_[last_part_].part == part) return parts_[last_part_];
    std::uint32_t& at = place_of_part_.at(part);
    if (at == FlatMap::kNone) {
        at = std::uint32_t(parts_.size());
        parts_.push_back({part, 0, 0});
    }
    last_part_ = at;
    return parts_[at];
}

void FaceSums::add_to(FaceStore& store) const {
    store.count += std::size_t(count_);
    store.hash += hash_;
    regions_.add_to(store.regions);
}

void FaceSums::add(const FaceSums& other) {
    for (const PartChange& change : other.parts_) {
        PartChange& mine = part(change.part);
        mine.faces += change.faces;
        mine.hash += change.hash;
    }
    for (const auto& [region, sum] : other.regions_.sums()) regions_.add(region, sum);
    count_ += other.count_;
    hash_ += other.hash_;
}

namespace {

void add_faces(const Block& block, FaceSums& sums) {
    for (const FaceRecord& face : block.faces) sums.add(block, face);
}

/// @return false when the work was stopped
bool add_together(const std::vector<PartIndex>& parts, LongWork& work, FaceSums& sums) {
    constexpr std::size_t kTogether = 1024;  // blocks
    std::vector<const Block*> blocks;
    for (const PartIndex& part : parts)
        for_each_block(*part.root, [&](const Block& block) { blocks.push_back(&block); });
    std::vector<FaceSums> some((blocks.size() + kTogether - 1) / kTogether);
    const bool done = work.each(some.size(), [&](std::size_t part) {
        std::size_t faces = 0;
        const std::size_t end = std::min(blocks.size(), (part + 1) * kTogether);
        for (std::size_t k = part * kTogether; k < end; ++k) {
            add_faces(*blocks[k], some[part]);
            faces += blocks[k]->faces.size();
        }
        work.add(faces);
    });
    for (const FaceSums& of_some : some) sums.add(of_some);
    return done;
}

}  // namespace

BuiltStore build_store(const FaceSet& faces, const TreeOptions& options, LongWork* work) {
    return store_of_parts(build_blocks(faces, options, work), work);
}

BuiltStore store_of_parts(std::vector<PartIndex> parts, LongWork* work) {
    BuiltStore built;
    FaceSums sums;
    std::vector<Ref<const Node>> roots;
    for (const PartIndex& part : parts) roots.push_back(part.root);
    if (kHasLongWork && work) {
        if (!add_together(parts, *work, sums)) return built;
    } else {
        for (const PartIndex& part : parts)
            for_each_block(*part.root, [&](const Block& block) { add_faces(block, sums); });
    }
    built.store.root = join_nodes(roots);
    sums.add_to(built.store);
    built.parts = std::move(parts);
    built.changes = sums.parts();
    return built;
}

StoreEdit::StoreEdit(FaceStore before, const TreeOptions& options)
    : after_(std::move(before)), blocks_(options), nodes_(after_.root) {}

void StoreEdit::remove(const FacetPlace& facet) {
    blocks_.remove(facet);
    sums_.remove(*facet.block, facet.record());
}

void StoreEdit::add(FaceSet&& faces) {
    for (const FaceSet::Entry& face : faces.faces) sums_.add(faces, face);
    blocks_.add(std::move(faces));
}

bool StoreEdit::step() {
    if (!blocks_done_) {
        if (blocks_.step()) return true;
        blocks_done_ = true;
        for (const Block* block : blocks_.removed()) nodes_.remove(block, block->box());
        for (const Ref<const Node>& leaf : blocks_.added()) nodes_.add(leaf);
        return true;
    }
    if (nodes_.step()) return true;
    after_.root = nodes_.result();
    sums_.add_to(after_);
    return false;
}

}  // namespace firma
