// SPDX-License-Identifier: MIT
// Perspective: where a camera sees a point, and which face is nearest in each sample of a picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "draw/draw_view.h"
#include "draw/svg_text.h"
#include "firma/level.h"
#include "firma/world.h"

namespace firma::draw {

inline constexpr double kNear = 0.02;  // metres before the eye: nothing nearer is seen
inline constexpr std::uint32_t kNothing = ~0u;
inline constexpr std::uint32_t kSeen = kStopsSight | kStopsLiquid;

inline Vec3 unit_of(const Vec3& v) {
    return v * (1 / length(v));
}

/// The camera's own axes, right-handed.
struct ViewFrame {
    Vec3 eye, right, up, forward;
    double width, height;  ///< samples
    double half;           ///< half the picture's width at distance 1

    /// @param samples  along each side of a pixel
    ViewFrame(const Camera& camera, int samples);

    /// Right, up, forward.
    Vec3 seen(const Vec3& point) const {
        const Vec3 p = point - eye;
        return {dot(p, right), dot(p, up), dot(p, forward)};
    }
    double column(const Vec3& p) const { return width / 2 * (1 + p.x / (p.z * half)); }
    double row(const Vec3& p) const { return height / 2 - width / 2 * p.y / (p.z * half); }
    /// Through the middle of a sample; its part along `forward` is 1.
    Vec3 ray(double x, double y) const {
        const double a = (x + 0.5) * 2 / width - 1, b = (height - 2 * (y + 0.5)) / width;
        return forward + right * (a * half) + up * (b * half);
    }
};

/// What each sample sees: the nearest face, and one over its distance.
struct DepthBuffer {
    int width, height;
    std::vector<double> nearness;
    std::vector<std::uint32_t> face;

    DepthBuffer(int wide, int high)
        : width(wide), height(high), nearness(std::size_t(wide) * std::size_t(high)), face(nearness.size(), kNothing) {}
    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

/// The corners before the eye, as ViewFrame::seen() has them.
std::vector<Vec3> before_eye(const ViewFrame& frame, std::span<const Vec3> corners);

/// The columns whose middles a convex outline covers in a row.
struct ColumnSpan {
    int first = 0, end = 0;
};
ColumnSpan covered(const std::vector<PagePoint>& outline, double y, int width);

/// Clips are not seen, and glass is looked through.
bool seen_from(const Vec3& eye, const Face& face);

/// Calls put(sample, nearness) for each sample that a face covers.
template <class Put>
void paint(const ViewFrame& frame, const Face& face, const DepthBuffer& buffer, const Put& put) {
    std::vector<PagePoint> outline;
    double top = INFINITY, bottom = -INFINITY;
    for (const Vec3& corner : before_eye(frame, face.corners)) {
        outline.push_back({frame.column(corner), frame.row(corner)});
        top = std::min(top, outline.back().y);
        bottom = std::max(bottom, outline.back().y);
    }
    if (outline.size() < 3) return;
    const double away = dot(face.normal, face.corners[0] - frame.eye);
    const int first_row = int(std::clamp(std::floor(top), 0.0, double(buffer.height)));
    const int last_row = int(std::clamp(std::floor(bottom) + 1, 0.0, double(buffer.height)));
    for (int y = first_row; y < last_row; ++y) {
        const ColumnSpan span = covered(outline, y + 0.5, buffer.width);
        for (int x = span.first; x < span.end; ++x) {
            const double nearness = dot(face.normal, frame.ray(x, y)) / away;  // of the plane: one over the distance
            if (nearness <= 1.001 / kNear) put(buffer.at(x, y), nearness);
        }
    }
}

DepthBuffer paint_all(const ViewFrame& frame, std::span<const Face> faces);

/// Whether the surface turns or ends between two samples side by side.
bool is_edge(const DepthBuffer& buffer, std::span<const Face> faces, const ViewFrame& frame, int x, int y, int other_x,
             int other_y);

inline constexpr Vec3 kSkyColour{0.70, 0.80, 0.90};
/// Faces of formats that know no contents have every bit.
inline bool is_sky(const Face& face) {
    return (face.mask & kIsSky) != 0 && face.mask != ~0u;
}

}  // namespace firma::draw
