// SPDX-License-Identifier: MIT
// One edit, step by step.
#include "carve/subtract.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/assert.h"
#include "carve/check_shells.h"
#include "carve/cut_volume.h"
#include "carve/gather.h"
#include "carve/label.h"
#include "carve/reaches_into.h"
#include "carve/tile_faces.h"
#include "carve/trace_loops.h"
#include "carve/write_reproduction.h"
#include "firma/rooms.h"

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

World with_doors_open(const World& world) {
    if (!world.data().closed) return world;
    auto data = std::make_shared<WorldData>(world.data());
    data->closed.reset();
    return World(std::move(data));
}

const CarveRules& rules_of(const World& world) {
    static const CarveRules kNone;
    return world.data().rules ? *world.data().rules : kNone;
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

Subtraction::Subtraction(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options,
                         CarveKind kind)
    : world_(world),
      doors_open_(with_doors_open(world)),
      cutter_(cutter),
      pose_(pose),
      options_(options),
      rules_(rules_of(world_)),
      budget_(rules_.most_pairs),
      face_cutter_(cut_, budget_) {
    result_.world = world;
    cut_.patch = &patch_;
    cut_.cutter = &solid_cutter_;
    cut_.fill = kind == CarveKind::kFill;
}

bool Subtraction::step() {
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
        case Phase::kRemove:
            phase_ = remove_facets();
            break;
        case Phase::kTree:
            phase_ = edit_tree();
            break;
        case Phase::kPublish:
            phase_ = publish();
            break;
        case Phase::kEnd:
            return false;
    }
    if (clock) *clock += microseconds_since(start);
    return phase_ != Phase::kEnd;
}

double* Subtraction::clock_of(Phase phase) {
    CarveReport::Times& times = result_.report.times;
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
        case Phase::kRemove:
        case Phase::kTree:
        case Phase::kPublish:
            return &times.tree;
        case Phase::kEnd:
            return nullptr;
    }
    return nullptr;
}

Subtraction::Phase Subtraction::refuse(ErrorCode code, std::string reason) {
    result_.status = CarveStatus::kRefused;
    result_.error = {code, cutter_.valid() && !cutter_.name().empty() ? "cutter " + cutter_.name() : "cutter",
                     std::move(reason)};
    return Phase::kEnd;
}

/// Edits and versions are numbered: after the last number there is no other edit.
bool Subtraction::has_numbers_left() const {
    const WorldData& data = world_.data();
    return data.edits != std::numeric_limits<decltype(data.edits)>::max() &&
           data.version != std::numeric_limits<decltype(data.version)>::max();
}

