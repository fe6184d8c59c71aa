// SPDX-License-Identifier: MIT
// What a carving does to faces that are castable only.
#include "world/open_faces.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/sort.h"
#include "carve/gather.h"
#include "carve/make_chunk.h"
#include "carve/place_solid.h"
#include "firma/level.h"
#include "world/share_corner.h"

namespace firma {
namespace {

std::uint64_t key_of(const FacetPlace& facet) {
    return facet.record().id.value;
}

const CarveRules& rules_of(const WorldData& data) {
    static const CarveRules kDefaults;
    return data.rules ? *data.rules : kDefaults;
}

}  // namespace

OpenFaceEdit::OpenFaceEdit(const WorldData& before, const CutterSolid& cutter, bool carves)
    : before_(before), cutter_(cutter), rules_(rules_of(before)), carves_(carves && rules_.open_faces) {
    sort_out();
}

OpenFaceEdit::~OpenFaceEdit() = default;

void OpenFaceEdit::take_along(std::span<const CutPiece> pieces, const SolidChange& change) {
    if (!carves_) return;
    columns_ = std::make_unique<ClipColumns>(
        before_.castable, before_.solid.data().faces, rules_, change, cutter_,
        [this](const FaceRecord& record) { return may_be_carved(record) && !pane_matter(record); });
    if (pieces.empty()) return;
    pieces_ = pieces;
    carried_ = std::make_unique<CarriedFaces>(before_.castable, before_.solid, change, pieces,
                                              [this](const FaceRecord& record) { return may_be_carved(record); });
}

void OpenFaceEdit::sort_out() {
    std::vector<FacetPlace> near, others, stay;
    gather_facets(before_.castable.root.get(), grown(cutter_.box, 1), cutter_.bevelled, 1, ~std::size_t(0), near,
                  others);
    for (const FacetPlace& facet : near) (carves_ && may_be_carved(facet.record()) ? trimmed_ : stay).push_back(facet);
    stay_.emplace(std::move(stay), cutter_, rules_.max_pairs);
}

/// What stops neither walkers nor shots nor sight is a liquid, a trigger, a volume of the game's own.
bool OpenFaceEdit::may_be_carved(const FaceRecord& record) const {
    if (!(record.mask & kStopsSolid) || (record.mask != ~0u && record.mask & kIsSky)) return false;
    if (record.material < rules_.hardness.size() && rules_.hardness[record.material] >= 1) return false;
    const MatterPieces* pieces = before_.matters.get();
    return !pieces || record.edit != 0 || pieces->table.matters[pieces->of_source(record.source)].hardness < 1;
}

/// The matter of a face of glass, where its table says that it breaks as a pane.
std::optional<std::uint32_t> OpenFaceEdit::pane_matter(const FaceRecord& record) const {
    const MatterPieces* pieces = before_.matters.get();
    if (!pieces || record.edit != 0) return std::nullopt;
    const std::uint32_t matter = pieces->of_source(record.source);
    if (pieces->table.matters[matter].fracture != FractureStyle::kPane) return std::nullopt;
    return matter;
}

bool OpenFaceEdit::step() {
    switch (phase_) {
        case Phase::kCount:
            if (!stay_->step()) phase_ = Phase::kCarried;
            break;
        case Phase::kCarried:
            if (carried_ && carried_->step()) break;
            take_carried();
            phase_ = Phase::kColumns;
            break;
        case Phase::kColumns:
            if (!columns_ || !columns_->step()) phase_ = Phase::kPlace;
            break;
        case Phase::kPlace:
            phase_ = place_next();
            break;
        case Phase::kTrim:
            phase_ = trim_on();
            break;
        case Phase::kTake:
            phase_ = take_trimmed();
            break;
        case Phase::kEnd:
            break;
    }
    return phase_ != Phase::kEnd;
}

/// And what the cutter may take of, from then on, has numbers.
void OpenFaceEdit::take_carried() {
    if (carried_)
        for (const FacetPlace& facet : carried_->faces()) {
            if (is_taken(facet)) continue;
            if (const auto matter = pane_matter(facet.record()))
                take_pane(facet, *matter);
            else
                take(facet);
        }
    std::erase_if(trimmed_, [&](const FacetPlace& facet) { return is_taken(facet); });
    Trim trim{&cutter_, {}};
    for (std::uint32_t k = 0; k < trimmed_.size(); ++k) {
        number_of_.at(key_of(trimmed_[k])) = k;
        trim.facets.push_back(k);
    }
    if (!trimmed_.empty()) trims_.push_back(std::move(trim));
}

OpenFaceEdit::Phase OpenFaceEdit::place_next() {
    if (columns_ && next_column_ < columns_->columns().size()) {
        place_column(columns_->columns()[next_column_++]);
        return Phase::kPlace;
    }
    if (next_piece_ == pieces_.size()) return start_trimmer();
    if (std::optional<Error> fault = place_piece(pieces_[next_piece_++]))
        return refuse(fault->code, std::move(fault->reason));
    return Phase::kPlace;
}

/// Numbers of faces that meet a box and may go, ascending.
template <class Takes>
std::vector<std::uint32_t> OpenFaceEdit::find_near(const GridBox& box, const Takes& takes) {
    std::vector<FacetPlace> near;
    gather_facets(before_.castable.root.get(), box, near);
    std::vector<std::uint32_t> numbers;
    for (const FacetPlace& facet : near) {
        if (is_taken(facet) || !may_be_carved(facet.record()) || !takes(facet)) continue;
        std::uint32_t& number = number_of_.at(key_of(facet));
        if (number == FlatMap::kNone) {
            number = std::uint32_t(trimmed_.size());
            trimmed_.push_back(facet);
        }
        numbers.push_back(number);
    }
    sort_range(numbers);
    return numbers;
}

/// @param facets  that it takes of
CutterSolid& OpenFaceEdit::add_cutter(std::vector<std::uint32_t> facets) {
    placed_.push_back(std::make_unique<CutterSolid>());
    trims_.push_back({placed_.back().get(), std::move(facets)});
    return *placed_.back();
}

/// Of the clips that stand on one wall, what stands straight over its hole.
void OpenFaceEdit::place_column(const ClipColumn& column) {
    GridBox box;
    for (const InputPoint& p : column.cutter.vertices) box.add(to_surface(p));
    std::vector<std::uint32_t> facets = find_near(grown(box, 1), [&](const FacetPlace& facet) {
        return columns_->stands_on(column.wall, facet.record().id.value) && columns_->may_be_over(column.wall, facet);
    });
    if (facets.empty()) return;
    make_cutter_solid(column.cutter, add_cutter(std::move(facets)));
}

/// Where it meets faces: as a cutter, where it lies.
std::optional<Error> OpenFaceEdit::place_piece(const CutPiece& piece) {
    std::vector<std::uint32_t> facets = find_near(grown(piece.box, 1), [](const FacetPlace&) { return true; });
    if (facets.empty()) return {};
    const Result<Cutter> cutter = cutter_from_solid(solid_of_cut_piece(piece, before_.solid));
    if (!cutter) return cutter.error();
    return place_any_cutter(cutter.value(), {}, add_cutter(std::move(facets)));
}

OpenFaceEdit::Phase OpenFaceEdit::start_trimmer() {
    if (trimmed_.empty()) return end();
    trimmer_ = std::make_unique<PolygonTrimmer>(std::move(trimmed_), std::move(trims_), rules_.max_pairs);
    return Phase::kTrim;
}

OpenFaceEdit::Phase OpenFaceEdit::refuse(ErrorCode code, std::string reason) {
    refused_ = Error{code, "cutter", std::move(reason)};
    return Phase::kEnd;
}

OpenFaceEdit::Phase OpenFaceEdit::trim_on() {
    const PolygonTrimmer::End end = trimmer_->step();
    if (end == PolygonTrimmer::End::kGoesOn) return Phase::kTrim;
    return end == PolygonTrimmer::End::kDone ? Phase::kTake : refuse(end);
}

/// @param end  not kGoesOn, not kDone
OpenFaceEdit::Phase OpenFaceEdit::refuse(PolygonTrimmer::End end) {
    if (end == PolygonTrimmer::End::kPairs)
        return refuse(ErrorCode::kTooLarge, "it and castable-only faces are more than the " +
                                                std::to_string(rules_.max_pairs) + " pairs that the world allows");
    if (end == PolygonTrimmer::End::kTooLarge)
        return refuse(ErrorCode::kTooLarge, "it and castable-only faces lie in more than 2 million planes");
    return refuse(ErrorCode::kInvalid, "it crosses itself where it meets castable-only faces");
}

void OpenFaceEdit::take(const FacetPlace& facet) {
    taken_.at(key_of(facet)) = 0;
    removed_.push_back(facet);
    clips_ += is_clip(facet.record());
}

bool OpenFaceEdit::is_taken(const FacetPlace& facet) const {
    return taken_.find(key_of(facet)) != FlatMap::kNone;
}

/// Panes whole, of all others what is held by the cutter, a column or a piece.
OpenFaceEdit::Phase OpenFaceEdit::take_trimmed() {
    const std::vector<FacetPlace>& facets = trimmer_->facets();
    for (std::size_t k = 0; k < facets.size(); ++k) {
        if (trimmer_->fate(k) == PolygonTrimmer::Fate::kStays || is_taken(facets[k])) continue;
        if (const auto matter = pane_matter(facets[k].record())) {
            take_pane(facets[k], *matter);
            continue;
        }
        take(facets[k]);
        if (trimmer_->fate(k) != PolygonTrimmer::Fate::kTrimmed) continue;
        ++cut_;
        trimmer_->append_left(k, added_);
    }
    return end();
}

/// All faces of one matter that hang together by corners.
void OpenFaceEdit::take_pane(const FacetPlace& seed, std::uint32_t matter) {
    ++panes_;
    std::vector<FacetPlace> waiting(1, seed), near;
    take(seed);
    while (!waiting.empty()) {
        const FacetPlace facet = waiting.back();
        waiting.pop_back();
        near.clear();
        gather_facets(before_.castable.root.get(), facet.block->box_of(facet.record()), near);
        for (const FacetPlace& other : near) {
            if (pane_matter(other.record()) != matter || !may_be_carved(other.record())) continue;
            if (is_taken(other) || !share_a_corner(facet, other)) continue;
            take(other);
            waiting.push_back(other);
        }
    }
}

OpenFaceEdit::Phase OpenFaceEdit::end() {
    sort_range(removed_, [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
    whole_ = removed_.size() - cut_;
    if (added_.faces.size() > rules_.max_new_faces)
        return refuse(ErrorCode::kTooLarge, "it makes more than the " + std::to_string(rules_.max_new_faces) +
                                                " new faces that the world allows");
    return Phase::kEnd;
}

void OpenFaceEdit::start(FaceIds& ids) {
    for (FaceSet::Entry& face : added_.faces) face.id = {ids.take()};
    store_ = std::make_unique<StoreEdit>(before_.castable, before_.tree_options);
    for (const FacetPlace& facet : removed_) store_->remove(facet);
    store_->add(std::move(added_));
}

void OpenFaceEdit::tell(CarveReport& report) const {
    report.faces_castable_only = stay_->count();
    report.open_trimmed = cut_;
    report.open_removed = whole_;
    report.panes = panes_;
    report.clips = clips_;
}

}  // namespace firma
