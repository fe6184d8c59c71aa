// SPDX-License-Identifier: MIT
// What a carving does to faces that are castable only: those that the cutter reaches are trimmed, without a cap; a pane
// of glass goes whole; liquids, triggers and what may not be carved stay.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/flat_map.h"
#include "carve/trim_polygons.h"
#include "firma/carve.h"
#include "solid/face_ids.h"
#include "solid/face_store.h"
#include "world/count_reaching.h"
#include "world/world_data.h"

namespace firma {

class OpenFaceEdit {
public:
    /// @param before  kept alive by the caller, as is the cutter
    /// @param carves  else nothing is trimmed, and only counted what stays
    OpenFaceEdit(const WorldData& before, const CutterSolid& cutter, bool carves);
    ~OpenFaceEdit();

    /// Does one piece of work, some ten microseconds; false once there is none left.
    bool step();

    // Once step() said false:
    const std::optional<Error>& refused() const { return refused_; }
    bool changes() const { return !removed_.empty(); }
    /// How many faces come.
    std::size_t added() const { return added_.faces.size(); }
    void tell(CarveReport& report) const;

    /// Begins to edit what is castable only, once: with changes().
    /// @param ids  behind those of the solid's faces
    void start(FaceIds& ids);
    /// Of the faces that go.
    const std::vector<FacetPlace>& removed() const { return removed_; }
    /// Once it was started.
    StoreEdit& store() { return *store_; }

private:
    enum class Phase : std::uint8_t { kCount, kTrim, kPanes, kEnd };

    void sort_out(bool carves);
    bool may_be_carved(const FaceRecord& record) const;
    std::optional<std::uint32_t> pane_matter(const FaceRecord& record) const;
    void trim_on();
    void take_panes();
    void take_pane(const FacetPlace& seed, std::uint32_t matter, FlatMap& taken);
    void take(const FacetPlace& facet);

    const WorldData& before_;
    const CutterSolid& cutter_;
    const CarveRules& rules_;
    Phase phase_ = Phase::kCount;
    std::vector<FacetPlace> trimmed_;  ///< near the cutter, and may be
    std::optional<ReachCount> stay_;
    std::unique_ptr<PolygonTrimmer> trimmer_;
    std::optional<Error> refused_;

    std::vector<FacetPlace> removed_;  ///< in order of ids
    FaceSet added_;
    std::unique_ptr<StoreEdit> store_;
    std::size_t cut_ = 0, whole_ = 0, panes_ = 0, clips_ = 0;
};

}  // namespace firma
