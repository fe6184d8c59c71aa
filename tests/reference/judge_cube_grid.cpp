// SPDX-License-Identifier: MIT
// A grid of cubes.
#include "tests/reference/judge_cube_grid.h"

#include <cmath>
#include <functional>
#include <utility>

#include "firma/carve.h"
#include "firma/solid.h"
#include "scenes/cut_families.h"
#include "tests/reference/carve_oracle.h"

namespace firma::reference {
namespace {

constexpr std::size_t kGridFailuresKept = 8;

struct Cell {
    int x, y, z;
};

class CubeJudge {
public:
    explicit CubeJudge(const CubeGrid& grid)
        : grid_(grid), cube_(scenes::box_cutter({grid.edge / 2, grid.edge / 2, grid.edge / 2})) {}

    CubeGridVerdict verdict;

    std::vector<Cell> cells(std::uint64_t shuffle, const std::function<bool(const Cell&)>& which) const {
        std::vector<Cell> all;
        for (int z = 0; z < grid_.side; ++z)
            for (int y = 0; y < grid_.side; ++y)
                for (int x = 0; x < grid_.side; ++x)
                    if (which({x, y, z})) all.push_back({x, y, z});
        scenes::Rng rng(grid_.order * 16 + shuffle);
        if (grid_.order > 0)
            for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[rng.below(std::uint32_t(k))]);
        return all;
    }

    /// @param before  cubes that are there
    World edit(World world, const std::vector<Cell>& order, CarveKind kind, std::size_t before) {
        std::size_t there = before;
        for (std::size_t k = 0; k < order.size(); ++k) {
            scenes::CutOrder cut{cube_, {}, kind};
            cut.pose.position = Vec3{order[k].x + 0.5, order[k].y + 0.5, order[k].z + 0.5} * grid_.edge;
            const CarveResult result =
                kind == CarveKind::kFill ? fill(world, cut.cutter, cut.pose) : carve(world, cut.cutter, cut.pose);
            ++verdict.edits;
            verdict.refused += result.status == CarveStatus::kRefused;
            const std::string what = (kind == CarveKind::kFill ? "fill " : "carve ") + std::to_string(k) + " at " +
                                     std::to_string(order[k].x) + ' ' + std::to_string(order[k].y) + ' ' +
                                     std::to_string(order[k].z) + ": ";
            if (!result.done()) {
                fail(what + (result.status == CarveStatus::kNothing ? "nothing" : result.error.text()));
                continue;
            }
            there += kind == CarveKind::kFill ? 1 : -1;
            world = result.world;
            if (k % 32 == 0 || k + 1 == order.size()) judge(world, there, what);
        }
        return world;
    }

    void judge(const World& world, std::size_t cubes, const std::string& what) {
        if (const auto fault = check_solid(world)) fail(what + fault->what);
        const double expected = double(cubes) * grid_.edge * grid_.edge * grid_.edge;
        const double volume = measure_solid(world).volume;
        if (std::fabs(volume - expected) > expected * 1e-14)
            fail(what + "volume " + std::to_string(volume) + " instead of " + std::to_string(expected));
    }

    void fail(const std::string& what) {
        if (verdict.failures.size() < kGridFailuresKept) verdict.failures.push_back(what);
    }

private:
    const CubeGrid grid_;
    const Cutter cube_;
};

}  // namespace

CubeGridVerdict judge_cube_grid(const CubeGrid& grid) {
    CubeJudge judge(grid);
    const auto all = [](const Cell&) { return true; };
    const auto board = [](const Cell& cell) { return (cell.x + cell.y + cell.z) % 2 == 0; };
    const auto half = [&](const Cell& cell) { return 2 * cell.x < grid.side; };
    const std::vector<Cell> cells = judge.cells(1, all);

    const World full = judge.edit(World(), cells, CarveKind::kFill, 0);
    judge.verdict.faces_full = measure_solid(full).faces;
    const World none = judge.edit(full, judge.cells(2, all), CarveKind::kCarve, cells.size());
    if (none.face_count() != 0) judge.fail(std::to_string(none.face_count()) + " faces are left");
    if (measure_solid(none).volume != 0) judge.fail("some volume is left");

    const std::pair<const char*, std::function<bool(const Cell&)>> patterns[] = {{"board", board}, {"half", half}};
    for (const auto& [name, kept] : patterns) {
        const auto carved = [&](const Cell& cell) { return !kept(cell); };
        const World left = judge.edit(full, judge.cells(3, carved), CarveKind::kCarve, cells.size());
        const World built = judge.edit(World(), judge.cells(4, kept), CarveKind::kFill, 0);
        if (!reference::same_solid(left, built))
            judge.fail(std::string(name) + ": another solid than what was built alone");
        if (hash_solid(left) != hash_solid(built)) judge.fail(std::string(name) + ": another hash_solid");
        if (measure_solid(left).volume != measure_solid(built).volume)
            judge.fail(std::string(name) + ": another volume");
    }
    return std::move(judge.verdict);
}

}  // namespace firma::reference
