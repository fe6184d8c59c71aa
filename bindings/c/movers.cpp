// SPDX-License-Identifier: MIT
// Hulls, and what any shape that moves meets and overlaps. What answers one struct takes no memory, no lock, and counts
// no reference; contact points take memory for the face's corners.
#include <limits>
#include <optional>
#include <vector>

#include "bindings/c/answers.h"
#include "bindings/c/convert.h"
#include "bindings/c/mover_there.h"
#include "bindings/c/objects.h"
#include "firma/hull.h"
#include "firma/rooms.h"

namespace firma::c {
namespace {

firma_code give_hull(const Result<Hull>& made, firma_hull* out, const char* function) {
    if (!made) return fail(made.error());
    return give(std::make_unique<HullObject>(made.value()), out, function);
}

/// What all questions of a moving shape begin with.
template <class Work>
firma_code ask_of_mover(firma_world world, const firma_mover* mover, const char* function, const Work& work) {
    const WorldObject* object = find<WorldObject>(world.id, function);
    if (!object) return FIRMA_ERROR_BAD_HANDLE;
    MoverThere there;
    if (const firma_code code = there.read(mover, function)) return code;
    return work(object->world, there);
}

/// Of a portal that was met, the polygon nearest to a point; none for a portal that is not there.
std::vector<Vec3> portal_at(const World& world, PortalId portal, const Vec3& point) {
    std::vector<Vec3> nearest;
    double least = std::numeric_limits<double>::max();
    for (std::vector<Vec3>& corners : portal_polygons(world, portal)) {
        const double distance = closest_point(point, corners).distance;
        if (!nearest.empty() && !(distance < least)) continue;
        least = distance;
        nearest = std::move(corners);
    }
    return nearest;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_hull_from_points(const double* points, size_t count, firma_hull* hull) {
    return guarded(__func__, [&, function = __func__] {
        if (!hull || (count && !points)) return bad_call(function, kNull);
        if (count > kMaxHullCorners)
            return fail(FIRMA_ERROR_TOO_LARGE, function,
                        "a hull has at most " + std::to_string(kMaxHullCorners) + " points");
        std::vector<Vec3> all(count);
        for (std::size_t k = 0; k < count; ++k) all[k] = {points[3 * k], points[3 * k + 1], points[3 * k + 2]};
        return give_hull(make_hull(all), hull, function);
    });
}

firma_code firma_hull_box(const double half[3], const double axes[9], firma_hull* hull) {
    return guarded(__func__, [&, function = __func__] {
        if (!half || !hull) return bad_call(function, kNull);
        const Vec3 size{half[0], half[1], half[2]};
        if (!axes) return give_hull(make_box(size), hull, function);
        return give_hull(
            make_box(size, {Vec3{axes[0], axes[1], axes[2]}, {axes[3], axes[4], axes[5]}, {axes[6], axes[7], axes[8]}}),
            hull, function);
    });
}

firma_code firma_hull_corners(firma_hull hull, double* corners, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count || (!corners && capacity)) return bad_call(function, kNull);
        const HullObject* object = find<HullObject>(hull.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::span<const Vec3> all = object->hull.corners();
        *count = all.size();
        for (std::size_t k = 0; k < std::min(capacity, all.size()); ++k) {
            corners[3 * k] = all[k].x;
            corners[3 * k + 1] = all[k].y;
            corners[3 * k + 2] = all[k].z;
        }
        return FIRMA_OK;
    });
}

firma_code firma_hull_release(firma_hull hull) {
    return release<HullObject>(hull.id, __func__);
}

firma_code firma_cast_mover(firma_world world, const firma_mover* mover, const double path[3],
                            const firma_cast_options* options, firma_hit* hit, firma_cast_counts* counts) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !path || !hit) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            TrailOptions chosen;
            if (const firma_code code = chosen.read(options, function)) return code;
            CastCounts seen;
            if (counts) chosen.cast.counts = &seen;
            const Vec3 way{path[0], path[1], path[2]};
            put_hit(there.with([&](const auto&... shape) { return cast(asked, shape..., way, chosen.cast); }), *hit);
            chosen.put();
            if (counts) add(seen, *counts);
            return FIRMA_OK;
        });
    });
}

firma_code firma_cast_mover_any(firma_world world, const firma_mover* mover, const double path[3],
                                const firma_cast_options* options, uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !path || !status) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            CastOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            const Vec3 way{path[0], path[1], path[2]};
            *status =
                std::uint32_t(there.with([&](const auto&... shape) { return cast_any(asked, shape..., way, chosen); }));
            return FIRMA_OK;
        });
    });
}

