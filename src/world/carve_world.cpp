// SPDX-License-Identifier: MIT
// Edits of worlds: a cut of the solid by the world's rules, then what it does to rooms, then a new version.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "base/assert.h"
#include "carve/cut_job.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "join/body_solid.h"
#include "world/count_reaching.h"
#include "world/inside_materials.h"
#include "world/room_edit.h"

namespace firma {
namespace {

double microseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// A piece as a solid: what may not be carved is cut off the cutter.
std::optional<Solid> solid_of_piece(const MatterPieces& pieces, const MatterPiece& piece) {
    return piece.mesh ? piece.mesh : solid_of_planes(pieces.planes_of(piece));
}

/// Works in pieces of some ten microseconds. Only reads the world; what it makes is its own until it is published.
class WorldCut {
public:
    WorldCut(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
        : world_(std::move(world)),
          materials_(world_.data().materials),
          inside_(insides(options, kind)),
          material_(materials_.index(options.material)),
          cut_(world_.solid(), std::move(cutter), pose, terms(), kind),
          rooms_(world_.data()) {}

    /// Does one piece of work; false once there is none left.
    bool step() {
        if (phase_ == Phase::kCut) {
            phase_ = cut_on();
            return phase_ != Phase::kEnd;
        }
        const auto start = std::chrono::steady_clock::now();
        switch (phase_) {
            case Phase::kCastable:
                phase_ = count_castable();
                report_time_ += microseconds_since(start);
                return phase_ != Phase::kEnd;
            case Phase::kPlaceFaces:
                phase_ = place_faces();
                break;
            case Phase::kSolid:
                if (solid_->step()) break;
                rooms_.start(*solid_);
                phase_ = Phase::kRooms;
                break;
            case Phase::kRooms:
                if (!rooms_.step()) phase_ = publish();
                break;
            case Phase::kCut:
            case Phase::kEnd:
                return false;
        }
        time_ += microseconds_since(start);
        return phase_ != Phase::kEnd;
    }

    CarveResult result() const {
        CarveResult result;
        result.status = refused_ ? CarveStatus::kRefused : cut_.status();
        result.error = refused_ ? *refused_ : cut_.error();
        result.report = cut_.report();
        result.report.times.gather += report_time_;
        result.report.times.tree += time_;
        if (castable_) result.report.faces_castable_only = castable_->count();
        result.reproduction = cut_.reproduction();
        result.world = published_ ? after_ : world_;
        return result;
    }

private:
    enum class Phase : std::uint8_t { kCut, kCastable, kPlaceFaces, kSolid, kRooms, kEnd };

    /// Materials of new faces by matter; none where the options name one for all, or there is one only.
    std::vector<std::uint32_t> insides(const CarveOptions& options, CarveKind kind) {
        const MatterPieces* pieces = world_.data().matters.get();
        if (!pieces || !options.material.empty() || kind == CarveKind::kFill) return {};
        return materials_.of_matters(pieces->table);
    }

    CutTerms terms() const {
        const WorldData& data = world_.data();
        CutTerms terms;
        terms.rules = data.rules.get();
        terms.materials = data.materials.get();
        terms.material = material_;
        terms.other_faces = data.castable.count;
        terms.matters = {data.matters.get(), inside_};
        if (const MatterPieces* pieces = data.matters.get())
            terms.solid_of = [pieces](const MatterPiece& piece) { return solid_of_piece(*pieces, piece); };
        return terms;
    }

    /// Versions are numbered: after the last number there is no other edit.
    Phase cut_on() {
        if (world_.version() == std::numeric_limits<std::uint64_t>::max()) {
            refused_ = Error{ErrorCode::kTooLarge, "cutter", "the world has no numbers left for new edits"};
            return Phase::kEnd;
        }
        if (cut_.step()) return Phase::kCut;
        const bool counts = cut_.status() != CarveStatus::kRefused && world_.data().castable.root;
        return counts ? Phase::kCastable : after_castable();
    }

    Phase after_castable() const { return cut_.status() == CarveStatus::kDone ? Phase::kPlaceFaces : Phase::kEnd; }

    Phase count_castable() {
        const WorldData& data = world_.data();
        if (!castable_) {
            const CarveRules defaults;
            const CarveRules& rules = data.rules ? *data.rules : defaults;
            castable_.emplace(data.castable.root.get(), cut_.cutter(), rules.max_pairs);
        }
        return castable_->step() ? Phase::kCastable : after_castable();
    }

    /// Says which room the faces that come are part of.
    Phase place_faces() {
        SolidChange change = cut_.take_change();
        for (const FacetPlace& facet : change.removed) rooms_.touch(facet.block->part);
        find_room();
        for (FaceSet::Entry& face : change.added.faces)
            if (face.part == kUnsetPart) face.part = rooms_.target();
        names_ = materials_.take_up(change.added, inside_.empty() ? material_ : ~0u);
        solid_ = std::make_unique<SolidEdit>(world_.solid(), std::move(change));
        return Phase::kSolid;
    }

    /// Once it is known which faces go. A cut that touches no face lies in the rock: a room of its own. What is filled
    /// in without touching any stands free in the air of one.
    void find_room() {
        if (!world_.data().cells.known()) return rooms_.touch(0);
        const bool touches_faces = rooms_.any();
        if (touches_faces || cut_.fills()) rooms_.touch_portals(cut_.cutter().box);
        if (touches_faces || !cut_.fills()) return;
        for (const ExactPoint& point : cut_.cutter().points) {
            const Location found = locate(world_, to_metres(point.rounded()));
            if (found.where == Where::kAir) return rooms_.touch(found.room.value);
        }
        rooms_.touch(0);  // too flat for any of its corners to be clear of it: closed by itself, it is sound anywhere
    }

    Phase publish() {
        auto data = next_version(world_.data());
        data->solid = solid_->result();
        rooms_.publish(*data);
        data->materials = names_;
        after_ = World(std::move(data));
        published_ = true;
        return Phase::kEnd;
    }

    const World world_;
    InsideMaterials materials_;
    const std::vector<std::uint32_t> inside_;
    const std::uint32_t material_;
    CutJob cut_;
    InsideMaterials::Names names_;  ///< once it is known which are used
    std::optional<ReachCount> castable_;
    RoomEdit rooms_;
    std::unique_ptr<SolidEdit> solid_;
    World after_;
    bool published_ = false;
    std::optional<Error> refused_;
    Phase phase_ = Phase::kCut;
    double time_ = 0;         ///< microseconds, of what comes after the cut
    double report_time_ = 0;  ///< of counting faces for the report alone
};

}  // namespace

struct CarveJob::State {
    WorldCut work;
    bool finished = false;
    bool broken = false;  ///< true while a step is done, and for good when an exception leaves it

