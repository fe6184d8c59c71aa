// SPDX-License-Identifier: MIT
// One try to move a cutter aside: vertices moved, judged, and a solid made of them.
#include "carve/cutter_mover.h"

#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "carve/check_shells.h"

namespace firma {
namespace {

CutterMover::Outcome failed(const PairBudget& budget) {
    return budget.spent() ? CutterMover::Outcome::kTooManyPairs : CutterMover::Outcome::kUnsound;
}

}  // namespace

void CutterMover::touched(std::vector<std::uint32_t>& vertices) {
    if (!is_large()) return;
    touching_.swap(vertices);
    if (touching_.empty())
        for (std::uint32_t v = 0; v < placed_.vertices.size(); ++v) touching_.push_back(v);
    sort_range(touching_);
    touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
}

CutterMover::Outcome CutterMover::move_all(int tries, CutterSolid& cutter, PairBudget& budget) const {
    Result<PlacedCutter> moved = move_cutter(placed_, tries);
    if (!moved) return Outcome::kUnsound;
    if (check_cutter(moved.value(), &budget)) return failed(budget);
    make_cutter_solid(std::move(moved).value(), cutter);
    return Outcome::kMoved;
}

/// While tries fail, `touching_` stays what it is: all other vertices are where they were when the cutter passed last,
/// which is why only triangles at these are judged again.
CutterMover::Outcome CutterMover::move_what_touches(int tries, CutterSolid& cutter, PairBudget& budget) const {
    // A try goes through all triangles some times, judged or not.
    if (!budget.take(placed_.triangles.size())) return Outcome::kTooManyPairs;
    Result<PlacedCutter> moved = move_vertices(placed_, cutter.placed, touching_, tries);
    if (!moved) return Outcome::kUnsound;
    const std::vector<std::uint32_t> triangles = update_cutter_solid(std::move(moved).value(), touching_, cutter);
    if (check_moved_cutter(cutter.placed, triangles, cutter.tree, &budget)) return failed(budget);
    return Outcome::kMoved;
}

}  // namespace firma
