// SPDX-License-Identifier: MIT
// Wide nodes over nodes that have some.
#include "index/widen.h"

namespace firma {

void BinWidener::widen(Node& node) {
    if (node.children[0]->wide.empty()) return;
    widen(
        node, [&](std::uint32_t bin) { return node.bins[bin].is_leaf() ? node.bins[bin].first : kNone; },
        [&](std::uint32_t child, WideNode& above, std::uint32_t lane) {
            above.child[lane] = node.children[child]->wide.data();
        });
}

}  // namespace firma
