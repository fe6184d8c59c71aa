// SPDX-License-Identifier: MIT
// Closed meshes with corners on a lattice.
#include "scenes/lattice_solids.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/exact_integer.h"

namespace firma::scenes {
namespace {

constexpr int kSpongeCells = 3;  ///< an edge, in pieces

/// The sign of the volume between them.
int turn_of(const Steps& a, const Steps& b, const Steps& c, const Steps& d) {
    const Steps u = b - a, v = c - a, w = d - a;
    const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return Int128(p) * s - Int128(q) * r;
    };
    const Int128 turn =
        minor(u.y, u.z, v.y, v.z) * w.x + minor(u.z, u.x, v.z, v.x) * w.y + minor(u.x, u.y, v.x, v.y) * w.z;
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

void turn_over(LatticeSolid& solid) {
    for (CutterTriangle& corners : solid.triangles) std::swap(corners[1], corners[2]);
}

void fill_cells(std::set<LatticeCell>& cells, const LatticeCell& low, const LatticeCell& size) {
    for (int x = 0; x < size[0]; ++x)
        for (int y = 0; y < size[1]; ++y)
            for (int z = 0; z < size[2]; ++z) cells.insert({low[0] + x, low[1] + y, low[2] + z});
}

/// Whether a cell is drilled away: in the middle third of two axes, at any level.
bool is_drilled(LatticeCell cell, int level) {
    for (; level > 0; --level) {
        int middle = 0;
        for (int& at : cell) {
            middle += at % kSpongeCells == 1;
            at /= kSpongeCells;
        }
        if (middle >= 2) return true;
    }
    return false;
}

struct Glyph {
    char letter;
    const char* rows[5];  ///< from above
};
constexpr Glyph kGlyphs[] = {
    {'C', {"###", "#..", "#..", "#..", "###"}}, {'E', {"###", "#..", "###", "#..", "###"}},
    {'F', {"###", "#..", "###", "#..", "#.."}}, {'H', {"#.#", "#.#", "###", "#.#", "#.#"}},
    {'I', {"###", ".#.", ".#.", ".#.", "###"}}, {'L', {"#..", "#..", "#..", "#..", "###"}},
    {'O', {"###", "#.#", "#.#", "#.#", "###"}}, {'T', {"###", ".#.", ".#.", ".#.", ".#."}},
    {'U', {"#.#", "#.#", "#.#", "#.#", "###"}},
};

}  // namespace

LatticeSolid block_solid(const Steps& low, const Steps& high) {
    LatticeSolid solid = cells_solid({{0, 0, 0}});
    for (Steps& v : solid.vertices) v = {v.x ? high.x : low.x, v.y ? high.y : low.y, v.z ? high.z : low.z};
    return solid;
}

LatticeSolid cells_solid(const std::set<LatticeCell>& cells) {
    LatticeSolid solid;
    std::map<LatticeCell, std::uint32_t> numbers;
    const auto vertex = [&](const LatticeCell& at) {
        const auto [entry, is_new] = numbers.try_emplace(at, std::uint32_t(solid.vertices.size()));
        if (is_new) solid.vertices.push_back({at[0], at[1], at[2]});
        return entry->second;
    };
    for (const LatticeCell& cell : cells)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side) {
                LatticeCell beside = cell;
                beside[axis] += side == 1 ? 1 : -1;
                if (cells.contains(beside)) continue;
                LatticeCell corner[4] = {cell, cell, cell, cell};
                for (LatticeCell& at : corner) at[axis] += side;
                const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                ++corner[1][u], ++corner[2][u], ++corner[2][v], ++corner[3][v];
                if (side == 0) std::swap(corner[1], corner[3]);
                std::uint32_t number[4];
                for (int k = 0; k < 4; ++k) number[k] = vertex(corner[k]);
                solid.triangles.push_back({number[0], number[1], number[2]});
                solid.triangles.push_back({number[0], number[2], number[3]});
            }
    return solid;
}

LatticeSolid star_prism(std::span<const Steps> outline, std::int64_t height) {
    LatticeSolid solid;
    const auto count = std::uint32_t(outline.size());
    for (const std::int64_t z : {std::int64_t(0), height})
        for (const Steps& p : outline) solid.vertices.push_back({p.x, p.y, z});
    solid.vertices.push_back({0, 0, 0});
    solid.vertices.push_back({0, 0, height});
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        solid.triangles.push_back({2 * count, next, k});
        solid.triangles.push_back({2 * count + 1, count + k, count + next});
        solid.triangles.push_back({k, next, count + next});
        solid.triangles.push_back({k, count + next, count + k});
    }
    return solid;
}

LatticeSolid wedge_solid(Rng& rng, std::int64_t most) {
    const auto size = [&] { return 1 + std::int64_t(rng.below(std::uint32_t(most))); };
    const std::int64_t x = size(), y = size(), z = size();
    const Steps corners[3] = {{0, 0, 0}, {x, 0, 0}, {rng.chance(0.7) ? 0 : x / 2, y, 0}};
    return moved_polygon(corners, {0, 0, z});
}

