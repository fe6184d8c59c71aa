// SPDX-License-Identifier: MIT
// Edits of worlds: a cut of the solid by the world's rules, then what it does to rooms, then a new version.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "base/assert.h"
#include "base/sort.h"
#include "carve/cut_job.h"
#include "carve/make_chunk.h"
#include "firma/carve.h"
#include "firma/rooms.h"
#include "join/body_solid.h"
#include "solid/face_ids.h"
#include "world/inside_materials.h"
#include "world/open_faces.h"
#include "world/room_edit.h"

namespace firma {

static_assert(kMaxEditNumber == kLastEditNumber);

namespace {

double microseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// What holds pieces, where loose ones are asked for.
std::shared_ptr<const Anchors> anchors_of(const World& world, const CarveOptions& options, CarveKind kind) {
    if (!options.chunks || kind == CarveKind::kFill || world.data().anchors) return world.data().anchors;
    return with_anchors(world).data().anchors;
}

/// A piece as a solid: what may not be carved is cut off the cutter.
std::optional<Solid> solid_of_piece(const MatterPieces& pieces, const MatterPiece& piece) {
    return piece.mesh ? piece.mesh : solid_of_planes(pieces.planes_of(piece));
}

/// What was filled in where nothing was stays there by intent; of a fill that swallowed or joined something, those
/// bodies of it that hang free.
/// @param hanging  keys of these; empty: all of the edit
std::shared_ptr<const Anchors> with_fill(const Anchors& anchors, std::uint32_t edit,
                                         const std::vector<std::uint64_t>& hanging) {
    auto more = std::make_shared<Anchors>(anchors);
    const auto insert = [](auto& list, auto value) {  // a patch that took edits back may have left higher ones
        const auto at = std::lower_bound(list.begin(), list.end(), value);
        if (at == list.end() || *at != value) list.insert(at, value);
    };
    for (const std::uint64_t key : hanging) insert(more->hanging, key);
    if (hanging.empty()) insert(more->edits, edit);
    return more;
}

/// Works in pieces of some ten microseconds. Only reads the world; what it makes is its own until it is published.
class WorldCut {
public:
    WorldCut(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
        : world_(std::move(world)),
          options_(options),
          anchors_(anchors_of(world_, options, kind)),
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
            case Phase::kOpenFaces:
                phase_ = trim_open_faces();
                report_time_ += microseconds_since(start);
                return phase_ != Phase::kEnd;
            case Phase::kPlaceFaces:
                phase_ = place_faces();
                break;
            case Phase::kSolid:
                if (!solid_->step()) phase_ = Phase::kCastable;
                break;
            case Phase::kCastable:
                if (changes_open_faces() && open_->store().step()) break;
                rooms_.start(*solid_, changes_open_faces() ? &open_->store() : nullptr);
                phase_ = Phase::kRooms;
                break;
            case Phase::kRooms:
                if (!rooms_.step()) phase_ = publish();
                break;
            case Phase::kChunks:
                phase_ = make_next_chunk();
                chunk_time_ += microseconds_since(start);
                return true;
            case Phase::kCut:
            case Phase::kEnd:
                return false;
        }
        time_ += microseconds_since(start);
        return phase_ != Phase::kEnd;
    }

    CarveResult result() const {
        CarveResult result;
        result.status = refused_ ? CarveStatus::kRefused : published_ ? CarveStatus::kDone : cut_.status();
        if (refused_ || !published_) result.error = refused_ ? *refused_ : cut_.error();
        result.report = cut_.report();
        result.report.times.gather += report_time_;
        result.report.times.tree += time_;
        result.report.times.chunks += chunk_time_;
        if (open_ && !refused_) open_->tell(result.report);
        if (published_) {
            result.report.faces_removed += open_removed_;
            result.report.faces_added += open_added_;
            result.report.portals = rooms_.portals_made();
            result.report.rooms = rooms_.rooms_made();
        }
        result.reproduction = cut_.reproduction();
        result.world = published_ ? after_ : world_;
        if (!published_) return result;
        result.chunks = chunks_;
        result.report.chunks = chunks_.size();
        for (const CutPiece& piece : cut_.pieces()) {
            const bool is_chunk = is_large(piece);
            (is_chunk ? result.report.chunk_volume : result.report.crumb_volume) += piece.volume;
            result.report.crumbs += !is_chunk;
        }
        return result;
    }

private:
    enum class Phase : std::uint8_t { kCut, kOpenFaces, kChunks, kPlaceFaces, kSolid, kCastable, kRooms, kEnd };

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
        terms.edit = options_.edit;
        if (options_.chunks) terms.anchors = anchors_.get();
        if (!data.cells.known()) return terms;
        terms.air_of = [&data](std::uint32_t part) { return data.cells.current_room(part); };
        terms.sheets_at = [&data](const GridBox& box, std::vector<CutSheet>& sheets) {
            std::vector<std::uint32_t> numbers;
            bool exact = true;
            data.cells.for_each_portal_where([&](const GridBox& other) { return boxes_meet(box, other); },
                                             [&](std::uint32_t number, const Portal& portal) {
                                                 exact = exact && portal.is_exact();
                                                 numbers.push_back(number);
                                             });
            if (!exact) return;  // RoomEdit::merge_at_portals() then
            sort_range(numbers);
            for (const std::uint32_t number : numbers) {
                const Portal& portal = data.cells.portal(number);
                append_sheets(portal, number, data.cells.rooms_of(portal), sheets);
            }
        };
        return terms;
    }

