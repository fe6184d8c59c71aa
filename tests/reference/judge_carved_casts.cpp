// SPDX-License-Identifier: MIT
// Casts through a carved world.
#include "tests/reference/judge_carved_casts.h"
#include "firma/queries.h"
#include "world/block_faces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/polygon_shape.h"
#include "tests/reference/facet_corners.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

using scenes::Rng;

void corners_of(const FacetPlace& place, std::vector<Vec3>& corners) {
    corners.clear();
    for (const GridPoint& corner : grid_corners_of(place)) corners.push_back(to_metres(corner));
}

std::vector<Vec3> corners_of(const FacetPlace& place) {
    std::vector<Vec3> corners;
    corners_of(place, corners);
    return corners;
}

Vec3 point_of(const std::vector<Vec3>& corners, Rng& rng) {
    const std::size_t k = rng.below(std::uint32_t(corners.size())), n = corners.size();
    const double which = rng.uniform(), u = rng.uniform(), v = rng.uniform();
    if (which < 0.4) return corners[k];
    const Vec3 on_edge = corners[k] + (corners[(k + 1) % n] - corners[k]) * (rng.chance(0.3) ? 0.5 : u);
    return which < 0.8 ? on_edge : on_edge + (corners[(k + 2) % n] - on_edge) * v;
}

/// What the oracle knows of a face is its own plane; a World says that of the exact face it was cut from.
PolygonHit with_own_normal(const Hit& hit, const std::vector<Vec3>& polygon) {
    PolygonHit own = hit;
    const PolygonShape shape = make_shape({polygon.data(), polygon.size()});
    own.face_normal = shape.normal * (1 / length(shape.normal));
    return own;
}

/// Whether a ray from the air, so long that it must meet something, gets out or into the rock. The first face met must
/// be met from its front: one met from behind is the far side of rock that the ray got into through a crack. Front or
/// back is what the facet's own plane says; casts go by no other.
bool is_lost(const World& world, const Vec3& start, const Vec3& path, RayTally& tally) {
    const Hit first = cast(world, {start, 0}, path, {.sides = Sides::kBoth});
    if (!first.touched()) return true;
    const std::optional<firma::Face> face = world.face(first.face);
    if (!face) return true;
    const PolygonShape shape = make_shape(face->corners);
    const double distance = length(path);
    const double facing = dot(path, shape.normal) / (distance * shape.normal_length);
    if (facing <= 1e-6) return false;
    // At an edge where the surface turns away both faces are met at once, up to rounding; and where a sliver was folded
    // by the rounding of its corners (3.3 um each), its back stands before its front by as much, measured across it.
    ++tally.at_edges;
    const Hit front = cast(world, {start, 0}, path);
    return !front.touched() || (front.fraction - first.fraction) * distance * facing > 1e-5;
}

}  // namespace

