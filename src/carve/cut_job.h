// SPDX-License-Identifier: MIT
// One cut, step by step: from a solid and a placed cutter to the change that makes the solid after it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "carve/arrange_cut.h"
#include "carve/cut_faces.h"
#include "carve/label.h"
#include "carve/make_faces.h"
#include "carve/split_matter.h"
#include "carve/tile_faces.h"
#include "carve/trim_cutter.h"
#include "firma/solid.h"
#include "solid/change_solid.h"

namespace firma {

/// What a cut goes by, beside the solid and the cutter.
struct CutTerms {
    const CarveRules* rules = nullptr;                    ///< null: none
    const std::vector<std::string>* materials = nullptr;  ///< for reasons; null: by number
    std::uint32_t material = 0;                           ///< of the faces that the cutter leaves
    /// What the solid is made of. With materials of insides these count in place of `material`, but for fills.
    CutMatters matters;
    /// A piece as a solid, for what may not be carved. None where there is nothing such.
    std::function<std::optional<Solid>(const MatterPiece&)> solid_of;
    std::size_t other_faces = 0;  ///< that count for CarveRules::max_faces beside the solid's
};

/// Works in pieces of some ten microseconds. Only reads the solid; what it makes is its own.
class CutJob {
public:
    /// @param terms  what it points to lives as long as the job
    CutJob(Solid solid, Cutter cutter, const Pose& pose, const CutTerms& terms, CarveKind kind);

    CutJob(const CutJob&) = delete;
    CutJob& operator=(const CutJob&) = delete;

    /// Does one piece of work; false once there is none left.
    bool step();

    // Once step() said false:
    CarveStatus status() const { return status_; }
    const Error& error() const { return error_; }
    const CarveReport& report() const { return report_; }
    const std::string& reproduction() const { return reproduction_; }
    /// With kDone. Once: it is moved out.
    SolidChange take_change() { return std::move(change_); }

    const Solid& solid() const { return solid_; }
    /// As it was cut with.
    const CutterSolid& cutter() const { return solid_cutter_; }
    bool fills() const { return input_.fill; }
    /// Whether it touched what it cuts, and so was arranged.
    bool arranged() const { return arranger_ != nullptr; }

private:
    enum class Phase : std::uint8_t {
        kPlace,
        kCheck,
        kTrim,
        kGather,
        kTile,
        kCut,
        kArrange,
        kLabel,
        kTrace,
        kRules,
        kSplit,
        kFacets,
        kChange,
        kEnd
    };

    Phase place();
    Phase judge_cutter();
    Phase trim();
    Phase gather();
    Phase tile();
    Phase cut_next_faces();
    Phase order();
    Phase label();
    Phase trace();
    Phase apply_materials();
    Phase split_on();
    Phase start_facets(std::uint32_t material);
    Phase make_next_faces();
    Phase make_change();

    Phase refuse(ErrorCode code, std::string reason);
    Phase move_on(Verdict verdict, Phase next);
    Phase start_arranging();
    Phase arrange();
    Phase take_loops();
    CutSide locate_point(const ExactPoint& point) const;
    Phase too_many_pairs();
    Phase too_many_new_faces();
    Phase contradiction();
    double hardness_at_middle() const;
    double hardness_of_zones(const Vec3& middle) const;
    double hardness_of_matter(const Vec3& middle) const;
    Pose scaled_pose() const;
    std::vector<CutShield> shields() const;
    std::optional<std::string> taken_and_hard() const;
    bool shows_insides() const { return !terms_.matters.inside.empty() && !input_.fill; }
    std::vector<FacetPlace> facets_removed();
    std::string material_name(std::uint32_t material) const;
    double* clock_of(Phase phase);

    const Crossings& crossings() const { return arranger_ ? arranger_->crossings() : face_cutter_.made(); }
    const NewLoops& loops() const { return arranger_ ? arranger_->loops() : loops_; }
    CutView view() const { return {input_, crossings(), loops()}; }
    // What comes of it: the same, split where matters meet.
    const NewLoops& made_loops() const { return splitter_ ? splitter_->loops() : loops(); }
    const SolidData& data() const { return solid_.data(); }
    const Node* index() const { return data().faces.root.get(); }

    const Solid solid_;
    const Cutter cutter_;
    const Pose pose_;
    const CutTerms terms_;
    const CarveRules& rules_;
    CarveStatus status_ = CarveStatus::kRefused;
    Error error_;
    CarveReport report_;
    std::string reproduction_;
    SolidChange change_;
    Phase phase_ = Phase::kPlace;

    bool hardness_asked_ = false;
    std::string cut_short_by_;               ///< the first such thing
    std::vector<std::uint32_t> source_of_;   ///< by face of the trimmed cutter: the triangle it is a part of
    std::optional<std::uint32_t> material_;  ///< of all faces that the cutter leaves; none: they are of several matters

    CutterSolid solid_cutter_;
    SolidPatch patch_;
    std::vector<FacetPlace> facets_;  ///< gathered
    PairBudget budget_;

    // What the phases make, in their order: each reads what stands above, and writes its own.
    CutInput input_;
    FaceCutter face_cutter_;
    CutOrder order_;
    Labels labels_;
    NewLoops loops_;
    std::unique_ptr<CutArranger> arranger_;     ///< where the cutter touches: in place of the four above
    std::unique_ptr<MatterSplitter> splitter_;  ///< where several matters are near
    KeptPieces kept_;
    std::unique_ptr<FaceMaker> face_maker_;

    std::uint32_t next_ = 0;  ///< face at hand, in phases that go through many
};

}  // namespace firma
