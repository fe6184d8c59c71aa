// SPDX-License-Identifier: MIT
// Any bytes as cutters and poses: refused or cut, and the world sound after each.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "firma/firma.h"
#include "tests/fuzz/bytes.h"

namespace {

using namespace firma;
using fuzz::Bytes;

void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// A box as six rectangles; fronts outward, or inward for a room.
std::string box(const Vec3& low, const Vec3& high, bool room) {
    std::string text;
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(k & 1 ? high.x : low.x) + " " + std::to_string(k & 2 ? high.y : low.y) + " " +
                std::to_string(k & 4 ? high.z : low.z) + "\n";
    constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& side : kSides) {
        text += "f";
        for (int k = 0; k < 4; ++k) text += " " + std::to_string(side[room ? 3 - k : k] - 8);
        text += "\n";
    }
    return text;
}

const World& world_of(int which) {
    static const std::vector<World> worlds = [] {
        const std::string texts[] = {
            box({-4, -4, -2}, {4, 4, 2}, true) + box({-1, -1, -1}, {1, 0, 1}, false),      // a pillar in a room
            box({-4, -4, -2}, {4, 4, 2}, false) + box({-1, -1, -1}, {1, 0, 1}, true),      // a cavity in a block
            box({-4, -4, -2}, {-0.0003, 4, 2}, true) + box({0, -4, -2}, {4, 4, 2}, true),  // a wall of one step
            box({-8192, -8192, -8192}, {8191.75, 8191.75, 8191.75}, true),                 // the whole world
            box({8187, 8187, 8187}, {8191.75, 8191.75, 8191.75}, false),                   // a block at the rim
        };
        std::vector<World> made;
        for (const std::string& text : texts) made.push_back(make_world(read_obj(text, "fuzz").value()).value());
        return made;
    }();
    return worlds[std::size_t(which) % worlds.size()];
}

Vec3 vector_of(Bytes& bytes) {
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) v[axis] = bytes.number();
    return v;
}

/// A crater's vertices moved, some of them onto each other.
Result<Cutter> bent(const Cutter& cutter, Bytes& bytes) {
    std::vector<Vec3> vertices(cutter.vertices().begin(), cutter.vertices().end());
    for (int moves = bytes.next() % 16; moves > 0; --moves) {
        Vec3& v = vertices[std::size_t(bytes.next()) % vertices.size()];
        if (bytes.next() % 4 == 0)
            v = vertices[std::size_t(bytes.next()) % vertices.size()];
        else
            v = v + vector_of(bytes);
    }
    return make_cutter(vertices, cutter.triangles(), "bent");
}

/// Craters in one mesh: within each other, crossing, apart, turned over.
Result<Cutter> several(const Cutter& cutter, Bytes& bytes) {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
    const int count = 1 + bytes.next() % (bytes.next() == 0 ? 200 : 4);
    for (int k = 0; k < count; ++k) {
        const auto first = std::uint32_t(vertices.size());
        const Vec3 move = vector_of(bytes);
        const double scale = bytes.number();
        const bool turned = bytes.next() % 2;
        for (const Vec3& v : cutter.vertices()) vertices.push_back(v * scale + move);
        for (const auto& [a, b, c] : cutter.triangles())
            triangles.push_back({a + first, (turned ? c : b) + first, (turned ? b : c) + first});
    }
    return make_cutter(vertices, triangles, "several");
}

/// Any triangles among any vertices, each both ways round when `closed`.
Result<Cutter> any_mesh(Bytes& bytes) {
    std::vector<Vec3> vertices(std::size_t(3 + bytes.next() % 20));
    for (Vec3& v : vertices) v = vector_of(bytes);
    std::vector<CutterTriangle> triangles;
    const bool closed = bytes.next() % 2;
    for (int left = 1 + bytes.next() % 40; left > 0; --left) {
        CutterTriangle triangle;
        for (std::uint32_t& corner : triangle)
            corner = std::uint32_t(std::size_t(bytes.next()) % (vertices.size() + 1));
        triangles.push_back(triangle);
        if (closed) triangles.push_back({triangle[0], triangle[2], triangle[1]});
    }
    return make_cutter(vertices, triangles, "any");
}

