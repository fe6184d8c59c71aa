// SPDX-License-Identifier: MIT
// What craters are cut with: closed meshes of triangles, made from a seed or from a file, and where they are put.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "firma/export.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/vec.h"

namespace firma {

struct CutterData;

/// Corners of a triangle as indices of vertices, counter-clockwise seen from outside.
using CutterTriangle = std::array<std::uint32_t, 3>;

/// A cutter of more triangles is refused.
inline constexpr std::size_t kMaxCutterTriangles = 4'000'000;

/// Crater shapes that are made from a seed.
enum class CutterShape : std::uint8_t {
    kRocky,  ///< a rough ball of 180 triangles, radii 0.78 to 1.2
    kSpiky,  ///< a ball of 180 triangles with 32 spikes, radii 0.55 to 2
    kDrill,  ///< a pointed rod of 16 sides along z, 6 long and about 1 in radius: 64 triangles
    kWedge,  ///< a blade with crooked corners along z, its edge toward x: 8 triangles
    kBox,    ///< the cube from -1 to 1, whatever the seed: 12 triangles
};

/// The shape of a name ("rocky", "spiky", "drill", "wedge", "box"); nothing for any other. Never allocates, as
/// cutter_shape_name(), which gives "" for what is no shape.
[[nodiscard]] FIRMA_EXPORT std::optional<CutterShape> cutter_shape(std::string_view name);
[[nodiscard]] FIRMA_EXPORT std::string_view cutter_shape_name(CutterShape shape);

/// A closed mesh in units of its own (metres at scale 1), or a solid (cutter_from_solid()), immutable: copies share it.
/// The default one holds nothing and cannot be placed. Copies and questions cost the same for every cutter and never
/// allocate.
class Cutter {
public:
    Cutter() = default;
    FIRMA_EXPORT explicit Cutter(std::shared_ptr<const CutterData> data);

    bool valid() const { return data_ != nullptr; }
    /// Views, as long-lived as the cutter and its copies.
    FIRMA_EXPORT std::span<const Vec3> vertices() const;
    FIRMA_EXPORT std::span<const CutterTriangle> triangles() const;
    /// For messages.
    FIRMA_EXPORT const std::string& name() const;

    /// Inner workings; null when not valid().
    const std::shared_ptr<const CutterData>& data() const { return data_; }

private:
    std::shared_ptr<const CutterData> data_;
};

/// A crater shape of mean radius about 1 around the origin, which sees every point of its surface. The same numbers
/// from the same seed on every machine; for what is no shape, a cutter that is not valid(). Costs the shape's
/// triangles, which allocate; make it once and place it often.
[[nodiscard]] FIRMA_EXPORT Cutter make_crater(CutterShape shape, std::uint64_t seed);

/// A cutter from a mesh. An inside-out one is turned over; vertices that no triangle uses are left out.
///
/// @param vertices   any unit
/// @param triangles  indices of vertices [4 <= count <= kMaxCutterTriangles], all wound the same way
/// @param name       for messages
/// @return the cutter, or the first fault, with the vertex, triangle or edge:
///         kTooLarge, too many triangles; kOutOfRange, a number that is not finite or beyond 2^200;
///         kMalformed, an index of no vertex, a triangle that names a vertex twice, an edge that not exactly two
///         triangles use, one each way (open, or more than two in one place, or wound against each other), fewer than 4
///         triangles, no volume.
/// Whether it crosses itself is judged where it is placed, on the grid.
/// Costs the vertices and triangles, copied, and sorting the edges.
[[nodiscard]] FIRMA_EXPORT Result<Cutter> make_cutter(std::span<const Vec3> vertices,
                                                      std::span<const CutterTriangle> triangles, std::string name = "");

/// A cutter from a level file: vertices at one position are one, faces are divided into triangles. Metres, as snapped.
/// Whether faces are two-sided, and materials and groups, are ignored.
///
/// @return as make_cutter(); an edge that a face does not share corner by corner (a T-joint) is open
/// Costs the level's vertices and faces, sorted, and make_cutter().
[[nodiscard]] FIRMA_EXPORT Result<Cutter> cutter_from_level(const Level& level);

/// A turn: x, y, z, w, of any length but zero; it is normalised when used.
using Quaternion = std::array<double, 4>;

/// Where a cutter goes: turned, scaled, then moved.
struct Pose {
    Vec3 position{};                  ///< metres
    Quaternion rotation{0, 0, 0, 1};  ///< none
    double scale = 1;                 ///< metres a unit of the cutter, > 0
};

/// A random turn, evenly distributed, of length 1; without sine or cosine, so the same on every machine. Costs a few
/// random numbers; never allocates.
/// Source: G. Marsaglia, Choosing a Point from the Surface of a Sphere, 1972 (by rejection, in four dimensions).
[[nodiscard]] FIRMA_EXPORT Quaternion random_turn(std::uint64_t seed);

}  // namespace firma
