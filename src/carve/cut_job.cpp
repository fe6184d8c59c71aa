// SPDX-License-Identifier: MIT
// One cut, step by step.
#include "carve/cut_job.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/assert.h"
#include "carve/change_points.h"
#include "carve/check_shells.h"
#include "carve/cut_volume.h"
#include "carve/gather.h"
#include "carve/label.h"
#include "carve/reaches_into.h"
#include "carve/tile_faces.h"
#include "carve/trace_loops.h"
#include "carve/write_reproduction.h"
#include "solid/first_seen.h"
#include "solid/near_facets.h"

namespace firma {
namespace {

constexpr int kMostTries = 64;
/// One less than what says "no face".
constexpr std::uint32_t kMostFaceIds = ~0u - 1;
/// How many facets' worth of faces one step makes.
constexpr std::uint32_t kFacesAStep = 16;

/// One step cuts so many faces, fewer once it has seen so many pairs of face and triangle.
constexpr int kFacesCutAStep = 16;
constexpr std::uint64_t kPairsAStep = 32;

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
    static const CarveRules kNone;
    return terms.rules ? *terms.rules : kNone;
}

}  // namespace

void Cut::clear() {
    // Room for as many as a cut usually makes: growing bit by bit writes everything twice.
    const std::size_t usual = std::min<std::size_t>(4 * patch->faces.size(), 4096);
    crossings.reserve(usual);
    world_crossing.reserve(usual / 2);
    cutter_crossing.reserve(usual / 2);
    touching.clear();
    crossings.clear();
    world_crossing.clear();
    cutter_crossing.clear();
    met.clear();
    real.clear();
    met_at.clear();
    segments.clear();
    face_cut.assign(patch->faces.size(), 0);
    new_edges.clear();
    uses.clear();
    loop_ends.clear();
    new_faces.clear();
    gone.clear();
}

CutJob::CutJob(Solid solid, Cutter cutter, const Pose& pose, const CutTerms& terms, CarveKind kind)
    : solid_(std::move(solid)),
      cutter_(std::move(cutter)),
      pose_(pose),
      terms_(terms),
      rules_(rules_of(terms_)),
      budget_(rules_.most_pairs),
      face_cutter_(cut_, budget_) {
    cut_.patch = &patch_;
    cut_.cutter = &solid_cutter_;
    cut_.fill = kind == CarveKind::kFill;
}

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
        case Phase::kMove:
            phase_ = try_move();
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
        case Phase::kLabel:
            phase_ = label();
            break;
        case Phase::kTrace:
            phase_ = trace();
            break;
        case Phase::kRules:
            phase_ = apply_materials();
            break;
        case Phase::kFacets:
            phase_ = make_next_faces();
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
        case Phase::kMove:
            return &times.place;
        case Phase::kGather:
        case Phase::kTile:
            return &times.gather;
        case Phase::kCut:
            return &times.cut;
        case Phase::kLabel:
            return &times.label;
        case Phase::kTrace:
        case Phase::kRules:
            return &times.trace;
        case Phase::kFacets:
            return &times.facets;
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
    if (cutter_.valid() && cutter_.triangles().size() > rules_.most_cutter_triangles)
        return refuse(ErrorCode::kTooLarge, "it has " + std::to_string(cutter_.triangles().size()) +
                                                " triangles; the world allows " +
                                                std::to_string(rules_.most_cutter_triangles));
    Pose pose = pose_;
    pose.scale *= report_.scale;
    Result<PlacedCutter> placed = place_cutter(cutter_, pose);
    if (!placed) {
        status_ = CarveStatus::kRefused;
        error_ = placed.error();
        return Phase::kEnd;
    }
    mover_.start(std::move(placed).value());
    make_cutter_solid(mover_.placed(), solid_cutter_);
    for (int axis = 0; axis < 3; ++axis)
        if (solid_cutter_.box.extent(axis) > rules_.largest_cutter)
            return refuse(ErrorCode::kTooLarge, "it is " + number(solid_cutter_.box.extent(axis)) +
                                                    " m long; the world allows " + number(rules_.largest_cutter) +
                                                    " m");
    const CarveZone* zone = zone_reached(0);
    return zone ? shrink(zone->hardness, "zone " + zone->name, Phase::kCheck) : Phase::kCheck;
}

/// The hardest zone that the cutter at hand reaches into; the first of several. Null when none is hard.
const CarveZone* CutJob::zone_reached(double harder_than) const {
    const CarveZone* hardest = nullptr;
    for (const CarveZone& zone : rules_.zones) {
        if (!(zone.hardness > harder_than) || !reaches_into(solid_cutter_, zone.box)) continue;
        hardest = &zone;
        harder_than = zone.hardness;
    }
    return hardest;
}

