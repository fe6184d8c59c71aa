// SPDX-License-Identifier: MIT
// Faces are cut off before the eye, then filled row by row; the nearest wins.
#include "draw/view_raster.h"

namespace firma::draw {

namespace {

// Squared sine of a view to upward, below which they give no side to the right: at a millionth of a radian that still
// has ten good digits.
constexpr double kUpright = 1e-12;
constexpr double kTurn = 0.95;  // cosine of the angle from which on a turn of the surface is an edge
constexpr double kJump = 0.02;  // of the depth: what lies farther behind its neighbour is another surface

}  // namespace

ViewFrame::ViewFrame(const Camera& camera, int samples)
    : eye(camera.eye), width(camera.width * samples), height(camera.height * samples), half(1 / camera.zoom) {
    forward = unit_of(camera.target - camera.eye);
    Vec3 upward;
    upward[camera.up] = 1;
    right = cross(forward, upward);
    if (dot(right, right) < kUpright) {  // straight up or down: any side will do
        upward = {};
        upward[(camera.up + 1) % 3] = 1;
        right = cross(forward, upward);
    }
    right = unit_of(right);
    up = cross(right, forward);
}

std::vector<Vec3> before_eye(const ViewFrame& frame, std::span<const Vec3> corners) {
    std::vector<Vec3> seen, kept;
    for (const Vec3& corner : corners) seen.push_back(frame.seen(corner));
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const Vec3 &a = seen[k], &b = seen[(k + 1) % seen.size()];
        if (a.z >= kNear) kept.push_back(a);
        if ((a.z >= kNear) != (b.z >= kNear)) kept.push_back(a + (b - a) * ((kNear - a.z) / (b.z - a.z)));
    }
    return kept;
}

ColumnSpan covered(const std::vector<PagePoint>& outline, double y, int width) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const PagePoint &a = outline[k], &b = outline[(k + 1) % outline.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
        low = std::min(low, x);
        high = std::max(high, x);
    }
    if (!(low < high)) return {};
    const double first = std::clamp(std::floor(low + 0.5), 0.0, double(width));
    const double end = std::clamp(std::floor(high + 0.5), 0.0, double(width));
    return {int(first), int(end)};
}

bool seen_from(const Vec3& eye, const Face& face) {
    if ((face.mask & kSeen) == 0) return false;
    const double side = dot(face.normal, eye - face.corners[0]);
    return face.two_sided ? side != 0 : side > 0;
}

DepthBuffer paint_all(const ViewFrame& frame, std::span<const Face> faces) {
    DepthBuffer buffer(int(frame.width), int(frame.height));
    for (std::size_t k = 0; k < faces.size(); ++k) {
        if (!seen_from(frame.eye, faces[k])) continue;
        paint(frame, faces[k], buffer, [&](std::size_t at, double nearness) {
            if (!(nearness > buffer.nearness[at])) return;
            buffer.nearness[at] = nearness;
            buffer.face[at] = std::uint32_t(k);
        });
    }
    return buffer;
}

bool is_edge(const DepthBuffer& buffer, std::span<const Face> faces, const ViewFrame& frame, int x, int y, int other_x,
             int other_y) {
    if (other_x >= buffer.width || other_y >= buffer.height) return false;
    const std::size_t here = buffer.at(x, y), there = buffer.at(other_x, other_y);
    const std::uint32_t a = buffer.face[here], b = buffer.face[there];
    if (a == b) return false;
    if (a == kNothing || b == kNothing) return true;
    if (dot(faces[a].normal, faces[b].normal) < kTurn) return true;
    // How near the plane of the one would be at the other.
    const Vec3& corner = faces[a].corners[0];
    const double plane = dot(faces[a].normal, frame.ray(other_x, other_y)) / dot(faces[a].normal, corner - frame.eye);
    return std::fabs(plane - buffer.nearness[there]) > kJump * buffer.nearness[there];
}

}  // namespace firma::draw
