// SPDX-License-Identifier: MIT
// One cut, step by step.
#include "carve/cut_job.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "base/assert.h"
#include "carve/change_points.h"
#include "carve/check_shells.h"
#include "carve/cut_volume.h"
#include "carve/gather.h"
#include "carve/place_solid.h"
#include "carve/side_of_solid.h"
#include "carve/trace_loops.h"
#include "carve/write_reproduction.h"
#include "solid/append_faces.h"
#include "solid/face_ids.h"
#include "solid/hash_face.h"

namespace firma {
namespace {

/// How many facets' worth of faces one step makes.
constexpr std::uint32_t kFacesAStep = 16;

/// That no face has.
constexpr std::uint32_t kNoMaterial = ~0u;

/// One step cuts so many faces, fewer once it has looked at kPairsACutStep pairs.
constexpr int kFacesCutAStep = 16;

double microseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

std::string number(double value) {
    std::string text = std::to_string(value);
    while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
        const bool point = text.back() == '.';
        text.pop_back();
        if (point) break;
    }
    return text;
}

const CarveRules& rules_of(const CutTerms& terms) {
    static const CarveRules kNoRules;
    return terms.rules ? *terms.rules : kNoRules;
}

}  // namespace

CutJob::CutJob(Solid solid, Cutter cutter, const Pose& pose, const CutTerms& terms, CarveKind kind)
    : solid_(std::move(solid)),
      cutter_(std::move(cutter)),
      pose_(pose),
      terms_(terms),
      rules_(rules_of(terms_)),
      budget_(rules_.max_pairs),
      input_{patch_, solid_cutter_, kind == CarveKind::kFill},
      face_cutter_(input_, budget_) {}

bool CutJob::step() {
    const auto start = std::chrono::steady_clock::now();
    double* clock = clock_of(phase_);
    switch (phase_) {
        case Phase::kPlace:
            phase_ = place();
            break;
        case Phase::kCheck:
            phase_ = judge_cutter();
            break;
        case Phase::kTrim:
            phase_ = trim();
            break;
        case Phase::kGather:
            phase_ = gather();
            break;
        case Phase::kTile:
            phase_ = tile();
            break;
        case Phase::kCut:
            phase_ = cut_next_faces();
            break;
        case Phase::kArrange:
            phase_ = arrange();
            break;
        case Phase::kLabel:
            phase_ = label();
            break;
        case Phase::kTrace:
            phase_ = trace();
            break;
        case Phase::kRules:
            phase_ = apply_materials();
            break;
        case Phase::kSplit:
            phase_ = split_on();
            break;
        case Phase::kFacets:
            phase_ = make_next_faces();
            break;
        case Phase::kLoose:
            phase_ = find_loose();
            break;
        case Phase::kChange:
            phase_ = make_change();
            break;
        case Phase::kEnd:
            return false;
    }
    if (clock) *clock += microseconds_since(start);
    return phase_ != Phase::kEnd;
}

double* CutJob::clock_of(Phase phase) {
    CarveReport::Times& times = report_.times;
    switch (phase) {
        case Phase::kPlace:
        case Phase::kCheck:
        case Phase::kTrim:
            return &times.place;
        case Phase::kGather:
        case Phase::kTile:
            return &times.gather;
        case Phase::kCut:
        case Phase::kArrange:
            return &times.cut;
        case Phase::kLabel:
            return &times.label;
        case Phase::kTrace:
        case Phase::kRules:
        case Phase::kSplit:
            return &times.trace;
        case Phase::kFacets:
            return &times.facets;
        case Phase::kLoose:
            return &times.chunks;
        case Phase::kChange:
            return &times.tree;
        case Phase::kEnd:
            return nullptr;
    }
    return nullptr;
}

CutJob::Phase CutJob::refuse(ErrorCode code, std::string reason) {
    status_ = CarveStatus::kRefused;
    error_ = {code, cutter_.valid() && !cutter_.name().empty() ? "cutter " + cutter_.name() : "cutter",
              std::move(reason)};
    return Phase::kEnd;
}

