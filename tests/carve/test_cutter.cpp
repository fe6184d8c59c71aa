// SPDX-License-Identifier: MIT
// Cutters: the shapes made from a seed, meshes and files taken or refused, and random turns.
#include "firma/cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "carve/cutter_data.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using test::box_mesh;
using test::mesh_of;
using test::TriangleMesh;

constexpr CutterShape kAllShapes[] = {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill,
                                      CutterShape::kWedge, CutterShape::kBox};
constexpr double kEndless = std::numeric_limits<double>::infinity();

double volume(const Cutter& cutter) {
    double sum = 0;
    for (const auto& [a, b, c] : cutter.triangles())
        sum += dot(cutter.vertices()[a], cross(cutter.vertices()[b], cutter.vertices()[c])) / 6;
    return sum;
}

void expect_refused(const TriangleMesh& mesh, ErrorCode code, const std::string& words) {
    const Result<Cutter> cutter = mesh.cutter();
    ASSERT_FALSE(cutter.ok()) << words;
    EXPECT_EQ(int(cutter.error().code), int(code)) << cutter.error().text();
    EXPECT_NE(cutter.error().text().find(words), std::string::npos) << cutter.error().text();
    EXPECT_EQ(cutter.error().place.rfind("mesh", 0), 0u) << cutter.error().text();
}

TEST(Crater, ShapesHaveNames) {
    for (const CutterShape shape : kAllShapes) EXPECT_EQ(cutter_shape(cutter_shape_name(shape)), shape);
    EXPECT_EQ(cutter_shape("drill"), CutterShape::kDrill);
    EXPECT_FALSE(cutter_shape("Rocky"));
    EXPECT_FALSE(cutter_shape(""));
}

TEST(Crater, HasItsTriangles) {
    const auto count = [](CutterShape shape) { return make_crater(shape, 1).triangles().size(); };
    EXPECT_EQ(count(CutterShape::kRocky), 180u);
    EXPECT_EQ(make_crater(CutterShape::kRocky, 1).vertices().size(), 92u);
    EXPECT_EQ(count(CutterShape::kSpiky), 180u);
    EXPECT_EQ(count(CutterShape::kDrill), 64u);
    EXPECT_EQ(count(CutterShape::kWedge), 8u);
    EXPECT_EQ(count(CutterShape::kBox), 12u);
}

TEST(Crater, IsSeenWholeFromTheOriginWhateverTheSeed) {
    scenes::Rng rng(1);
    for (const CutterShape shape : kAllShapes)
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const Cutter cutter = make_crater(shape, seed);
            const auto at = [&](std::uint32_t v) { return cutter.vertices()[v]; };
            double smallest = kEndless;
            int covering = 0;
            const Vec3 direction = rng.direction();
            for (const auto& [a, b, c] : cutter.triangles()) {
                smallest = std::min(smallest, dot(at(a), cross(at(b), at(c))));
                covering += dot(direction, cross(at(a), at(b))) > 0 && dot(direction, cross(at(b), at(c))) > 0 &&
                            dot(direction, cross(at(c), at(a))) > 0;
            }
            EXPECT_GT(smallest, 0.01) << cutter.name() << seed;
            EXPECT_EQ(covering, 1) << cutter.name() << seed;
        }
}

TEST(Crater, KeepsItsRadii) {
    double rocky_low = 9, rocky_high = 0, spiky_low = 9, spiky_high = 0, sum = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Cutter rocky = make_crater(CutterShape::kRocky, seed);
        for (const Vec3& v : rocky.vertices()) {
            rocky_low = std::min(rocky_low, length(v));
            rocky_high = std::max(rocky_high, length(v));
            sum += length(v);
        }
        const Cutter spiky = make_crater(CutterShape::kSpiky, seed);
        for (const Vec3& v : spiky.vertices()) {
            spiky_low = std::min(spiky_low, length(v));
            spiky_high = std::max(spiky_high, length(v));
        }
    }
    EXPECT_NEAR(rocky_low, 0.78, 0.005);
    EXPECT_NEAR(rocky_high, 1.2, 0.005);
    EXPECT_NEAR(sum / (50 * 92), 0.99, 0.01);
    EXPECT_NEAR(spiky_low, 0.55, 0.005);
    EXPECT_NEAR(spiky_high, 2, 0.01);
}

TEST(Crater, DependsOnTheSeedAlone) {
    for (const CutterShape shape : kAllShapes) {
        const TriangleMesh first = mesh_of(make_crater(shape, 5)), again = mesh_of(make_crater(shape, 5));
        EXPECT_EQ(first.vertices, again.vertices);
        EXPECT_EQ(first.vertices == mesh_of(make_crater(shape, 6)).vertices, shape == CutterShape::kBox);
    }
}

