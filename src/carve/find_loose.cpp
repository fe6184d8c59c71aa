// SPDX-License-Identifier: MIT
// Which pieces of a solid a cut leaves loose.
#include "carve/find_loose.h"

#include <algorithm>

#include "base/flat_map.h"
#include "carve/gather.h"
#include "carve/side_of_solid.h"
#include "solid/append_faces.h"
#include "solid/measure_boundary.h"
#include "solid/moment_sum.h"
#include "solid/part_of_solid.h"

namespace firma {
namespace {

constexpr int kFacesSearchedAStep = 16;

bool lies_within(const GridBox& inner, const GridBox& outer) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
    return true;
}

Plane plane_of(const std::vector<ExactPoint>& corners) {
    Plane plane;
    for (std::size_t k = 2; k < corners.size() && !plane.valid(); ++k)  // the first ones may lie on a line
        plane = plane_through(corners[0].grid(), corners[k - 1].grid(), corners[k].grid());
    return plane;
}

void append_corners(const LiveFace& face, std::vector<ExactPoint>& corners) {
    if (face.stored)
        for (const SolidUse& use : face.stored->uses) corners.push_back(use.from().point);
    else
        for (std::size_t k = 0; k < face.facet.record().corner_count; ++k)
            corners.emplace_back(to_input(face.facet.block->corner(face.facet.record(), k)));
}

}  // namespace

LooseSearch::LooseSearch(const Solid& solid, const CutFaces& cut, const Anchors& anchors)
    : solid_(solid), cut_(cut), anchors_(anchors), groups_(cut) {}

bool LooseSearch::step() {
    switch (phase_) {
        case Phase::kGroup:
            phase_ = group();
            break;
        case Phase::kFlood:
            phase_ = flood();
            break;
        case Phase::kRest:
            phase_ = look_at_rest();
            break;
        case Phase::kTake:
            phase_ = take_next();
            break;
        case Phase::kEnd:
            break;
    }
    return phase_ != Phase::kEnd;
}

/// Faces of the patch that held something and went without leaving a piece of themselves.
std::vector<std::uint32_t> LooseSearch::lost_anchors() const {
    const SolidPatch& patch = cut_.view.patch();
    std::vector<std::uint8_t> leaves(patch.faces.size(), 0);
    for (const NewFace& face : cut_.loops.faces)
        if (face.face != ~0u) leaves[face.face] = 1;
    std::vector<std::uint32_t> lost;
    for (const std::uint32_t face : cut_.loops.gone)
        if (!leaves[face] && anchors_.holds(patch.faces[face].facet.record())) lost.push_back(face);
    return lost;
}

LooseSearch::Phase LooseSearch::group() {
    if (groups_.changed().empty()) return Phase::kEnd;
    const std::vector<std::uint32_t> lost = lost_anchors();
    const bool cuts = cuts_a_volume();
    if (groups_.changed().size() == 1 && lost.empty() && !cuts) return Phase::kEnd;
    families_ = groups_.families(lost);
    for (FaceGroups::Family& family : families_) family.lost = family.lost || cuts;
    std::erase_if(families_, [](const auto& family) { return family.groups.size() == 1 && !family.lost; });
    if (families_.empty()) return Phase::kEnd;
    groups_.start(solid_.data().faces.root.get(), anchors_);
    return next_family();
}

LooseSearch::Phase LooseSearch::next_family() {
    if (family_ == families_.size()) return Phase::kTake;
    growing_ = families_[family_].groups;
    turn_ = growing_.size();
    may_hold_elsewhere_ = families_[family_++].lost;
    return Phase::kFlood;
}

