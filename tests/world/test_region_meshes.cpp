// SPDX-License-Identifier: MIT
// Meshes by region: all triangles of a world, after any edits those made anew, with textures that show no seams.
#include "firma/region_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <span>

#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/triangles.h"
#include "scenes/divided_building.h"
#include "scenes/rng.h"
#include "tests/sample.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

using Meshes = std::map<Tile, RegionMesh>;

const World& depot() {
    static const World world =
        with_rules(make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value(), {}).value();
    return world;
}

World divided_building() {
    return assemble_world(scenes::DividedBuilding({.rooms_x = 3, .rooms_y = 3, .closed = 0.3, .seed = 5}).parts())
        .value();
}

/// Where a shot from inside the bounds meets something.
World blasted(const World& world, scenes::Rng& rng, CutterShape shape = CutterShape::kRocky) {
    const Box box = world.bounds();
    for (int tries = 0; tries < 50; ++tries) {
        Vec3 from, way;
        for (int axis = 0; axis < 3; ++axis) {
            from[axis] = rng.uniform(box.low[axis], box.high[axis]);
            way[axis] = rng.uniform(-60, 60);
        }
        const Hit hit = cast(world, Ray{from, way});
        if (!hit) continue;
        const CarveResult cut =
            carve(world, make_crater(shape, rng.below(1000)),
                  {.position = hit.point, .rotation = random_turn(rng.below(1 << 30)), .scale = rng.uniform(0.3, 1.6)});
        if (cut.status == CarveStatus::kDone) return cut.world;
    }
    return world;
}

World blasted(World world, int times, std::uint64_t seed) {
    scenes::Rng rng(seed);
    for (int k = 0; k < times; ++k) world = blasted(world, rng);
    return world;
}

std::vector<RegionMesh> meshes_of(const World& world, const RegionMeshOptions& options = {}) {
    return region_meshes(world, options).value();
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// To the bit, also of floats.
bool same(const RegionMesh& a, const RegionMesh& b) {
    return a == b && same_bytes(a.positions, b.positions) && same_bytes(a.normals, b.normals) &&
           same_bytes(a.tangents, b.tangents) && same_bytes(a.uvs, b.uvs);
}

Meshes by_place(std::vector<RegionMesh> meshes) {
    Meshes by;
    for (RegionMesh& mesh : meshes) {
        const Tile place = mesh.place;
        EXPECT_TRUE(by.emplace(place, std::move(mesh)).second);
    }
    return by;
}

void replace(Meshes& kept, std::vector<RegionMesh> changed) {
    for (RegionMesh& mesh : changed) {
        const Tile place = mesh.place;
        if (mesh.empty())
            kept.erase(place);
        else
            kept[place] = std::move(mesh);
    }
}

::testing::AssertionResult all_same(const Meshes& a, const Meshes& b) {
    if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " regions, not " << b.size();
    for (const auto& [place, mesh] : a) {
        const auto other = b.find(place);
        if (other == b.end() || !same(mesh, other->second))
            return ::testing::AssertionFailure()
                   << "region " << place[0] << " " << place[1] << " " << place[2] << " differs";
    }
    return ::testing::AssertionSuccess();
}

Vec3 corner_of(const RegionMesh& mesh, std::uint32_t vertex) {
    const auto& p = mesh.positions[vertex];
    return mesh.origin + Vec3{double(p[0]), double(p[1]), double(p[2])};
}

Vec3 lowest_of(const std::vector<Vec3>& corners) {
    Vec3 lowest = corners[0];
    for (const Vec3& c : corners)
        if (std::tuple(c.x, c.y, c.z) < std::tuple(lowest.x, lowest.y, lowest.z)) lowest = c;
    return lowest;
}

/// Runs and parts cover what there is, in order, and each says of its vertices what is so.
void expect_whole(const RegionMesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.faces.size(), mesh.corners.size());
    std::uint32_t triangles = 0, vertices = 0;
    for (const RegionMesh::Run& run : mesh.runs) {
        EXPECT_EQ(run.first_triangle, triangles);
        EXPECT_EQ(run.first_vertex, vertices);
        for (std::uint32_t t = run.first_triangle; t < run.first_triangle + run.triangle_count; ++t)
            for (const std::uint32_t corner : mesh.corners[t]) {
                EXPECT_GE(corner, run.first_vertex);
                EXPECT_LT(corner, run.first_vertex + run.vertex_count);
            }
        triangles += run.triangle_count;
        vertices += run.vertex_count;
    }
    EXPECT_EQ(triangles, mesh.corners.size());
    EXPECT_EQ(vertices, mesh.positions.size());
    for (std::size_t k = 1; k < mesh.runs.size(); ++k) {
        const auto key = [&](const RegionMesh::Run& r) {
            return std::tuple(r.material, r.cut, r.two_sided, r.uv_unit);
        };
        EXPECT_LT(key(mesh.runs[k - 1]), key(mesh.runs[k]));
    }
    triangles = vertices = 0;
    for (const RegionMesh::FacePart& part : mesh.parts) {
        EXPECT_EQ(part.first_triangle, triangles);
        EXPECT_EQ(part.first_vertex, vertices);
        EXPECT_EQ(part.triangle_count + 2, part.vertex_count);
        for (std::uint32_t t = 0; t < part.triangle_count; ++t) EXPECT_EQ(mesh.faces[triangles + t], part.face.id);
        triangles += part.triangle_count;
        vertices += part.vertex_count;
    }
    EXPECT_EQ(triangles, mesh.corners.size());
    EXPECT_EQ(vertices, mesh.positions.size());
}

