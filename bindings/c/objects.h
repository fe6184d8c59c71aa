// SPDX-License-Identifier: MIT
// What handles stand for.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/handles.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/cutter.h"
#include "firma/edit_log.h"
#include "firma/firma_c.h"
#include "firma/hull.h"
#include "firma/result.h"
#include "firma/versions.h"
#include "firma/world.h"

namespace firma::c {

struct WorldObject final : Object {
    static constexpr Kind kKind = Kind::kWorld;
    static constexpr const char* kNoun = "world";
    explicit WorldObject(World w) : world(std::move(w)) {}
    World world;  ///< never changes once its handle is known
};

struct CutterObject final : Object {
    static constexpr Kind kKind = Kind::kCutter;
    static constexpr const char* kNoun = "cutter";
    explicit CutterObject(Cutter c) : cutter(std::move(c)) {}
    CutterObject(Cutter c, CraterSeed s) : cutter(std::move(c)), seed(s) {}
    const Cutter cutter;
    const std::optional<CraterSeed> seed;  ///< of one that is made from it
};

struct HullObject final : Object {
    static constexpr Kind kKind = Kind::kHull;
    static constexpr const char* kNoun = "hull";
    explicit HullObject(Hull h) : hull(std::move(h)) {}
    const Hull hull;
};

struct JobObject final : Object {
    static constexpr Kind kKind = Kind::kJob;
    static constexpr const char* kNoun = "job";
    explicit JobObject(CarveJob j) : job(std::move(j)) {}
    explicit JobObject(CommandJob j) : job(std::move(j)) {}
    std::variant<CarveJob, CommandJob> job;
    bool broken = false;  ///< memory ran out within run()
};

struct EditObject final : Object {
    static constexpr Kind kKind = Kind::kEdit;
    static constexpr const char* kNoun = "edit";
    explicit EditObject(World w) : edit(std::move(w)) {}
    WorldEdit edit;
};

/// Faces with their corners in one row.
struct FaceList {
    std::vector<firma_face> faces;
    std::vector<double> corners;

    void add(const FaceInfo& face, std::span<const Vec3> outline);
};

struct FacesObject final : Object {
    static constexpr Kind kKind = Kind::kFaces;
    static constexpr const char* kNoun = "list of faces";
    FaceList list;
};

struct DiffObject final : Object {
    static constexpr Kind kKind = Kind::kDiff;
    static constexpr const char* kNoun = "diff";
    WorldDiff diff;
    std::vector<std::uint32_t> removed;
    std::vector<firma_face> removed_faces;
    FaceList added;
};

struct BytesObject final : Object {
    static constexpr Kind kKind = Kind::kBytes;
    static constexpr const char* kNoun = "piece of bytes";
    std::vector<std::byte> bytes;
};

/// Bytes, or the error in their place, as a handle.
firma_code give_bytes(Result<std::vector<std::byte>> made, firma_bytes* out, const char* function);

/// Pieces, and what worlds of them take over from the world that they were of, which is not held.
struct ChunksObject final : Object {
    static constexpr Kind kKind = Kind::kChunks;
    static constexpr const char* kNoun = "list of chunks";
    ChunksObject(std::vector<firma::Chunk> all, const World& of);
    std::vector<firma::Chunk> chunks;
    std::vector<std::vector<firma_matter_volume>> volumes;  ///< of each
    std::shared_ptr<const std::vector<std::string>> materials;
    Tolerance tolerance;
    TreeOptions tree;
};

struct CommandObject final : Object {
    static constexpr Kind kKind = Kind::kCommand;
    static constexpr const char* kNoun = "command";
    explicit CommandObject(EditCommand c) : command(std::move(c)) {}
    const EditCommand command;
};

struct LogObject final : Object {
    static constexpr Kind kKind = Kind::kLog;
    static constexpr const char* kNoun = "log";
    explicit LogObject(EditLog l) : log(std::move(l)) {}
    EditLog log;
};

struct ReplayObject final : Object {
    static constexpr Kind kKind = Kind::kReplay;
    static constexpr const char* kNoun = "replay";
    explicit ReplayObject(LogReplay r) : replay(std::move(r)) {}
    LogReplay replay;
    std::string error;  ///< why it ended early, once that was asked for
};

}  // namespace firma::c