TEST(MakeCutter, TakesABoxAndFindsItsEdges) {
    const Result<Cutter> cutter = box_mesh({0, 0, 0}, {1, 2, 3}).cutter();
    ASSERT_TRUE(cutter.ok());
    EXPECT_DOUBLE_EQ(volume(cutter.value()), 6);
    EXPECT_EQ(cutter.value().name(), "mesh");
    EXPECT_EQ(cutter.value().data()->topology.edges.size(), 18u);
}

/// Every edge is where its triangles say it is.
void expect_true_edges(const CutterData& data) {
    ASSERT_EQ(data.topology.edges.size() * 2, data.triangles.size() * 3);
    ASSERT_EQ(data.topology.triangle_edges.size(), data.triangles.size());
    std::vector<int> uses(data.topology.edges.size());
    for (std::uint32_t t = 0; t < data.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = data.triangles[t][k], to = data.triangles[t][(k + 1) % 3];
            const std::uint32_t id = data.topology.triangle_edges[t][k];
            const CutterEdge& edge = data.topology.edges[id];
            ++uses[id];
            if (edge.left == t)
                EXPECT_TRUE(edge.a == from && edge.b == to);
            else
                EXPECT_TRUE(edge.right == t && edge.b == from && edge.a == to);
            EXPECT_LT(edge.a, edge.b);
        }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 2), std::ptrdiff_t(uses.size()));
    for (std::size_t k = 1; k < data.topology.edges.size(); ++k) {
        const CutterEdge &one = data.topology.edges[k - 1], &next = data.topology.edges[k];
        EXPECT_LT(std::pair(one.a, one.b), std::pair(next.a, next.b));
    }
}

TEST(MakeCutter, EdgesLieBetweenTheirTriangles) {
    for (const CutterShape shape : kAllShapes) expect_true_edges(*make_crater(shape, 3).data());
    expect_true_edges(*test::ring_mesh(12, 7).cutter().value().data());
}

TEST(MakeCutter, TurnsOverAnInsideOutMesh) {
    TriangleMesh mesh = mesh_of(make_crater(CutterShape::kRocky, 1));
    mesh.turn_over();
    const Result<Cutter> cutter = mesh.cutter();
    ASSERT_TRUE(cutter.ok());
    EXPECT_GT(volume(cutter.value()), 1);
    expect_true_edges(*cutter.value().data());
}

TEST(MakeCutter, LeavesOutVerticesThatNothingUses) {
    TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
    mesh.vertices.insert(mesh.vertices.begin() + 2, Vec3{kEndless, 0, 0});
    for (CutterTriangle& corners : mesh.triangles)
        for (std::uint32_t& corner : corners) corner += corner >= 2;
    const Result<Cutter> cutter = mesh.cutter();
    ASSERT_TRUE(cutter.ok());
    EXPECT_EQ(mesh_of(cutter.value()).vertices, box_mesh({0, 0, 0}, {1, 1, 1}).vertices);
    expect_true_edges(*cutter.value().data());
    // Messages still count as the caller does.
    mesh.triangles.pop_back();
    expect_refused(mesh, ErrorCode::kMalformed, "the edge between vertices 1 and 6");
}

TEST(MakeCutter, RefusesWhatIsNotClosed) {
    const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
    TriangleMesh mesh = box;
    mesh.triangles.pop_back();
    expect_refused(mesh, ErrorCode::kMalformed, "the mesh is open");
    mesh = box;
    mesh.triangles.push_back(mesh.triangles[3]);
    expect_refused(mesh, ErrorCode::kMalformed, "belongs to 3 triangles");
    mesh = box;
    std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
    expect_refused(mesh, ErrorCode::kMalformed, "wound against each other");
    mesh = box;
    mesh.triangles[7][1] = mesh.triangles[7][0];
    expect_refused(mesh, ErrorCode::kMalformed, "triangle 7: names a vertex twice");
    mesh = box;
    mesh.triangles[7][1] = 8;
    expect_refused(mesh, ErrorCode::kMalformed, "triangle 7: names vertex 8 of 8");
    mesh.triangles[7][1] = ~0u;
    expect_refused(mesh, ErrorCode::kMalformed, "names vertex 4294967295");
    mesh.triangles.resize(3);
    expect_refused(mesh, ErrorCode::kMalformed, "at least 4 triangles");
    expect_refused({}, ErrorCode::kMalformed, "at least 4 triangles");
}