void expect_all_triangles(const World& world, double size) {
    std::map<FaceId, Face> left;
    for (const Face& face : world.faces()) left[face.id] = face;
    double area = 0, faces_area = 0;
    for (const auto& [id, face] : left)
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            faces_area +=
                dot(face.normal, cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0])) / 2;
    const std::vector<RegionMesh> meshes = region_meshes(world, {.size = size}).value();
    for (std::size_t k = 1; k < meshes.size(); ++k) ASSERT_LT(meshes[k - 1].place, meshes[k].place);
    std::vector<Tile> places;
    for (const RegionMesh& mesh : meshes) {
        places.push_back(mesh.place);
        expect_whole(mesh);
        Box bounds;
        for (const RegionMesh::FacePart& part : mesh.parts) {
            const auto found = left.find(part.face.id);
            ASSERT_NE(found, left.end()) << "once each";
            const Face& face = found->second;
            EXPECT_EQ(world.face(part.face)->id, face.id);
            EXPECT_EQ(part.source, face.source);
            EXPECT_EQ(part.source_edit, face.source_edit);
            EXPECT_EQ(part.mask, face.mask);
            EXPECT_EQ(part.two_sided, face.two_sided);
            EXPECT_EQ(part.solid, face.solid);
            const Vec3 lowest = lowest_of(face.corners);
            ASSERT_EQ(part.vertex_count, face.corners.size());
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_EQ(mesh.place[std::size_t(axis)], std::floor(lowest[axis] / size));
            for (std::uint32_t k = 0; k < part.vertex_count; ++k) {
                bounds.add(face.corners[k]);
                const Vec3 off = corner_of(mesh, part.first_vertex + k) - face.corners[k];
                const double far = max_abs(face.corners[k] - mesh.origin);
                ASSERT_LE(max_abs(off), far <= 64 ? 0 : far * 0x1p-24) << "exact up to 64 m";
            }
            left.erase(found);
        }
        ASSERT_EQ(bounds, mesh.bounds);
        for (const auto& [a, b, c] : mesh.corners) {
            const Vec3 at = corner_of(mesh, a);
            const Vec3 twice = cross(corner_of(mesh, b) - at, corner_of(mesh, c) - at);
            const auto& n = mesh.normals[a];
            const double own = dot(twice, {n[0], n[1], n[2]}) / 2;
            ASSERT_GT(length(twice), 0) << "with area";
            ASSERT_TRUE(own > 0 || length(twice) < 1e-5) << "counter-clockwise; slivers are rounded";
            area += own;
        }
    }
    EXPECT_TRUE(left.empty());
    EXPECT_NEAR(area, faces_area, 1e-6 * faces_area);
    EXPECT_EQ(places, regions_of(world, size).value());
}

