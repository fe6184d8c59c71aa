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
#include "carve/clip_sheets.h"
#include "carve/cut_faces.h"
#include "carve/cut_opening.h"
#include "carve/cut_terms.h"
#include "carve/cutter_limits.h"
#include "carve/edge_parts.h"
#include "carve/find_loose.h"
#include "carve/find_pockets.h"
#include "carve/label.h"
#include "carve/make_faces.h"
#include "carve/split_matter.h"
#include "carve/tile_faces.h"
#include "carve/trim_cutter.h"
#include "firma/solid.h"
#include "solid/change_solid.h"

namespace firma {

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
    /// Refused, as it takes nothing of the solid and was cut short: what is left of the cutter is cutter().
    bool left_with_nothing() const { return left_with_nothing_; }
    /// With kDone. Once: it is moved out.
    SolidChange take_change() { return std::move(change_); }
    const SolidChange& change() const { return change_; }
    /// Once: it is moved out.
    CutOpening take_opening() { return std::move(opening_); }
    /// Whether a fill met sheets and it is known what it does to them. With kDone, as the next two.
    bool clipped() const { return clipped_.has_value(); }
    /// Of each of SolidChange::added.faces; no air and no place for pieces of old ones.
    const std::vector<FaceAir>& air_of_added() const { return air_of_added_; }
    /// The sheets that are left, in order of portals.
    /// @param changed  gets the portals of those that are not what they were
    std::vector<CutSheet> sheets_left(std::vector<std::uint32_t>& changed);
    bool met_sheets() const { return !sheets_.empty(); }
    /// The airs that faces that went, whole or in part, looked into: each once, in order of these faces. Without
    /// those of faces of which a carving only divides edges.
    std::vector<std::uint32_t> airs_touched() const;
    /// What became of an edge that is used by something else than faces of the solid, too. With kDone.
    /// @param parts  gets the edges that take its place, as it ran; as faces have them
    /// @return whether any do
    bool divide_edge(const SolidUse& use, std::vector<SolidUse>& parts);
    /// The same between two corners of faces that no cut has touched.
    bool divide_edge(const InputPoint& from, const InputPoint& to, std::vector<SolidUse>& parts);
    /// Around all edges of the solid that are divided now.
    GridBox divided_box() const { return edge_parts_ ? edge_parts_->box() : GridBox(); }
    /// With kDone, where CutTerms::anchors said to look for them.
    const std::vector<CutPiece>& pieces() const { return pieces_; }

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
        kLoose,
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
    Phase find_loose();
    Phase make_change();
    void make_opening();
    std::vector<std::uint32_t> wall_parts() const;

    Phase refuse(ErrorCode code, std::string reason);
    Phase move_on(Verdict verdict, Phase next);
    Phase start_arranging();
    Phase arrange();
    Phase take_loops();
    CutSide locate_point(const ExactPoint& point) const;
    Phase too_many_pairs();
    Phase too_many_new_faces();
    Phase contradiction();
    Pose scaled_pose() const;
    CutterLimits limits() const { return {solid_, solid_cutter_, terms_, rules_, input_.fill}; }
    bool shows_insides() const { return !terms_.matters.inside.empty() && !input_.fill; }
    std::vector<FacetPlace> facets_removed();
    bool may_open() const;
    bool opens_several() const;
    bool goes_several() const;
    void take_pieces_out();
    double* clock_of(Phase phase);

    const Crossings& crossings() const {
        return clipped_ ? clipped_->crossings : arranger_ ? arranger_->crossings() : face_cutter_.made();
    }
    const NewLoops& loops() const { return clipped_ ? clipped_->loops : arranger_ ? arranger_->loops() : loops_; }
    CutView view() const { return {input_, crossings(), loops()}; }
    // What comes of it: the same, split where matters meet.
    const NewLoops& made_loops() const { return splitter_ ? splitter_->loops() : loops(); }
    const Crossings& made_crossings() const { return splitter_ ? splitter_->crossings() : crossings(); }
    CutView made_view() const { return {input_, made_crossings(), made_loops()}; }
    const SolidData& data() const { return solid_.data(); }
    /// The number of this edit.
    std::uint32_t edit() const { return terms_.edit > 0 ? terms_.edit : data().edits + 1; }
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
    bool left_with_nothing_ = false;
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
    struct Loose {
        const CutView view;
        const CutFaces cut;
        LooseSearch search;
        explicit Loose(const CutJob& job)
            : view(job.made_view()),
              cut{view, job.made_loops(), job.kept_, job.face_maker_->made()},
              search(job.solid_, cut, *job.terms_.anchors) {}
    };
    std::unique_ptr<Loose> loose_;
    std::vector<CutPiece> pieces_;
    std::vector<std::vector<std::uint32_t>> made_of_piece_;  ///< of `pieces_`: owners that the cut made

    bool opens_ = false;  ///< several airs
    CutOpening opening_;
    std::vector<CutSheet> sheets_;  ///< of a fill
    std::optional<ClippedSheets> clipped_;
    std::vector<FaceAir> air_of_added_;
    std::vector<std::uint32_t> made_from_;   ///< of each of SolidChange::added.faces: NewLoops::faces, or ~0
    std::vector<std::uint32_t> taken_from_;  ///< of each of CutOpening::taken.faces: NewLoops::taken
    std::optional<EdgeParts> edge_parts_;    ///< with kDone
    std::uint32_t next_ = 0;                 ///< face at hand, in phases that go through many
};

}  // namespace firma
