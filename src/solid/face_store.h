// SPDX-License-Identifier: MIT
// Faces in blocks, counted and hashed, and found by an index: what a solid keeps its facets in, and a world those that
// are castable only. A value: copies share everything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/persistent_map.h"
#include "firma/tree_options.h"
#include "index/edit_nodes.h"
#include "solid/edit_blocks.h"
#include "solid/region.h"

namespace firma {

struct FaceStore {
    Ref<const Node> root;  ///< over all blocks; null for no faces
    std::size_t count = 0;
    std::uint64_t hash = 0;                ///< sum of hash_facet()
    PersistentMap<std::uint64_t> regions;  ///< the same by region, of each face's lowest corner
};

/// What came to the faces of one part, or went.
struct PartChange {
    std::uint32_t part = 0;
    std::int64_t faces = 0;
    std::uint64_t hash = 0;  ///< sum of hash_facet()
};

/// Sums over faces that come and go.
class FaceSums {
public:
    void add(const FaceSet& set, const FaceSet::Entry& face);
    void add(const Block& block, const FaceRecord& face) { change(block, face, 1); }
    void remove(const Block& block, const FaceRecord& face) { change(block, face, -1); }
    void add(const FaceSums& other);

    const std::vector<PartChange>& parts() const { return parts_; }
    void add_to(FaceStore& store) const;

private:
    void change(const Block& block, const FaceRecord& face, std::int64_t sign);
    void change(std::uint32_t part, const GridPoint& lowest, std::uint64_t hash, std::int64_t sign);
    PartChange& part(std::uint32_t part);

    std::vector<PartChange> parts_;  ///< in order of first use
    FlatMap place_of_part_;
    std::size_t last_part_ = 0;
    SumsByKey regions_;
    RegionFinder region_of_;
    std::int64_t count_ = 0;
    std::uint64_t hash_ = 0;
};

/// Faces as they come from a file: each part in blocks of its own.
struct BuiltStore {
    FaceStore store;
    std::vector<PartIndex> parts;     ///< an index over the faces of each, ascending
    std::vector<PartChange> changes;  ///< of each part with faces, in no order
};
/// @param work  does it, and is told of each face three times; null: this thread does it. When it was stopped, there
///              is nothing in the store
BuiltStore build_store(const FaceSet& faces, const TreeOptions& options, LongWork* work = nullptr);

/// A store over blocks that are there already.
/// @param parts  an index over the faces of each
BuiltStore store_of_parts(std::vector<PartIndex> parts, LongWork* work = nullptr);

/// One change to a store: faces go, others come.
class StoreEdit {
public:
    StoreEdit(FaceStore before, const TreeOptions& options);

    /// A face that goes, once.
    void remove(const FacetPlace& facet);
    /// Faces that come: ids, parts and owners set. Once.
    void add(FaceSet&& faces);

    /// Does one piece of work, some 10 us: all changes must be in.
    /// @return whether there is more to do
    bool step();

    // Once step() said false:
    const FaceStore& result() const { return after_; }
    const std::vector<PartChange>& parts() const { return sums_.parts(); }
    const std::vector<const Block*>& removed() const { return blocks_.removed(); }
    const std::vector<Ref<const Node>>& added() const { return blocks_.added(); }

private:
    FaceStore after_;
    BlockEdit blocks_;
    NodeEdit nodes_;
    FaceSums sums_;
    bool blocks_done_ = false;
};

}  // namespace firma
