// SPDX-License-Identifier: MIT
// Paints go by matter: of a face of the level by its brush, of a face that a cut made by what is behind it.
#include "draw/scene_faces.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "draw/room_colours.h"
#include "draw/view_raster.h"
#include "firma/matter.h"
#include "firma/turn.h"

namespace firma::draw {

namespace {

constexpr Vec3 kPlayerPaint{0.16, 0.42, 0.72}, kLiquidPaint{0.45, 0.62, 0.72};
constexpr double kFresh = 0.86;         // of the paint, on faces that a cut or a crack made
constexpr double kVariety = 0.07;       // between materials of one matter, up and down
constexpr int kSides = 20, kRings = 5;  // of a capsule: around, and of each of its caps

/// What a matter looks like.
Vec3 paint_of_matter(const std::string& name) {
    static const std::array<std::pair<const char*, Vec3>, 7> kPaints = {{{"brick", {0.76, 0.50, 0.40}},
                                                                         {"concrete", {0.76, 0.75, 0.71}},
                                                                         {"wood", {0.76, 0.58, 0.36}},
                                                                         {"steel", {0.52, 0.59, 0.67}},
                                                                         {"glass", {0.62, 0.80, 0.82}},
                                                                         {"rock", {0.60, 0.55, 0.48}},
                                                                         {"", {0.80, 0.79, 0.74}}}};
    for (const auto& [matter, paint] : kPaints)
        if (name == matter) return paint;
    return kPaints.back().second;
}

/// Lighter or darker by its name, the same on every machine.
double shade_of_name(const std::string& name) {
    std::uint32_t hash = 2166136261u;
    for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
    return 1 + kVariety * (double(hash >> 16) / 32768.0 - 1);
}

Vec3 level_paint(const World& world, const Face& face) {
    if ((face.mask & kStopsSight) == 0) return kLiquidPaint;
    const std::uint32_t of = matter_of(world, face.ref()).value_or(0);
    const Vec3 paint = paint_of_matter(matter(world, of).name);
    return face.source_edit != 0 ? paint * kFresh : paint * shade_of_name(world.material_name(face.material));
}

void add_face(SceneFaces& scene, std::vector<Vec3> corners, const Vec3& normal, const Vec3& paint) {
    Face face;
    face.corners = std::move(corners);
    face.normal = normal;
    scene.faces.push_back(std::move(face));
    scene.paints.push_back(paint);
}

void add_solid(SceneFaces& scene, const World& level, const DrawnSolid& drawn) {
    const Result<World> facets = make_world(drawn.solid);
    if (!facets) return;
    const Vec3 paint = paint_of_matter(matter(level, drawn.matter).name);
    const TurnMatrix turn = matrix_of(normalised(drawn.pose.rotation));
    each_face(facets.value(), [&](const FaceView& face) {
        std::vector<Vec3> corners;
        for (const Vec3& corner : face.corners) corners.push_back(drawn.pose.position + turn * corner);
        add_face(scene, std::move(corners), turn * face.normal, face.source_edit != 0 ? paint * kFresh : paint);
        return true;
    });
}

/// One half of a capsule's outline: how far out and how far up from its lower end.
struct RingPoint {
    double out, up;
};
std::vector<RingPoint> outline_of(const Capsule& capsule) {
    constexpr double kQuarter = 1.5707963267948966;
    const double height = length(capsule.to - capsule.from);
    std::vector<RingPoint> points;
    for (int k = 0; k <= kRings; ++k) {
        const SineCosine angle = sine_cosine(kQuarter * k / kRings);
        points.push_back({capsule.radius * angle.sine, -capsule.radius * angle.cosine});
    }
    for (int k = kRings; k >= 0; --k)
        points.push_back({points[std::size_t(k)].out, height - points[std::size_t(k)].up});
    return points;
}

void add_capsule(SceneFaces& scene, const Capsule& capsule) {
    constexpr double kWhole = 6.283185307179586;
    const Vec3 up = unit_of(capsule.to - capsule.from);
    const Vec3 side = unit_of(cross(up, std::fabs(up.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
               front = cross(up, side);
    const std::vector<RingPoint> outline = outline_of(capsule);
    const auto corner = [&](std::size_t ring, int step) {
        const SineCosine angle = sine_cosine(kWhole * (step % kSides) / kSides);
        return capsule.from + up * outline[ring].up + (side * angle.cosine + front * angle.sine) * outline[ring].out;
    };
    for (std::size_t ring = 0; ring + 1 < outline.size(); ++ring)
        for (int step = 0; step < kSides; ++step) {
            std::vector<Vec3> corners{corner(ring, step), corner(ring, step + 1), corner(ring + 1, step + 1),
                                      corner(ring + 1, step)};
            if (ring == 0) corners.erase(corners.begin());
            if (ring + 2 == outline.size()) corners.pop_back();
            const Vec3 normal = unit_of(cross(corners[1] - corners[0], corners[2] - corners[0]));
            add_face(scene, std::move(corners), normal, kPlayerPaint);
        }
}

/// Triangles of faces, on the grid; those without area there are left out.
World world_of(std::span<const Face> faces) {
    Level level;
    level.materials = {""};
    level.groups = {""};
    for (const Face& face : faces)
        for (std::size_t k = 2; k < face.corners.size(); ++k) {
            std::array<GridPoint, 3> grid;
            bool fits = true;
            for (const std::size_t which : {std::size_t(0), k - 1, k}) {
                const std::optional<GridPoint> point = snap(face.corners[which]);
                fits = fits && point;
                if (point) grid[which == 0 ? 0 : which == k ? 2 : 1] = *point;
            }
            const Vec3 a = to_metres(grid[0]), b = to_metres(grid[1]), c = to_metres(grid[2]);
            if (!fits || cross(b - a, c - a) == Vec3{}) continue;
            LevelFace triangle;
            triangle.first_corner = std::uint32_t(level.corners.size());
            triangle.corner_count = 3;
            triangle.two_sided = true;
            for (const GridPoint& point : grid) {
                level.corners.push_back(std::uint32_t(level.vertices.size()));
                level.vertices.push_back(point);
            }
            level.faces.push_back(triangle);
        }
    if (level.faces.empty()) return {};
    Result<World> world = make_world(level);
    return world ? std::move(world).value() : World();
}

}  // namespace

SceneFaces scene_faces(const World& world, const DrawnThings& things) {
    SceneFaces scene;
    scene.faces = world.faces();
    for (const Face& face : scene.faces) scene.paints.push_back(level_paint(world, face));
    for (const DrawnSolid& solid : things.solids) add_solid(scene, world, solid);
    for (const Capsule& player : things.players) add_capsule(scene, player);
    scene.things = world_of(std::span(scene.faces).subspan(world.face_count()));
    return scene;
}

}  // namespace firma::draw
