// SPDX-License-Identifier: MIT
// How much of a body is of which matter.
//
// Integrals over a share are those over what was left before it was cut out minus those over what is left after: of
// sums of 100 bits the difference has all the digits that anybody asks for. Most pieces near a body touch it only, and
// one mostly holds all of it: the body's exact corners tell that of convex pieces, and nothing is cut then.
#include "carve/matter_shares.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/sort.h"
#include "solid/boundary.h"

namespace firma {
namespace {

/// Rounded by a step, and the pieces' boxes by another.
GridBox padded(GridBox box) {
    constexpr std::int64_t kPad = 2, kLow = std::numeric_limits<std::int32_t>::min(),
                           kHigh = std::numeric_limits<std::int32_t>::max();
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::int32_t(std::max(box.low[axis] - kPad, kLow));
        box.high[axis] = std::int32_t(std::min(box.high[axis] + kPad, kHigh));
    }
    return box;
}

/// Less of a body than this share of its volume is as good as none of it: a tenth of what masses are held to.
constexpr double kNegligible = 1e-13;

}  // namespace

std::optional<std::uint32_t> only_matter_in(const MatterPieces& pieces, const GridBox& box) {
    const bool several = pieces.tree.for_each_meeting(
        padded(box), [&](std::uint32_t number) { return pieces.pieces[number].matter != pieces.rest; });
    return several ? std::nullopt : std::optional(pieces.rest);
}

MatterShares::MatterShares(Solid solid, const GridBox& box, const InputPoint& apex, const MatterPieces& pieces,
                           const CarveRules* rules, std::function<std::optional<Solid>(const MatterPiece&)> solid_of)
    : whole_(std::move(solid)), apex_(apex), pieces_(pieces), solid_of_(std::move(solid_of)), left_(whole_) {
    const Boundary boundary = take_boundary(whole_.data().faces.root.get());
    total_ = moments_left_ = moments_of(boundary.patch, apex_);
    list_pieces(box, rules, boundary.patch);
}

void MatterShares::list_pieces(const GridBox& box, const CarveRules* rules, const SolidPatch& patch) {
    struct Near {
        std::uint32_t number;
        bool soft;
    };
    std::vector<Near> near;
    pieces_.tree.for_each_meeting(padded(box), [&](std::uint32_t number) {
        near.push_back({number, !(hardness_of(pieces_, pieces_.pieces[number], rules) >= 1)});
        return false;
    });
    sort_range(near, [](const Near& a, const Near& b) { return a.soft != b.soft ? b.soft : a.number < b.number; });
    last_ = pieces_.rest;
    for (const Near& it : near) {
        const MatterPiece& piece = pieces_.pieces[it.number];
        bool clear = false, all = piece.plane_count > 0;
        for (const Ref<const SolidPlane>& plane : pieces_.planes_of(piece)) {
            bool behind = false;
            for (const PatchVertex& vertex : patch.vertices) {
                const int side = exact_side(plane->plane, vertex.point);
                behind = behind || side < 0;
                all = all && side <= 0;
                if (behind && !all) break;
            }
            clear = !behind;
            if (clear) break;
        }
        if (clear) continue;
        if (all) {
            last_ = piece.matter;
            break;
        }
        order_.push_back(it.number);
    }
    while (!order_.empty() && pieces_.pieces[order_.back()].matter == last_) order_.pop_back();
}

bool MatterShares::step() {
    if (job_) {
        if (job_->step()) return true;
        take_share();
        job_.reset();
        ++next_;
        return true;
    }
    if (next_ < order_.size() && left_.face_count() > 0) {
        const MatterPiece& piece = pieces_.pieces[order_[next_]];
        if (taken_ && *taken_ != piece.matter) {
            settle();
            return true;
        }
        start(piece);
        if (!job_) ++next_;
        return true;
    }
    settle();
    add(last_, moments_left_);
    moments_left_ = {};
    return false;
}

void MatterShares::start(const MatterPiece& piece) {
    if (piece.mesh) {
        const std::optional<bool> all = holds_all(*piece.mesh);
        if (all && *all) {
            last_ = piece.matter;
            order_.resize(next_);
        }
        if (all) return;
    }
    const std::optional<Solid> body = solid_of_(piece);
    if (!body) return;
    Result<Cutter> cutter = cutter_from_solid(*body);
    if (cutter)
        job_ = std::make_unique<CutJob>(left_, std::move(cutter).value(), Pose{}, CutTerms{}, CarveKind::kCarve);
}

void MatterShares::take_share() {
    if (job_->status() != CarveStatus::kDone) return;
    SolidChange change = job_->take_change();
    for (FaceSet::Entry& face : change.added.faces)
        if (face.part == kUnsetPart) face.part = 0;
    SolidEdit edit(left_, std::move(change));
    while (edit.step()) {
    }
    left_ = edit.result();
    taken_ = pieces_.pieces[order_[next_]].matter;
}

/// Gives a matter what its pieces took. Those of one matter mostly follow one another: that is integrated once.
void MatterShares::settle() {
    if (!taken_) return;
    const Boundary boundary = take_boundary(left_.data().faces.root.get());
    const Moments now = moments_of(boundary.patch, apex_);
    Moments share = moments_left_;
    add_moments(share, now, -1);
    add(*taken_, share);
    moments_left_ = now;
    taken_.reset();
}

void MatterShares::add(std::uint32_t matter, const Moments& moments) {
    if (!(moments.volume.high > 0)) return;
    auto at = shares_.begin();
    while (at != shares_.end() && at->matter < matter) ++at;
    if (at == shares_.end() || at->matter != matter) at = shares_.insert(at, Share{matter, {}});
    add_moments(at->moments, moments, 1);
}

/// Meshes may have many more faces than the body: so the body is cut out of the mesh, which costs those near it.
std::optional<bool> MatterShares::holds_all(const Solid& mesh) const {
    const Result<Cutter> body = cutter_from_solid(whole_);
    if (!body) return false;
    const SolidResult cut = subtract(mesh, body.value(), Pose{});
    constexpr double kSteps = kInputSteps;
    const double all = total_.volume.high / (kSteps * kSteps * kSteps), held = cut.done() ? cut.report.volume : 0;
    if (held <= kNegligible * all) return false;
    if (held >= (1 - kNegligible) * all) return true;
    return std::nullopt;
}

}  // namespace firma