    /// Versions are numbered: after the last number there is no other edit.
    Phase cut_on() {
        if (world_.version() == std::numeric_limits<std::uint64_t>::max()) {
            refused_ = Error{ErrorCode::kTooLarge, "cutter", "the world has no numbers left for new edits"};
            return Phase::kEnd;
        }
        if (cut_.step()) return Phase::kCut;
        const bool goes_on = cut_.status() != CarveStatus::kRefused || (cut_.left_with_nothing() && !cut_.fills());
        return goes_on && world_.data().castable.root ? Phase::kOpenFaces : after_open_faces();
    }

    Phase after_open_faces() const {
        if (cut_.status() != CarveStatus::kDone) return changes_open_faces() ? Phase::kPlaceFaces : Phase::kEnd;
        return cut_.pieces().empty() ? Phase::kPlaceFaces : Phase::kChunks;
    }

    bool changes_open_faces() const { return open_ && open_->changes(); }

    bool is_large(const CutPiece& piece) const { return piece.volume >= options_.chunks->min_volume; }

    /// Those of the world's new faces first, as without chunks; then what only loose pieces show, crumbs among them:
    /// names do not depend on how large a chunk is.
    void number_materials() {
        materials_.see(cut_.change().added);
        for (const CutPiece& piece : cut_.pieces()) materials_.see(piece.made);
    }

    Phase make_next_chunk() {
        if (next_piece_ == 0) number_materials();
        if (chunk_) {
            if (chunk_->step()) return Phase::kChunks;
            chunks_.push_back(chunk_->take());
            chunk_.reset();
        } else if (const CutPiece& piece = cut_.pieces()[next_piece_++]; is_large(piece)) {
            const MatterPieces* pieces = world_.data().matters.get();
            const auto solid_of = [pieces](const MatterPiece& it) { return solid_of_piece(*pieces, it); };
            const auto material_of = [this](std::uint32_t material) { return materials_.number(material); };
            chunk_ =
                std::make_unique<ChunkMaker>(piece, world_.solid(), options_.chunks->density,
                                             ChunkMatters{pieces, world_.data().rules.get(), solid_of, material_of});
        }
        return chunk_ || next_piece_ < cut_.pieces().size() ? Phase::kChunks : Phase::kPlaceFaces;
    }

    Phase trim_open_faces() {
        if (!open_) {
            open_.emplace(world_.data(), cut_.cutter(), !cut_.fills());
            if (cut_.status() == CarveStatus::kDone) open_->take_along(cut_.pieces(), cut_.change());
        }
        if (open_->step()) return Phase::kOpenFaces;
        refused_ = open_->refused();
        return refused_ ? Phase::kEnd : after_open_faces();
    }

    /// What is castable only, once it is known which ids the solid's faces take.
    bool start_open_faces(SolidChange& change) {
        const WorldData& data = world_.data();
        open_removed_ = open_->removed().size();
        open_added_ = open_->added();
        const std::size_t of_solid = change.added.faces.size();
        const CarveRules& rules = data.rules ? *data.rules : CarveRules();
        FaceIds ids(data.next_face(), options_.edit);
        if (data.face_count() - change.removed.size() - open_removed_ + of_solid + open_added_ > rules.max_faces)
            refused_ = Error{ErrorCode::kTooLarge, "cutter",
                             "the world would have more than " + std::to_string(rules.max_faces) + " faces"};
        else if (!ids.has(of_solid + open_added_))
            refused_ = Error{ErrorCode::kTooLarge, "cutter", "the world has no ids left for new faces"};
        if (refused_) return false;
        for (std::size_t k = 0; k < of_solid; ++k) ids.take();
        open_->start(ids);
        change.edit = options_.edit;
        change.next_face = ids.next_face();
        return true;
    }

    /// Says which room the faces that come are part of.
    Phase place_faces() {
        SolidChange change = cut_.take_change();
        if (changes_open_faces() && !start_open_faces(change)) return Phase::kEnd;
        if (cut_.status() == CarveStatus::kDone)
            place_faces_of_solid(change);
        else
            names_ = world_.data().materials;
        if (changes_open_faces())
            for (const FacetPlace& facet : open_->removed()) rooms_.add_to(facet.block->part);
        solid_ = std::make_unique<SolidEdit>(world_.solid(), std::move(change));
        return Phase::kSolid;
    }

