// SPDX-License-Identifier: MIT
// The centre's path, clipped to the half spaces of a prism around the polygon.
#include "world/reach_portal.h"

namespace firma {
namespace {

/// The times at which the centre is in all half spaces so far.
struct Span {
    double from, to;

    /// Keeps those with start + t * change <= limit. What rounding moves here, it moves by its share of the height,
    /// which the limit has room for.
    void clip(double start, double change, double limit) {
        if (change > 0) {
            const double until = (limit - start) / change;
            to = until < to ? until : to;
        } else if (change < 0) {
            const double since = (limit - start) / change;
            from = since > from ? since : from;
        } else if (start > limit) {
            to = -1;
        }
    }
    bool empty() const { return !(from <= to); }
};

}  // namespace

bool reaches_portal(const Sweep& sweep, const PolygonShape& polygon, double grown, double latest, double& nearest) {
    Span span{0, latest};
    const double height = dot(polygon.normal, sweep.start - polygon.corners[0]);
    const double rise = dot(polygon.normal, sweep.direction);
    span.clip(height, rise, grown * polygon.normal_length);
    span.clip(-height, -rise, grown * polygon.normal_length);
    for (std::size_t k = 0; k < polygon.corners.size() && !span.empty(); ++k) {
        const Vec3& corner = polygon.corners[k];
        const Vec3 outward = cross(polygon.corners[polygon.next(k)] - corner, polygon.normal);
        span.clip(dot(outward, sweep.start - corner), dot(outward, sweep.direction), grown * length(outward));
    }
    nearest = span.from;
    return !span.empty();
}

}  // namespace firma