Subtraction::Phase Subtraction::place() {
    if (!has_numbers_left()) return refuse(ErrorCode::kTooLarge, "the world has no numbers left for new edits");
    if (cutter_.valid() && cutter_.triangles().size() > rules_.most_cutter_triangles)
        return refuse(ErrorCode::kTooLarge, "it has " + std::to_string(cutter_.triangles().size()) +
                                                " triangles; the world allows " +
                                                std::to_string(rules_.most_cutter_triangles));
    Pose pose = pose_;
    pose.scale *= result_.report.scale;
    Result<PlacedCutter> placed = place_cutter(cutter_, pose);
    if (!placed) {
        result_.status = CarveStatus::kRefused;
        result_.error = placed.error();
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
const CarveZone* Subtraction::zone_reached(double harder_than) const {
    const CarveZone* hardest = nullptr;
    for (const CarveZone& zone : rules_.zones) {
        if (!(zone.hardness > harder_than) || !reaches_into(solid_cutter_, zone.box)) continue;
        hardest = &zone;
        harder_than = zone.hardness;
    }
    return hardest;
}

/// Places the cutter anew, smaller, unless it is that small already.
Subtraction::Phase Subtraction::shrink(double hardness, const std::string& by, Phase otherwise) {
    if (hardness >= 1) return refuse(ErrorCode::kInvalid, by + " may not be carved");
    if (result_.report.scale <= 1 - hardness) return otherwise;
    result_.report.scale = 1 - hardness;
    result_.report.retries = 0;  // another cutter
    return Phase::kPlace;
}

Subtraction::Phase Subtraction::judge_cutter() {
    if (std::optional<Error> fault = firma::check_cutter(mover_.placed(), &budget_)) {
        result_.status = CarveStatus::kRefused;
        result_.error = std::move(*fault);
        return Phase::kEnd;
    }
    return Phase::kGather;
}

Subtraction::Phase Subtraction::gather() {
    patch_.clear();
    facets_.clear();
    // The cutter may be moved aside later: by so many steps of the input grid.
    constexpr std::int32_t kSteps = (kFarthestMove + 1) * kSurfacePerInput;
    const GridBox reach = grown(solid_cutter_.box, kSteps);
    rooms_of_facets_.clear();
    std::vector<FacetPlace> others;
    std::vector<std::uint32_t> rooms_of_others;
    for (const RoomTree& tree : trees_near(world_.data(), reach)) {
        gather_facets(*tree.root, reach, solid_cutter_.bevelled, kSteps, facets_, others);
        rooms_of_facets_.resize(facets_.size(), tree.room);
        rooms_of_others.resize(others.size(), tree.room);
    }
    patch_.add(facets_);
    for (std::size_t k = 0; k < others.size(); ++k) {
        if (patch_.find(others[k]) == SolidPatch::kNone) continue;
        facets_.push_back(others[k]);
        rooms_of_facets_.push_back(rooms_of_others[k]);
    }
    result_.report.faces_looked_at = patch_.faces.size();
    if (patch_.faces.size() > rules_.most_faces_looked_at)
        return refuse(ErrorCode::kTooLarge, "it meets " + std::to_string(patch_.faces.size()) +
                                                " faces; the world allows " +
                                                std::to_string(rules_.most_faces_looked_at));
    return Phase::kTile;
}

Subtraction::Phase Subtraction::tile() {
    // A little less than faces were gathered in, so that each of which a part lies there has been, however it is
    // divided into facets, whose corners are rounded.
    tile_faces(world_.data(), solid_cutter_, kFarthestMove * kSurfacePerInput + kSurfacePerInput / 2, patch_);
    return start_cut();
}

Subtraction::Phase Subtraction::start_cut() {
    cut_.clear();
    cut_.collects = mover_.is_large();
    come_ = {};
    next_ = 0;
    return Phase::kCut;
}

Subtraction::Phase Subtraction::move_on(Verdict verdict, Phase next) {
    if (verdict == Verdict::kFine) return next;
    // What touches may come to a contradiction elsewhere, where phases go on after it.
    return verdict == Verdict::kBroken && cut_.touching.empty() ? contradiction() : degenerate();
}

Subtraction::Phase Subtraction::move_cutter_aside() {
    if (result_.report.retries < kMostTries) return Phase::kMove;
    return refuse(ErrorCode::kInvalid,
                  "it stays in degenerate position however it is moved, " + std::to_string(kMostTries) + " times");
}

Subtraction::Phase Subtraction::degenerate() {
    mover_.touched(cut_.touching);
    return move_cutter_aside();
}

/// One try. A cutter that was moved must pass what it passed before.
Subtraction::Phase Subtraction::try_move() {
    switch (mover_.move(++result_.report.retries, solid_cutter_, budget_)) {
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

Subtraction::Phase Subtraction::too_many_pairs() {
    std::string reason = "it takes more than " + std::to_string(rules_.most_pairs) +
                         " pairs of its triangles with each other and with faces of the world to cut it";
    if (const int tries = result_.report.retries; tries > 0)
        reason += ", in " + std::to_string(tries) + (tries > 1 ? " moves" : " move") + " out of degenerate position";
    return refuse(ErrorCode::kTooLarge, std::move(reason));
}

Subtraction::Phase Subtraction::contradiction() {
    result_.reproduction = write_reproduction(patch_, solid_cutter_);
    const Vec3 low = to_metres(solid_cutter_.box.low), high = to_metres(solid_cutter_.box.high);
    const Vec3 middle = (low + high) * 0.5;
    FIRMA_ASSERT(false, "cuts or labels contradict each other: see CarveResult::reproduction");
    return refuse(ErrorCode::kInvalid, "its cuts contradict each other near " + number(middle.x) + " " +
                                           number(middle.y) + " " + number(middle.z) +
                                           ": the solid or the cutter crosses itself");
}

Subtraction::Phase Subtraction::cut_next_faces() {
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

Subtraction::Phase Subtraction::label() {
    const auto locate = [&](std::uint32_t vertex) {
        const Vec3 point = to_metres(solid_cutter_.points[vertex].rounded());
        // Facets lie within a few steps of the exact faces: nearer than that they cannot tell.
        if (closest(doors_open_, point, 16 / kSurfaceSteps)) return Where::kUnknown;
        const std::optional<bool> inside = in_solid(world_, point);
        return !inside ? Where::kUnknown : *inside ? Where::kInside : Where::kOutside;
    };
    return move_on(label_vertices(cut_, locate), Phase::kTrace);
}

Subtraction::Phase Subtraction::trace() {
    const Verdict verdict = trace_loops(cut_);
    if (verdict != Verdict::kFine) return move_on(verdict, Phase::kEnd);
    result_.report.faces_cut = std::size_t(std::count(cut_.face_cut.begin(), cut_.face_cut.end(), 1));
    if (cut_.gone.empty() && cut_.new_faces.empty()) {
        result_.status = CarveStatus::kNothing;
        return Phase::kEnd;
    }
    keep_pieces(cut_);
    return Phase::kRules;
}

Subtraction::Phase Subtraction::apply_materials() {
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
    source.edit = world_.data().edits + 1;
    source.material = material_index(*world_.data().materials, options_.material);
    face_maker_ = std::make_unique<FaceMaker>(cut_, source, come_);
    next_ = 0;
    sound_ = true;
    return hardest > 0 ? shrink(hardest, "material " + world_.material_name(by), Phase::kFacets) : Phase::kFacets;
}

Subtraction::Phase Subtraction::make_next_faces() {
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
    if (come_.faces.size() > rules_.most_new_faces)
        return refuse(ErrorCode::kTooLarge, "it makes more than the " + std::to_string(rules_.most_new_faces) +
                                                " new faces that the world allows");
    if (next_ < cut_.new_faces.size()) return Phase::kFacets;
    return sound_ ? Phase::kRemove : degenerate();
}

/// All facets of the faces that go. Those near the cutter were gathered already; a face may have others farther away.
std::vector<FacetPlace> Subtraction::facets_gone() {
    std::vector<std::uint32_t> found(patch_.faces.size(), 0);
    for (const FacetPlace& facet : facets_) ++found[patch_.find(facet)];
    std::vector<bool> goes(patch_.faces.size(), false);
    std::vector<FacetPlace> gone;
    for (const std::uint32_t index : cut_.gone) {
        const PatchFace& face = patch_.faces[index];
        if (face.parent != ~0u) continue;  // a piece: its parent goes
        if (found[index] == (face.stored ? face.stored->facets : 1))
            goes[index] = true;
        else
            gather_face(world_.data(), face.facet, gone, [&](std::uint32_t room) { rooms_.touch(room); });
    }
    for (std::size_t k = 0; k < facets_.size(); ++k) {
        if (!goes[patch_.find(facets_[k])]) continue;
        gone.push_back(facets_[k]);
        rooms_.touch(rooms_of_facets_[k]);
    }
    return gone;
}

/// Where faces come, once it is known which go. A cut that touches no face lies in the rock: a room of its own. What is
/// filled in without touching any stands free in the air of one.
void Subtraction::find_room() {
    if (!world_.data().room_records) return rooms_.touch(0);
    const bool touches_faces = rooms_.any();
    if (touches_faces || cut_.fill) rooms_.touch_portals(solid_cutter_.box);
    if (touches_faces || !cut_.fill) return;
    for (const ExactPoint& point : solid_cutter_.points) {
        const Location where = locate(world_, to_metres(point.rounded()));
        if (where.kind == Location::Kind::kRoom) return rooms_.touch(where.room.value);
    }
    rooms_.touch(0);  // too flat for any of its corners to be clear of it: closed by itself, it is sound anywhere
}

Subtraction::Phase Subtraction::remove_facets() {
    const WorldData& data = world_.data();
    rooms_ = RoomJoin(data);
    const std::vector<FacetPlace> gone = facets_gone();
    find_room();
    CarveReport& report = result_.report;
    const std::size_t come = come_.faces.size();
    if (data.face_count - gone.size() + come > rules_.most_faces)
        return refuse(ErrorCode::kTooLarge,
                      "the world would have more than " + std::to_string(rules_.most_faces) + " faces");
    if (data.next_face > kMostFaceIds || come > kMostFaceIds - data.next_face)
        return refuse(ErrorCode::kTooLarge, "the world has no ids left for new faces");
    report.faces_gone = gone.size();
    report.faces_new = come;
    report.volume = volume_taken(cut_);
    std::uint32_t id = data.next_face;
    for (FaceSet::Entry& face : come_.faces) face.id = {id++};
    block_edit_ = std::make_unique<BlockEdit>(rooms_.tree(), data.tree_options);
    for (const FacetPlace& place : gone) block_edit_->remove(place.block, place.slot);
    block_edit_->add(std::move(come_));
    return Phase::kTree;
}

Subtraction::Phase Subtraction::edit_tree() {
    return block_edit_->step() ? Phase::kTree : Phase::kPublish;
}

Subtraction::Phase Subtraction::publish() {
    const CarveReport& report = result_.report;
    auto data = next_version(world_.data());
    rooms_.publish(*data, block_edit_->result());
    ++data->edits;
    data->face_count += report.faces_new - report.faces_gone;
    data->next_face += std::uint32_t(report.faces_new);
    data->materials = with_material(data->materials, options_.material);
    result_.world = World(std::move(data));
    result_.status = CarveStatus::kDone;
    return Phase::kEnd;
}

}  // namespace firma
