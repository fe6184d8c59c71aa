// SPDX-License-Identifier: MIT
// From faces to blocks, and an index over them: first one binary tree of bins over all faces, then cut into pieces.
#pragma once

#include <span>
#include <vector>

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
    /// @return the root; null for no faces
    Ref<const Node> build(const FaceSet& faces, const TreeOptions& options, std::size_t by_area = ~std::size_t{});

    /// Only the leaves, for edits: divided by surface area, whatever the options say.
    /// @param leaves  they are added to these
    void build_leaves(const FaceSet& faces, const TreeOptions& options, std::vector<Ref<const Node>>& leaves);

private:
    /// What parts bins by surface area, by how many faces they have.
    struct ByArea {
        std::size_t above;  ///< bins of more faces, whatever the options say
        std::size_t apart;  ///< bins of few faces, so many at most, are divided where these lie apart
    };
    void divide(const FaceSet& faces, const TreeOptions& options, const ByArea& by_area);
    void sort_bins_by_id();
    Ref<const Node> pack_leaf(std::uint32_t bin);

    const FaceSet* faces_ = nullptr;
    BinTree tree_;
    FaceLayout layout_;
    BinWidener widener_;
};

/// Blocks of all faces, those of each part apart.
/// @return an index over the faces of each part, parts ascending; none for no faces
struct PartIndex {
    std::uint32_t part = 0;
    Ref<const Node> root;
};
std::vector<PartIndex> build_blocks(const FaceSet& faces, const TreeOptions& options);

}  // namespace firma
