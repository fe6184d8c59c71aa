// SPDX-License-Identifier: MIT
// What is castable only and goes with loose pieces.
#include "world/carried_faces.h"

#include <utility>

#include "carve/gather.h"
#include "solid/solid_data.h"
#include "world/share_corner.h"

namespace firma {
namespace {

std::uint64_t id_of(const FacetPlace& face) {
    return face.record().id.value;
}

}  // namespace

CarriedFaces::CarriedFaces(const FaceStore& open, const Solid& solid, const SolidChange& change,
                           std::span<const CutPiece> pieces, std::function<bool(const FaceRecord&)> may_go)
    : open_(open), solid_(solid), change_(change), may_go_(std::move(may_go)) {
    for (const CutPiece& piece : pieces) {
        near_.clear();
        gather_facets(open_.root.get(), grown(piece.box, 1), near_);
        if (near_.empty()) continue;
        for (const FacetPlace& facet : piece.removed) add_seeds(facet.block->box_of(facet.record()));
        for (const FaceSet::Entry& face : piece.made.faces) add_seeds(piece.made.box_of(face));
    }
    if (seeds_.empty()) return;
    for (const FacetPlace& facet : change_.removed) removed_.at(id_of(facet)) = 0;
    for (const FaceSet::Entry& face : change_.added.faces) added_box_.add(change_.added.box_of(face));
}

void CarriedFaces::add_seeds(const GridBox& box) {
    gather_facets(open_.root.get(), grown(box, 1), seeds_);
}

bool CarriedFaces::step() {
    if (next_face_ < body_.size()) {
        const FacetPlace face = body_[next_face_++];
        if (is_held(face))
            end_body(true);
        else
            look_at(face);
        return true;
    }
    if (!body_.empty()) end_body(false);
    if (next_seed_ == seeds_.size()) return false;
    const FacetPlace seed = seeds_[next_seed_++];
    if (!may_go_(seed.record()) || body_of_.find(id_of(seed)) != FlatMap::kNone) return true;
    body_of_.at(id_of(seed)) = std::uint32_t(held_.size());
    body_.push_back(seed);
    return true;
}

/// Its neighbours are part of the body; where one was found to be held before, this one is.
void CarriedFaces::look_at(const FacetPlace& face) {
    near_.clear();
    gather_facets(open_.root.get(), face.block->box_of(face.record()), near_);
    for (const FacetPlace& other : near_) {
        if (!may_go_(other.record()) || !share_a_corner(face, other)) continue;
        std::uint32_t& body = body_of_.at(id_of(other));
        if (body < held_.size()) return end_body(true);  // it was left as soon as that was known
        if (body == held_.size()) continue;
        body = std::uint32_t(held_.size());
        body_.push_back(other);
    }
}

void CarriedFaces::end_body(bool held) {
    held_.push_back(held);
    if (!held) faces_.insert(faces_.end(), body_.begin(), body_.end());
    body_.clear();
    next_face_ = 0;
}

bool CarriedFaces::is_held(const FacetPlace& face) {
    const GridBox box = grown(face.block->box_of(face.record()), 1);
    near_.clear();
    gather_facets(solid_.data().faces.root.get(), box, near_);
    for (const FacetPlace& facet : near_)
        if (removed_.find(id_of(facet)) == FlatMap::kNone) return true;
    if (!boxes_meet(box, added_box_)) return false;
    for (const FaceSet::Entry& added : change_.added.faces)
        if (boxes_meet(box, change_.added.box_of(added))) return true;
    return false;
}

}  // namespace firma