/// Places the cutter anew, smaller, unless it is that small already.
CutJob::Phase CutJob::shrink(double hardness, const std::string& by, Phase otherwise) {
    if (hardness >= 1) return refuse(ErrorCode::kInvalid, by + " may not be carved");
    if (report_.scale <= 1 - hardness) return otherwise;
    report_.scale = 1 - hardness;
    report_.retries = 0;  // another cutter
    return Phase::kPlace;
}

CutJob::Phase CutJob::judge_cutter() {
    if (std::optional<Error> fault = firma::check_cutter(mover_.placed(), &budget_)) {
        status_ = CarveStatus::kRefused;
        error_ = std::move(*fault);
        return Phase::kEnd;
    }
    return Phase::kGather;
}

CutJob::Phase CutJob::gather() {
    patch_.clear();
    facets_.clear();
    // The cutter may be moved aside later: by so many steps of the input grid.
    constexpr std::int32_t kSteps = (kFarthestMove + 1) * kSurfacePerInput;
    const GridBox reach = grown(solid_cutter_.box, kSteps);
    std::vector<FacetPlace> others;
    gather_facets(index(), reach, solid_cutter_.bevelled, kSteps, facets_, others);
    patch_.add(facets_);
    for (const FacetPlace& facet : others)
        if (patch_.find(facet) != SolidPatch::kNone) facets_.push_back(facet);
    report_.faces_looked_at = patch_.faces.size();
    if (patch_.faces.size() > rules_.most_faces_looked_at)
        return refuse(ErrorCode::kTooLarge, "it meets " + std::to_string(patch_.faces.size()) +
                                                " faces; the world allows " +
                                                std::to_string(rules_.most_faces_looked_at));
    return Phase::kTile;
}

CutJob::Phase CutJob::tile() {
    // A little less than faces were gathered in, so that each of which a part lies there has been, however it is
    // divided into facets, whose corners are rounded.
    tile_faces(index(), solid_cutter_, kFarthestMove * kSurfacePerInput + kSurfacePerInput / 2, patch_);
    return start_cut();
}

CutJob::Phase CutJob::start_cut() {
    cut_.clear();
    cut_.collects = mover_.is_large();
    added_ = {};
    next_ = 0;
    return Phase::kCut;
}

CutJob::Phase CutJob::move_on(Verdict verdict, Phase next) {
    if (verdict == Verdict::kFine) return next;
    // What touches may come to a contradiction elsewhere, where phases go on after it.
    return verdict == Verdict::kBroken && cut_.touching.empty() ? contradiction() : degenerate();
}

CutJob::Phase CutJob::move_cutter_aside() {
    if (report_.retries < kMostTries) return Phase::kMove;
    return refuse(ErrorCode::kInvalid,
                  "it stays in degenerate position however it is moved, " + std::to_string(kMostTries) + " times");
}

CutJob::Phase CutJob::degenerate() {
    mover_.touched(cut_.touching);
    return move_cutter_aside();
}

/// One try. A cutter that was moved must pass what it passed before.
CutJob::Phase CutJob::try_move() {
    switch (mover_.move(++report_.retries, solid_cutter_, budget_)) {
        case CutterMover::Outcome::kTooManyPairs:
            return too_many_pairs();
        case CutterMover::Outcome::kUnsound:
            return move_cutter_aside();
        case CutterMover::Outcome::kMoved:
            break;
    }
    if (const CarveZone* zone = zone_reached(0); zone && zone->hardness >= 1) return move_cutter_aside();
    return start_cut();
}

CutJob::Phase CutJob::too_many_pairs() {
    std::string reason = "it takes more than " + std::to_string(rules_.most_pairs) +
                         " pairs of its triangles with each other and with faces of the world to cut it";
    if (const int tries = report_.retries; tries > 0)
        reason += ", in " + std::to_string(tries) + (tries > 1 ? " moves" : " move") + " out of degenerate position";
    return refuse(ErrorCode::kTooLarge, std::move(reason));
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
    for (int left = kFacesCutAStep; left > 0 && budget_.taken() - before < kPairsAStep; --left) {
        while (next_ < patch_.faces.size() && patch_.faces[next_].replaced) ++next_;
        if (next_ == patch_.faces.size())
            return cut_.touching.empty() ? move_on(order_cuts(cut_), Phase::kLabel) : degenerate();
        const Verdict verdict = face_cutter_.cut_face(next_++);
        if (budget_.spent()) return too_many_pairs();
        if (cut_.stops_at(verdict)) return move_on(verdict, Phase::kCut);
    }
    return Phase::kCut;
}

