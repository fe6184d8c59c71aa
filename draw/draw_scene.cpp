// SPDX-License-Identifier: MIT
// Colour of each sample: paint, light of the sky by how much of it is open, the lamp where nothing stands between, and
// the light of flashes; then what is in the air.
#include "draw/draw_scene.h"
#include "firma/queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "draw/room_colours.h"
#include "draw/scene_faces.h"
#include "draw/view_raster.h"
#include "firma/turn.h"

namespace firma::draw {

namespace {

constexpr int kGrid = 2;                                // samples along each side of a pixel
constexpr double kOff = 0.004;                          // metres from a face to where its rays begin
constexpr double kOpenReach = 1.5;                      // metres: what is nearer takes light of the sky
constexpr int kOpenRays = 18;                           // of a pixel
constexpr double kSkyLight = 0.62, kClosedLight = 0.3;  // in the open, and in a corner
constexpr double kLampLight = 0.52;
constexpr double kUpLight = 0.06;  // more from above, less from below
constexpr double kLine = 0.62;     // of the light, on an edge
constexpr double kFlashReach = 7;  // in radii of a puff: so far its light is looked at
constexpr double kBrightest = 1.25;

/// Even over the half sphere around z, more where it is steep: a spiral.
std::array<Vec3, kOpenRays> open_rays() {
    constexpr double kGolden = 2.399963229728653;
    std::array<Vec3, kOpenRays> rays;
    for (int k = 0; k < kOpenRays; ++k) {
        const double square = (k + 0.5) / kOpenRays, out = std::sqrt(square);
        const SineCosine turn = sine_cosine(kGolden * k);
        rays[std::size_t(k)] = {out * turn.cosine, out * turn.sine, std::sqrt(1 - square)};
    }
    return rays;
}

class SceneLight {
public:
    SceneLight(const World& world, const SceneFaces& scene, const DrawnThings& things, const Camera& camera,
               const Vec3& lamp)
        : world_(world), scene_(scene), puffs_(things.puffs), camera_(camera), lamp_(lamp), rays_(open_rays()) {}

    /// Red, green and blue of a point of a face, without its edges.
    Vec3 on(std::uint32_t which, const Vec3& point, const Vec3& normal, double open) const {
        const Vec3 from = point + normal * kOff, to_lamp = lamp_ - from;
        double light = (kClosedLight + (kSkyLight - kClosedLight) * open) + kUpLight * normal[camera_.up];
        const double facing = dot(normal, unit_of(to_lamp));
        if (facing > 0 && is_free(from, to_lamp)) light += kLampLight * facing;
        Vec3 sum = Vec3{1, 1, 1} * light;
        for (const DrawnPuff& puff : puffs_) sum = sum + flash(puff, from, normal);
        const Vec3& paint = scene_.paints[which];
        return {paint.x * sum.x, paint.y * sum.y, paint.z * sum.z};
    }

