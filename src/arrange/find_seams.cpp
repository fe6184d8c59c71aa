// SPDX-License-Identifier: MIT
// Where faces of the result become one across a piece, which then is an edge of neither.
#include "arrange/find_seams.h"

#include <algorithm>
#include <optional>

namespace firma {

SeamFinder::SeamFinder(KeptCells& in) : in_(in), met_(in.overlay.faces.size(), 0) {}

template <class BecomesOne>
void SeamFinder::for_each_seam(std::uint32_t piece, const BecomesOne& becomes_one) {
    const auto uses = in_.users.at(piece);
    std::optional<bool> complete;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (!in_.is_kept(uses[i]) || !in_.uses[uses[i]].forward || in_.dissolved[uses[i]]) continue;
        for (std::size_t j = 0; j < uses.size(); ++j) {
            if (!in_.is_kept(uses[j]) || in_.uses[uses[j]].forward || in_.dissolved[uses[j]]) continue;
            if (in_.plane_of(in_.users.cell_of(uses[i])) != in_.plane_of(in_.users.cell_of(uses[j]))) continue;
            if (in_.uses[uses[i]].edge != in_.uses[uses[j]].edge) {
                if (!complete) complete = is_complete(piece);
                if (!*complete) continue;
            }
            if (!becomes_one(uses[i], uses[j])) continue;
            in_.dissolved[uses[i]] = in_.dissolved[uses[j]] = 1;
            in_.across[uses[i]] = uses[j];
            in_.across[uses[j]] = uses[i];
            in_.contact[in_.lines.piece(piece).from] = in_.contact[in_.lines.piece(piece).to] = 1;
            break;
        }
    }
}

void SeamFinder::find_contacts(std::uint32_t piece) {
    if (!in_.users.shared(piece)) return;
    for (const std::uint32_t use : in_.users.at(piece)) met_[in_.cells.cells[in_.users.cell_of(use)].face] = 1;
    in_.contact[in_.lines.piece(piece).from] = 1;
    in_.contact[in_.lines.piece(piece).to] = 1;
}

void SeamFinder::merge_across(std::uint32_t piece) {
    for_each_seam(piece, [&](std::uint32_t use, std::uint32_t other) {
        const std::uint32_t a = in_.users.cell_of(use), b = in_.users.cell_of(other);
        if (in_.groups.find(a) == in_.groups.find(b)) return true;
        if (!may_merge(use, other) || !are_alike(a, b)) return false;
        const GridBox box = box_of_both(a, b);
        if (!of_one_face(a, b) && box.longest_extent() > in_.selection.longest) return false;
        in_.groups.join(a, b);
        in_.box[in_.groups.find(a)] = box;
        return true;
    });
}

void SeamFinder::dissolve_within(std::uint32_t piece) {
    for_each_seam(piece,
                  [&](std::uint32_t use, std::uint32_t other) { return in_.group_of(use) == in_.group_of(other); });
}

bool SeamFinder::may_merge(std::uint32_t use, std::uint32_t other) const {
    if (in_.users.shared(in_.uses[use].piece)) return true;
    return in_.uses[use].edge != FacePiece::kNoEdge && in_.uses[use].edge == in_.uses[other].edge &&
           (meets_other(use) || meets_other(other));
}

bool SeamFinder::meets_other(std::uint32_t use) const {
    return met_[in_.cells.cells[in_.users.cell_of(use)].face] != 0;
}

bool SeamFinder::of_one_face(std::uint32_t a, std::uint32_t b) const {
    return in_.cells.cells[a].face == in_.cells.cells[b].face;
}

bool SeamFinder::are_alike(std::uint32_t a, std::uint32_t b) const {
    return of_one_face(a, b) || in_.selection.alike(in_.cells.cells[a].face, in_.cells.cells[b].face);
}

GridBox SeamFinder::box_of_both(std::uint32_t a, std::uint32_t b) {
    GridBox box = in_.box[in_.groups.find(a)];
    box.add(in_.box[in_.groups.find(b)]);
    return box;
}

bool SeamFinder::is_complete(std::uint32_t piece) const {
    if (in_.users.shared(piece)) return true;
    const auto uses = in_.users.at(piece);
    return std::all_of(uses.begin(), uses.end(),
                       [&](std::uint32_t use) { return in_.mate_of(use) != KeptCells::kNone; });
}

}  // namespace firma