TEST(RegionMeshes, OfAllRegionsAreAllTriangles) {
    const World carved = blasted(divided_building(), 25, 1);
    ASSERT_GT(carved.solid().edits(), 15u);
    for (const double size : {1.0, 2.5, 8.0, 32.0, 1024.0}) expect_all_triangles(carved, size);
    const World depot_carved = blasted(depot(), 20, 2);
    for (const double size : {10.0, 32.0}) expect_all_triangles(depot_carved, size);
    EXPECT_TRUE(region_meshes(World()).value().empty());
    EXPECT_TRUE(regions_of(World(), 32).value().empty());
}

TEST(RegionMeshes, KeptThroughAHundredCratersAreThoseMadeAnew) {
    const std::array<double, 2> texels{128, 64};
    const std::vector<std::array<double, 2>> sizes(200, texels);
    for (const auto& [first, size] : {std::pair{depot(), 8.0}, {depot(), 32.0}, {divided_building(), 4.0}}) {
        const RegionMeshOptions options{.size = size, .texture_sizes = sizes};
        scenes::Rng rng(std::uint64_t(size) + 7);
        Meshes kept = by_place(region_meshes(first, options).value());
        const std::size_t regions = kept.size();
        std::vector<World> versions{first};
        std::size_t changed_most = 0, cut = 0;
        const int craters = test::sample(100);
        for (int k = 0; k < craters; ++k) {
            const World before = versions.back();
            World after = blasted(before, rng);
            if (k % 10 == 9) {  // and rock where there was air
                const CarveResult filled = fill(after, make_crater(CutterShape::kRocky, std::uint64_t(k)),
                                                {.position = after.bounds().low + Vec3{3.0 + 0.1 * k, 4, 2}});
                after = filled.world;
            }
            cut += after.solid().edits() > before.solid().edits();
            std::vector<RegionMesh> changed = changed_region_meshes(before, after, options).value();
            changed_most = std::max(changed_most, changed.size());
            std::vector<Tile> places;
            for (const RegionMesh& mesh : changed) places.push_back(mesh.place);
            ASSERT_EQ(places, changed_regions(before, after, size).value());
            replace(kept, std::move(changed));
            versions.push_back(after);
            if (k % 5 == 0) {
                ASSERT_TRUE(all_same(kept, by_place(region_meshes(after, options).value()))) << k;
            }
        }
        EXPECT_GT(cut, std::size_t(craters) * 9 / 10);
        EXPECT_TRUE(size >= 32 || changed_most < regions) << "not all each time";
        const World last = versions.back();
        ASSERT_TRUE(all_same(kept, by_place(region_meshes(last, options).value())));
        // Each by itself, however the faces are kept.
        const World rebuilt = rebuild_index(last, {.split = Split::kSurfaceArea, .faces_per_leaf = 1});
        for (const auto& [place, mesh] : kept) ASSERT_TRUE(same(mesh, region_mesh(rebuilt, place, options).value()));
        EXPECT_TRUE(changed_regions(last, rebuilt, size).value().empty());
        // Undone, many at a time.
        while (versions.size() > 1) {
            const World from = versions.back();
            versions.resize(versions.size() > 7 ? versions.size() - 7 : 1);
            replace(kept, changed_region_meshes(from, versions.back(), options).value());
            if (versions.size() % 3 == 0) {
                ASSERT_TRUE(all_same(kept, by_place(region_meshes(versions.back(), options).value())));
            }
        }
        ASSERT_TRUE(all_same(kept, by_place(region_meshes(first, options).value())));
    }
}