LatticeSolid gear_solid(Rng& rng, std::int64_t height) {
    // Around a square of 6 x 6, so as not to need a sine: points on it, and teeth that stand out from it.
    std::vector<Steps> outline;
    const bool pointed = rng.chance(0.5);
    const Steps first[] = {{3, -3, 0}, {3, -1, 0}, {3, 1, 0}};
    for (int side = 0; side < 4; ++side) {
        const auto add = [&](const Steps& p) {
            Steps q = p;
            for (int k = 0; k < side; ++k) q = {-q.y, q.x, 0};
            outline.push_back(q);
        };
        add(first[0]);
        add(first[1]);
        if (pointed) {
            add({5, 0, 0});
        } else {
            add({4, -1, 0});
            add({4, 1, 0});
        }
        add(first[2]);
    }
    return star_prism(outline, height);
}

LatticeSolid letter_solid(char letter, int height) {
    std::set<LatticeCell> cells;
    for (const Glyph& glyph : kGlyphs)
        if (glyph.letter == letter)
            for (int row = 0; row < 5; ++row)
                for (int column = 0; column < 3; ++column)
                    if (glyph.rows[row][column] == '#') fill_cells(cells, {column, 4 - row, 0}, {1, 1, height});
    return cells_solid(cells);
}

LatticeSolid bent_solid(Rng& rng, int size) {
    static const std::vector<std::vector<LatticeCell>> shapes = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},                                                         // L
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},                                              // long L
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},                                              // T
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}},                                              // Z
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}},                                   // U
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},                                              // corner
        {{1, 1, 1}, {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}},             // cross
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},  // ring
    };
    std::set<LatticeCell> cells;
    for (const LatticeCell& at : shapes[rng.below(std::uint32_t(shapes.size()))])
        fill_cells(cells, {at[0] * size, at[1] * size, at[2] * size}, {size, size, size});
    return cells_solid(cells);
}

LatticeSolid sponge_solid(int level) {
    int size = 1;
    for (int k = 0; k < level; ++k) size *= kSpongeCells;
    std::set<LatticeCell> cells;
    fill_cells(cells, {0, 0, 0}, {size, size, size});
    std::erase_if(cells, [&](const LatticeCell& cell) { return is_drilled(cell, level); });
    return cells_solid(cells);
}

LatticeSolid column_terrain(Rng& rng, int size, int most) {
    std::vector<int> along_x, along_y;
    for (int k = 0; k < size; ++k) {
        along_x.push_back(1 + int(rng.below(std::uint32_t(most))));
        along_y.push_back(int(rng.below(std::uint32_t(most))));
    }
    std::set<LatticeCell> cells;
    for (int x = 0; x < size; ++x)
        for (int y = 0; y < size; ++y)
            fill_cells(cells, {x, y, 0}, {1, 1, along_x[std::size_t(x)] + along_y[std::size_t(y)]});
    return cells_solid(cells);
}

LatticeSolid tetrahedron(const Steps& a, const Steps& b, const Steps& c, const Steps& d) {
    const int turn = turn_of(a, b, c, d);
    if (turn == 0) return {};
    LatticeSolid solid{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    if (turn < 0) turn_over(solid);
    return solid;
}

LatticeSolid moved_polygon(std::span<const Steps> corners, const Steps& way) {
    LatticeSolid solid;
    const auto count = std::uint32_t(corners.size());
    for (const Steps& p : corners) solid.vertices.push_back(p);
    for (const Steps& p : corners) solid.vertices.push_back(p + way);
    int turn = 0;
    for (std::uint32_t k = 2; k < count; ++k) {
        turn = turn_of(corners[0], corners[k - 1], corners[k], corners[0] + way);
        if (turn == 0) return {};
        solid.triangles.push_back({0, k, k - 1});
        solid.triangles.push_back({count, count + k - 1, count + k});
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        solid.triangles.push_back({k, next, count + next});
        solid.triangles.push_back({k, count + next, count + k});
    }
    if (turn < 0) turn_over(solid);
    return solid;
}

LatticeSolid turned(LatticeSolid solid, std::uint32_t which) {
    for (Steps& v : solid.vertices) {
        for (std::uint32_t k = 0; k < which % 3; ++k) v = {v.y, v.z, v.x};
        if (which / 3 % 2) v = {-v.y, v.x, v.z};
        if (which / 6 % 2) v = {-v.x, -v.y, v.z};
        if (which / 12 % 2) v = {v.x, -v.y, -v.z};
    }
    return solid;
}

LatticeSolid moved(LatticeSolid solid, const Steps& by) {
    for (Steps& v : solid.vertices) v = v + by;
    return solid;
}

LatticeSolid scaled(LatticeSolid solid, std::int64_t by) {
    for (Steps& v : solid.vertices) v = v * by;
    return solid;
}

void add_faces(std::vector<GridPolygon>& faces, const LatticeSolid& solid, bool room) {
    for (auto [a, b, c] : solid.triangles) {
        if (room) std::swap(b, c);
        faces.push_back({in_world(solid.vertices[a]), in_world(solid.vertices[b]), in_world(solid.vertices[c])});
    }
}

Cutter cutter_of(const LatticeSolid& solid, std::string_view name, Vec3& at) {
    at = to_metres(solid.vertices[0]);
    std::vector<Vec3> vertices;
    for (const Steps& v : solid.vertices) vertices.push_back(to_metres(v - solid.vertices[0]));
    Result<Cutter> made = make_cutter(vertices, solid.triangles, std::string(name));
    return made ? std::move(made).value() : Cutter();
}

}  // namespace firma::scenes