    State(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
        : work(std::move(world), std::move(cutter), pose, options, kind) {}

    void step() {
        broken = true;
        finished = !work.step();
        broken = false;
    }
};

CarveJob::CarveJob(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
    : state_(new State(std::move(world), std::move(cutter), pose, options, kind)) {}
CarveJob::~CarveJob() = default;
CarveJob::CarveJob(CarveJob&&) noexcept = default;
CarveJob& CarveJob::operator=(CarveJob&&) noexcept = default;

bool CarveJob::run(double microseconds) {
    const auto start = std::chrono::steady_clock::now();
    while (!finished()) {
        state_->step();
        if (microseconds == INFINITY) continue;
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
        if (!(spent.count() < microseconds)) break;
    }
    return finished();
}

bool CarveJob::finished() const {
    return !state_ || state_->finished || state_->broken;
}

bool CarveJob::broken() const {
    return state_ && state_->broken;
}

CarveResult CarveJob::result() const {
    FIRMA_ASSERT(finished(), "an edit has no result yet: call run() until it returns true");
    if (!state_) {
        CarveResult nothing;
        nothing.error = {ErrorCode::kInvalid, "", "the job was moved away"};
        return nothing;
    }
    CarveResult result = state_->work.result();
    if (state_->finished) return result;
    result.status = CarveStatus::kRefused;
    result.error = state_->broken ? Error{ErrorCode::kNoMemory, "", "memory ran out in the middle of the edit"}
                                  : Error{ErrorCode::kInvalid, "", "the edit is not finished"};
    return result;
}

CarveResult carve(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveJob job(world, cutter, pose, options, CarveKind::kCarve);
    job.run(INFINITY);
    return job.result();
}

CarveResult fill(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveJob job(world, cutter, pose, options, CarveKind::kFill);
    job.run(INFINITY);
    return job.result();
}

}  // namespace firma
