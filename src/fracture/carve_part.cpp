// SPDX-License-Identifier: MIT
// Parts cut in pieces: what still holds which, and what falls.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "firma/break_parts.h"
#include "firma/part_edits.h"
#include "firma/rooms.h"
#include "fracture/part_pieces.h"
#include "fracture/piece_spheres.h"
#include "moving/part_frame.h"
#include "moving/touch_sides.h"

namespace firma {
namespace {

/// Of the way from the middle of a cutter's box, or of a portal, to its corners.
constexpr double kTowardCorners = 0.9375;
/// Metres between points that are asked about.
constexpr double kApart = 0.125;

class PartCutter {
public:
    PartCutter(const World& level, MovingPart& part, const PartCutOptions& options)
        : level_(level), part_(part), options_(options) {
        result_.level = level;
    }

    PartCut cut(Breakable* breakable, const Cutter& cutter, const Pose& pose, Bodies& bodies, Debris& debris) {
        const World before = part_.world();
        const Pose seen = pose_in_part(part_, options_.pieces.fraction, pose);
        const bool was_held = options_.hold == PartHold::kLevel && is_held(before.solid());
        CarveOptions alone = options_.carve;
        alone.chunks.reset();
        CarveResult whole = carve(before, cutter, seen, alone);
        take(whole);
        if (!whole.done()) return std::move(result_);
        BreakOptions breaks = options_.pieces;
        const std::vector<PortalId> closed = portals_closed_by(level_, part_);
        breaks.portals.insert(breaks.portals.end(), closed.begin(), closed.end());
        part_.set_world(whole.world);
        for (const PortalId portal : closed)
            if (!covers(portal)) open(portal);
        const std::vector<Solid> pieces = connected_pieces(whole.world.solid());
        const std::vector<bool> held = held_pieces(pieces, was_held);
        const auto count = std::size_t(std::count(held.begin(), held.end(), true));
        if (count == 0) {
            BreakOptions falls = breaks;
            falls.unbroken = true;
            break_rest(breakable, bodies, debris, falls);
        } else if (count < pieces.size()) {
            drop(before, cutter, seen, pieces, held, bodies, debris);
        }
        if (breakable && is_too_little(*breakable)) break_rest(breakable, bodies, debris, breaks);
        return std::move(result_);
    }

private:
    void take(const CarveResult& made) {
        result_.status = made.status;
        result_.error = made.error;
        result_.report = made.report;
    }

    void break_rest(Breakable* breakable, Bodies& bodies, Debris& debris, const BreakOptions& how) {
        result_.broken = break_part(result_.level, part_, breakable, bodies, debris, how);
        result_.level = result_.broken->level;
        const std::vector<PortalId>& more = result_.broken->opened;
        result_.opened.insert(result_.opened.end(), more.begin(), more.end());
        std::sort(result_.opened.begin(), result_.opened.end());
    }

    void open(PortalId portal) {
        if (portal_info(result_.level, portal)->open) return;
        result_.level = *set_portal_open(result_.level, portal, true);
        result_.opened.push_back(portal);
    }

    /// Whether points all over a portal lie in the part, where its motion begins.
    bool covers(PortalId portal) const {
        const PartFrame frame(part_.motion, 0);
        for (const std::vector<Vec3>& polygon : portal_polygons(level_, portal)) {
            Vec3 middle;
            for (const Vec3& corner : polygon) middle += corner * (1.0 / double(polygon.size()));
            for (std::size_t k = 0; k < polygon.size(); ++k)
                if (!covers(frame, middle, polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0])) return false;
        }
        return true;
    }
    /// Of a triangle from the middle of a polygon to a side, a sixteenth of the way in from that.
    bool covers(const PartFrame& frame, const Vec3& middle, const Vec3& from, const Vec3& to) const {
        const Vec3 a = (from - middle) * kTowardCorners, b = (to - middle) * kTowardCorners;
        const double longest = std::max({length(a), length(b), length(b - a)});
        const int steps = int(std::clamp(std::ceil(longest / kApart), 1.0, 256.0));
        for (int row = 0; row <= steps; ++row)
            for (int column = 0; column <= row; ++column) {
                const Vec3 at = middle + a * (double(row - column) / steps) + b * (double(column) / steps);
                if (locate(part_.world(), frame.in(at)).where != Where::kSolid) return false;
            }
        return true;
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
        if (const auto air = air_of_cut(cutter, seen)) anchors.volumes.push_back(*air);
        CarveOptions options = options_.carve;
        if (!options.chunks) options.chunks = ChunkOptions{};
        CarveResult made = carve(with_anchors(before, anchors), cutter, seen, options);
        if (!made.done()) return;  // the same cut was done before: what it left stays
        take(made);
        const PartPieces loose(result_.level, part_, options_.pieces);
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
        const SphereSet balls = piece_spheres(solid, 1).spheres;
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

    /// A place in the air that the cutter's box holds: as if what held all that the cut meets had been there. Without
    /// it a piece that the cut does not divide is left hanging, although it cut off what that stood on.
    std::optional<Box> air_of_cut(const Cutter& cutter, const Pose& seen) const {
        const TurnMatrix turn = matrix_of(normalised(seen.rotation));
        Box box;
        for (const Vec3& vertex : cutter.vertices()) box.add(seen.position + turn * vertex * seen.scale);
        const Vec3 middle = (box.low + box.high) * 0.5;
        for (int k = 0; k < 9; ++k) {
            Vec3 at = middle;
            for (int axis = 0; axis < 3 && k > 0; ++axis)
                at[axis] +=
                    (box.high[axis] - middle[axis]) * (((k - 1) >> axis & 1) ? -kTowardCorners : kTowardCorners);
            if (locate(part_.world().solid(), at) == Where::kAir) return Box{at, at};
        }
        return std::nullopt;
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