/// Every turn is one face of one group.
LooseSearch::Phase LooseSearch::flood() {
    groups_.look_behind(growing_[looks_++ % growing_.size()]);
    for (int left = kFacesSearchedAStep; left > 0; --left) {
        if (turn_ == growing_.size()) {
            std::vector<std::uint32_t> unfinished;
            bool all_held = true;
            for (std::uint32_t& group : growing_) group = groups_.group_of(group);
            std::sort(growing_.begin(), growing_.end());
            growing_.erase(std::unique(growing_.begin(), growing_.end()), growing_.end());
            for (const std::uint32_t group : growing_) {
                if (groups_.is_closed(group)) continue;
                unfinished.push_back(group);
                all_held = all_held && groups_.is_held(group);
            }
            if (unfinished.size() < 2 || all_held) return judge(unfinished);
            turn_ = 0;
        }
        groups_.grow(growing_[turn_++]);
    }
    return Phase::kFlood;
}

LooseSearch::Phase LooseSearch::judge(const std::vector<std::uint32_t>& unfinished) {
    for (const std::uint32_t group : growing_)
        if (groups_.is_closed(group)) judge_whole(group);
    if (unfinished.size() != 1 || !may_hold_elsewhere_) return next_family();
    rest_ = unfinished[0];
    return Phase::kRest;
}

LooseSearch::Phase LooseSearch::look_at_rest() {
    groups_.look_behind(rest_);
    for (int left = kFacesSearchedAStep; left > 0; --left) {
        if (groups_.is_held(rest_)) return next_family();
        if (groups_.grow(rest_)) continue;
        judge_whole(rest_);
        return next_family();
    }
    return Phase::kRest;
}

/// Two families may lead to one shell: what hangs between two places that the cutter cut.
void LooseSearch::judge_whole(std::uint32_t group) {
    group = groups_.group_of(group);
    if (std::any_of(loose_.begin(), loose_.end(), [&](const Loose& it) { return groups_.group_of(it.group) == group; }))
        return;
    const double volume = groups_.is_held(group) ? 0 : volume_of(groups_.faces(group));
    if (volume > 0 && !holds_a_volume(group))
        loose_.push_back({group, volume});
    else
        may_hold_elsewhere_ = true;
}

/// Whether a volume that holds lies in the piece, which no face of it reaches into then.
bool LooseSearch::holds_a_volume(std::uint32_t group) {
    const GridBox box = groups_.box(group);
    std::optional<Solid> piece;
    return std::any_of(anchors_.volumes.begin(), anchors_.volumes.end(), [&](const GridBox& volume) {
        if (!lies_within(volume, box)) return false;
        if (!piece) piece = solid_of_group(group);
        return locate(*piece, to_metres(volume.low)) == Where::kSolid;
    });
}

bool LooseSearch::cuts_a_volume() const {
    const GridBox& cutter = cut_.view.cutter().box;
    return std::any_of(anchors_.volumes.begin(), anchors_.volumes.end(),
                       [&](const GridBox& volume) { return boxes_meet(cutter, volume); });
}

double LooseSearch::volume_of(const std::vector<LiveFace>& faces) {
    GridBox box;
    for (const LiveFace& face : faces) box.add(face.box());
    MomentSum sum(middle_of(box));
    FlatMap known;
    std::vector<PointArm> arms;
    const auto arm_of_vertex = [&](const SolidVertex& vertex) {
        std::uint32_t& number = known.at(reinterpret_cast<std::uintptr_t>(&vertex));
        if (number == FlatMap::kNone) {
            number = std::uint32_t(arms.size());
            arms.push_back(arm_of(vertex.point, sum.apex()));
        }
        return arms[number];
    };
    for (const LiveFace& face : faces) {
        if (face.stored) {
            const auto arm = [&](std::uint32_t k) { return arm_of_vertex(face.stored->uses[k].from()); };
            sum.add_volume(face.stored->plane->plane, face.stored->loop_ends(), arm);
            continue;
        }
        corners_.clear();
        append_corners(face, corners_);
        const auto arm = [&](std::uint32_t k) { return arm_of(corners_[k], sum.apex()); };
        const auto all = std::uint32_t(corners_.size());
        sum.add_volume(plane_of(corners_), std::span(&all, 1), arm);
    }
    return rounded(sum.sums().volume) / (kInputSteps * kInputSteps * kInputSteps);
}