TEST(MakeCutter, RefusesNumbersThatAreNone) {
    for (const double bad : {double(NAN), kEndless, -kEndless, 1e200}) {
        TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1});
        mesh.vertices[6].y = bad;
        expect_refused(mesh, ErrorCode::kOutOfRange, "vertex 6: ");
    }
}

TEST(MakeCutter, RefusesWhatEnclosesNothing) {
    expect_refused(box_mesh({0, 0, 0}, {1, 1, 0}), ErrorCode::kMalformed, "no volume");
    expect_refused(box_mesh({3, 3, 3}, {3, 3, 3}), ErrorCode::kMalformed, "no volume");
    expect_refused(box_mesh({0, 0, 0}, {5e-324, 5e-324, 5e-324}), ErrorCode::kMalformed, "no volume");
    TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 1, 1}), inside_out = box_mesh({2, 0, 0}, {3, 1, 1});
    inside_out.turn_over();
    mesh.add(inside_out);
    expect_refused(mesh, ErrorCode::kMalformed, "no volume");
    EXPECT_TRUE(box_mesh({0, 0, 0}, {1e-60, 1e-60, 1e-60}).cutter().ok());
    EXPECT_TRUE(box_mesh({-1e4, -1e4, 0}, {1e4, 1e4, 1e-4}).cutter().ok());
}

TEST(MakeCutter, SpoiledMeshesAreRefusedOrSound) {
    scenes::Rng rng(5);
    int refused = 0, taken = 0;
    for (int k = 0; k < 3000; ++k) {
        TriangleMesh mesh = rng.chance(0.5) ? mesh_of(make_crater(CutterShape::kWedge, 1))
                                            : mesh_of(make_crater(CutterShape::kRocky, 1));
        const auto count = std::uint32_t(mesh.triangles.size());
        for (std::uint32_t times = rng.below(3) + 1; times > 0; --times) {
            const std::uint32_t t = rng.below(count), u = rng.below(count), corner = rng.below(3);
            const double bad[] = {0, NAN, 1e300, -5e-324, kEndless, 3, -1e199};
            switch (rng.below(5)) {
                case 0:
                    mesh.triangles[t][corner] = rng.below(std::uint32_t(mesh.vertices.size()) + 2);
                    break;
                case 1:
                    std::swap(mesh.triangles[t], mesh.triangles[u]);
                    break;
                case 2:
                    mesh.triangles[t] = mesh.triangles[u];
                    break;
                case 3:
                    std::swap(mesh.triangles[t][0], mesh.triangles[t][corner]);
                    break;
                default:
                    mesh.vertices[t % mesh.vertices.size()][int(corner)] = bad[rng.below(7)];
            }
        }
        const Result<Cutter> cutter = mesh.cutter();
        (cutter.ok() ? taken : refused) += 1;
        if (!cutter.ok()) continue;
        expect_true_edges(*cutter.value().data());
        for (const Vec3& v : cutter.value().vertices()) EXPECT_TRUE(is_finite(v));
    }
    EXPECT_GT(refused, 500);
    EXPECT_GT(taken, 500);
}

TEST(MakeCutter, RefusesTooManyTrianglesBeforeLookingAtThem) {
    const std::vector<CutterTriangle> triangles(kMaxCutterTriangles + 1);
    const Result<Cutter> cutter = make_cutter({}, triangles, "");
    ASSERT_FALSE(cutter.ok());
    EXPECT_EQ(int(cutter.error().code), int(ErrorCode::kTooLarge));
    EXPECT_EQ(cutter.error().text(), "4000001 triangles; a cutter has at most 4000000");
}

TEST(EmptyCutter, HoldsNothing) {
    const Cutter none;
    EXPECT_FALSE(none.valid());
    EXPECT_TRUE(none.vertices().empty());
    EXPECT_TRUE(none.triangles().empty());
    EXPECT_EQ(none.name(), "");
}

Result<Cutter> from_obj(const std::string& text) {
    const Result<Level> level = read_obj(text, "cutter.obj");
    EXPECT_TRUE(level.ok()) << level.error().text();
    return cutter_from_level(level.value());
}

const char* const kCubeVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";