TEST(RegionMeshes, TangentsAreAlongTheFaceAndSayWhereTheCoordinatesGrow) {
    const World carved = blasted(depot(), 15, 3);
    std::size_t mirrored = 0, looked_at = 0;
    for (const RegionMesh& mesh : meshes_of(carved)) {
        ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
        for (const RegionMesh::FacePart& part : mesh.parts) {
            const auto& n = mesh.normals[part.first_vertex];
            const auto& t = mesh.tangents[part.first_vertex];
            const Vec3 normal{n[0], n[1], n[2]}, tangent{t[0], t[1], t[2]};
            ASSERT_NEAR(length(tangent), 1, 1e-6);
            ASSERT_NEAR(dot(tangent, normal), 0, 1e-6);
            ASSERT_TRUE(t[3] == 1 || t[3] == -1);
            ASSERT_TRUE(part.source_edit == 0 || t[3] == 1) << "of edits never mirrored";
            mirrored += t[3] < 0;
            const Vec3 up = double(t[3]) * cross(normal, tangent);
            // Along the tangent u grows and v stays; up the picture v shrinks: from the coordinates of the corners.
            const Vec3 at = corner_of(mesh, part.first_vertex);
            const auto& uv = mesh.uvs[part.first_vertex];
            for (std::uint32_t k = 2; k < part.vertex_count; ++k) {
                const std::uint32_t b = part.first_vertex + k - 1, c = part.first_vertex + k;
                const Vec3 p = corner_of(mesh, b) - at, q = corner_of(mesh, c) - at;
                const double area = dot(normal, cross(p, q));
                if (area < 0.01) continue;
                const double u1 = double(mesh.uvs[b][0]) - uv[0], v1 = double(mesh.uvs[b][1]) - uv[1],
                             u2 = double(mesh.uvs[c][0]) - uv[0], v2 = double(mesh.uvs[c][1]) - uv[1];
                // Gradients in the plane.
                const Vec3 across_q = cross(q, normal), across_p = cross(normal, p);
                const Vec3 grows_u = (u1 * across_q + u2 * across_p) * (1 / area),
                           grows_v = (v1 * across_q + v2 * across_p) * (1 / area);
                const double slack = 0.02 * (length(grows_u) + length(grows_v));
                ASSERT_GT(dot(grows_u, tangent), 0);
                ASSERT_NEAR(dot(grows_v, tangent), 0, slack);
                ASSERT_LT(dot(grows_v, up), 0);
                ++looked_at;
            }
        }
    }
    EXPECT_GT(looked_at, 1000u);
    EXPECT_GT(mirrored, 0u);
}

TEST(RegionMeshes, TextureCoordinatesAreThoseOfTheFile) {
    const World carved = blasted(depot(), 10, 4);
    const std::vector<std::array<double, 2>> sizes(4, {64, 32});
    const TriangleMesh all = triangles_of(carved, {.uvs = true, .texture_sizes = sizes});
    std::map<FaceId, const TriangleMesh::Source*> sources;
    for (const TriangleMesh::Source& source : all.sources) sources[source.face] = &source;
    std::set<TextureUnit> units;
    for (const RegionMesh& mesh : meshes_of(carved, {.texture_sizes = sizes})) {
        auto run = mesh.runs.begin();
        for (const RegionMesh::FacePart& part : mesh.parts) {
            while (part.first_triangle >= run->first_triangle + run->triangle_count) ++run;
            const TriangleMesh::Source& source = *sources.at(part.face.id);
            ASSERT_EQ(run->material, source.material);
            ASSERT_EQ(run->two_sided, source.two_sided);
            ASSERT_EQ(run->uv_unit, source.uv_unit);
            ASSERT_EQ(run->cut, source.source_edit != 0);
            ASSERT_TRUE(!run->cut || run->uv_unit == TextureUnit::kMetres);
            units.insert(run->uv_unit);
            for (std::uint32_t k = 0; k < part.vertex_count; ++k)
                ASSERT_EQ(mesh.uvs[part.first_vertex + k], all.uvs[source.first_vertex + k]);
        }
    }
    EXPECT_EQ(units.size(), 3u);
}

struct MixedCorner {
    FaceId face;
    Vec3 normal;
    std::array<std::uint8_t, 4> blend;
};

