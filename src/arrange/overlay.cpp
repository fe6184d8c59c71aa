// SPDX-License-Identifier: MIT
// The faces of several solids laid over each other.
#include "arrange/overlay.h"

namespace firma {

std::uint32_t Overlay::add_face(PlaneId plane, std::uint8_t operand, std::span<const OverlaySide> sides,
                                std::span<const std::uint32_t> ends) {
    OverlayFace face;
    face.plane = plane;
    face.operand = operand;
    face.first_side = std::uint32_t(all_sides.size());
    face.side_count = std::uint32_t(sides.size());
    face.first_loop = std::uint32_t(loop_ends.size());
    face.loop_count = std::uint32_t(ends.size());
    for (const OverlaySide& side : sides) face.box.add(point(from(side)).rounded());
    all_sides.insert(all_sides.end(), sides.begin(), sides.end());
    loop_ends.insert(loop_ends.end(), ends.begin(), ends.end());
    faces.push_back(face);
    return std::uint32_t(faces.size()) - 1;
}

}  // namespace firma
