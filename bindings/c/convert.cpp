// SPDX-License-Identifier: MIT
// Between the C API's plain structs and the library's own.
#include "bindings/c/convert.h"

#include <algorithm>

#include "firma/queries.h"

namespace firma::c {
namespace {

static_assert(FIRMA_NO_FACE == FaceId{}.value && FIRMA_NO_PORTAL == PortalId{}.value &&
              FIRMA_NO_ROOM == RoomId{}.value && FIRMA_ANY_ROOM == kAnyRoom.value &&
              FIRMA_LOCATE_ROOM == kLocateRoom.value);

}  // namespace

namespace {

/// Of a struct that may be null, or shorter than this version's: all of it, what is lacking by default.
template <class T>
firma_code whole_of(const T* given, void (*defaults)(T*), T& whole, const char* function) {
    defaults(&whole);
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    take_sized(given, whole);
    return FIRMA_OK;
}

bool is_length(double number) {
    return is_finite(number) && number >= 0;
}

}  // namespace

firma_code read_options(const firma_world_options* options, WorldOptions& world, ReadOptions& read,
                        const char* function) {
    firma_world_options whole;
    const firma_world_options* const given = &whole;
    if (const firma_code code = whole_of(options, firma_world_options_defaults, whole, function)) return code;
    if (given->surface_area > 1 || given->max_depth < 0 || given->max_depth > 64 || given->faces_per_leaf < 1 ||
        !(given->min_node_volume >= 0))
        return fail(FIRMA_ERROR_INVALID, function, "a rule for the tree is out of its range");
    if (!(given->contact_offset >= 0) || !is_finite(given->contact_offset))
        return fail(FIRMA_ERROR_INVALID, function, "the contact offset must be a finite number, not below zero");
    if (!(given->scale >= 0) || !is_finite(given->scale))
        return fail(FIRMA_ERROR_INVALID, function, "the scale must be a finite number above zero, or 0");
    world.tree.split = given->surface_area ? Split::kSurfaceArea : Split::kLongestAxis;
    world.tree.max_depth = given->max_depth;
    world.tree.faces_per_leaf = given->faces_per_leaf;
    world.tree.min_node_volume = given->min_node_volume;
    world.tolerance.contact_offset = given->contact_offset;
    if (given->no_textures > 1 || given->reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "no_textures must be 0 or 1, reserved 0");
    world.textures = given->no_textures == 0;
    read.scale = given->scale;
    if (!given->matters) return FIRMA_OK;
    return read_matters(*given->matters, world.matters.emplace(), function);
}

namespace {

firma_code read_whole(const firma_cast_options* options, CastOptions& cast, firma_cast_options& whole,
                      const char* function) {
    const firma_cast_options* const given = &whole;
    if (const firma_code code = whole_of(options, firma_cast_options_defaults, whole, function)) return code;
    if (given->sides > 1) return fail(FIRMA_ERROR_INVALID, function, "sides must be 0 or 1");
    if (!is_finite(given->contact_offset))
        return fail(FIRMA_ERROR_INVALID, function, "the contact offset is not finite");
    if (!given->passed && (given->passed_capacity || given->passed_portals))
        return bad_call(function, "a count without its array");
    cast.mask = given->mask;
    cast.room = {given->room};
    cast.sides = given->sides ? Sides::kBoth : Sides::kFront;
    cast.contact_offset = given->contact_offset;
    return FIRMA_OK;
}

}  // namespace

firma_code read_options(const firma_cast_options* options, CastOptions& cast, const char* function) {
    firma_cast_options whole;
    return read_whole(options, cast, whole, function);
}

firma_code TrailOptions::read(const firma_cast_options* given, const char* function) {
    if (const firma_code code = read_whole(given, cast, whole_, function)) return code;
    static_assert(sizeof(RoomId) == sizeof(std::uint32_t) && sizeof(PortalId) == sizeof(std::uint32_t));
    trail_.rooms = {reinterpret_cast<RoomId*>(whole_.passed), whole_.passed_capacity};
    if (whole_.passed_portals)
        trail_.portals = {reinterpret_cast<PortalId*>(whole_.passed_portals), whole_.passed_capacity};
    if (whole_.passed || whole_.passed_count) cast.trail = &trail_;
    return FIRMA_OK;
}

void TrailOptions::put() const {
    if (whole_.passed_count) *whole_.passed_count = trail_.count;
}

firma_code read_options(const firma_near_options* options, NearOptions& near, const char* function) {
    firma_near_options whole;
    const firma_near_options* const given = &whole;
    if (const firma_code code = whole_of(options, firma_near_options_defaults, whole, function)) return code;
    if (given->reserved != 0) return fail(FIRMA_ERROR_INVALID, function, "reserved must be 0");
    near.mask = given->mask;
    near.room = {given->room};
    return FIRMA_OK;
}

firma_code read_options(const firma_carve_options* options, CarveOptions& carve, CarveKind& kind,
                        const char* function) {
    firma_carve_options whole;
    const firma_carve_options* const given = &whole;
    const auto defaults = [](firma_carve_options* out) { *out = {}; };
    if (const firma_code code = whole_of(options, +defaults, whole, function)) return code;
    if (given->fill > 1) return fail(FIRMA_ERROR_INVALID, function, "fill must be 0 or 1");
    if (given->has_from > 1 || given->reserved != 0)
        return fail(FIRMA_ERROR_INVALID, function, "has_from must be 0 or 1, reserved 0");
    if (given->has_from) {
        carve.from = vec(given->from);
        if (!is_finite(*carve.from)) return fail(FIRMA_ERROR_INVALID, function, "from is not finite");
    }
    if (given->chunks > 1) return fail(FIRMA_ERROR_INVALID, function, "chunks must be 0 or 1");
    if (!is_length(given->min_chunk_volume) || !is_length(given->density))
        return fail(FIRMA_ERROR_INVALID, function,
                    "min_chunk_volume and density must be finite numbers, not below zero");
    if (given->chunks) {
        carve.chunks.emplace();
        if (given->min_chunk_volume != 0) carve.chunks->min_volume = given->min_chunk_volume;
        if (given->density != 0) carve.chunks->density = given->density;
    }
    carve.edit = given->edit;
    carve.material = text_of(given->material);
    kind = given->fill ? CarveKind::kFill : CarveKind::kCarve;
    return FIRMA_OK;
}

Pose pose_of(const firma_pose& pose) {
    return {vec(pose.position), {pose.rotation[0], pose.rotation[1], pose.rotation[2], pose.rotation[3]}, pose.scale};
}

void put_pose(const Pose& pose, firma_pose& out) {
    put(pose.position, out.position);
    std::copy(pose.rotation.begin(), pose.rotation.end(), out.rotation);
    out.scale = pose.scale;
}

void put_corner(const FaceRef& face, std::int32_t (&corner)[3]) {
    corner[0] = face.corner.x;
    corner[1] = face.corner.y;
    corner[2] = face.corner.z;
}

FaceRef face_of(const firma_hit& hit) {
    return {{hit.face}, {hit.corner[0], hit.corner[1], hit.corner[2]}};
}

void put_hit(const Hit& hit, firma_hit& out) {
    out.fraction = hit.fraction;
    out.safe_fraction = hit.safe_fraction;
    put(hit.centre, out.centre);
    put(hit.point, out.point);
    put(hit.normal, out.normal);
    put(hit.face_normal, out.face_normal);
    out.status = std::uint32_t(hit.status);
    out.feature = std::uint32_t(hit.feature);
    out.feature_index = hit.feature_index;
    out.face = hit.face.id.value;
    put_corner(hit.face, out.corner);
    out.portal = hit.portal.value;
    out.material = hit.material;
    out.reserved = 0;
}

std::uint32_t face_flags(const FaceInfo& face) {
    return (face.two_sided ? FIRMA_FACE_TWO_SIDED : 0) | (face.solid ? FIRMA_FACE_SOLID : 0);
}

void put_near(const NearFace& near, firma_near& out) {
    out = {};
    put(near.point, out.point);
    out.distance = near.distance;
    out.face = near.face.id.value;
    put_corner(near.face, out.corner);
    out.material = near.material;
    out.feature = std::uint32_t(near.feature);
    out.feature_index = near.feature_index;
    out.portal = near.portal.value;
}

void put_overlap(const Overlap& overlap, firma_near& out) {
    put_near(overlap, out);
    put(overlap.direction, out.direction);
    out.depth = overlap.depth;
}

void put_report(const CarveResult& result, firma_chunks loose, firma_carve_report* to) {
    const CarveReport& report = result.report;
    firma_carve_report out{};
    out.status = std::uint32_t(result.status);
    out.retries = std::uint32_t(report.retries);
    out.candidate_faces = report.candidate_faces;
    out.faces_cut = report.faces_cut;
    out.faces_removed = report.faces_removed;
    out.faces_added = report.faces_added;
    out.scale = report.scale;
    out.volume = report.volume;
    out.place_us = report.times.place;
    out.gather_us = report.times.gather;
    out.cut_us = report.times.cut;
    out.label_us = report.times.label;
    out.trace_us = report.times.trace;
    out.facets_us = report.times.facets;
    out.tree_us = report.times.tree;
    out.faces_castable_only = report.faces_castable_only;
    out.portals = report.portals;
    out.rooms = report.rooms;
    out.chunks = report.chunks;
    out.crumbs = report.crumbs;
    out.chunk_volume = report.chunk_volume;
    out.crumb_volume = report.crumb_volume;
    out.faces_searched = report.faces_searched;
    out.chunks_us = report.times.chunks;
    out.loose = loose;
    out.cut_short = report.cut_short;
    out.open_trimmed = report.open_trimmed;
    out.open_removed = report.open_removed;
    out.panes = report.panes;
    out.clips = report.clips;
    put_sized(out, to);
}

}  // namespace firma::c