CutJob::Phase CutJob::place() {
    if (data().edits == std::numeric_limits<std::uint32_t>::max())
        return refuse(ErrorCode::kTooLarge, "the world has no numbers left for new edits");
    if (terms_.edit > kLastEditNumber)
        return refuse(ErrorCode::kTooLarge, "an edit cannot have the number " + std::to_string(terms_.edit) +
                                                "; the last one is " + std::to_string(kLastEditNumber));
    if (terms_.edit > 0 && terms_.edit <= data().edits)
        return refuse(ErrorCode::kInvalid, "it is edit " + std::to_string(terms_.edit) + ", and edit " +
                                               std::to_string(data().edits) + " was made before it");
    if (cutter_.valid() && cutter_.triangles().size() > rules_.max_cutter_triangles)
        return refuse(ErrorCode::kTooLarge, "it has " + std::to_string(cutter_.triangles().size()) +
                                                " triangles; the world allows " +
                                                std::to_string(rules_.max_cutter_triangles));
    if (std::optional<Error> fault = place_any_cutter(cutter_, scaled_pose(), solid_cutter_)) {
        status_ = CarveStatus::kRefused;
        error_ = std::move(*fault);
        return Phase::kEnd;
    }
    arranger_.reset();
    clipped_.reset();
    for (int axis = 0; axis < 3; ++axis)
        if (solid_cutter_.box.extent(axis) > rules_.max_cutter_size)
            return refuse(ErrorCode::kTooLarge, "it is " + number(solid_cutter_.box.extent(axis)) +
                                                    " m long; the world allows " + number(rules_.max_cutter_size) +
                                                    " m");
    if (std::exchange(hardness_asked_, true)) return Phase::kCheck;
    const double hardness = limits().hardness_at_middle();
    if (!(hardness > 0)) return Phase::kCheck;
    report_.scale = 1 - hardness;
    return Phase::kPlace;
}

Pose CutJob::scaled_pose() const {
    Pose pose = pose_;
    pose.scale *= report_.scale;
    return pose;
}

/// The cutter minus what may not be carved: where that takes something of it, a Solid goes on in its place.
CutJob::Phase CutJob::trim() {
    const std::vector<CutShield> near = limits().shields();
    if (near.empty()) return Phase::kGather;
    Result<TrimmedCutter> trimmed = trim_cutter(cutter_, scaled_pose(), near);
    if (!trimmed) {
        status_ = CarveStatus::kRefused;
        error_ = trimmed.error();
        return Phase::kEnd;
    }
    report_.cut_short = trimmed.value().shields;
    if (report_.cut_short == 0) return Phase::kGather;
    cut_short_by_ = std::move(trimmed.value().first);
    const Solid& left = trimmed.value().solid;
    if (left.face_count() == 0) return refuse(ErrorCode::kInvalid, cut_short_by_ + " may not be carved");
    const Result<Cutter> cutter = cutter_from_solid(left, cutter_.name());
    if (!cutter) return refuse(cutter.error().code, cutter.error().reason);
    source_of_ = triangles_of_trimmed(left);
    if (std::optional<Error> fault = place_any_cutter(cutter.value(), {}, solid_cutter_)) {
        status_ = CarveStatus::kRefused;
        error_ = std::move(*fault);
        return Phase::kEnd;
    }
    return Phase::kGather;
}

CutJob::Phase CutJob::judge_cutter() {
    if (solid_cutter_.turned) return Phase::kTrim;  // a Solid is sound
    if (std::optional<Error> fault = firma::check_cutter(solid_cutter_.placed, &budget_)) {
        status_ = CarveStatus::kRefused;
        error_ = std::move(*fault);
        return Phase::kEnd;
    }
    return Phase::kTrim;
}

CutJob::Phase CutJob::gather() {
    patch_.clear();
    facets_.clear();
    // Facets' corners are rounded.
    constexpr std::int32_t kSteps = kSurfacePerInput;
    const GridBox reach = grown(solid_cutter_.box, kSteps);
    std::vector<FacetPlace> others;
    if (!gather_facets(index(), reach, solid_cutter_.bevelled, kSteps, rules_.max_candidate_faces, facets_, others))
        return refuse(ErrorCode::kTooLarge, "it meets more than the " + std::to_string(rules_.max_candidate_faces) +
                                                " faces that the world allows");
    patch_.add(facets_);
    for (const FacetPlace& facet : others)
        if (patch_.find(facet) != SolidPatch::kNone) facets_.push_back(facet);
    report_.candidate_faces = patch_.faces.size();
    material_ = terms_.material;
    if (shows_insides()) {
        const std::optional<std::uint32_t> matter = one_matter_near(*terms_.matters.pieces, reach);
        material_.reset();
        if (matter) material_ = terms_.matters.inside[*matter];
    }
    return Phase::kTile;
}

