// SPDX-License-Identifier: MIT
// Judges cuts in contact.
#include "tests/reference/judge_contact.h"

#include <cmath>
#include <cstdio>

#include "firma/solid.h"
#include "tests/reference/carve_oracle.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

using scenes::CutOrder;

CutOrder opposite(CutOrder order) {
    order.kind = order.kind == CarveKind::kFill ? CarveKind::kCarve : CarveKind::kFill;
    return order;
}

/// By the reference, by hash and by volume: what of them says otherwise; empty when all say the same solid.
std::string differs(const World& a, const World& b) {
    if (!reference::same_solid(a, b)) return "another solid";
    if (hash_solid(a) != hash_solid(b)) return "the same solid of another hash";
    const double one = measure_solid(a).volume, other = measure_solid(b).volume;
    // Of sums of 100 bits, in steps of the grid; rounded once or twice.
    if (std::fabs(one - other) > std::fabs(one) * 0x1p-50 + 1e-15) return "the same solid of another volume";
    return "";
}

class CutInContact {
public:
    CutInContact(const World& before, const CutOrder& order, const CarveResult& result, const std::string& where,
                 CutTally& tally)
        : before_(before), after_(result.world), order_(order), result_(result), where_(where), tally_(tally) {}

    bool holds() const { return holds_; }

    void judge_place() {
        // No position is refused. That nothing was moved shows in volumes and points: they are those of the cutter
        // where snapping put it.
        if (result_.status == CarveStatus::kRefused) fail("refused: " + result_.error.text());
    }

    void judge_faces() {
        const std::string doubled = doubled_face(after_, compare_facets(before_, after_).come);
        if (!doubled.empty()) fail(doubled);
        if (reference::same_solid(before_, after_)) fail("done, and yet the solid is the same");
    }

    void judge_again() {
        ++tally_.again;
        const CarveResult again = make_cut(after_, order_);
        if (again.status == CarveStatus::kDone) fail("the same cut again is done again");
        if (again.status == CarveStatus::kRefused) fail("the same cut again is refused: " + again.error.text());
    }

    /// (W - C + C) - C = W - C, and (W + C - C) + C = W + C.
    void judge_back() {
        ++tally_.reversed;
        const CarveResult back = make_cut(after_, opposite(order_));
        if (back.status == CarveStatus::kRefused) return fail("back refused: " + back.error.text());
        if (back.status == CarveStatus::kNothing) return fail("back it answers nothing");
        const CarveResult forth = make_cut(back.world, order_);
        if (forth.status == CarveStatus::kRefused) return fail("back and forth refused: " + forth.error.text());
        if (const std::string what = differs(after_, forth.world); !what.empty()) fail("back and forth: " + what);
        tally_.grown += measure_solid(forth.world).faces > measure_solid(after_).faces;
    }

    void judge_point(const CutHistory& history, std::span<const Triangle> surface, const Vec3& p) {
        const std::optional<bool> expected = history.solid_at(p);
        if (!expected) return;
        ++tally_.history_points;
        char text[120];
        std::snprintf(text, sizeof text, " (%.17g, %.17g, %.17g)", p.x, p.y, p.z);
        const double turns = winding(surface, p) + after_.data().rock_outside();
        if (std::fabs(turns - *expected) > 1e-3)
            return fail("by level and cutters a point is " + std::string(*expected ? "solid" : "air") +
                        ", and the surface winds otherwise around" + text);
        const Where where = locate(after_.solid(), p);
        if (where != (*expected ? Where::kSolid : Where::kAir))
            fail("locate() puts a point on the wrong side:" + std::string(text));
    }

    void fail(const std::string& what) {
        tally_.fail(where_, what);
        holds_ = false;
    }

private:
    const World &before_, &after_;
    const CutOrder& order_;
    const CarveResult& result_;
    const std::string& where_;
    CutTally& tally_;
    bool holds_ = true;
};

Vec3 point_around(const PlacedCutter& cutter, scenes::Rng& rng) {
    Box box;
    for (const InputPoint& p : cutter.vertices) box.add(to_metres(to_surface(p)));
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const double wide = (box.high[axis] - box.low[axis]) * 0.3;
        point[axis] = rng.uniform(box.low[axis] - wide, box.high[axis] + wide);
    }
    return point;
}

}  // namespace

bool ContactJudge::judge(const World& before, const CutOrder& order, const CarveResult& result, scenes::Rng& rng,
                         const std::string& where, CutTally& tally) {
    CutInContact cut(before, order, result, where, tally);
    cut.judge_place();
    const std::optional<PlacedCutter> placed = placed_cutter(order, result.report);
    if (result.status == CarveStatus::kRefused || !placed) return cut.holds();
    history_.add(*placed, order.kind);
    const std::vector<Triangle> surface = triangles_of(result.world);
    for (int k = 0; k < options_.history_points; ++k)
        cut.judge_point(history_, surface, k % 2 ? history_.point_beside(rng) : point_around(*placed, rng));
    if (!result.done()) return cut.holds();
    cut.judge_faces();
    cut.judge_again();
    if (rng.chance(options_.back)) cut.judge_back();
    return cut.holds();
}

}  // namespace firma::reference
