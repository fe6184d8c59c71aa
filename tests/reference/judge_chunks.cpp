// SPDX-License-Identifier: MIT
#include "tests/reference/judge_chunks.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

HangingFaces hanging_faces(const World& world) {
    const Boundary boundary = take_boundary(world.solid().data().faces.root.get());
    HangingFaces hanging, others;
    for (const FloodedShell& shell : flood_all(boundary))
        for (const std::uint32_t face : shell.faces)
            (shell.volume > 0 ? hanging : others).insert(key_of(boundary, face));
    for (const auto& key : others) hanging.erase(key);
    return hanging;
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

}  // namespace firma::reference
