// SPDX-License-Identifier: MIT
// From faces to blocks, and an index over them: first one binary tree of bins over all faces, then cut into pieces.
#pragma once

#include <span>
#include <vector>

#include "base/long_work.h"
#include "base/ref.h"
#include "firma/tree_options.h"
#include "index/divide_bins.h"
#include "solid/block.h"
#include "solid/face_set.h"
#include "solid/lay_out_faces.h"

namespace firma {

/// Keeps its scratch memory from call to call: for edits, which build many small trees.
class BlockBuilder {
public:
    /// @param faces    of one part, at most 2^31
    /// @param by_area  bins of more faces than this are divided by surface area, whatever the options say
    /// @param work     does it, and is told of each face twice; null: this thread does it
    /// @return the root; null for no faces, and when the work was stopped
    Ref<const Node> build(const FaceSet& faces, const TreeOptions& options, std::size_t by_area = ~std::size_t{},
                          LongWork* work = nullptr);

    /// Only the leaves, for edits: divided by surface area, whatever the options say.
    /// @param leaves  they are added to these
    void build_leaves(const FaceSet& faces, const TreeOptions& options, std::vector<Ref<const Node>>& leaves);

private:
    /// What parts bins by surface area, by how many faces they have.
    struct ByArea {
        std::size_t above;  ///< bins of more faces, whatever the options say
        std::size_t apart;  ///< bins of few faces, so many at most, are divided where these lie apart
    };
    bool divide(const FaceSet& faces, const TreeOptions& options, const ByArea& by_area, LongWork* work = nullptr);
    void sort_bins_by_id();
    void sort_by_id(const BinNode& bin);
    Ref<const Node> pack_leaf(std::uint32_t bin, FaceLayout& layout) const;
    bool pack_leaves(LongWork& work);

    const FaceSet* faces_ = nullptr;
    BinTree tree_;
    std::vector<Ref<const Node>> packed_;  ///< by bin, those packed together
    FaceLayout layout_;
    BinWidener widener_;
};

/// Blocks of all faces, those of each part apart.
/// @param work  as of BlockBuilder::build()
/// @return an index over the faces of each part, parts ascending; none for no faces, and when the work was stopped
struct PartIndex {
    std::uint32_t part = 0;
    Ref<const Node> root;
};
std::vector<PartIndex> build_blocks(const FaceSet& faces, const TreeOptions& options, LongWork* work = nullptr);

}  // namespace firma
