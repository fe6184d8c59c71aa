// SPDX-License-Identifier: MIT
#include "tests/reference/judge_chunks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firma/level.h"
#include "scenes/rng.h"
#include "solid/boundary.h"
#include "solid/solid_data.h"

namespace firma::reference {
namespace {

/// A shell: every face that edges lead to.
struct FloodedShell {
    std::vector<std::uint32_t> faces;
    double volume = 0;  // cubic metres
};

std::vector<FloodedShell> flood_all(const Boundary& boundary) {
    const SolidPatch& patch = boundary.patch;
    std::vector<FloodedShell> shells;
    std::vector<bool> seen(patch.faces.size(), false);
    for (std::uint32_t start = 0; start < patch.faces.size(); ++start) {
        if (seen[start]) continue;
        FloodedShell& shell = shells.emplace_back();
        shell.faces.push_back(start);
        seen[start] = true;
        const Vec3 apex = patch.vertices[patch.from(patch.uses(patch.faces[start])[0])].point.approximate();
        long double sixths = 0;
        for (std::size_t k = 0; k < shell.faces.size(); ++k) {
            const PatchFace& face = patch.faces[shell.faces[k]];
            const auto uses = patch.uses(face);
            std::uint32_t first = 0;
            for (const std::uint32_t end : patch.ends(face)) {
                const auto at = [&](std::uint32_t i) {
                    return patch.vertices[patch.from(uses[i])].point.approximate() - apex;
                };
                for (std::uint32_t i = first + 2; i < end; ++i)
                    sixths += static_cast<long double>(dot(at(first), cross(at(i - 1), at(i))));
                first = end;
            }
            for (const PatchUse& use : uses) {
                const std::uint32_t other = patch.edges[use.edge].face[!use.reversed];
                if (other == ~0u || seen[other]) continue;
                seen[other] = true;
                shell.faces.push_back(other);
            }
        }
        shell.volume = double(sixths / 6 / (4096.0L * 4096 * 4096));
    }
    return shells;
}

std::pair<std::uint32_t, std::uint32_t> key_of(const Boundary& boundary, std::uint32_t face) {
    const FaceRecord& record = boundary.patch.faces[face].facet.record();
    return {record.edit, record.source};
}

}  // namespace

namespace {

/// Of shells that look outward, and of which each face is one that counts.
template <class Counts>
HangingFaces faces_of_bodies(const World& world, const Counts& counts) {
    const Boundary boundary = take_boundary(world.solid().data().faces.root.get());
    HangingFaces hanging, others;
    for (const FloodedShell& shell : flood_all(boundary)) {
        const bool hangs = shell.volume > 0 && std::all_of(shell.faces.begin(), shell.faces.end(), [&](auto face) {
                               return counts(key_of(boundary, face).first);
                           });
        for (const std::uint32_t face : shell.faces) (hangs ? hanging : others).insert(key_of(boundary, face));
    }
    for (const auto& key : others) hanging.erase(key);
    return hanging;
}

}  // namespace

HangingFaces hanging_faces(const World& world) {
    return faces_of_bodies(world, [](std::uint32_t) { return true; });
}

HangingFaces put_down_faces(const World& world) {
    return faces_of_bodies(world, [&](std::uint32_t edit) { return edit == world.solid().edits(); });
}

ChunkVerdict judge_chunks(const World& before, const HangingFaces& hanging, const CarveResult& result,
                          const CarveResult& plain) {
    ChunkVerdict verdict;
    const auto fail = [&](std::string what) {
        verdict.fault = std::move(what);
        return verdict;
    };
    if (result.status != plain.status) return fail("another status");
    if (!plain.done()) return verdict;
    const Boundary boundary = take_boundary(plain.world.solid().data().faces.root.get());
    std::vector<double> volumes;
    double loose_volume = 0;
    for (const FloodedShell& shell : flood_all(boundary)) {
        const bool held = std::any_of(shell.faces.begin(), shell.faces.end(),
                                      [&](std::uint32_t face) { return hanging.count(key_of(boundary, face)) > 0; });
        if (held || !(shell.volume > 0)) continue;
        volumes.push_back(shell.volume);
        loose_volume += shell.volume;
    }
    verdict.loose = volumes.size();
    if (result.chunks.size() != volumes.size())
        return fail(std::to_string(result.chunks.size()) + " chunks for " + std::to_string(volumes.size()));
    std::vector<double> found;
    for (const Chunk& chunk : result.chunks) found.push_back(chunk.mass.volume);
    std::sort(found.begin(), found.end());
    std::sort(volumes.begin(), volumes.end());
    const double close = 1e-9 * (1 + loose_volume);
    for (std::size_t k = 0; k < found.size(); ++k)
        if (found[k] > volumes[k] + close) return fail("a chunk is larger than its piece");  // smaller by its hollows
    if (result.world.version() != before.version() + 1) return fail("more than one version");
    if (result.world.solid().edits() != plain.world.solid().edits()) return fail("another count of edits");
    if (const auto fault = check_world(result.world)) return fail(fault->what);
    if (const auto fault = check_solid(result.world)) return fail(fault->what);
    // Put back where they were, they make what is there without taking them out.
    Solid whole = result.world.solid();
    for (const Chunk& chunk : result.chunks) {
        if (const auto fault = check_solid(chunk.solid)) return fail("of a chunk: " + fault->what);
        Pose pose;
        pose.position = chunk.origin;
        const SolidResult united = unite(whole, cutter_from_solid(chunk.solid).value(), pose);
        if (!united.done()) return fail("a chunk cannot be put back: " + united.error.reason);
        whole = united.solid;
    }
    if (!same_solid(whole, plain.world.solid())) return fail("world and chunks are not what the cut left");
    return verdict;
}

namespace {

World with_box(const World& world, const Box& box) {
    const Vec3 &low = box.low, &high = box.high;
    std::vector<Vec3> vertices;
    for (int k = 0; k < 8; ++k)
        vertices.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
    const std::vector<CutterTriangle> triangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return fill(world, make_cutter(vertices, triangles).value(), {}).world;
}

/// Rock around 16 x 16 x 8 m of air.
World empty_hall() {
    Level level;
    level.materials = level.groups = {""};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const Vec3 size{16, 16, 8};
            LevelFace face;
            face.first_corner = std::uint32_t(level.corners.size());
            face.corner_count = 4;
            face.source = level.source_faces++;
            for (int k = 0; k < 4; ++k) {
                const bool at_u = k == 1 || k == 2, at_v = k >= 2;
                Vec3 p;
                p[axis] = upper ? size[axis] : 0;
                p[u] = (upper ? at_v : at_u) ? size[u] : 0;
                p[v] = (upper ? at_u : at_v) ? size[v] : 0;
                level.corners.push_back(std::uint32_t(level.vertices.size()));
                level.vertices.push_back(snap(p).value());
            }
            level.faces.push_back(face);
        }
    return make_world(level).value();
}

}  // namespace

