// SPDX-License-Identifier: MIT
// The blocks that only one of two sets of trees has. A block has more faces than any below it: when those of so many
// faces are compared, all of them are at hand, whatever level they stand at.
#include "tree/unshared_blocks.h"

#include <algorithm>
#include <functional>

#include "base/sort.h"

namespace firma {
namespace {

/// Blocks to look at, the one with most faces first.
class Waiting {
public:
    void add(const Block& block) {
        blocks_.push_back(&block);
        std::push_heap(blocks_.begin(), blocks_.end(), fewer);
    }
    std::uint32_t most() const { return blocks_.empty() ? 0 : blocks_[0]->faces_below; }

    /// Takes out all of so many faces, in order of address: for comparing with another such list, and nothing else.
    void take(std::uint32_t faces, std::vector<const Block*>& taken) {
        taken.clear();
        while (most() == faces) {
            std::pop_heap(blocks_.begin(), blocks_.end(), fewer);
            taken.push_back(blocks_.back());
            blocks_.pop_back();
        }
        sort_range(taken, std::less<const Block*>());
    }

private:
    static bool fewer(const Block* a, const Block* b) { return a->faces_below < b->faces_below; }

    std::vector<const Block*> blocks_;
};

/// Notes and opens the blocks that the others do not have.
void open(const std::vector<const Block*>& mine, const std::vector<const Block*>& others, Waiting& waiting,
          std::vector<const Block*>& unshared) {
    for (const Block* block : mine) {
        if (std::binary_search(others.begin(), others.end(), block, std::less<const Block*>())) continue;
        unshared.push_back(block);
        for (const Ref<const Block>& child : block->children) waiting.add(*child);
    }
}

}  // namespace

UnsharedBlocks unshared_blocks(std::span<const Block* const> before, std::span<const Block* const> after) {
    UnsharedBlocks found;
    Waiting old_blocks, new_blocks;
    for (const Block* root : before) old_blocks.add(*root);
    for (const Block* root : after) new_blocks.add(*root);
    std::vector<const Block*> olds, news;
    while (const std::uint32_t most = std::max(old_blocks.most(), new_blocks.most())) {
        old_blocks.take(most, olds);
        new_blocks.take(most, news);
        open(olds, news, old_blocks, found.before);
        open(news, olds, new_blocks, found.after);
    }
    return found;
}

}  // namespace firma
