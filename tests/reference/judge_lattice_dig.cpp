// SPDX-License-Identifier: MIT
// Boxes on a lattice dug out of a block and filled in again.
#include "tests/reference/judge_lattice_dig.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "firma/solid.h"
#include "scenes/cut_families.h"
#include "scenes/rng.h"

namespace firma::reference {
namespace {

constexpr int kCells = 16;
constexpr int kMostBoxes = 60;
constexpr int kAsked = 8;  ///< cells whose middles are located after an edit

struct CellBox {
    std::array<int, 3> low, high;

    template <class Function>
    void for_each(const Function& function) const {
        for (int z = low[2]; z < high[2]; ++z)
            for (int y = low[1]; y < high[1]; ++y)
                for (int x = low[0]; x < high[0]; ++x) function(std::size_t((z * kCells + y) * kCells + x));
    }
    CellBox within() const {
        CellBox box;
        for (std::size_t k = 0; k < 3; ++k) box.low[k] = std::max(low[k], 0), box.high[k] = std::min(high[k], kCells);
        return box;
    }
    bool empty() const { return low[0] >= high[0] || low[1] >= high[1] || low[2] >= high[2]; }
};

class LatticeDig {
public:
    explicit LatticeDig(std::uint64_t seed)
        : rng_(seed),
          edge_(std::ldexp(1.0, int(rng_.below(7)) - 1)),
          most_(1 + int(rng_.below(6))),
          kind_(rng_.below(3)) {
        edit({{0, 0, 0}, {kCells, kCells, kCells}}, true);
    }

    LatticeDigVerdict run() {
        for (int k = 0; k < kMostBoxes && verdict_.failures.empty(); ++k) {
            const CellBox box = next_box();
            const bool fills = rng_.chance(0.35);
            // What is filled stays within the block.
            if (!fills || !box.within().empty()) edit(fills ? box.within() : box, fills);
        }
        if (verdict_.failures.empty()) edit({{-1, -1, -1}, {kCells + 1, kCells + 1, kCells + 1}}, false);
        if (verdict_.failures.empty() && solid_.face_count() > 0) fail("faces are left");
        return std::move(verdict_);
    }

private:
    CellBox next_box() {
        CellBox box;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int length = 1 + int(rng_.below(std::uint32_t(most_)));
            box.low[axis] = int(rng_.below(kCells + 2)) - 1;
            if (kind_ == 2) box.low[axis] = box.low[axis] / 4 * 4;
            box.high[axis] = box.low[axis] + (kind_ == 2 ? 4 : length);
        }
        if (kind_ == 1) {
            box.low[2] = kCells - 2 - int(rng_.below(2));
            box.high[2] = kCells + 1;
        }
        return box;
    }

    void edit(const CellBox& box, bool fills) {
        std::size_t changed = 0;
        box.within().for_each([&](std::size_t cell) {
            changed += full_[cell] != fills;
            full_[cell] = fills;
        });
        Vec3 half;
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = std::size_t(axis);
            half[axis] = (box.high[k] - box.low[k]) * edge_ / 2;
            pose.position[axis] = (box.high[k] + box.low[k]) * edge_ / 2;
        }
        const Cutter cutter = scenes::box_cutter(half);
        const SolidResult result = fills ? unite(solid_, cutter, pose) : subtract(solid_, cutter, pose);
        ++verdict_.edits;
        verdict_.nothing += changed == 0;
        if (result.status == CarveStatus::kRefused) return fail("refused: " + result.error.text());
        if ((result.status == CarveStatus::kNothing) != (changed == 0))
            return fail(std::to_string(changed) + " cells change, and it says otherwise");
        const double volume = (fills ? -1.0 : 1.0) * double(changed) * edge_ * edge_ * edge_;
        if (result.report.volume != volume) return fail("its volume is " + std::to_string(result.report.volume));
        if (const auto fault = check_solid(result.solid)) return fail(fault->what);
        solid_ = result.solid;
        for (int k = 0; k < kAsked; ++k) {
            const std::array<int, 3> at{int(rng_.below(kCells)), int(rng_.below(kCells)), int(rng_.below(kCells))};
            const bool full = full_[std::size_t((at[2] * kCells + at[1]) * kCells + at[0])];
            const Where where = locate(solid_, Vec3{at[0] + 0.5, at[1] + 0.5, at[2] + 0.5} * edge_);
            if (where != (full ? Where::kSolid : Where::kAir)) return fail("a cell lies on the wrong side");
        }
    }

    void fail(const std::string& what) {
        verdict_.failures.push_back("edit " + std::to_string(verdict_.edits) + " of cells of " + std::to_string(edge_) +
                                    " m, kind " + std::to_string(kind_) + ": " + what);
    }

    scenes::Rng rng_;
    const double edge_;  ///< metres
    const int most_;     ///< cells of a box
    const std::uint32_t kind_;
    Solid solid_;
    std::vector<bool> full_ = std::vector<bool>(std::size_t(kCells) * kCells * kCells, false);
    LatticeDigVerdict verdict_;
};

}  // namespace

LatticeDigVerdict judge_lattice_dig(std::uint64_t seed) {
    return LatticeDig(seed).run();
}

}  // namespace firma::reference
