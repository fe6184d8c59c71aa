// SPDX-License-Identifier: MIT
// Long rows of cuts and fills that touch.
#include "tests/reference/judge_digs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "firma/grid.h"
#include "firma/solid.h"
#include "scenes/cut_families.h"
#include "scenes/lattice_solids.h"
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

    DigVerdict run() {
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
        ++(changed == 0 ? verdict_.nothing : verdict_.done);
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
    DigVerdict verdict_;
};

class MixedDig {
public:
    explicit MixedDig(std::uint64_t seed)
        : rng_(seed), unit_(std::ldexp(1.0, int(rng_.below(6)) - 2)), kind_(rng_.below(3)) {
        Pose pose;
        solid_ = unite(Solid(), scenes::box_cutter(Vec3{32, 32, 8} * unit_), pose).solid;
        volume_ = measure_solid(solid_).volume;
        whole_ = volume_;
    }

    DigVerdict run() {
        for (int k = 0; k < kMostCuts && verdict_.failures.empty(); ++k) edit();
        return std::move(verdict_);
    }

private:
    static constexpr int kMostCuts = 80;

    void place(scenes::LatticeSolid solid) {
        solid = scenes::turned(std::move(solid), rng_.below(24));
        cutter_ = scenes::cutter_of(scenes::scaled(std::move(solid), std::int64_t(unit_ * kSurfaceSteps)), "dig",
                                    pose_.position);
    }

    void next_cutter() {
        pose_ = {};
        switch (rng_.below(kind_ == 0 ? 3 : 5)) {
            case 0: {
                const std::int64_t x = 1 + rng_.below(12), y = 1 + rng_.below(12), z = 1 + rng_.below(6);
                place(scenes::block_solid({0, 0, 0}, {x, y, z}));
                break;
            }
            case 1:
                place(scenes::wedge_solid(rng_, 8));
                break;
            case 2:
                place(scenes::bent_solid(rng_, 1 + int(rng_.below(3))));
                break;
            case 3: {
                const auto shape = CutterShape(rng_.below(5));
                cutter_ = make_crater(shape, rng_.next());
                pose_.rotation = random_turn(rng_.next());
                pose_.scale = unit_ * rng_.uniform(0.5, 6);
                break;
            }
            default:
                place(scenes::gear_solid(rng_, 1 + rng_.below(4)));
        }
        for (int axis = 0; axis < 3; ++axis) {
            const int reach = axis == 2 || kind_ == 2 ? 8 : 32;
            pose_.position[axis] += (int(rng_.below(std::uint32_t(2 * reach + 1))) - reach) * unit_;
        }
    }

    void edit() {
        next_cutter();
        const auto cut = rng_.chance(0.4) ? unite : subtract;
        const SolidResult result = cut(solid_, cutter_, pose_, {});
        ++verdict_.edits;
        if (result.status == CarveStatus::kRefused) {
            if (subtract(Solid(), cutter_, pose_).status != CarveStatus::kRefused)
                return fail("refused: " + result.error.text());
            ++verdict_.unplaceable;
            return;
        }
        ++(result.done() ? verdict_.done : verdict_.nothing);
        if (!result.done()) return;
        if (const auto fault = check_solid(result.solid)) return fail(fault->what);
        const double volume = measure_solid(result.solid).volume;
        if (!(std::fabs(volume_ - result.report.volume - volume) < 1e-12 * whole_))
            return fail("its volume is another");
        if (cut(result.solid, cutter_, pose_, {}).status != CarveStatus::kNothing)
            return fail("the same again finds something");
        solid_ = result.solid;
        volume_ = volume;
    }

    void fail(const std::string& what) {
        verdict_.failures.push_back("edit " + std::to_string(verdict_.edits) + " of units of " + std::to_string(unit_) +
                                    " m, kind " + std::to_string(kind_) + ": " + what);
    }

    scenes::Rng rng_;
    const double unit_;  ///< metres
    const std::uint32_t kind_;
    Solid solid_;
    double volume_ = 0, whole_ = 0;
    Cutter cutter_;
    Pose pose_;
    DigVerdict verdict_;
};

}  // namespace

DigVerdict judge_lattice_dig(std::uint64_t seed) {
    return LatticeDig(seed).run();
}

DigVerdict judge_mixed_dig(std::uint64_t seed) {
    return MixedDig(seed).run();
}

}  // namespace firma::reference
