// SPDX-License-Identifier: MIT
// Each face into a buffer of depths, four samples a pixel; then colour, shadow and edges sample by sample.
#include "draw/draw_view.h"
#include "firma/queries.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "draw/room_colours.h"
#include "draw/view_raster.h"
#include "firma/level.h"
#include "firma/rooms.h"

namespace firma::draw {
namespace {

constexpr int kSamples = 2;          // along each side of a pixel
constexpr double kTooClose = 2;      // metres: a wall so near hides what a picture is to show
constexpr double kLift = 0.004;      // metres from a face to where its shadow ray begins
constexpr double kLampShare = 0.55;  // of the way to the target, upward and to the left
constexpr double kShadow = 0.66;     // light that is left in shadow
constexpr double kEdgeShade = 0.5;   // light that is left on an edge
constexpr Vec3 kWaterColour = {0.45, 0.62, 0.72};
constexpr Vec3 kOpenColour = {0.10, 0.80, 0.66}, kClosedColour = {0.85, 0.14, 0.12};
constexpr double kPane = 0.22, kClosedPane = 0.5;  // share of a pane's colour in what is seen through it
constexpr double kRoomWhite = 0.25;                // in a room's colour
constexpr double kShadeOfNew = 0.72;               // of a room's colour, on faces that an edit made
constexpr std::uint8_t kMostPanes = 6;             // in front of one another, that are told apart

/// Along the normal of a polygon, twice its area long.
Vec3 area_normal(std::span<const Vec3> corners) {
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum = sum + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    return sum;
}

/// What each sample sees of portals, before the faces: how many panes, and which is the nearest.
struct Panes {
    std::vector<std::uint8_t> open, closed;
    std::vector<std::uint32_t> nearest;  ///< a portal, or kNothing
    std::vector<double> nearness;
};

Panes paint_portals(const World& world, const ViewFrame& frame, const DepthBuffer& buffer) {
    const std::size_t samples = buffer.face.size();
    Panes panes{std::vector<std::uint8_t>(samples), std::vector<std::uint8_t>(samples),
                std::vector<std::uint32_t>(samples, kNothing), std::vector<double>(samples)};
    for (std::uint32_t id = 0; id < portal_count(world); ++id) {
        const bool open = portal_info(world, {id})->open;
        for (const std::vector<Vec3>& polygon : portal_polygons(world, {id})) {
            Face pane;
            pane.corners = polygon;
            pane.normal = unit_of(area_normal(polygon));
            pane.two_sided = true;
            if (!seen_from(frame.eye, pane)) continue;
            paint(frame, pane, buffer, [&](std::size_t at, double nearness) {
                if (nearness < buffer.nearness[at]) return;
                std::uint8_t& count = (open ? panes.open : panes.closed)[at];
                if (count < kMostPanes) ++count;
                if (nearness <= panes.nearness[at]) return;
                panes.nearness[at] = nearness;
                panes.nearest[at] = id;
            });
        }
    }
    return panes;
}

/// A colour behind panes, and their rims.
Vec3 behind(const Panes& panes, const DepthBuffer& buffer, int x, int y, Vec3 colour) {
    const std::size_t at = buffer.at(x, y);
    for (int k = 0; k < panes.open[at]; ++k) colour = mixed(colour, kOpenColour, kPane);
    for (int k = 0; k < panes.closed[at]; ++k) colour = mixed(colour, kClosedColour, kClosedPane);
    const auto differs = [&](int other_x, int other_y) {
        return other_x < buffer.width && other_y < buffer.height &&
               panes.nearest[buffer.at(other_x, other_y)] != panes.nearest[at];
    };
    if (!differs(x + 1, y) && !differs(x, y + 1) && !differs(x + 2, y) && !differs(x, y + 2)) return colour;
    return panes.closed[at] > 0 ? kClosedColour * 0.6 : kOpenColour * 0.6;
}

/// Toward the lamp from the eye: up and to the left, so that rims throw shadows into what lies behind them.
Vec3 way_to_lamp(const ViewFrame& frame, const Camera& camera) {
    return (frame.up - frame.right) * (kLampShare * length(camera.target - camera.eye));
}

/// Where the lamp hangs: as far that way as there is room.
Vec3 lamp_of(const World& world, const ViewFrame& frame, const Camera& camera) {
    const Vec3 path = way_to_lamp(frame, camera);
    CastOptions both;
    both.sides = Sides::kBoth;
    both.mask = kStopsSight;
    const Hit hit = cast(world, {frame.eye, 0.0}, path, both);
    return frame.eye + path * (hit.touched() ? 0.8 * hit.fraction : 1.0);
}

/// Light on a face without shadows: more from above and from the lamp's side.
double light_on(const Vec3& normal, const Vec3& to_lamp, int up) {
    const double facing = std::max(0.0, dot(normal, to_lamp));
    return 0.6 + 0.4 * facing + 0.1 * normal[up];
}

bool in_shadow(const World& world, const Vec3& point, const Vec3& lamp) {
    CastOptions opaque;
    opaque.mask = kStopsSight;
    return cast_any(world, {point, 0.0}, lamp - point, opaque) != Status::kMiss;
}

/// What a face is painted with.
Vec3 paint_of(const Face& face) {
    if (is_sky(face)) return kSkyColour;
    if (face.source_edit != 0) return {0.80, 0.55, 0.33};
    return (face.mask & kStopsSight) == 0 ? kWaterColour : Vec3{0.80, 0.81, 0.80};
}

/// With each in the colour of its room.
std::vector<Vec3> paints_of(const World& world, std::span<const Face> faces, bool rooms) {
    std::vector<Vec3> paints;
    for (const Face& face : faces) paints.push_back(paint_of(face));
    if (!rooms) return paints;
    const std::vector<RoomId> room = rooms_of_faces(faces);
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (is_sky(faces[k])) continue;
        const Vec3 colour = mixed(room_colour(room[k], room_info(world, room[k])->exterior), kWhite, kRoomWhite);
        paints[k] = colour * (faces[k].source_edit != 0 ? kShadeOfNew : 1.0);
    }
    return paints;
}

struct Scene {
    const World& world;
    const Camera& camera;
    const ViewFrame& frame;
    std::span<const Face> faces;
    std::vector<Vec3> paints;  ///< of each face
    const DepthBuffer& buffer;
    Vec3 lamp;
};

/// Red, green and blue of one sample, 0 .. 1.
Vec3 colour_of(const Scene& scene, int x, int y) {
    const DepthBuffer& buffer = scene.buffer;
    const ViewFrame& frame = scene.frame;
    const std::size_t at = buffer.at(x, y);
    if (buffer.face[at] == kNothing) return {};
    const Face& face = scene.faces[buffer.face[at]];
    const Vec3& paint = scene.paints[buffer.face[at]];
    if (is_sky(face)) return paint;
    const Vec3 ray = frame.ray(x, y);
    const Vec3 normal = dot(face.normal, ray) < 0 ? face.normal : -face.normal;
    const Vec3 point = frame.eye + ray * (1 / buffer.nearness[at]) + normal * kLift;
    Vec3 middle;
    for (const Vec3& corner : face.corners) middle = middle + corner * (1.0 / double(face.corners.size()));
    const Vec3 toward = face.source_edit != 0 ? unit_of(scene.lamp - middle) : unit_of(frame.up - frame.right);
    double light = light_on(normal, toward, scene.camera.up);
    if (in_shadow(scene.world, point, scene.lamp)) light *= kShadow;
    if (is_edge(buffer, scene.faces, frame, x, y, x + 1, y) || is_edge(buffer, scene.faces, frame, x, y, x, y + 1))
        light *= kEdgeShade;
    return paint * std::min(light, 1.2);
}

}  // namespace

