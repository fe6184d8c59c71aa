// SPDX-License-Identifier: MIT
// One edit, step by step: from a placed cutter to the rooms of a new world.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "carve/cut_faces.h"
#include "carve/cut_state.h"
#include "carve/cutter_mover.h"
#include "carve/make_faces.h"
#include "carve/room_trees.h"
#include "firma/carve.h"
#include "tree/edit_blocks.h"
#include "world/world_data.h"

namespace firma {

/// Does the work of a CarveJob in pieces of some ten microseconds. Only reads the world; what it makes is its own until
/// it is published.
class Subtraction {
public:
    Subtraction(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options,
                CarveKind kind);

    Subtraction(const Subtraction&) = delete;
    Subtraction& operator=(const Subtraction&) = delete;

    /// Does one piece of work; false once there is none left.
    bool step();
    CarveResult take_result() const { return result_; }

private:
    enum class Phase : std::uint8_t {
        kPlace,
        kCheck,
        kMove,
        kGather,
        kTile,
        kCut,
        kLabel,
        kTrace,
        kRules,
        kFacets,
        kRemove,
        kTree,
        kPublish,
        kEnd
    };

    Phase place();
    Phase judge_cutter();
    Phase gather();
    Phase tile();
    Phase cut_next_faces();
    Phase label();
    Phase trace();
    Phase apply_materials();
    Phase make_next_faces();
    Phase remove_facets();
    Phase edit_tree();
    Phase publish();

    Phase refuse(ErrorCode code, std::string reason);
    Phase start_cut();
    Phase move_on(Verdict verdict, Phase next);
    Phase degenerate();
    Phase move_cutter_aside();
    Phase try_move();
    Phase too_many_pairs();
    bool has_numbers_left() const;
    const CarveZone* zone_reached(double harder_than) const;
    Phase contradiction();
    Phase shrink(double hardness, const std::string& by, Phase otherwise);
    std::vector<FacetPlace> facets_gone();
    void find_room();
    double* clock_of(Phase phase);

    const World world_;
    const World doors_open_;  ///< the same with all portals open: what is asked about the solid
    const Cutter cutter_;
    const Pose pose_;
    const CarveOptions options_;
    const CarveRules& rules_;
    CarveResult result_;
    Phase phase_ = Phase::kPlace;

    CutterMover mover_;
    CutterSolid solid_cutter_;
    SolidPatch patch_;
    std::vector<FacetPlace> facets_;              ///< gathered
    std::vector<std::uint32_t> rooms_of_facets_;  ///< of each of them
    RoomJoin rooms_{world_.data()};               ///< that the edit touches
    Cut cut_;
    PairBudget budget_;  ///< of all tries together
    FaceCutter face_cutter_;
    std::unique_ptr<FaceMaker> face_maker_;
    FaceSet come_;
    std::unique_ptr<BlockEdit> block_edit_;
    std::uint32_t next_ = 0;  ///< face at hand, in phases that go through many
    bool sound_ = true;       ///< whether all facets made so far are
};

}  // namespace firma
