// SPDX-License-Identifier: MIT
// Closed meshes wound into the air.
#include "scenes/closed_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace firma::scenes {

namespace {

Steps random_place(Rng& rng) {
    if (rng.chance(0.5)) return {};
    const auto far = [&] {
        const std::int64_t side = rng.chance(0.5) ? kMetre : -kMetre;
        return side * (8150 - std::int64_t(rng.below(4000)));
    };
    return {far(), far(), far()};
}

void add_box(ClosedMesh& mesh, const Steps& o, const Steps& u, const Steps& v, const Steps& w, bool triangles) {
    const auto quad = [&](const Steps& at, const Steps& s, const Steps& t) {  // front against s x t
        const GridPoint a = in_world(at), b = in_world(at + s), c = in_world(at + s + t), d = in_world(at + t);
        if (triangles) {
            mesh.faces.push_back({a, c, b});
            mesh.faces.push_back({a, d, c});
        } else {
            mesh.faces.push_back({a, d, c, b});
        }
    };
    quad(o + w, u, v);
    quad(o, v, u);
    quad(o + u, v, w);
    quad(o, w, v);
    quad(o + v, w, u);
    quad(o, u, w);
    mesh.inside = {(firma::to_metres(in_world(o)) + firma::to_metres(in_world(o + u + v + w))) * 0.5};
}

void box(ClosedMesh& mesh, Rng& rng, bool triangles) {
    const auto side = [&] { return kInput * (2048 + std::int64_t(rng.below(20480))); };
    const Steps size{side(), side(), side()}, o = random_place(rng) - Steps{size.x / 2, size.y / 2, size.z / 2};
    add_box(mesh, o, {size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}, triangles);
    mesh.free_radius = double(std::min({size.x, size.y, size.z})) / kSurfaceSteps * 0.4;
}

void turned_box(ClosedMesh& mesh, Rng& rng) {
    const WholeFrame frame = random_frame(rng, 4);
    const std::int64_t unit = 2 * kMetre / frame.length;
    const auto side = [&] { return unit + std::int64_t(rng.below(std::uint32_t(unit))); };
    const Steps place = random_place(rng);
    const Steps size{side(), side(), side()};
    add_box(mesh, place, frame.x * size.x, frame.y * size.y, frame.z * size.z, rng.chance(0.5));
    mesh.free_radius = 0.7;
}

/// A ring of points about a square around the origin, so as not to need a sine: counter-clockwise seen from +z.
std::vector<Steps> ring(Rng& rng, int count, double least, double most) {
    std::vector<Steps> points;
    for (int k = 0; k < count; ++k) {
        const double part = 4.0 * k / count, on_side = part - std::floor(part);
        const double x[4] = {1, 1 - 2 * on_side, -1, -1 + 2 * on_side},
                     y[4] = {-1 + 2 * on_side, 1, 1 - 2 * on_side, -1};
        const double scale = rng.uniform(least, most) * double(kMetre);
        points.push_back({std::llround(x[int(part)] * scale), std::llround(y[int(part)] * scale), 0});
    }
    return points;
}

void two_fans(ClosedMesh& mesh, Rng& rng, double top, double bottom) {
    const int count = 3 + int(rng.below(62));
    const Steps place = random_place(rng);
    std::vector<Steps> rim = ring(rng, count, 1.5, 3);
    for (Steps& p : rim) p = p + Steps{0, 0, std::llround(rng.uniform(-0.05, 0.05) * double(kMetre))};
    const GridPoint up =
        in_world(place + random_steps(rng, kMetre / 16) + Steps{0, 0, std::llround(top * double(kMetre))}, kInput);
    const GridPoint down =
        in_world(place + random_steps(rng, kMetre / 16) + Steps{0, 0, std::llround(bottom * double(kMetre))}, kInput);
    for (int k = 0; k < count; ++k) {
        const GridPoint p = in_world(place + rim[std::size_t(k)], kInput),
                        q = in_world(place + rim[std::size_t((k + 1) % count)], kInput);
        mesh.faces.push_back({up, q, p});
        mesh.faces.push_back({down, p, q});
    }
}

void bipyramid(ClosedMesh& mesh, Rng& rng) {
    const double top = rng.uniform(1, 3), bottom = -rng.uniform(1, 3);
    two_fans(mesh, rng, top, bottom);
    const Vec3 middle = (firma::to_metres(mesh.faces[0][0]) + firma::to_metres(mesh.faces[1][0])) * 0.5;
    mesh.inside = {middle};
    mesh.free_radius = 0;  // measured below
}

// The lid is pushed in toward the bottom; a ring of air is left around, and air between the hubs.
void cup(ClosedMesh& mesh, Rng& rng) {
    const double top = -rng.uniform(0.1, 0.5), bottom = -rng.uniform(1.5, 3);
    two_fans(mesh, rng, top, bottom);
    const Vec3 middle = (firma::to_metres(mesh.faces[0][0]) + firma::to_metres(mesh.faces[1][0])) * 0.5;
    mesh.inside = {middle};
}

/// Half the least distance of the planes that the star's middle sees: a ball that lies inside a star-shaped mesh.
void measure_star(ClosedMesh& mesh) {
    double least = INFINITY;
    for (const GridPolygon& face : mesh.faces)
        least = std::min(least, dot(mesh.inside[0] - firma::to_metres(face[0]), unit_normal(face)));
    mesh.free_radius = least * 0.5;
}

void voxel_room(ClosedMesh& mesh, Rng& rng, bool jittered) {
    using Cell = std::array<int, 3>;
    std::set<Cell> air{{0, 0, 0}};
    std::vector<Cell> list{{0, 0, 0}};
    const int count = 4 + int(rng.below(20));
    while (int(air.size()) < count) {
        Cell next = list[rng.below(std::uint32_t(list.size()))];
        const int step = rng.chance(0.5) ? 1 : -1;
        next[rng.below(3)] += step;
        if (air.insert(next).second) list.push_back(next);
    }
    const Steps place = random_place(rng);
    const std::int64_t cell = kMetre * (1 + rng.below(3));
    std::map<Cell, GridPoint> corners;
    const auto corner = [&](const Cell& at) {
        const auto [entry, is_new] = corners.try_emplace(at);
        if (is_new) {
            const Steps base = place + Steps{at[0] * cell, at[1] * cell, at[2] * cell};
            entry->second = in_world(jittered ? base + random_steps(rng, cell / 6) : base, kInput);
        }
        return entry->second;
    };
    for (const Cell& c : list)
        for (int axis = 0; axis < 3; ++axis)
            for (int up = 0; up < 2; ++up) {
                Cell beside = c;
                beside[std::size_t(axis)] += up ? 1 : -1;
                if (air.count(beside)) continue;
                Cell o = c, u{}, v{};
                if (up) o[std::size_t(axis)] += 1;
                u[std::size_t((axis + 1) % 3)] = 1;
                v[std::size_t((axis + 2) % 3)] = 1;
                if (up) std::swap(u, v);  // the front looks back into the cell
                const auto plus = [](const Cell& a, const Cell& b) {
                    return Cell{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
                };
                const GridPoint p = corner(o), q = corner(plus(o, u)), r = corner(plus(plus(o, u), v)),
                                s = corner(plus(o, v));
                if (jittered) {
                    mesh.faces.push_back({p, q, r});
                    mesh.faces.push_back({p, r, s});
                } else {
                    mesh.faces.push_back({p, q, r, s});
                }
            }
    for (const Cell& c : list)
        mesh.inside.push_back(
            to_metres(place + Steps{c[0] * cell + cell / 2, c[1] * cell + cell / 2, c[2] * cell + cell / 2}));
    mesh.free_radius = double(cell) / kSurfaceSteps * 0.25;
}

void icosphere(ClosedMesh& mesh, Rng& rng) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec3> v = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<std::array<std::size_t, 3>> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int level = rng.chance(0.5) ? 1 : 2; level > 0; --level) {
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> halves;
        const auto half = [&](std::size_t a, std::size_t b) {
            const auto [entry, is_new] = halves.try_emplace(std::minmax(a, b), v.size());
            if (is_new) v.push_back((v[a] + v[b]) * 0.5);
            return entry->second;
        };
        std::vector<std::array<std::size_t, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const std::size_t ab = half(a, b), bc = half(b, c), ca = half(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    const Steps place = random_place(rng);
    const double radius = rng.uniform(1, 4) * double(kMetre);
    std::vector<GridPoint> snapped;
    for (const Vec3& p : v) {
        const Vec3 at = p * (radius / length(p));
        snapped.push_back(in_world(place + Steps{std::llround(at.x), std::llround(at.y), std::llround(at.z)}, kInput));
    }
    for (const auto& [a, b, c] : triangles) mesh.faces.push_back({snapped[a], snapped[c], snapped[b]});
    mesh.inside = {to_metres(place)};
}

}  // namespace

const char* name_of(MeshKind kind) {
    constexpr const char* kNames[kMeshKinds] = {"box",        "triangle_box",  "bipyramid", "cup",
                                                "voxel_room", "jittered_room", "icosphere", "turned_box"};
    return kNames[int(kind)];
}

ClosedMesh make_closed_mesh(MeshKind kind, Rng& rng) {
    for (;;) {
        ClosedMesh mesh;
        mesh.kind = kind;
        switch (kind) {
            case MeshKind::kBox:
                box(mesh, rng, false);
                break;
            case MeshKind::kTriangleBox:
                box(mesh, rng, true);
                break;
            case MeshKind::kBipyramid:
                bipyramid(mesh, rng);
                break;
            case MeshKind::kCup:
                cup(mesh, rng);
                break;
            case MeshKind::kVoxelRoom:
                voxel_room(mesh, rng, false);
                break;
            case MeshKind::kJitteredRoom:
                voxel_room(mesh, rng, true);
                break;
            case MeshKind::kIcosphere:
                icosphere(mesh, rng);
                break;
            case MeshKind::kTurnedBox:
                turned_box(mesh, rng);
                break;
        }
        if (kind == MeshKind::kBipyramid || kind == MeshKind::kCup || kind == MeshKind::kIcosphere) measure_star(mesh);
        if (mesh.free_radius < 0.01) continue;  // the hubs came too near to each other
        Box bounds;
        for (const GridPolygon& face : mesh.faces)
            for (const GridPoint& p : face) bounds.add(firma::to_metres(p));
        mesh.size = length(bounds.high - bounds.low);
        return mesh;
    }
}

CastQuery escaping_cast(const ClosedMesh& mesh, bool sphere, Rng& rng) {
    for (;;) {
        const GridPolygon& face = mesh.faces[rng.below(std::uint32_t(mesh.faces.size()))];
        const std::size_t k = rng.below(std::uint32_t(face.size()));
        const Vec3 a = firma::to_metres(face[k]), b = firma::to_metres(face[(k + 1) % face.size()]),
                   c = firma::to_metres(face[(k + 2) % face.size()]);
        const double which = rng.uniform(), u = rng.uniform();
        Vec3 target = a;  // a corner; hubs are corners of many faces
        if (which > 0.5) target = a + (b - a) * (rng.chance(0.3) ? 0.5 : u);
        if (which > 0.8) target = target + (c - target) * rng.uniform();
        Vec3 start = mesh.inside[rng.below(std::uint32_t(mesh.inside.size()))];
        if (rng.chance(0.8)) {
            const Vec3 aside = rng.direction();
            start = start + aside * (mesh.free_radius * rng.uniform());
        }
        const bool floats = rng.chance(0.5);
        Vec3 way;
        for (int axis = 0; axis < 3; ++axis) {
            if (floats) {
                start[axis] = rounded_to_float(start[axis]);
                way[axis] = rounded_to_float(rounded_to_float(target[axis]) - start[axis]);
            } else {
                way[axis] = target[axis] - start[axis];
            }
        }
        const double far = length(way);
        if (far == 0) continue;
        int power = 0;
        while (std::ldexp(far, power) < 4 * mesh.size) ++power;
        power += int(rng.below(8));
        way = way * std::ldexp(1.0, power);
        double radius = 0;
        if (sphere) {
            radius = std::ldexp(mesh.free_radius, -int(rng.below(20)));
            radius *= rng.uniform();
        }
        return {{start, radius}, way};
    }
}

}  // namespace firma::scenes
