// SPDX-License-Identifier: MIT
// What handles stand for.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "bindings/c/handles.h"
#include "firma/carve.h"
#include "firma/cutter.h"
#include "firma/firma_c.h"
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
    const Cutter cutter;
};

struct JobObject final : Object {
    static constexpr Kind kKind = Kind::kJob;
    static constexpr const char* kNoun = "job";
    explicit JobObject(CarveJob j) : job(std::move(j)) {}
    CarveJob job;
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

}  // namespace firma::c