CutJob::Phase CutJob::tile() {
    // A little less than faces were gathered in, so that each of which a part lies there has been, however it is
    // divided into facets, whose corners are rounded.
    tile_faces(index(), solid_cutter_, kSurfacePerInput / 2, patch_);
    // All planes now, so that from here on the patch is only read.
    for (std::uint32_t edge = 0; edge < patch_.edges.size(); ++edge)
        if (!patch_.edges[edge].split()) patch_.settle_planes(edge);
    input_.opens = may_open();
    sheets_.clear();
    if (input_.fill && terms_.sheets_at) terms_.sheets_at(grown(solid_cutter_.box, kSurfacePerInput), sheets_);
    input_.divides = input_.opens || !sheets_.empty();
    if (solid_cutter_.turned) return start_arranging();
    face_cutter_.start();
    next_ = 0;
    return Phase::kCut;
}

/// By the faces near the cutter.
bool CutJob::may_open() const {
    if (!terms_.air_of || input_.fill) return false;
    std::vector<std::uint32_t> parts;
    parts.reserve(patch_.faces.size());
    for (const PatchFace& face : patch_.faces)
        if (!face.replaced) parts.push_back(face.facet.block->part);
    return several_airs(parts, terms_.air_of) || has_several_shells(solid_cutter_);
}

/// By the faces that go.
bool CutJob::opens_several() const {
    if (!input_.opens) return false;
    std::vector<std::uint32_t> parts;
    for (const NewFace& face : loops().taken) parts.push_back(patch_.faces[face.face].facet.block->part);
    return several_airs(parts, terms_.air_of) || has_several_shells(solid_cutter_);
}

/// The same of any cut.
bool CutJob::goes_several() const {
    std::vector<std::uint32_t> parts;
    for (const std::uint32_t face : loops().gone) parts.push_back(patch_.faces[face].facet.block->part);
    return several_airs(parts, terms_.air_of);
}

std::vector<std::uint32_t> CutJob::airs_touched() const {
    std::vector<std::uint32_t> airs;
    if (!terms_.air_of) return airs;
    if (!input_.fill && arranger_ && !arranger_->takes_walls()) return airs;
    const auto add = [&](std::uint32_t face) {
        const std::uint32_t air = terms_.air_of(patch_.faces[face].facet.block->part);
        if (std::find(airs.begin(), airs.end(), air) == airs.end()) airs.push_back(air);
    };
    if (input_.opens) {
        for (const NewFace& taken : loops().taken) add(taken.face);
    } else {
        for (const std::uint32_t face : loops().gone) add(face);
    }
    return airs;
}

CutJob::Phase CutJob::move_on(Verdict verdict, Phase next) {
    switch (verdict) {
        case Verdict::kFine:
            return next;
        case Verdict::kDegenerate:
            return start_arranging();
        case Verdict::kBroken:
            break;
    }
    return contradiction();
}

CutJob::Phase CutJob::start_arranging() {
    arranger_ = std::make_unique<CutArranger>(input_, budget_, material_.value_or(kNoMaterial));
    return Phase::kArrange;
}

CutJob::Phase CutJob::arrange() {
    const auto locate = [&](const ExactPoint& point) { return locate_point(point); };
    switch (arranger_->step(locate)) {
        case CutArranger::End::kGoesOn:
            return Phase::kArrange;
        case CutArranger::End::kFine:
            return take_loops();
        case CutArranger::End::kTooLarge:
            return refuse(ErrorCode::kTooLarge,
                          "it and the faces that it meets lie in more planes than one cut can hold");
        case CutArranger::End::kPairs:
            return too_many_pairs();
        case CutArranger::End::kUnlocated:
            return refuse(ErrorCode::kInvalid, "of a part of it no line tells on which side of the solid it lies");
        case CutArranger::End::kBroken:
            break;
    }
    return contradiction();
}

/// What no crossing tells.
CutSide CutJob::locate_point(const ExactPoint& exact) const {
    const int side = side_of_solid(solid_, exact);
    return side > 0 ? CutSide::kInside : side < 0 ? CutSide::kOutside : CutSide::kUnknown;
}

CutJob::Phase CutJob::too_many_pairs() {
    return refuse(ErrorCode::kTooLarge, "it takes more than " + std::to_string(rules_.max_pairs) +
                                            " pairs of its triangles with each other and with faces of the world to "
                                            "cut it");
}