ChunkHallVerdict judge_chunk_hall(std::uint64_t seed, int cuts) {
    scenes::Rng rng(seed);
    const auto place = [&](double low, double high) { return std::floor(rng.uniform(low, high) * 4) / 4; };
    World world = empty_hall();
    std::vector<Box> built;
    const auto put = [&](const Vec3& low, const Vec3& high) {
        built.push_back({low, high});
        world = with_box(world, built.back());
    };
    for (int k = 0; k < 5; ++k) {
        const double x = place(2, 13), y = place(2, 13);
        put({x, y, 0}, {x + 0.5, y + 0.75, 8});
    }
    for (int k = 0; k < 6; ++k) {
        const double at = place(2, 13), z = place(2, 6);
        k % 2 ? put({0, at, z}, {16, at + 1, z + 0.25}) : put({at, 0, z}, {at + 1, 16, z + 0.25});
    }
    put({4, 4, 6.5}, {12, 12, 6.75});  // it may hang free
    const HangingFaces hanging = hanging_faces(world);
    world = with_anchors(world);
    CarveOptions options;
    options.chunks = ChunkOptions{.min_volume = 0, .density = 2000};
    ChunkHallVerdict total;
    for (int k = 0; k < cuts; ++k) {
        const auto shape = CutterShape(rng.below(5));
        const Box& near = built[rng.below(std::uint32_t(built.size()))];
        Pose pose;
        for (int axis = 0; axis < 3; ++axis)
            pose.position[axis] =
                rng.chance(0.3) ? place(near.low[axis], near.high[axis]) : rng.uniform(near.low[axis], near.high[axis]);
        if (shape != CutterShape::kBox || rng.chance(0.5)) pose.rotation = random_turn(rng.next());
        pose.scale = rng.chance(0.3) ? 1 : rng.uniform(0.3, 1.5);
        const Cutter cutter = make_crater(shape, rng.next());
        const CarveResult result = carve(world, cutter, pose, options), plain = carve(world, cutter, pose);
        const ChunkVerdict verdict = judge_chunks(world, hanging, result, plain);
        total.loose += verdict.loose;
        total.done += result.done();
        if (!verdict.fault.empty()) {
            total.fault = "cut " + std::to_string(k) + ": " + verdict.fault;
            return total;
        }
        world = result.world;
    }
    return total;
}

}  // namespace firma::reference
