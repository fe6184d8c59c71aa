// SPDX-License-Identifier: MIT
// Matters along a path: where it enters and leaves the pieces of a level, and which of them counts where.
#include "body/matters_along.h"

#include <algorithm>

#include "index/sweep_box.h"
#include "solid/solid_data.h"
#include "world/sweep_world.h"

namespace firma {
namespace {

/// The part of a sweep, between two parameters, that lies behind all planes of a body.
bool clip_by_planes(std::span<const Ref<const SolidPlane>> planes, const Sweep& sweep, double& from, double& to) {
    const Vec3 start = sweep.start * kInputSteps, direction = sweep.direction * kInputSteps;
    for (const Ref<const SolidPlane>& it : planes) {
        const Vec3 normal = it->plane.direction();
        const double height = dot(normal, start) + it->plane.d, rise = dot(normal, direction);
        if (rise > 0)
            to = std::min(to, -height / rise);
        else if (rise < 0)
            from = std::max(from, -height / rise);
        else if (height > 0)
            return false;
    }
    return from < to;
}

class PiecesOnTheWay {
public:
    PiecesOnTheWay(const MatterPieces& all, const CarveRules* rules, const Sweep& sweep, double from, double to,
                   MatterScratch& scratch)
        : all_(all),
          rules_(rules),
          any_hard_(firma::any_hard(all, rules)),
          sweep_(sweep),
          from_(from),
          to_(to),
          scratch_(scratch) {}

    void find() {
        scratch_.pieces.clear();
        const SweepBox boxes(sweep_);
        const auto meets = [&](const GridBox& box) {
            const Vec3 low = to_metres(box.low), high = to_metres(box.high);
            double nearest;
            return boxes.enters(BoxD{{low.x, low.y, low.z}, {high.x, high.y, high.z}}, to_, nearest);
        };
        all_.tree.for_each_where(meets, [&](std::uint32_t number) {
            add(number);
            return false;
        });
    }

private:
    void add(std::uint32_t number) {
        const MatterPiece& piece = all_.pieces[number];
        PieceStretch stretch{from_, to_, true, number, piece.matter};
        if (any_hard_) stretch.soft = !(hardness_of(all_, piece, rules_) >= 1);
        if (piece.plane_count > 0) {
            if (clip_by_planes(all_.planes_of(piece), sweep_, stretch.from, stretch.to))
                scratch_.pieces.push_back(stretch);
        } else if (piece.mesh) {
            add_mesh(*piece.mesh, stretch);
        }
    }

    void add_mesh(const Solid& mesh, PieceStretch stretch) {
        const SolidData& data = mesh.data();
        cross_facets(data.faces.root.get(), sweep_, scratch_.crossings);
        const auto start = [&]() -> unsigned {
            cross_facets(data.faces.root.get(), far_on(sweep_), scratch_.far);
            return starts_inside(scratch_.far, data.rock_outside);
        };
        find_stretches(sweep_, scratch_.crossings, start, scratch_.inside);
        for (const SolidStretch& it : scratch_.inside) {
            stretch.from = std::max(from_, it.from);
            stretch.to = std::min(to_, it.to);
            if (stretch.from < stretch.to) scratch_.pieces.push_back(stretch);
        }
    }

    const MatterPieces& all_;
    const CarveRules* rules_;
    const bool any_hard_;
    const Sweep& sweep_;
    const double from_, to_;
    MatterScratch& scratch_;
};

/// Takes stretches of one matter, one behind the other, and joins those that are alike or too short to tell.
class MatterList {
public:
    MatterList(const Sweep& sweep, double from, std::vector<MatterLength>& found)
        : sweep_(sweep), found_(found), first_(found.size()), from_(from) {}

    void add(double to, std::uint32_t matter, bool last) {
        const bool any = found_.size() > first_;
        const bool tiny = (to - from_) * sweep_.direction_length < kDistanceRounding;
        if (any && (tiny || found_.back().matter == matter))
            end_at(to);
        else if (!tiny || last)
            begin_at(from_, to, matter);
        else
            return;  // what comes next begins where this did
        from_ = to;
    }

private:
    void begin_at(double from, double to, std::uint32_t matter) {
        found_.push_back({matter, sweep_.fraction(from), 0, 0});
        started_ = from;
        end_at(to);
    }
    void end_at(double to) {
        found_.back().to = sweep_.fraction(to);
        found_.back().length = (to - started_) * sweep_.direction_length;
    }

    const Sweep& sweep_;
    std::vector<MatterLength>& found_;
    const std::size_t first_;
    double from_, started_ = 0;
};

}  // namespace

void add_matters_along(const MatterPieces* pieces, const CarveRules* rules, const Sweep& sweep, double from, double to,
                       MatterScratch& scratch, std::vector<MatterLength>& found) {
    MatterList list(sweep, from, found);
    if (!pieces || pieces->pieces.empty()) return list.add(to, pieces ? pieces->rest : 0, true);
    PiecesOnTheWay(*pieces, rules, sweep, from, to, scratch).find();
    for (double at = from; at < to;) {
        const PieceStretch* best = nullptr;
        for (const PieceStretch& it : scratch.pieces)
            if (it.from <= at && at < it.to && (!best || it.counts_before(*best))) best = &it;
        double next = best ? best->to : to;
        for (const PieceStretch& it : scratch.pieces)
            if (it.from > at && it.from < next && (!best || it.counts_before(*best))) next = it.from;
        list.add(next, best ? best->matter : pieces->rest, next >= to);
        at = next;
    }
}

}  // namespace firma