CutJob::Phase CutJob::contradiction() {
    reproduction_ = write_reproduction(patch_, solid_cutter_);
    const Vec3 low = to_metres(solid_cutter_.box.low), high = to_metres(solid_cutter_.box.high);
    const Vec3 middle = (low + high) * 0.5;
    FIRMA_ASSERT(false, "cuts or labels contradict each other: see CarveResult::reproduction");
    return refuse(ErrorCode::kInvalid, "its cuts contradict each other near " + number(middle.x) + " " +
                                           number(middle.y) + " " + number(middle.z) +
                                           ": the solid or the cutter crosses itself");
}

CutJob::Phase CutJob::cut_next_faces() {
    const std::uint64_t before = budget_.taken();
    for (int left = kFacesCutAStep; left > 0 && budget_.taken() - before < kPairsACutStep; --left) {
        while (next_ < patch_.faces.size() && patch_.faces[next_].replaced) ++next_;
        if (next_ == patch_.faces.size()) return order();
        const Verdict verdict = face_cutter_.cut_face(next_++);
        if (budget_.spent()) return too_many_pairs();
        if (verdict != Verdict::kFine) return move_on(verdict, Phase::kCut);
    }
    return Phase::kCut;
}

/// Once all faces are cut.
CutJob::Phase CutJob::order() {
    return move_on(order_cuts(input_, face_cutter_.made(), order_), Phase::kLabel);
}

CutJob::Phase CutJob::label() {
    const auto locate = [&](std::uint32_t vertex) { return locate_point(solid_cutter_.points[vertex]); };
    return move_on(label_vertices(input_, face_cutter_.made(), order_, locate, labels_), Phase::kTrace);
}

CutJob::Phase CutJob::trace() {
    const Verdict verdict = trace_loops(input_, face_cutter_.made(), order_, labels_, loops_);
    if (verdict != Verdict::kFine) return move_on(verdict, Phase::kEnd);
    return take_loops();
}

CutJob::Phase CutJob::take_loops() {
    const std::vector<std::uint8_t>& cut = crossings().face_cut;
    report_.faces_cut = std::size_t(std::count(cut.begin(), cut.end(), 1));
    if (loops().gone.empty() && loops().faces.empty()) {
        left_with_nothing_ = !cut_short_by_.empty();
        if (left_with_nothing_) return refuse(ErrorCode::kInvalid, cut_short_by_ + " may not be carved");
        status_ = CarveStatus::kNothing;
        return Phase::kEnd;
    }
    if (!sheets_.empty() || (input_.fill && terms_.air_of && goes_several()))
        clipped_ = clip_sheets(input_, crossings(), loops(), sheets_, terms_.air_of);
    if (loops().faces.size() > rules_.max_new_faces) return too_many_new_faces();
    return Phase::kRules;
}

CutJob::Phase CutJob::too_many_new_faces() {
    return refuse(ErrorCode::kTooLarge, "it makes more than the " + std::to_string(rules_.max_new_faces) +
                                            " new faces that the world allows");
}

CutJob::Phase CutJob::apply_materials() {
    if (const std::optional<std::string> hard = limits().taken_and_hard(patch_, loops()))
        return refuse(ErrorCode::kInvalid, *hard + " may not be carved");
    if (material_) return start_facets(*material_);
    splitter_ = std::make_unique<MatterSplitter>(input_, crossings(), loops(), terms_.matters, &rules_);
    return Phase::kSplit;
}

CutJob::Phase CutJob::split_on() {
    return splitter_->step() ? Phase::kSplit : start_facets(terms_.material);
}

CutJob::Phase CutJob::start_facets(std::uint32_t material) {
    kept_ = keep_pieces(patch_, made_loops().gone);
    NewSource source;
    source.edit = edit();
    source.material = material;
    face_maker_ = std::make_unique<FaceMaker>(input_, made_crossings(), made_loops(), source);
    opens_ = opens_several();
    made_from_.clear();
    taken_from_.clear();
    next_ = 0;
    return Phase::kFacets;
}