Solid LooseSearch::solid_of_group(std::uint32_t group) {
    std::vector<FacetPlace> facets;
    const Node* root = solid_.data().faces.root.get();
    for (const LiveFace& face : groups_.faces(group))
        if (face.facet.block) gather_face(root, face.facet, facets);
    FaceSet set;
    append_facets(facets, set);
    append_made(cut_.made, groups_.made(group), set);
    std::uint32_t id = 0;
    for (FaceSet::Entry& face : set.faces) face.id = {id++};
    return solid_of_faces(std::move(set), id, solid_.data());
}

/// Of a whole shell: by the first corner that tells. A shell may touch the body in some.
bool LooseSearch::lies_in(std::uint32_t group, const Solid& body) {
    for (const LiveFace& face : groups_.faces(group)) {
        corners_.clear();
        append_corners(face, corners_);
        for (const ExactPoint& corner : corners_)
            if (const int side = side_of_solid(body, corner); side != 0) return side > 0;
    }
    return false;
}

/// Shells that look inward, lie in the piece, and in no other body in it: a body in a hollow hangs free, and stays.
std::vector<std::uint32_t> LooseSearch::hollows_of(std::uint32_t group) {
    const GridBox box = groups_.box(group);
    std::vector<FacetPlace> near;
    gather_facets(solid_.data().faces.root.get(), box, near);
    std::vector<std::uint32_t> nodes = groups_.changed();
    for (const FacetPlace& facet : near) {
        const FaceOwner* owner = facet.block->owner_of(facet.record());
        if (!groups_.stays(facet) || !lies_within(owner ? owner->box : facet.block->box_of(facet.record()), box))
            continue;
        const std::uint32_t known = groups_.find(facet);
        nodes.push_back(known == ~0u ? groups_.add(facet) : known);
    }
    std::vector<std::uint32_t> hollows, bodies;
    std::vector<std::uint32_t> seen;
    for (const std::uint32_t node : nodes) {
        if (groups_.group_of(node) == groups_.group_of(group)) continue;
        while (lies_within(groups_.box(node), box) && groups_.grow(node)) {
        }
        if (!lies_within(groups_.box(node), box)) continue;
        const std::uint32_t whole = groups_.group_of(node);
        if (std::find(seen.begin(), seen.end(), whole) != seen.end()) continue;
        seen.push_back(whole);
        (volume_of(groups_.faces(whole)) > 0 ? bodies : hollows).push_back(whole);
    }
    if (hollows.empty()) return hollows;
    const Solid piece = solid_of_group(group);
    std::erase_if(hollows, [&](std::uint32_t hollow) { return !lies_in(hollow, piece); });
    for (const std::uint32_t body : bodies) {
        if (hollows.empty()) break;
        const Solid solid = solid_of_group(body);
        std::erase_if(hollows, [&](std::uint32_t hollow) { return lies_in(hollow, solid); });
    }
    return hollows;
}

LooseSearch::Phase LooseSearch::take_next() {
    if (next_ == loose_.size()) return Phase::kEnd;
    const Loose loose = loose_[next_++];
    std::vector<std::uint32_t> shells = hollows_of(loose.group);
    shells.insert(shells.begin(), loose.group);
    LoosePiece piece;
    piece.box = groups_.box(loose.group);
    for (const std::uint32_t shell : shells) {
        const std::vector<LiveFace> faces = groups_.faces(shell);
        for (const LiveFace& face : faces)
            if (face.facet.block) piece.faces.push_back(face.facet);
        const std::vector<std::uint32_t> made = groups_.made(shell);
        piece.made.insert(piece.made.end(), made.begin(), made.end());
        piece.volume += shell == loose.group ? loose.volume : volume_of(faces);
    }
    std::sort(piece.made.begin(), piece.made.end());
    pieces_.push_back(std::move(piece));
    return Phase::kTake;
}

}  // namespace firma