TEST(RegionMeshes, FacesOfEditsThatMeetAgreeHowPicturesAreMixed) {
    for (const auto& [world, size] :
         {std::pair{blasted(depot(), 40, 5), 4.0}, {blasted(divided_building(), 60, 6), 2.0}}) {
        // From each edge's ends, in order, to the faces that go along it so.
        using MeshEdge = std::array<std::array<double, 3>, 2>;
        std::map<MeshEdge, std::array<MixedCorner, 2>> edges;
        const auto key = [](const Vec3& v) { return std::array{v.x, v.y, v.z}; };
        std::size_t cut_faces = 0, mixed = 0;
        for (const RegionMesh& mesh : meshes_of(world, {.size = size}))
            for (const RegionMesh::FacePart& part : mesh.parts) {
                const auto& n = mesh.normals[part.first_vertex];
                for (std::uint32_t k = 0; k < part.vertex_count; ++k) {
                    const std::uint32_t a = part.first_vertex + k, b = part.first_vertex + (k + 1) % part.vertex_count;
                    const auto& blend = mesh.blends[a];
                    ASSERT_EQ(blend[0] + blend[1] + blend[2] + blend[3], 255);
                    ASSERT_EQ(blend[3], part.source_edit != 0 ? 0 : 255);
                    if (part.source_edit == 0) continue;
                    mixed += blend[0] != 255 && blend[1] != 255 && blend[2] != 255;
                    const Vec3 normal{n[0], n[1], n[2]};
                    edges[{key(corner_of(mesh, a)), key(corner_of(mesh, b))}] = {
                        MixedCorner{part.face.id, normal, blend}, MixedCorner{part.face.id, normal, mesh.blends[b]}};
                }
                cut_faces += part.source_edit != 0;
            }
        ASSERT_GT(cut_faces, 1000u);
        EXPECT_GT(mixed, cut_faces);
        std::size_t agree = 0, sharp = 0;
        for (const auto& [edge, ends] : edges) {
            const auto other = edges.find({edge[1], edge[0]});
            if (other == edges.end()) continue;  // a face of the level
            if (dot(ends[0].normal, other->second[0].normal) <= 0.2501) {
                ++sharp;
                continue;
            }
            ASSERT_EQ(ends[0].blend, other->second[1].blend);
            ASSERT_EQ(ends[1].blend, other->second[0].blend);
            ++agree;
        }
        EXPECT_GT(agree, 3000u);
        EXPECT_LT(sharp, agree / 10) << agree;
    }
}

World of_obj(const std::string& text) {
    return with_rules(make_world(read_obj(text, "test.obj").value()).value(), {}).value();
}

/// A cube of `size` metres from a corner, its faces looking outwards.
std::string cube(double x, double y, double z, double size) {
    std::string text;
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(x + (k & 1 ? size : 0)) + " " + std::to_string(y + (k & 2 ? size : 0)) + " " +
                std::to_string(z + (k & 4 ? size : 0)) + "\n";
    // Corners from the end: -8 is corner 0.
    return text + "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
}

TEST(RegionMeshes, FlatFacesOfABoxShowOnePictureEach) {
    const World rock = of_obj(cube(0, 0, 0, 16));
    const Cutter box = make_crater(CutterShape::kBox, 0);
    const World cut = carve(rock, box, {.position = {4, 8, 16}, .scale = 3}).world;
    std::size_t corners = 0;
    for (const RegionMesh& mesh : meshes_of(cut))
        for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
            if (mesh.blends[k][3] != 0) continue;
            ++corners;
            for (std::size_t axis = 0; axis < 3; ++axis)
                ASSERT_EQ(mesh.blends[k][axis], mesh.normals[k][axis] != 0 ? 255 : 0);
        }
    EXPECT_GE(corners, 20u);
}