CutJob::Phase CutJob::make_next_faces() {
    const auto cut = std::uint32_t(made_loops().faces.size()), whole = cut + std::uint32_t(kept_.pieces.size());
    const std::uint32_t all = whole + (opens_ ? std::uint32_t(made_loops().taken.size()) : 0);
    const std::uint32_t end = std::min(next_ + kFacesAStep, all);
    for (; next_ < end; ++next_) {
        if (next_ >= whole) {
            face_maker_->make_taken(made_loops().taken[next_ - whole]);
            taken_from_.resize(face_maker_->taken().faces.size(), next_ - whole);
            continue;
        }
        const bool is_new = next_ < cut;
        const std::uint32_t piece = is_new ? 0 : kept_.pieces[next_ - cut];
        const std::uint32_t corners = is_new ? made_loops().faces[next_].use_count : patch_.faces[piece].use_count;
        if (corners > rules_.max_corners)
            return refuse(ErrorCode::kTooLarge, "a face would have " + std::to_string(corners) +
                                                    " corners; the world allows " + std::to_string(rules_.max_corners));
        if (is_new)
            face_maker_->make(made_loops().faces[next_]);
        else
            face_maker_->make_kept(piece);
        if (opens_ || clipped_ || (terms_.anchors && terms_.air_of))
            made_from_.resize(face_maker_->made().faces.size(), is_new ? next_ : Pockets::kNone);
    }
    if (face_maker_->made().faces.size() > rules_.max_new_faces) return too_many_new_faces();
    if (next_ < all) return Phase::kFacets;
    return terms_.anchors && !input_.fill ? Phase::kLoose : Phase::kChange;
}

CutJob::Phase CutJob::find_loose() {
    if (!loose_) loose_ = std::make_unique<Loose>(*this);
    if (loose_->search.step()) return Phase::kLoose;
    report_.faces_searched = loose_->search.searched();
    return Phase::kChange;
}

/// All facets of the faces that go. Those near the cutter were gathered already; a face may have others farther away.
std::vector<FacetPlace> CutJob::facets_removed() {
    std::vector<std::uint32_t> found(patch_.faces.size(), 0);
    for (const FacetPlace& facet : facets_) ++found[patch_.find(facet)];
    std::vector<bool> goes(patch_.faces.size(), false);
    std::vector<FacetPlace> removed;
    const auto remove = [&](std::uint32_t at) {
        const PatchFace& face = patch_.faces[at];
        if (found[at] == (face.stored ? face.stored->facets : 1))
            goes[at] = true;
        else
            gather_face(index(), face.facet, removed);
    };
    for (const std::uint32_t at : made_loops().gone)
        if (patch_.faces[at].parent == ~0u) remove(at);  // else a piece: its parent goes
    for (const std::uint32_t at : kept_.replaced) remove(at);
    for (const FacetPlace& facet : facets_)
        if (goes[patch_.find(facet)]) removed.push_back(facet);
    return removed;
}

/// Loose pieces: what is left of them goes, what the cut made of them does not come.
void CutJob::take_pieces_out() {
    PointHash hash;
    FlatMap leaves;
    for (LoosePiece& piece : loose_->search.pieces()) {
        CutPiece& taken = pieces_.emplace_back();
        for (const FacetPlace& face : piece.faces) {
            add_face(*face.block, face.record(), -1, hash);
            gather_face(index(), face, taken.removed);
        }
        for (const std::uint32_t k : piece.made) {
            const FaceOwner& owner = *change_.added.owners[k];
            add_face(static_cast<const SolidFace&>(owner), -1, hash);
            leaves.at(reinterpret_cast<std::uintptr_t>(&owner)) = k;
        }
        append_made(change_.added, piece.made, taken.made);
        made_of_piece_.push_back(piece.made);
        taken.volume = piece.volume;
        taken.box = piece.box;
        change_.removed.insert(change_.removed.end(), taken.removed.begin(), taken.removed.end());
    }
    for (const auto& [key, sum] : hash.finish().sums()) change_.points.add(key, sum);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < change_.added.faces.size(); ++k) {
        if (leaves.find(reinterpret_cast<std::uintptr_t>(change_.added.faces[k].owner)) != FlatMap::kNone) continue;
        if (!made_from_.empty()) made_from_[kept] = made_from_[k];
        change_.added.faces[kept++] = change_.added.faces[k];
    }
    change_.added.faces.resize(kept);
    if (!made_from_.empty()) made_from_.resize(kept);
}

