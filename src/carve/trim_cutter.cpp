// SPDX-License-Identifier: MIT
// A cutter without what may not be carved: by cuts of Solids.
#include "carve/trim_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/flat_map.h"
#include "carve/gather.h"
#include "geometry/exact_plane.h"
#include "solid/solid_data.h"
#include "solid/solid_patch.h"

namespace firma {
namespace {

/// The first edit of a Solid that was empty.
constexpr std::uint32_t kOfCutter = 1;

}  // namespace

std::optional<Cutter> box_shield(const Box& box, const GridBox& around) {
    InputPoint low, high;
    for (int axis = 0; axis < 3; ++axis) {
        const double first = std::max(double(around.low[axis]) / kSurfacePerInput - kInputSteps, -double(kRimSteps)),
                     last = std::min(double(around.high[axis]) / kSurfacePerInput + kInputSteps, kRimSteps - 1.0);
        low[axis] = std::int32_t(std::floor(std::max(box.low[axis] * kInputSteps, first)));
        high[axis] = std::int32_t(std::ceil(std::min(box.high[axis] * kInputSteps, last)));
        if (low[axis] >= high[axis]) return std::nullopt;
    }
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) {
        const InputPoint corner{k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
        corners.push_back(to_metres(to_surface(corner)));
    }
    constexpr CutterTriangle kTriangles[] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                             {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    Result<Cutter> made = make_cutter(corners, kTriangles);
    if (!made) return std::nullopt;
    return std::move(made).value();
}

Result<TrimmedCutter> trim_cutter(const Cutter& cutter, const Pose& pose, std::span<const CutShield> shields) {
    TrimmedCutter trimmed;
    SolidResult whole = unite(Solid(), cutter, pose);
    if (!whole.done()) return whole.error;
    trimmed.solid = std::move(whole.solid);
    for (const CutShield& shield : shields) {
        SolidResult less = subtract(trimmed.solid, shield.cutter, {});
        if (less.status == CarveStatus::kRefused) return less.error;
        if (!less.done()) continue;
        if (trimmed.shields++ == 0) trimmed.first = shield.name;
        trimmed.solid = std::move(less.solid);
        if (trimmed.solid.face_count() == 0) break;
    }
    return trimmed;
}

std::vector<std::uint32_t> triangles_of_trimmed(const Solid& solid) {
    std::vector<std::uint32_t> triangles;
    SolidPatch patch;
    patch.add(all_facets(solid.data().faces.root.get()));
    for (const PatchFace& face : patch.faces) {
        const FaceRecord& record = face.facet.record();
        triangles.push_back(record.edit == kOfCutter ? record.source : ~0u);
    }
    return triangles;
}

}  // namespace firma