TEST(RegionMeshes, RegionsThatGotEmptyAreToldSo) {
    const World two = of_obj(cube(1, 1, 1, 2) + cube(101, -99, 1, 2));
    EXPECT_EQ(regions_of(two, 32).value(), (std::vector<Tile>{{0, 0, 0}, {3, -4, 0}}));
    const CarveResult cut = carve(two, make_crater(CutterShape::kBox, 0), {.position = {102, -98, 2}, .scale = 3});
    ASSERT_EQ(cut.status, CarveStatus::kDone);
    const std::vector<RegionMesh> changed = changed_region_meshes(two, cut.world, {.size = 32}).value();
    ASSERT_EQ(changed.size(), 1u);
    EXPECT_EQ(changed[0].place, (Tile{3, -4, 0}));
    EXPECT_EQ(changed[0].origin, (Vec3{96, -128, 0}));
    EXPECT_TRUE(changed[0].empty());
    EXPECT_TRUE(changed[0].positions.empty() && changed[0].runs.empty() && changed[0].parts.empty());
    EXPECT_TRUE(changed[0].bounds.empty());
    const std::vector<RegionMesh> back = changed_region_meshes(cut.world, two, {.size = 32}).value();
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(back[0].corners.size(), 12u);
    EXPECT_EQ(regions_of(cut.world, 32).value(), (std::vector<Tile>{{0, 0, 0}}));
    EXPECT_TRUE(changed_region_meshes(two, two).value().empty());
}

TEST(RegionMeshes, BadOptionsAreToldAndOthersKeptTo) {
    const World world = blasted(depot(), 3, 8);
    for (const double size : {0.0, -32.0, 0.5, 32.01, 1024.5, 1e300, double(INFINITY), double(NAN)}) {
        for (const auto& result : {regions_of(world, size), changed_regions(world, world, size)}) {
            ASSERT_FALSE(result) << size;
            EXPECT_EQ(result.error().text(), "size: must be from 1 to 1024 m, in whole sixteenths of a metre");
            EXPECT_EQ(result.error().code, ErrorCode::kInvalid);
        }
        EXPECT_FALSE(region_meshes(world, {.size = size}));
        EXPECT_FALSE(changed_region_meshes(world, world, {.size = size}));
        EXPECT_FALSE(region_mesh(world, {0, 0, 0}, {.size = size}));
    }
    for (const double bad : {-1.0, double(INFINITY), double(NAN)}) {
        const std::vector<std::array<double, 2>> sizes{{64, 64}, {64, bad}};
        const auto result = region_meshes(world, {.texture_sizes = sizes});
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().text(), "texture_sizes: must be finite numbers, none below zero");
    }
    EXPECT_TRUE(region_meshes(world, {.mask = 0}).value().empty());
    for (const Tile& place : {Tile{INT32_MAX, 0, 0}, Tile{0, INT32_MIN, 0}, Tile{0, 0, 512}, Tile{-513, 0, 0}})
        EXPECT_TRUE(region_mesh(world, place).value().empty());

    const auto count = [](const std::vector<RegionMesh>& meshes) {
        std::size_t faces = 0;
        for (const RegionMesh& mesh : meshes) faces += mesh.parts.size();
        return faces;
    };
    std::size_t solid = 0, shown = 0;
    for (const Face& face : world.faces()) {
        solid += face.solid;
        shown += (face.mask & 2) != 0;
    }
    ASSERT_LT(solid, world.face_count());
    EXPECT_EQ(count(region_meshes(world, {.castable_only = false}).value()), solid);
    EXPECT_EQ(count(region_meshes(world, {.mask = 2}).value()), shown);
    const std::vector<RegionMesh> plain = region_meshes(world, {.textures = false}).value();
    EXPECT_EQ(count(plain), world.face_count());
    for (const RegionMesh& mesh : plain) EXPECT_TRUE(mesh.uvs.empty() && mesh.tangents.empty() && mesh.blends.empty());
}

TEST(RegionMeshes, AtTheRimOfTheWorld) {
    const World world = of_obj(cube(8180, 8180, -8192, 11) + cube(-8192, -8192, 8180, 11));
    for (const double size : {1.0, 10.0, 32.0, 1000.0, 1024.0}) expect_all_triangles(world, size);
}

}  // namespace
}  // namespace firma