CutJob::Phase CutJob::make_change() {
    change_.removed = facets_removed();
    change_.points = change_of_points(view(), loops());
    change_.added = face_maker_->take();
    if (loose_ && !loose_->search.pieces().empty()) take_pieces_out();
    const std::size_t removed = change_.removed.size(), added = change_.added.faces.size();
    if (data().faces.count + terms_.other_faces - removed + added > rules_.max_faces)
        return refuse(ErrorCode::kTooLarge,
                      "the world would have more than " + std::to_string(rules_.max_faces) + " faces");
    FaceIds ids(data().next_face, terms_.edit);
    if (!ids.has(added)) return refuse(ErrorCode::kTooLarge, "the world has no ids left for new faces");
    report_.faces_removed = removed;
    report_.faces_added = added;
    report_.volume = volume_taken(view(), loops());
    // Those of the cutter first: how many pieces others are cut into depends on the edits before.
    for (const bool of_cutter : {true, false})
        for (FaceSet::Entry& face : change_.added.faces)
            if (terms_.edit == 0 ? of_cutter : (face.edit == edit()) == of_cutter) face.id = {ids.take()};
    if (!source_of_.empty())
        for (FaceSet::Entry& face : change_.added.faces)
            if (face.edit == edit()) face.source = source_of_[face.source];
    change_.next_face = ids.next_face();
    change_.edit = edit();
    if (opens_ || (terms_.air_of && !pieces_.empty())) make_opening();
    if (clipped_)
        for (const std::uint32_t from : made_from_)
            air_of_added_.push_back(from == Pockets::kNone ? FaceAir() : clipped_->air[from]);
    if (terms_.air_of || !sheets_.empty()) edge_parts_.emplace(patch_, made_loops(), *face_maker_);
    status_ = CarveStatus::kDone;
    return Phase::kEnd;
}

/// What a loose piece bounds is air of its pocket, once the piece has left.
void CutJob::make_opening() {
    std::vector<std::uint32_t> parts = wall_parts();
    if (!opens_ && !several_airs(parts, terms_.air_of)) return;
    Pockets pockets = opens_ ? find_pockets(made_view(), made_loops()) : one_pocket(made_loops());
    if (!opens_) {
        const std::vector<std::uint32_t> airs = airs_touched();
        opening_.air = airs.empty() ? terms_.air_of(parts[0]) : airs[0];
    }
    if (opens_) opening_.taken = face_maker_->take_taken();
    const std::vector<std::uint32_t> pocket_of_piece = join_pockets(made_of_piece_, pockets);
    opening_.pockets = pockets.count;
    for (const std::uint32_t from : taken_from_) opening_.of_taken.push_back(pockets.of_taken[from]);
    for (const std::uint32_t from : made_from_)
        opening_.of_added.push_back(from == Pockets::kNone ? from : pockets.of_face[from]);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        append_walls(pieces_[k], opening_.taken);
        opening_.of_taken.resize(opening_.taken.faces.size(), pocket_of_piece[k]);
    }
}

/// The parts of all walls that go with loose pieces, and of those that the cutter took.
std::vector<std::uint32_t> CutJob::wall_parts() const {
    std::vector<std::uint32_t> parts;
    for (const std::uint32_t face : loops().gone) parts.push_back(patch_.faces[face].facet.block->part);
    for (const CutPiece& piece : pieces_) {
        for (const FacetPlace& facet : piece.removed) parts.push_back(facet.block->part);
        for (const FaceSet::Entry& face : piece.made.faces)
            if (face.part != kUnsetPart) parts.push_back(face.part);
    }
    return parts;
}

std::vector<CutSheet> CutJob::sheets_left(std::vector<std::uint32_t>& changed) {
    std::vector<CutSheet> left;
    changed.clear();
    std::size_t next = 0;  // of the rest
    for (std::uint32_t k = 0; k < sheets_.size(); ++k) {
        if (!clipped_->changed[k]) {
            left.push_back(sheets_[k]);
            continue;
        }
        changed.push_back(sheets_[k].portal);
        for (; next < clipped_->rest.size() && clipped_->rest[next].sheet == k; ++next) {
            const SheetRest& rest = clipped_->rest[next];
            CutSheet& sheet = left.emplace_back(sheets_[k]);
            sheet.uses.clear();
            for (const SheetSide& side : rest.sides) {
                if (side.edge == SheetSide::kAsItWas)
                    sheet.uses.push_back(side.use);
                else
                    edge_parts_->append({side.edge, side.reversed}, sheet.uses);
            }
            sheet.ends = rest.ends;
        }
    }
    return left;
}

bool CutJob::divide_edge(const SolidUse& use, std::vector<SolidUse>& parts) {
    const std::optional<PatchUse> found = patch_.find(use);
    return edge_parts_ && found && edge_parts_->divide(*found, parts);
}

bool CutJob::divide_edge(const InputPoint& from, const InputPoint& to, std::vector<SolidUse>& parts) {
    const std::optional<PatchUse> found = patch_.find(from, to);
    return edge_parts_ && found && edge_parts_->divide(*found, parts);
}

}  // namespace firma
