// SPDX-License-Identifier: MIT
// What became of edges that a cut divided.
#include "carve/edge_parts.h"

namespace firma {

EdgeParts::EdgeParts(const SolidPatch& patch, const NewLoops& loops, FaceMaker& maker)
    : patch_(patch), loops_(loops), maker_(maker) {
    const auto note = [&](const PatchEdge& edge) {
        for (const std::uint32_t vertex : edge.vertex) box_.add(patch_.vertices[vertex].point.rounded());
    };
    for (const PatchEdge& edge : patch_.edges)
        if (edge.split()) note(edge);
    const std::vector<EdgeDivision>& divisions = loops_.divisions;
    if (divisions.empty()) return;
    division_of_edge_.assign(patch_.edges.size(), ~0u);
    for (std::uint32_t k = 0; k < divisions.size(); ++k) {
        division_of_edge_[divisions[k].edge] = k;
        note(patch_.edges[divisions[k].edge]);
    }
}

bool EdgeParts::divide(const PatchUse& use, std::vector<SolidUse>& parts) const {
    const PatchEdge& edge = patch_.edges[use.edge];
    if (edge.split()) {
        for (const bool last : {false, true}) {
            const PatchUse half{edge.half[use.reversed != last], use.reversed};
            if (!divide(half, parts)) append(half, parts);
        }
        return true;
    }
    if (division_of_edge_.empty() || division_of_edge_[use.edge] == ~0u) return false;
    const EdgeDivision& division = loops_.divisions[division_of_edge_[use.edge]];
    for (std::uint32_t k = 0; k < division.count; ++k) {
        PatchUse part = loops_.parts[division.first_part + (use.reversed ? division.count - 1 - k : k)];
        part.reversed = part.reversed != use.reversed;
        append(part, parts);
    }
    return true;
}

void EdgeParts::append(const PatchUse& use, std::vector<SolidUse>& uses) const {
    const Ref<const SolidEdge>& edge = maker_.edge(use.edge);
    uses.emplace_back(edge, use.reversed != maker_.runs_against(use.edge, *edge));
}

}  // namespace firma