CutJob::Phase CutJob::label() {
    const auto locate = [&](std::uint32_t vertex) {
        const Vec3 point = to_metres(solid_cutter_.points[vertex].rounded());
        // Facets lie within a few steps of the exact faces: nearer than that they cannot tell.
        if (any_facet_near(index(), point, 16 / kSurfaceSteps)) return Where::kUnknown;
        const std::optional<bool> inside = in_solid(solid_, point);
        return !inside ? Where::kUnknown : *inside ? Where::kInside : Where::kOutside;
    };
    return move_on(label_vertices(cut_, locate), Phase::kTrace);
}

CutJob::Phase CutJob::trace() {
    const Verdict verdict = trace_loops(cut_);
    if (verdict != Verdict::kFine) return move_on(verdict, Phase::kEnd);
    report_.faces_cut = std::size_t(std::count(cut_.face_cut.begin(), cut_.face_cut.end(), 1));
    if (cut_.gone.empty() && cut_.new_faces.empty()) {
        status_ = CarveStatus::kNothing;
        return Phase::kEnd;
    }
    keep_pieces(cut_);
    return Phase::kRules;
}

CutJob::Phase CutJob::apply_materials() {
    double hardest = 0;
    std::uint32_t by = 0;
    for (const std::uint32_t face : cut_.gone) {
        const std::uint32_t material = patch_.faces[face].facet.record().material;
        if (!takes_something_of(cut_, face) || material >= rules_.hardness.size()) continue;
        if (!(rules_.hardness[material] > hardest)) continue;
        hardest = rules_.hardness[material];
        by = material;
    }
    NewSource source;
    source.edit = data().edits + 1;
    source.material = terms_.material;
    face_maker_ = std::make_unique<FaceMaker>(cut_, source, added_);
    next_ = 0;
    sound_ = true;
    return hardest > 0 ? shrink(hardest, "material " + material_name(by), Phase::kFacets) : Phase::kFacets;
}

CutJob::Phase CutJob::make_next_faces() {
    const std::uint32_t end = std::min(next_ + kFacesAStep, std::uint32_t(cut_.new_faces.size()));
    for (; next_ < end; ++next_) {
        if (cut_.new_faces[next_].use_count > rules_.most_corners)
            return refuse(ErrorCode::kTooLarge, "a face would have " + std::to_string(cut_.new_faces[next_].use_count) +
                                                    " corners; the world allows " +
                                                    std::to_string(rules_.most_corners));
        if (face_maker_->make(next_)) continue;
        if (!cut_.collects) return degenerate();
        sound_ = false;
    }
    if (added_.faces.size() > rules_.most_new_faces)
        return refuse(ErrorCode::kTooLarge, "it makes more than the " + std::to_string(rules_.most_new_faces) +
                                                " new faces that the world allows");
    if (next_ < cut_.new_faces.size()) return Phase::kFacets;
    return sound_ ? Phase::kChange : degenerate();
}

std::string CutJob::material_name(std::uint32_t material) const {
    if (terms_.materials && material < terms_.materials->size()) return (*terms_.materials)[material];
    return std::to_string(material);
}

/// All facets of the faces that go. Those near the cutter were gathered already; a face may have others farther away.
std::vector<FacetPlace> CutJob::facets_removed() {
    std::vector<std::uint32_t> found(patch_.faces.size(), 0);
    for (const FacetPlace& facet : facets_) ++found[patch_.find(facet)];
    std::vector<bool> goes(patch_.faces.size(), false);
    std::vector<FacetPlace> removed;
    for (const std::uint32_t at : cut_.gone) {
        const PatchFace& face = patch_.faces[at];
        if (face.parent != ~0u) continue;  // a piece: its parent goes
        if (found[at] == (face.stored ? face.stored->facets : 1))
            goes[at] = true;
        else
            gather_face(index(), face.facet, removed);
    }
    for (const FacetPlace& facet : facets_)
        if (goes[patch_.find(facet)]) removed.push_back(facet);
    return removed;
}

CutJob::Phase CutJob::make_change() {
    change_.removed = facets_removed();
    const std::size_t removed = change_.removed.size(), added = added_.faces.size();
    if (data().faces.count + terms_.other_faces - removed + added > rules_.most_faces)
        return refuse(ErrorCode::kTooLarge,
                      "the world would have more than " + std::to_string(rules_.most_faces) + " faces");
    if (data().next_face > kMostFaceIds || added > kMostFaceIds - data().next_face)
        return refuse(ErrorCode::kTooLarge, "the world has no ids left for new faces");
    report_.faces_gone = removed;
    report_.faces_new = added;
    report_.volume = volume_taken(cut_);
    std::uint32_t id = data().next_face;
    for (FaceSet::Entry& face : added_.faces) face.id = {id++};
    change_.added = std::move(added_);
    change_.points = change_of_points(cut_);
    status_ = CarveStatus::kDone;
    return Phase::kEnd;
}

}  // namespace firma