Tally judge_casts_at(const World& world, Rng& rng, int casts, double size) {
    const std::vector<FacetPlace> facets = all_facets(world);
    const std::vector<Vec3> aimed = corners_of(facets[rng.below(std::uint32_t(facets.size()))]);
    const Vec3 middle = point_of(aimed, rng);
    Box box;
    for (const double sign : {-0.5, 0.5}) box.add(middle + Vec3{size, size, size} * sign);

    std::vector<std::vector<Vec3>> polygons;
    std::map<FaceId, std::uint32_t> index;
    std::vector<bool> two_sided;
    for (const FacetPlace& place : facets) {
        const std::vector<Vec3> corners = corners_of(place);
        Box own;
        for (const Vec3& corner : corners) own.add(corner);
        bool meets = true;
        for (int axis = 0; axis < 3; ++axis)
            meets = meets && own.low[axis] <= box.high[axis] && own.high[axis] >= box.low[axis];
        if (!meets) continue;
        index[place.record().id] = std::uint32_t(polygons.size());
        polygons.push_back(corners);
        two_sided.push_back(place.record().two_sided);
    }
    const ExactOracle oracle(polygons, two_sided);

    Tally tally;
    for (int k = 0; k < casts; ++k) {
        Cast asked;
        asked.sphere.radius = rng.chance(0.4) ? 0 : size * 0.2 * rng.uniform() * rng.uniform();
        const double room = size / 2 - asked.sphere.radius * 1.01 - 1e-6;
        Vec3 end;
        for (int axis = 0; axis < 3; ++axis) {
            asked.sphere.centre[axis] = middle[axis] + room * rng.uniform(-1, 1);
            end[axis] = middle[axis] + room * rng.uniform(-1, 1);
        }
        if (rng.chance(0.5)) {  // at a feature
            const Vec3 target = point_of(polygons[rng.below(std::uint32_t(polygons.size()))], rng);
            bool within = true;
            for (int axis = 0; axis < 3; ++axis) within = within && std::fabs(target[axis] - middle[axis]) < room;
            if (within) end = target;
        }
        asked.path = end - asked.sphere.centre;
        asked.sides = rng.chance(0.7) ? Sides::kFront : Sides::kBoth;
        const Hit hit = cast(world, asked.sphere, asked.path, {.sides = asked.sides});
        Answer answer{hit, 0, NAN, world.tolerance().contact_offset, false};
        if (hit.touched()) {
            const auto found = index.find(hit.face.id);
            if (found == index.end()) {
                tally.add({Fault::kFalse, false, "a face that is nowhere near"}, true, describe(oracle, asked, {}));
                continue;
            }
            answer.face = found->second;
            answer.safe_fraction = hit.safe_fraction;
            answer.hit = with_own_normal(hit, polygons[answer.face]);
        }
        const Verdict verdict = judge(oracle, asked, answer);
        std::vector<std::uint32_t> faces;
        if (!verdict.ok() && tally.wants_more()) {
            faces = oracle.expect(asked).faces;
            if (hit.touched()) faces.push_back(answer.face);
        }
        tally.add(verdict, hit.touched(), verdict.ok() ? "" : describe(oracle, asked, faces));
    }
    return tally;
}

void shoot_from_air(const World& world, Rng& rng, std::uint64_t rays, RayTally& tally) {
    const std::vector<FacetPlace> facets = all_facets(world);
    const Box bounds = world.bounds();
    const double far = 2 * length(bounds.high - bounds.low);
    std::uint64_t shot = 0;
    while (shot < rays) {
        // A start in the air before a face, and a hundred faces around it to aim at.
        const std::uint32_t first = rng.below(std::uint32_t(facets.size()));
        const Vec3 normal = world.face_info(ref_to(*facets[first].block, facets[first].slot))->normal;
        const Vec3 on = point_of(corners_of(facets[first]), rng);
        const double away = rng.uniform();
        const Vec3 start = on + normal * std::ldexp(away, -int(rng.below(8)));
        if (closest(world, start, 1e-4) || locate(world.solid(), start) != Where::kAir) continue;
        std::vector<Overlap> near;
        overlap(world, {start, 3}, near);
        for (int k = 0; k < 200 && shot < rays; ++k) {
            Vec3 target = point_of(corners_of(facets[rng.below(std::uint32_t(facets.size()))]), rng);
            if (!near.empty() && rng.chance(0.8)) {
                const NearFace& aim = near[rng.below(std::uint32_t(near.size()))];
                target = point_of(world.face(aim.face)->corners, rng);
            }
            const Vec3 way = target - start;
            if (!(length(way) > 1e-9)) continue;
            const Vec3 path = way * std::exp2(std::ceil(std::log2(far / length(way))));
            ++shot;
            ++tally.rays;
            if (!is_lost(world, start, path, tally)) continue;
            ++tally.lost;
            if (!tally.first_failure.empty()) continue;
            char text[300];
            std::snprintf(text, sizeof text, "lost from {%.17g, %.17g, %.17g} by {%.17g, %.17g, %.17g}", start.x,
                          start.y, start.z, path.x, path.y, path.z);
            tally.first_failure = text;
        }
    }
}

World carved_world(const scenes::CutFamily& family, std::uint64_t seed, std::uint64_t cuts, const Level& ours) {
    World world;
    std::uint64_t done = 0;
    for (std::uint64_t index = 0; done < cuts && index < cuts; ++index) {
        const scenes::CutCase it = scenes::make_cut_case(family, seed, index, ours);
        if (index == 0) world = make_world(it.level).value();
        for (const scenes::CutOrder& order : it.cuts) {
            if (done == cuts) break;
            const CarveResult result = make_cut(world, order);
            done += result.done();
            world = result.world;
        }
    }
    return world;
}

}  // namespace firma::reference
