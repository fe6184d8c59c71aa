// SPDX-License-Identifier: MIT
// How the world lies on a page: along an axis, to scale, without perspective.
#pragma once

#include <cmath>

#include "draw/svg_text.h"
#include "firma/vec.h"

namespace firma::draw {

/// Cosine of the angle to the viewer: what is seen more edge-on than this may be turned either way by the rounding of
/// its unit normal, and shows nothing.
inline constexpr double kEdgeOn = 1e-9;

struct View {
    int across = 0;     ///< axis of the world that runs to the right
    int upward = 1;     ///< axis that runs up the page
    int depth = 2;      ///< axis that the viewer looks along ...
    double toward = 1;  ///< ... 1 when it points at the viewer, -1 when away
    Box region;         ///< what is shown, metres
    double scale = 1;   ///< pixels a metre
    PagePoint corner;   ///< page position of the region's low corner, bottom left

    double width() const { return (region.high[across] - region.low[across]) * scale; }
    double height() const { return (region.high[upward] - region.low[upward]) * scale; }

    PagePoint place(const Vec3& p) const {
        return {corner.x + (p[across] - region.low[across]) * scale,
                corner.y - (p[upward] - region.low[upward]) * scale};
    }
    /// Cosine of the angle between a face's normal and the way to the viewer.
    double facing(const Vec3& normal) const { return toward * normal[depth]; }
    bool sees(const Vec3& normal, bool two_sided) const {
        return two_sided ? std::fabs(facing(normal)) > kEdgeOn : facing(normal) > kEdgeOn;
    }
    /// The larger, the nearer to the viewer; metres.
    double nearness(const Vec3& p) const { return toward * p[depth]; }
};

/// A straight line of the page, cut off at the borders of a view.
struct PageLine {
    PagePoint from, to;
    bool from_cut = false, to_cut = false;  ///< the end lies outside of the view
    bool visible = false;
};
PageLine cut_to_view(const View& view, const Vec3& from, const Vec3& to);

inline constexpr const char* kAxisNames[] = {"x", "y", "z"};

}  // namespace firma::draw
