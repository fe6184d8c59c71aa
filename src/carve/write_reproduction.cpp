// SPDX-License-Identifier: MIT
// What it takes to see a failed cut again.
#include "carve/write_reproduction.h"

#include "base/decimal.h"

namespace firma {

std::string write_reproduction(const SolidPatch& patch, const CutterSolid& cutter) {
    std::string text = "# faces that a cut tested, and the cutter\n";
    const auto vertex = [&](const GridPoint& p) {
        text += "v " + exact_decimal(p.x) + ' ' + exact_decimal(p.y) + ' ' + exact_decimal(p.z) + '\n';
    };
    for (const PatchVertex& v : patch.vertices) vertex(v.point.rounded());
    for (const ExactPoint& p : cutter.points) vertex(p.rounded());
    text += "g solid\n";
    for (const PatchFace& face : patch.faces) {
        if (face.parent != ~0u) continue;
        std::uint32_t k = 0;
        for (const std::uint32_t end : patch.ends(face)) {
            text += 'f';
            for (; k < end; ++k) text += ' ' + std::to_string(patch.from(patch.uses(face)[k]) + 1);
            text += '\n';
        }
    }
    text += "g cutter\n";
    for (const CutterTriangle& triangle : cutter.placed.triangles) {
        text += 'f';
        for (const std::uint32_t v : triangle) text += ' ' + std::to_string(patch.vertices.size() + v + 1);
        text += '\n';
    }
    return text;
}

}  // namespace firma