    /// The share of the sky that nothing near covers.
    double open_share(const Vec3& point, const Vec3& normal) const {
        const Vec3 from = point + normal * kOff;
        const Vec3 side = unit_of(cross(normal, std::fabs(normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
        const Vec3 front = cross(normal, side);
        int open = 0;
        for (const Vec3& ray : rays_)
            open += is_free(from, (side * ray.x + front * ray.y + normal * ray.z) * kOpenReach);
        return double(open) / kOpenRays;
    }

private:
    bool is_free(const Vec3& from, const Vec3& path) const {
        CastOptions opaque;
        opaque.mask = kStopsSight;
        return cast_any(scene_.things, Ray{from, path}, opaque) == Status::kMiss &&
               cast_any(world_, Ray{from, path}, opaque) == Status::kMiss;
    }

    Vec3 flash(const DrawnPuff& puff, const Vec3& from, const Vec3& normal) const {
        if (puff.light == 0) return {};
        const Vec3 way = puff.at - from;
        const double far = length(way) / puff.radius;
        if (far > kFlashReach || far == 0) return {};
        const double facing = dot(normal, unit_of(way)), fades = 1 - far / kFlashReach;
        if (facing <= 0 || !is_free(from, way * 0.95)) return {};
        return puff.colour * (puff.light * facing * fades * fades);
    }

    const World& world_;
    const SceneFaces& scene_;
    std::span<const DrawnPuff> puffs_;
    const Camera& camera_;
    const Vec3 lamp_;
    const std::array<Vec3, kOpenRays> rays_;
};

/// A puff on the screen.
struct PuffDisc {
    double column, row, radius, nearness;
    const DrawnPuff* puff;
};
std::vector<PuffDisc> discs_of(std::span<const DrawnPuff> puffs, const ViewFrame& frame) {
    std::vector<PuffDisc> discs;
    for (const DrawnPuff& puff : puffs) {
        const Vec3 seen = frame.seen(puff.at);
        if (seen.z < 4 * kNear) continue;
        const double radius = puff.radius / (seen.z * frame.half) * frame.width / 2;
        discs.push_back({frame.column(seen), frame.row(seen), radius, 1 / seen.z, &puff});
    }
    std::sort(discs.begin(), discs.end(), [](const PuffDisc& a, const PuffDisc& b) {
        return std::tie(a.nearness, a.puff) < std::tie(b.nearness, b.puff);
    });
    return discs;
}

Vec3 through_puffs(std::span<const PuffDisc> discs, double nearness, double x, double y, Vec3 colour) {
    for (const PuffDisc& disc : discs) {
        const double across = (x - disc.column) / disc.radius, down = (y - disc.row) / disc.radius;
        const double square = across * across + down * down;
        if (square >= 1) continue;
        // What stands in the ball is hidden by the part before it.
        const double thick = disc.puff->radius * std::sqrt(1 - square);
        const double free = nearness > 0 ? 1 / nearness - 1 / disc.nearness + thick : 2 * thick;
        const double share = std::clamp(free / (2 * thick), 0.0, 1.0) * (1 - square) * (1 - square);
        colour = mixed(colour, disc.puff->colour, disc.puff->cover * share);
        colour = colour + disc.puff->colour * (disc.puff->light * share);
    }
    return colour;
}

/// In steps that nobody sees, as files are a third smaller so.
std::uint8_t rounded(double part) {
    constexpr double kStep = 4;
    return std::uint8_t(std::clamp(std::floor(part / kStep + 0.5) * kStep, 0.0, 255.0));
}

/// One picture's rows, which threads share.
struct SceneRows {
    const SceneFaces& scene;
    const ViewFrame& frame;
    const DepthBuffer& buffer;
    const SceneLight& light;
    std::span<const PuffDisc> discs;
    Picture& picture;

    Vec3 sample(int column, int row, std::uint32_t& open_of, double& open) const {
        const std::size_t at = buffer.at(column, row);
        const std::uint32_t which = buffer.face[at];
        Vec3 colour;
        if (which != kNothing) {
            const Face& face = scene.faces[which];
            colour = is_sky(face) ? kSkyColour : lit(column, row, which, open_of, open);
        }
        return through_puffs(discs, buffer.nearness[at], column + 0.5, row + 0.5, colour);
    }

    /// @param open_of, open  the face that its share of the sky was last asked for, in this pixel
    Vec3 lit(int column, int row, std::uint32_t which, std::uint32_t& open_of, double& open) const {
        const Face& face = scene.faces[which];
        const Vec3 ray = frame.ray(column, row);
        const Vec3 normal = dot(face.normal, ray) < 0 ? face.normal : -face.normal;
        const Vec3 point = frame.eye + ray * (1 / buffer.nearness[buffer.at(column, row)]);
        if (open_of != which) {
            open = light.open_share(point, normal);
            open_of = which;
        }
        const Vec3 colour = light.on(which, point, normal, open);
        const bool edge = is_edge(buffer, scene.faces, frame, column, row, column + 1, row) ||
                          is_edge(buffer, scene.faces, frame, column, row, column, row + 1);
        return edge ? colour * kLine : colour;
    }

    void draw(int y) const {
        for (int x = 0; x < picture.width; ++x) {
            Vec3 sum;
            std::uint32_t open_of = kNothing;
            double open = 1;
            for (int k = 0; k < kGrid * kGrid; ++k) {
                const Vec3 colour = sample(x * kGrid + k % kGrid, y * kGrid + k / kGrid, open_of, open);
                for (int part = 0; part < 3; ++part) sum[part] += std::min(colour[part], kBrightest);
            }
            for (int part = 0; part < 3; ++part)
                picture.at(x, y)[std::size_t(part)] = rounded(255 * sum[part] / (kGrid * kGrid));
        }
    }
};

void draw_row(void* rows, std::size_t y) {
    static_cast<const SceneRows*>(rows)->draw(int(y));
}

}  // namespace

Picture draw_scene(const World& world, const DrawnThings& things, const Camera& camera, const Vec3& lamp,
                   const Tasks* tasks) {
    const SceneFaces scene = scene_faces(world, things);
    const ViewFrame frame(camera, kGrid);
    const DepthBuffer buffer = paint_all(frame, scene.faces);
    const SceneLight light(world, scene, things, camera, lamp);
    const std::vector<PuffDisc> discs = discs_of(things.puffs, frame);
    Picture picture(camera.width, camera.height, {0, 0, 0});
    SceneRows rows{scene, frame, buffer, light, discs, picture};
    if (tasks) {
        tasks->run(std::size_t(picture.height), draw_row, &rows, tasks->user);
    } else {
        for (int y = 0; y < picture.height; ++y) rows.draw(y);
    }
    return picture;
}

}  // namespace firma::draw
