// SPDX-License-Identifier: MIT
// Between the C API's plain structs and the library's own.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "bindings/c/calls.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/mass.h"
#include "firma/matter.h"
#include "firma/queries.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma::c {

inline Vec3 vec(const double (&v)[3]) {
    return {v[0], v[1], v[2]};
}
inline void put(const Vec3& v, double (&out)[3]) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}
inline void put(const MassProperties& from, firma_mass& to) {
    to.volume = from.volume;
    to.mass = from.mass;
    put(from.centre, to.centre);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            to.inertia[3 * row + column] = from.inertia[std::size_t(row)][column];
}

inline std::string text_of(const char* text) {
    return text ? text : "";
}

/// For messages: what the caller named, or what it is.
inline std::string name_or(const char* name, const char* otherwise) {
    return name && *name ? name : otherwise;
}

inline Sphere sphere_of(const firma_cast_input& input) {
    return {vec(input.centre), input.radius};
}

/// A table as a caller has it. What it says is judged by whoever makes a world by it.
firma_code read_matters(const firma_matter_table& given, MatterTable& table, const char* function);
/// FIRMA_OK, or what is wrong with the options; null gives the defaults.
firma_code read_options(const firma_world_options* given, WorldOptions& world, ReadOptions& read, const char* function);
firma_code read_options(const firma_cast_options* given, CastOptions& cast, const char* function);
/// The same with the rooms passed. It stays where it is, as `cast` points into it.
struct TrailOptions {
    CastOptions cast;
    firma_code read(const firma_cast_options* given, const char* function);
    /// To the caller, once the cast is made.
    void put() const;

private:
    firma_cast_options whole_;
    RoomTrail trail_{};
};
firma_code read_options(const firma_near_options* given, NearOptions& near, const char* function);
firma_code read_options(const firma_carve_options* given, CarveOptions& carve, CarveKind& kind, const char* function);

/// The caller's hook that batches are spread over, of firma_set_tasks(); `run` null: in the calling thread.
Tasks batch_tasks();

inline std::span<const std::byte> bytes_of(const void* data, std::size_t length) {
    return {static_cast<const std::byte*>(data), length};
}

Pose pose_of(const firma_pose& pose);
void put_pose(const Pose& pose, firma_pose& out);
void put_hit(const Hit& hit, firma_hit& out);
void put_near(const NearFace& near, firma_near& out);
void put_overlap(const Overlap& overlap, firma_near& out);
FaceRef face_of(const firma_hit& hit);
void put_corner(const FaceRef& face, std::int32_t (&corner)[3]);
std::uint32_t face_flags(const FaceInfo& face);
/// `out` is sized().
void put_report(const CarveResult& result, firma_chunks loose, firma_carve_report* out);

}  // namespace firma::c