firma_code firma_cast_mover_all(firma_world world, const firma_mover* mover, const double path[3],
                                const firma_cast_options* options, firma_hit* hits, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !path || !count || (!hits && capacity)) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            CastOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            const Vec3 way{path[0], path[1], path[2]};
            std::vector<Hit> found;
            const Status status =
                there.with([&](const auto&... shape) { return cast_all(asked, shape..., way, found, chosen); });
            if (status == Status::kInvalid) return not_cast(asked, chosen.room, function);
            put_some(found, hits, capacity, count, put_hit);
            return FIRMA_OK;
        });
    });
}

firma_code firma_cast_mover_each(firma_world world, const firma_mover* mover, const double path[3],
                                 const firma_cast_options* options, firma_hit_visitor visit, void* user,
                                 uint32_t* status) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !path || !visit) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            CastOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            const auto show = [&](const Hit& hit) {
                firma_hit shown;
                put_hit(hit, shown);
                return visit(&shown, user);
            };
            const World held = asked;  // which the visitor may release, and the hull
            const Hull kept = there.hull ? *there.hull : Hull();
            const MoverThere same{there.mover, there.hull ? &kept : nullptr};
            const Vec3 way{path[0], path[1], path[2]};
            const Status met =
                same.with([&](const auto&... shape) { return cast_each(held, shape..., way, show, chosen); });
            if (status) *status = std::uint32_t(met);
            return FIRMA_OK;
        });
    });
}

firma_code firma_contact_points(firma_world world, firma_hull hull, const firma_hit* hit, double points[12],
                                uint32_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!hit || !points || !count) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const HullObject* shape = find<HullObject>(hull.id, function);
        if (!shape) return FIRMA_ERROR_BAD_HANDLE;
        PolygonHit met;
        met.status = Status(hit->status);
        met.feature = Feature(hit->feature);
        met.feature_index = hit->feature_index;
        met.fraction = hit->fraction;
        met.centre = vec(hit->centre);
        met.point = vec(hit->point);
        met.normal = vec(hit->normal);
        met.face_normal = vec(hit->face_normal);
        std::vector<Vec3> corners;
        if (hit->status != FIRMA_HIT && hit->status != FIRMA_INITIAL_OVERLAP) {
            *count = 0;
            return FIRMA_OK;
        }
        if (hit->portal != FIRMA_NO_PORTAL) {
            corners = portal_at(object->world, {hit->portal}, met.point);
            if (corners.empty()) return fail(FIRMA_ERROR_INVALID, function, "the world has no such portal");
        } else {
            const std::optional<Face> face = object->world.face(face_of(*hit));
            if (!face)
                return fail(FIRMA_ERROR_INVALID, function,
                            "the world has no such face: cut since, or of another world");
            corners = face->corners;
        }
        const ContactPoints found = contact_points(shape->hull, met, corners);
        *count = std::uint32_t(found.count);
        for (std::size_t k = 0; k < found.count; ++k) {
            points[3 * k] = found.at[k].x;
            points[3 * k + 1] = found.at[k].y;
            points[3 * k + 2] = found.at[k].z;
        }
        return FIRMA_OK;
    });
}

firma_code firma_overlap_mover(firma_world world, const firma_mover* mover, const firma_near_options* options,
                               firma_near* found, size_t capacity, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !count || (!found && capacity)) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            NearOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            std::vector<Overlap> near;
            const Status status =
                there.with([&](const auto&... shape) { return overlap(asked, shape..., near, chosen); });
            if (status == Status::kInvalid) return not_asked(asked, chosen.room, kBadSphere, function);
            put_some(near, found, capacity, count, put_overlap);
            return FIRMA_OK;
        });
    });
}

firma_code firma_overlap_mover_each(firma_world world, const firma_mover* mover, const firma_near_options* options,
                                    firma_overlap_visitor visit, void* user, uint32_t* found) {
    return guarded(__func__, [&, function = __func__] {
        if (!mover || !visit) return bad_call(function, kNull);
        return ask_of_mover(world, mover, function, [&](const World& asked, const MoverThere& there) {
            NearOptions chosen;
            if (const firma_code code = read_options(options, chosen, function)) return code;
            const auto show = [&](const Overlap& overlap) {
                firma_near shown;
                put_overlap(overlap, shown);
                return visit(&shown, user) != 0;
            };
            const World held = asked;  // which the visitor may release, and the hull
            const Hull kept = there.hull ? *there.hull : Hull();
            const MoverThere same{there.mover, there.hull ? &kept : nullptr};
            const Status met =
                same.with([&](const auto&... shape) { return overlap_each(held, shape..., show, chosen); });
            if (met == Status::kInvalid) return not_asked(held, chosen.room, kBadSphere, function);
            if (found) *found = met != Status::kMiss;
            return FIRMA_OK;
        });
    });
}
