// SPDX-License-Identifier: MIT
// Closed meshes with corners on a lattice, to be levels and cutters that touch: blocks, wedges, gears, letters,
// sponges.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "firma/cutter.h"
#include "scenes/grid_polygons.h"

namespace firma::scenes {

/// Closed and one-sided, counter-clockwise seen from outside; in steps of the lattice, or of the surface grid.
struct LatticeSolid {
    std::vector<Steps> vertices;
    std::vector<CutterTriangle> triangles;

    bool empty() const { return triangles.empty(); }
};

/// A unit cube from (x, y, z) to (x + 1, y + 1, z + 1).
using LatticeCell = std::array<int, 3>;

LatticeSolid block_solid(const Steps& low, const Steps& high);
/// The surface of cells, two triangles a unit square. No edge may be the only one that two of the cells share.
LatticeSolid cells_solid(const std::set<LatticeCell>& cells);
/// A prism along z from 0 to `height` over an outline, counter-clockwise, that the origin sees whole from its inside.
LatticeSolid star_prism(std::span<const Steps> outline, std::int64_t height);
/// A prism of three sides, its length along z: half a block of random size.
LatticeSolid wedge_solid(Rng& rng, std::int64_t most);
/// A wheel with square or pointed teeth.
LatticeSolid gear_solid(Rng& rng, std::int64_t height);
/// A capital of 3 x 5 cells and `height` along z: any of kLatticeLetters.
LatticeSolid letter_solid(char letter, int height);
inline constexpr std::string_view kLatticeLetters = "CEFHILOTU";
/// An L, T, Z, U or a cross of blocks of `size` cells.
LatticeSolid bent_solid(Rng& rng, int size);
/// 3 cells wide (level 1) or 9 (level 2).
LatticeSolid sponge_solid(int level);
/// Columns of heights a(x) + b(y) over `size` x `size` cells: no two columns meet along an edge alone.
LatticeSolid column_terrain(Rng& rng, int size, int most);
/// A tetrahedron, turned so that it encloses; empty when the four lie in one plane.
LatticeSolid tetrahedron(const Steps& a, const Steps& b, const Steps& c, const Steps& d);
/// What lies between a convex polygon and the same one moved; empty when its corners or the way lie in one plane.
LatticeSolid moved_polygon(std::span<const Steps> corners, const Steps& way);

/// One of the 24 turns that keep the axes.
LatticeSolid turned(LatticeSolid solid, std::uint32_t which);
LatticeSolid moved(LatticeSolid solid, const Steps& by);
LatticeSolid scaled(LatticeSolid solid, std::int64_t by);

/// Adds its triangles, wound so that fronts look outward, or inward for a room in rock. In surface steps.
void add_faces(std::vector<GridPolygon>& faces, const LatticeSolid& solid, bool room);
/// In metres about the first vertex, so that a pose puts it where it is; `at` is that vertex. In surface steps.
Cutter cutter_of(const LatticeSolid& solid, std::string_view name, Vec3& at);

}  // namespace firma::scenes
