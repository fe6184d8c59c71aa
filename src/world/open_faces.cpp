// SPDX-License-Identifier: MIT
// What a carving does to faces that are castable only.
#include "world/open_faces.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/sort.h"
#include "carve/gather.h"
#include "firma/level.h"

namespace firma {
namespace {

/// Stops walkers or shots alone, and nothing else: a brush that is there for that.
bool is_clip(const FaceRecord& record) {
    const std::uint32_t stops = record.mask & kStopsSolid;
    return stops == kStopsWalk || stops == kStopsShots;
}

std::uint64_t key_of(const FacetPlace& facet) {
    return facet.record().id.value;
}

bool share_a_corner(const FacetPlace& a, const FacetPlace& b) {
    for (std::uint32_t j = 0; j < a.record().corner_count; ++j)
        for (std::uint32_t k = 0; k < b.record().corner_count; ++k)
            if (a.block->corner(a.record(), j) == b.block->corner(b.record(), k)) return true;
    return false;
}

const CarveRules& rules_of(const WorldData& data) {
    static const CarveRules kDefaults;
    return data.rules ? *data.rules : kDefaults;
}

}  // namespace

OpenFaceEdit::OpenFaceEdit(const WorldData& before, const CutterSolid& cutter, bool carves)
    : before_(before), cutter_(cutter), rules_(rules_of(before)) {
    sort_out(carves && rules_.open_faces);
}

OpenFaceEdit::~OpenFaceEdit() = default;

void OpenFaceEdit::sort_out(bool carves) {
    std::vector<FacetPlace> near, others, stay;
    gather_facets(before_.castable.root.get(), grown(cutter_.box, 1), cutter_.bevelled, 1, ~std::size_t(0), near,
                  others);
    for (const FacetPlace& facet : near) (carves && may_be_carved(facet.record()) ? trimmed_ : stay).push_back(facet);
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
            if (stay_->step()) break;
            phase_ = Phase::kEnd;
            if (trimmed_.empty()) break;
            trimmer_ = std::make_unique<PolygonTrimmer>(cutter_, std::move(trimmed_), rules_.max_pairs);
            phase_ = Phase::kTrim;
            break;
        case Phase::kTrim:
            trim_on();
            break;
        case Phase::kPanes:
            take_panes();
            phase_ = Phase::kEnd;
            break;
        case Phase::kEnd:
            break;
    }
    return phase_ != Phase::kEnd;
}

void OpenFaceEdit::trim_on() {
    const auto refuse = [&](ErrorCode code, std::string reason) {
        refused_ = Error{code, "cutter", std::move(reason)};
        phase_ = Phase::kEnd;
    };
    switch (trimmer_->step()) {
        case PolygonTrimmer::End::kGoesOn:
            return;
        case PolygonTrimmer::End::kDone:
            phase_ = Phase::kPanes;
            return;
        case PolygonTrimmer::End::kPairs:
            return refuse(ErrorCode::kTooLarge, "it and castable-only faces are more than the " +
                                                    std::to_string(rules_.max_pairs) + " pairs that the world allows");
        case PolygonTrimmer::End::kTooLarge:
            return refuse(ErrorCode::kTooLarge, "it and castable-only faces lie in more than 2 million planes");
        case PolygonTrimmer::End::kBroken:
            return refuse(ErrorCode::kInvalid, "it crosses itself where it meets castable-only faces");
    }
}

void OpenFaceEdit::take(const FacetPlace& facet) {
    removed_.push_back(facet);
    clips_ += is_clip(facet.record());
}

/// Panes whole, of all others what the cutter holds.
void OpenFaceEdit::take_panes() {
    const std::vector<FacetPlace>& facets = trimmer_->facets();
    FlatMap taken;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        if (trimmer_->fate(k) == PolygonTrimmer::Fate::kStays) continue;
        if (const auto matter = pane_matter(facets[k].record())) {
            if (taken.find(key_of(facets[k])) != FlatMap::kNone) continue;
            take_pane(facets[k], *matter, taken);
            ++panes_;
            continue;
        }
        take(facets[k]);
        const bool trimmed = trimmer_->fate(k) == PolygonTrimmer::Fate::kTrimmed;
        (trimmed ? cut_ : whole_) += 1;
        if (trimmed) trimmer_->append_left(k, added_);
    }
    sort_range(removed_, [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
    if (added_.faces.size() > rules_.max_new_faces)
        refused_ = Error{
            ErrorCode::kTooLarge, "cutter",
            "it makes more than the " + std::to_string(rules_.max_new_faces) + " new faces that the world allows"};
}

/// All faces of one matter that hang together by corners.
void OpenFaceEdit::take_pane(const FacetPlace& seed, std::uint32_t matter, FlatMap& taken) {
    std::vector<FacetPlace> waiting(1, seed), near;
    taken.at(key_of(seed)) = 0;
    while (!waiting.empty()) {
        const FacetPlace facet = waiting.back();
        waiting.pop_back();
        take(facet);
        ++whole_;
        near.clear();
        gather_facets(before_.castable.root.get(), facet.block->box_of(facet.record()), near);
        for (const FacetPlace& other : near) {
            if (pane_matter(other.record()) != matter || !may_be_carved(other.record())) continue;
            if (taken.find(key_of(other)) != FlatMap::kNone || !share_a_corner(facet, other)) continue;
            taken.at(key_of(other)) = 0;
            waiting.push_back(other);
        }
    }
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
