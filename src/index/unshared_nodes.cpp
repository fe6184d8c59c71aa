// SPDX-License-Identifier: MIT
// The nodes that only one of two sets of indices has. A node has more facets than any below it: when those of so many
// facets are compared, all of them are at hand, whatever level they stand at.
#include "index/unshared_nodes.h"

#include <algorithm>
#include <functional>

#include "base/sort.h"

namespace firma {
namespace {

/// Nodes to look at, the one with most facets first.
class Waiting {
public:
    void add(const Node& node) {
        nodes_.push_back(&node);
        std::push_heap(nodes_.begin(), nodes_.end(), fewer);
    }
    std::uint32_t most() const { return nodes_.empty() ? 0 : nodes_[0]->facets_below; }

    /// Takes out all of so many facets, in order of address: for comparing with another such list, and nothing else.
    void take(std::uint32_t facets, std::vector<const Node*>& taken) {
        taken.clear();
        while (most() == facets) {
            std::pop_heap(nodes_.begin(), nodes_.end(), fewer);
            taken.push_back(nodes_.back());
            nodes_.pop_back();
        }
        sort_range(taken, std::less<const Node*>());
        taken.erase(std::unique(taken.begin(), taken.end()), taken.end());  // below several roots
    }

private:
    static bool fewer(const Node* a, const Node* b) { return a->facets_below < b->facets_below; }

    std::vector<const Node*> nodes_;
};

/// Notes and opens the nodes that the others do not have.
void open(const std::vector<const Node*>& mine, const std::vector<const Node*>& others, Waiting& waiting,
          std::vector<const Node*>& unshared) {
    for (const Node* node : mine) {
        if (std::binary_search(others.begin(), others.end(), node, std::less<const Node*>())) continue;
        unshared.push_back(node);
        for (const Ref<const Node>& child : node->children) waiting.add(*child);
    }
}

}  // namespace

UnsharedNodes unshared_nodes(std::span<const Node* const> before, std::span<const Node* const> after) {
    UnsharedNodes found;
    Waiting old_nodes, new_nodes;
    for (const Node* root : before) old_nodes.add(*root);
    for (const Node* root : after) new_nodes.add(*root);
    std::vector<const Node*> olds, news;
    while (const std::uint32_t most = std::max(old_nodes.most(), new_nodes.most())) {
        old_nodes.take(most, olds);
        new_nodes.take(most, news);
        open(olds, news, old_nodes, found.before);
        open(news, olds, new_nodes, found.after);
    }
    return found;
}

}  // namespace firma