Picture draw_view(const World& world, const Camera& camera, bool rooms) {
    const std::vector<Face> faces = world.faces();
    const ViewFrame frame(camera, kSamples);
    const DepthBuffer buffer = paint_all(frame, faces);
    const Scene scene{
        world, camera, frame, faces, paints_of(world, faces, rooms), buffer, lamp_of(world, frame, camera)};
    std::optional<Panes> panes;
    if (rooms) panes = paint_portals(world, frame, buffer);
    Picture picture(camera.width, camera.height, {0, 0, 0});
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            Vec3 sum;
            for (int k = 0; k < kSamples * kSamples; ++k) {
                const int column = x * kSamples + k % kSamples, row = y * kSamples + k / kSamples;
                const Vec3 colour = colour_of(scene, column, row);
                sum = sum + (panes ? behind(*panes, buffer, column, row, colour) : colour);
            }
            for (int part = 0; part < 3; ++part)
                picture.at(x, y)[std::size_t(part)] =
                    std::uint8_t(std::clamp(255 * sum[part] / (kSamples * kSamples), 0.0, 255.0));
        }
    return picture;
}

double share_of_new_faces(std::span<const Face> faces, const Camera& camera) {
    const ViewFrame frame(camera, 1);
    const DepthBuffer buffer = paint_all(frame, faces);
    double good = 0;
    for (std::size_t at = 0; at < buffer.face.size(); ++at) {
        if (buffer.face[at] == kNothing) continue;
        if (buffer.nearness[at] * kTooClose > 1) {
            good -= 1;
        } else if (faces[buffer.face[at]].source_edit != 0) {
            good += 1;
        }
    }
    return good / double(buffer.face.size());
}

}  // namespace firma::draw