TEST(CutterFromLevel, ReadsACubeOfQuads) {
    const Result<Cutter> cutter =
        from_obj(std::string(kCubeVertices) + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    ASSERT_TRUE(cutter.ok()) << cutter.error().text();
    EXPECT_EQ(cutter.value().triangles().size(), 12u);
    EXPECT_DOUBLE_EQ(volume(cutter.value()), 1);
    EXPECT_EQ(cutter.value().name(), "cutter.obj");
}

TEST(CutterFromLevel, WeldsByPosition) {
    std::string text;
    int next = 1;
    const TriangleMesh box = box_mesh({0, 0, 0}, {1, 1, 1});
    for (const CutterTriangle& corners : box.triangles) {
        for (const std::uint32_t corner : corners) {
            const Vec3& v = box.vertices[corner];
            text += "v " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
        }
        text += "f " + std::to_string(next) + " " + std::to_string(next + 1) + " " + std::to_string(next + 2) + "\n";
        next += 3;
    }
    const Result<Cutter> cutter = from_obj(text);
    ASSERT_TRUE(cutter.ok()) << cutter.error().text();
    EXPECT_EQ(cutter.value().vertices().size(), 8u);
}

TEST(CutterFromLevel, DividesFacesWithCornersAlongTheirSides) {
    // The top's sides have corners along them, one or two each, beginning at every corner in turn; triangles below.
    const std::string vertices = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 -4\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 1 0\nv 0 3 0\n";
    const std::vector<int> top = {1, 5, 6, 2, 7, 3, 9, 8};
    for (std::size_t start = 0; start < top.size(); ++start) {
        std::string text = vertices + "f";
        for (std::size_t k = 0; k < top.size(); ++k) text += " " + std::to_string(top[(start + k) % top.size()]);
        text += "\nf 4 5 1\nf 4 6 5\nf 4 2 6\nf 4 7 2\nf 4 3 7\nf 4 9 3\nf 4 8 9\nf 4 1 8\n";
        const Result<Cutter> cutter = from_obj(text);
        ASSERT_TRUE(cutter.ok()) << cutter.error().text();
        EXPECT_EQ(cutter.value().triangles().size(), 14u);
        EXPECT_DOUBLE_EQ(volume(cutter.value()), 32.0 / 3);
        for (const auto& [a, b, c] : cutter.value().triangles()) {
            const auto v = cutter.value().vertices();
            EXPECT_GT(length(cross(v[b] - v[a], v[c] - v[a])), 0.1);
        }
    }
}

TEST(CutterFromLevel, RefusesWhatIsOpen) {
    const Result<Cutter> open = from_obj(std::string(kCubeVertices) + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\n");
    ASSERT_FALSE(open.ok());
    EXPECT_NE(open.error().text().find("the mesh is open"), std::string::npos) << open.error().text();
    EXPECT_EQ(open.error().place.rfind("cutter.obj: triangle ", 0), 0u);
}

TEST(CutterFromLevel, RefusesLevelsMadeByHandThatNameWhatIsNotThere) {
    Level level;
    level.name = "hand";
    EXPECT_FALSE(cutter_from_level(level).ok());
    level.vertices = {{0, 0, 0}, {64, 0, 0}, {0, 64, 0}};
    level.corners = {0, 1, 2};
    level.faces.resize(1);
    for (const auto& [first, count] : {std::pair(0u, 4u), {1u, 3u}, {~0u, 3u}, {0u, ~0u}, {0u, 2u}}) {
        level.faces[0].first_corner = first;
        level.faces[0].corner_count = count;
        const Result<Cutter> cutter = cutter_from_level(level);
        ASSERT_FALSE(cutter.ok());
        EXPECT_EQ(cutter.error().place, "hand: face 0");
    }
    level.faces[0].first_corner = 0;
    level.faces[0].corner_count = 3;
    level.corners[2] = 3;
    EXPECT_NE(cutter_from_level(level).error().text().find("names a vertex"), std::string::npos);
    level.corners[2] = 1;
    EXPECT_NE(cutter_from_level(level).error().text().find("has no area"), std::string::npos);
}

TEST(RandomTurn, IsEvenAndOfLengthOne) {
    double sum[4] = {}, squares[4] = {};
    constexpr int kCount = 20'000;
    for (std::uint64_t seed = 0; seed < kCount; ++seed) {
        const Quaternion q = random_turn(seed);
        double square = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            sum[k] += q[k];
            squares[k] += q[k] * q[k];
            square += q[k] * q[k];
        }
        EXPECT_NEAR(square, 1, 1e-15);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(sum[k] / kCount, 0, 0.015);
        EXPECT_NEAR(squares[k] / kCount, 0.25, 0.01);
    }
    EXPECT_EQ(random_turn(7), random_turn(7));
    EXPECT_NE(random_turn(7), random_turn(8));
}

}  // namespace
}  // namespace firma