    void place_faces_of_solid(SolidChange& change) {
        stands_free_ = cut_.fills() && change.removed.empty();
        if (anchors_ && cut_.fills() && !stands_free_)
            hanging_ =
                find_hanging(build_store(change.added, world_.data().tree_options).store.root.get(), change.edit);
        for (const FacetPlace& facet : change.removed) rooms_.take(facet.block->part);
        for (const FaceSet::Entry& face : change.added.faces)
            if (face.part != kUnsetPart) rooms_.keep(face.part);
        if (world_.data().cells.known()) rooms_.divide_portals(cut_);
        if (const CutOpening opening = cut_.take_opening(); opening.pockets > 0) {
            rooms_.open(opening, shot_from(), change.added);
            if (world_.data().rules) rooms_.merge_by_share(world_.data().rules->merge_share);
        } else if (cut_.clipped()) {
            place_at_portals(change.added);
            rooms_.clip_portals(cut_);
        } else {
            const std::uint32_t room = find_room();
            for (FaceSet::Entry& face : change.added.faces)
                if (face.part == kUnsetPart) face.part = room;
        }
        names_ = materials_.take_up(change.added, inside_.empty() ? material_ : ~0u);
    }

    /// Whose air a carving's new air is, if that is not told by what it touches.
    std::optional<std::uint32_t> shot_from() const {
        if (!options_.from) return {};
        const Location found = locate(world_, *options_.from);
        return found.where == Where::kAir ? std::optional(found.room.value) : std::nullopt;
    }

    /// Faces of a fill that meets portals: what bounds the air of which room is told by portals and walls, or by where
    /// they are.
    void place_at_portals(FaceSet& added) {
        for (std::size_t k = 0; k < added.faces.size(); ++k) {
            FaceSet::Entry& face = added.faces[k];
            if (face.part != kUnsetPart) continue;
            const FaceAir& found = cut_.air_of_added()[k];
            face.part = found.air != ClippedSheets::kNoAir ? found.air : room_at(found.place, added, face);
            rooms_.add_to(face.part);
        }
    }
    /// @param place  it may touch a wall there
    std::uint32_t room_at(const GridPoint& place, const FaceSet& added, const FaceSet::Entry& face) const {
        Location found = locate(world_, to_metres(place));
        for (std::uint32_t k = 0; k < face.corner_count && found.where != Where::kAir; ++k)
            found = locate(world_, to_metres(added.corner(face, k)));
        return found.where == Where::kAir ? found.room.value : 0;
    }

    /// The room of what comes of the cutter, once it is known which faces go: the one that they are of. A carving that
    /// touches no face lies in the rock: a room of its own. What is filled in without touching any stands free in the
    /// air of one.
    std::uint32_t find_room() {
        if (!world_.data().cells.known()) {
            rooms_.add_to(0);
            return 0;
        }
        const std::vector<std::uint32_t> touched = cut_.airs_touched();
        if (cut_.fills()) rooms_.merge_at_portals(cut_.cutter().box, touched);
        if (!touched.empty()) {
            rooms_.add_to(touched[0]);
            return touched[0];
        }
        if (!cut_.fills()) return rooms_.add_new();
        for (const ExactPoint& point : cut_.cutter().points) {
            const Location found = locate(world_, to_metres(point.rounded()));
            if (found.where != Where::kAir) continue;
            rooms_.add_to(found.room.value);
            return found.room.value;
        }
        rooms_.add_to(0);  // too flat for any of its corners to be clear of it: closed by itself, it is sound anywhere
        return 0;
    }

    Phase publish() {
        auto data = next_version(world_.data());
        data->solid = solid_->result();
        if (changes_open_faces()) data->castable = open_->store().result();
        rooms_.publish(*data);
        data->materials = names_;
        data->anchors = anchors_;
        if (anchors_ && (stands_free_ || !hanging_.empty()))
            data->anchors = with_fill(*anchors_, data->edits(), hanging_);
        after_ = World(std::move(data));
        published_ = true;
        return Phase::kEnd;
    }

    const World world_;
    const CarveOptions options_;
    const std::shared_ptr<const Anchors> anchors_;
    InsideMaterials materials_;
    const std::vector<std::uint32_t> inside_;
    const std::uint32_t material_;
    CutJob cut_;
    InsideMaterials::Names names_;  ///< once it is known which are used
    std::optional<OpenFaceEdit> open_;
    std::size_t open_removed_ = 0, open_added_ = 0;
    RoomEdit rooms_;
    std::unique_ptr<SolidEdit> solid_;
    World after_;
    bool published_ = false;
    bool stands_free_ = false;            ///< filled in where nothing was
    std::vector<std::uint64_t> hanging_;  ///< keys of what of it does, else
    std::vector<Chunk> chunks_;
    std::unique_ptr<ChunkMaker> chunk_;  ///< the one at hand
    std::size_t next_piece_ = 0;
    std::optional<Error> refused_;
    Phase phase_ = Phase::kCut;
    double time_ = 0;         ///< microseconds, of what comes after the cut
    double chunk_time_ = 0;   ///< of making chunks
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
