// SPDX-License-Identifier: MIT
// What a carving does to faces that are castable only: those that the cutter reaches are trimmed, without a cap; a pane
// of glass goes whole; liquids, triggers and what may not be carved stay. Loose pieces take such faces along.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/flat_map.h"
#include "carve/trim_polygons.h"
#include "firma/carve.h"
#include "solid/face_ids.h"
#include "solid/face_store.h"
#include "world/carried_faces.h"
#include "world/clip_columns.h"
#include "world/count_reaching.h"
#include "world/world_data.h"

namespace firma {

class OpenFaceEdit {
public:
    /// @param before  kept alive by the caller, as is the cutter
    /// @param carves  else nothing is trimmed, and only counted what stays
    OpenFaceEdit(const WorldData& before, const CutterSolid& cutter, bool carves);
    ~OpenFaceEdit();

    /// What the cut takes of the solid: clips that stand on walls go where the cutter takes these. And pieces that
    /// leave: what stands on them alone goes with them, and of the rest what lies in them, as if each were a cutter.
    /// Before the first step().
    /// @param change  what the cut makes of the solid, pieces gone; kept alive by the caller, as are the pieces
    void take_along(std::span<const CutPiece> pieces, const SolidChange& change);

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
    enum class Phase : std::uint8_t { kCount, kCarried, kColumns, kPlace, kTrim, kTake, kEnd };

    void sort_out();
    bool may_be_carved(const FaceRecord& record) const;
    std::optional<std::uint32_t> pane_matter(const FaceRecord& record) const;
    void take_carried();
    Phase place_next();
    CutterSolid& add_cutter(std::vector<std::uint32_t> facets);
    void place_column(const ClipColumn& column);
    std::optional<Error> place_piece(const CutPiece& piece);
    template <class Takes>
    std::vector<std::uint32_t> find_near(const GridBox& box, const Takes& takes);
    Phase start_trimmer();
    Phase trim_on();
    Phase refuse(PolygonTrimmer::End end);
    Phase take_trimmed();
    Phase refuse(ErrorCode code, std::string reason);
    Phase end();
    void take_pane(const FacetPlace& seed, std::uint32_t matter);
    void take(const FacetPlace& facet);
    bool is_taken(const FacetPlace& facet) const;

    const WorldData& before_;
    const CutterSolid& cutter_;
    const CarveRules& rules_;
    const bool carves_;
    Phase phase_ = Phase::kCount;
    std::optional<ReachCount> stay_;
    std::optional<Error> refused_;

    std::span<const CutPiece> pieces_;
    std::unique_ptr<CarriedFaces> carried_;
    std::unique_ptr<ClipColumns> columns_;
    std::size_t next_column_ = 0;
    std::size_t next_piece_ = 0;
    std::vector<FacetPlace> trimmed_;                   ///< that the cutter, columns and pieces may take of
    FlatMap number_of_;                                 ///< by their ids
    std::vector<std::unique_ptr<CutterSolid>> placed_;  ///< columns and pieces
    std::vector<Trim> trims_;
    std::unique_ptr<PolygonTrimmer> trimmer_;

    std::vector<FacetPlace> removed_;  ///< in order of ids once all is done
    FlatMap taken_;                    ///< their ids
    FaceSet added_;
    std::unique_ptr<StoreEdit> store_;
    std::size_t cut_ = 0, whole_ = 0, panes_ = 0, clips_ = 0;
};

}  // namespace firma