/// What is solid now, or what has been taken from it; none of either where rock reaches to infinity.
Result<Cutter> solid_of(const World& first, const World& now, Bytes& bytes) {
    const Result<Cutter> rest = cutter_from_solid(now.solid(), "rest");
    if (!rest || bytes.next() % 2) return rest;
    const SolidResult taken = subtract(first.solid(), rest.value(), {});
    expect(taken.reproduction.empty(), "cuts contradict each other");
    if (taken.status == CarveStatus::kRefused) return taken.error;
    return cutter_from_solid(taken.solid, "taken");
}

Result<Cutter> cutter_of(const World& first, const World& now, Bytes& bytes) {
    const int kind = bytes.next() % 9;
    if (kind == 8) return solid_of(first, now, bytes);
    const Cutter crater = make_crater(CutterShape(bytes.next() % 5), std::uint64_t(bytes.next()));
    if (kind == 0) return any_mesh(bytes);
    if (kind <= 2) return several(crater, bytes);
    if (kind <= 5) return bent(crater, bytes);
    return crater;
}

Pose pose_of(Bytes& bytes, const World& world) {
    Pose pose;
    const Box bounds = world.bounds();
    const int at = bytes.next();  // a corner of the world, its middle, or the origin
    for (int axis = 0; axis < 3; ++axis)
        pose.position[axis] = at % 4 == 0            ? 0
                              : at % 4 == 1          ? (bounds.low[axis] + bounds.high[axis]) / 2
                              : at >> (axis + 2) & 1 ? bounds.low[axis]
                                                     : bounds.high[axis];
    if (bytes.next() % 4) pose.position = pose.position + vector_of(bytes);
    if (bytes.next() % 2)
        for (double& part : pose.rotation) part = bytes.number();
    if (bytes.next() % 2) pose.scale = bytes.number();
    if (bytes.next() % 4 == 0) {  // by quarter turns about the axes
        for (double& part : pose.rotation) part = bytes.next() % 3 - 1;
        pose.scale = 1;
    }
    return pose;
}

/// Every directed edge of the solid is used as often the other way.
bool closed(const World& world) {
    using Corner = std::array<double, 3>;
    std::map<std::pair<Corner, Corner>, int> uses;
    for (const Face& face : world.faces()) {
        if (!face.solid) continue;
        for (std::size_t k = 0; k < face.corners.size(); ++k) {
            const Vec3 &p = face.corners[k], &q = face.corners[k + 1 < face.corners.size() ? k + 1 : 0];
            const Corner a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
            a < b ? ++uses[{a, b}] : --uses[{b, a}];
        }
    }
    for (const auto& [edge, sum] : uses)
        if (sum != 0) return false;
    return true;
}

void judge(const World& before, const CarveResult& result) {
    expect(result.reproduction.empty(), "cuts contradict each other");
    if (!result.done()) return expect(&result.world.data() == &before.data(), "not done, and yet another world");
    const std::optional<WorldFault> fault = check_world(result.world);
    expect(!fault, fault ? fault->what.c_str() : "");
    expect(closed(result.world), "an open edge");
    expect(result.world.face_count() + result.report.faces_removed == before.face_count() + result.report.faces_added,
           "the count of faces");
    expect(result.report.volume == result.report.volume, "the volume is no number");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const World first = world_of(bytes.next());
    World world = first;
    for (int cuts = 0; cuts < 6 && !bytes.empty(); ++cuts) {
        const Result<Cutter> cutter = cutter_of(first, world, bytes);
        if (!cutter) continue;
        const Pose pose = pose_of(bytes, world);
        const int how = bytes.next();
        const CarveKind kind = how % 3 == 0 ? CarveKind::kFill : CarveKind::kCarve;
        CarveOptions options;
        if (how & 16) options.material = std::to_string(how & 32);
        CarveResult result = kind == CarveKind::kFill ? fill(world, cutter.value(), pose, options)
                                                      : carve(world, cutter.value(), pose, options);
        judge(world, result);
        if (how >= 192) {
            CarveJob job(world, cutter.value(), pose, options, kind);
            while (!job.run(0)) {
            }
            expect(hash_world(job.result().world) == hash_world(result.world), "in slices it ends otherwise");
        }
        world = result.world;
        if (world.face_count() > 20000) break;
    }
    return 0;
}
