// SPDX-License-Identifier: MIT
// What a cut took: how much, and of which faces.
#include "carve/cut_volume.h"

#include <algorithm>

namespace firma {
namespace {

/// Six times the volume between a loop's fan and a point, in cubic input steps.
template <class Corner>
double cone(std::size_t first, std::size_t end, const Vec3& apex, const Corner& corner) {
    const Vec3 a = corner(first) - apex;
    double sum = 0;
    for (std::size_t k = first + 2; k < end; ++k) sum += dot(a, cross(corner(k - 1) - apex, corner(k) - apex));
    return sum;
}

template <class Ends, class Corner>
double cones(const Ends& ends, const Vec3& apex, const Corner& corner) {
    double sum = 0;
    std::size_t first = 0;
    for (const std::uint32_t end : ends) {
        sum += cone(first, end, apex, corner);
        first = end;
    }
    return sum;
}

}  // namespace

double volume_taken(const Cut& cut) {
    const SolidPatch& patch = *cut.patch;
    Vec3 apex;  // near what changes, so that little cancels
    for (int axis = 0; axis < 3; ++axis)
        apex[axis] =
            (double(cut.cutter->box.low[axis]) + double(cut.cutter->box.high[axis])) / (2.0 * kSurfacePerInput);
    double before = 0, after = 0;
    for (const std::uint32_t index : cut.gone) {
        const PatchFace& face = patch.faces[index];
        if (face.replaced) continue;  // only divided: its pieces count, as far as they changed
        const auto uses = patch.uses(face);
        before += cones(patch.ends(face), apex,
                        [&](std::size_t k) { return patch.vertices[patch.from(uses[k])].point.approximate(); });
    }
    for (std::size_t k = 0; k < cut.first_kept; ++k) {
        const NewFace& face = cut.new_faces[k];
        const std::span<const std::uint32_t> ends(cut.loop_ends.data() + face.first_loop, face.loop_count);
        after += cones(ends, apex, [&](std::size_t corner) {
            return cut.point(cut.from(cut.uses[face.first_use + corner])).approximate();
        });
    }
    return (before - after) / 6 / (kInputSteps * kInputSteps * kInputSteps);
}

bool takes_something_of(const Cut& cut, std::uint32_t face) {
    if (cut.patch->faces[face].replaced) return false;  // its pieces are asked
    return true;
}

}  // namespace firma
