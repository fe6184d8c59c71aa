// SPDX-License-Identifier: MIT
// Parts cut in pieces: what still holds which, and what falls.
#include <algorithm>
#include <utility>

#include "firma/break_parts.h"
#include "firma/part_edits.h"
#include "fracture/part_pieces.h"
#include "fracture/piece_spheres.h"
#include "moving/touch_sides.h"

namespace firma {
namespace {

class PartCutter {
public:
    PartCutter(const World& level, MovingPart& part, const PartCutOptions& options)
        : level_(level), part_(part), options_(options) {}

    PartCut cut(Breakable* breakable, const Cutter& cutter, const Pose& pose, Bodies& bodies, Debris& debris) {
        const World before = part_.world();
        const Pose seen = pose_in_part(part_, options_.pieces.fraction, pose);
        const bool was_held = options_.hold == PartHold::kLevel && is_held(before.solid());
        CarveOptions alone = options_.carve;
        alone.chunks.reset();
        CarveResult whole = carve(before, cutter, seen, alone);
        take(whole);
        if (!whole.done()) return std::move(result_);
        // Those that it closed before: with a hole in it it covers none.
        BreakOptions breaks = options_.pieces;
        for (const PortalId portal : portals_closed_by(level_, part_)) breaks.portals.push_back(portal);
        part_.set_world(whole.world);
        const std::vector<Solid> pieces = connected_pieces(whole.world.solid());
        const std::vector<bool> held = held_pieces(pieces, was_held);
        const auto count = std::size_t(std::count(held.begin(), held.end(), true));
        if (count == 0) {
            breaks.unbroken = true;
            result_.broken = break_part(level_, part_, breakable, bodies, debris, breaks);
        } else if (count < pieces.size()) {
            drop(before, cutter, seen, pieces, held, bodies, debris);
        }
        if (breakable && is_too_little(*breakable))
            result_.broken = break_part(level_, part_, breakable, bodies, debris, breaks);
        return std::move(result_);
    }

private:
    void take(const CarveResult& made) {
        result_.status = made.status;
        result_.error = made.error;
        result_.report = made.report;
    }

    bool is_held(const Solid& solid) const {
        const Result<World> alone = make_world(solid);
        if (!alone) return false;
        const auto sides = support_sides(MovingPart(alone.value(), part_.motion), options_.pieces.fraction);
        return !touched_parts(level_, sides, options_.touch, options_.touch, kStopsSolid).empty();
    }

    std::vector<bool> held_pieces(const std::vector<Solid>& pieces, bool by_level) const {
        std::vector<bool> held(pieces.size());
        if (by_level) {
            for (std::size_t k = 0; k < pieces.size(); ++k) held[k] = is_held(pieces[k]);
            return held;
        }
        std::size_t largest = 0;
        double most = 0;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const double volume = mass_properties(pieces[k], 1).volume;
            if (volume > most) {
                most = volume;
                largest = k;
            }
        }
        if (!pieces.empty()) held[largest] = true;
        return held;
    }

    /// Cuts again, with what is held named, so that the rest comes loose within the cut.
    void drop(const World& before, const Cutter& cutter, const Pose& seen, const std::vector<Solid>& pieces,
              const std::vector<bool>& held, Bodies& bodies, Debris& debris) {
        AnchorRules anchors;
        anchors.hanging = false;
        for (std::size_t k = 0; k < pieces.size(); ++k)
            if (held[k]) anchors.volumes.push_back(box_within(pieces[k]));
        CarveOptions options = options_.carve;
        if (!options.chunks) options.chunks = ChunkOptions{};
        CarveResult made = carve(with_anchors(before, anchors), cutter, seen, options);
        if (!made.done()) return;  // the same cut was done before: what it left stays
        take(made);
        const PartPieces loose(level_, part_, options_.pieces);
        for (const Chunk& chunk : made.chunks) {
            DebrisPiece piece;
            piece.solid = chunk.solid;
            piece.origin = chunk.origin;
            piece.matter = main_matter(chunk);
            if (const auto id = loose.add(bodies, debris, std::move(piece), chunk.mass))
                result_.loose.push_back(*id);
            else
                ++result_.unfit;
        }
        part_.set_world(with_anchors(made.world));  // what hangs in it now stays, for who carves it by itself
    }

    /// A box that reaches into a piece, and into nothing beside it.
    static Box box_within(const Solid& solid) {
        const SphereSet balls = piece_spheres(solid, 1);
        if (!balls.empty()) {
            const double half = balls[0].radius * 0.5;
            return {balls[0].centre - Vec3{half, half, half}, balls[0].centre + Vec3{half, half, half}};
        }
        // So thin that no ball is in it: at a corner.
        Box box;
        const Result<World> alone = make_world(solid);
        if (!alone) return box;
        each_face(alone.value(), [&](const FaceView& face) {
            box.add(face.corners[0]);
            return false;
        });
        return box;
    }

    bool is_too_little(const Breakable& breakable) const {
        if (breakable.broken || !(breakable.whole > 0) || part_.world().face_count() == 0) return false;
        const double left = mass_properties(part_.world().solid(), 1).volume;
        return left < breakable.whole * (1 - breakable.max_taken);
    }

    const World& level_;
    MovingPart& part_;
    const PartCutOptions& options_;
    PartCut result_;
};

}  // namespace

PartCut carve_part(const World& level, MovingPart& part, Breakable* breakable, const Cutter& cutter, const Pose& pose,
                   Bodies& bodies, Debris& debris, const PartCutOptions& options) {
    return PartCutter(level, part, options).cut(breakable, cutter, pose, bodies, debris);
}

}  // namespace firma
