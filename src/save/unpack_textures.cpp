// SPDX-License-Identifier: MIT
// How textures lie, of a saved world: every number that anything later relies on is checked.
#include "save/unpack_textures.h"

#include <utility>

#include "geometry/polygon_shape.h"
#include "save/sections.h"

namespace firma {
namespace {

TextureProjection projection_at(const std::byte* at, std::uint32_t unit) {
    const auto axis = [](const std::byte* from) {
        return Vec3{read_f64(from), read_f64(from + 8), read_f64(from + 16)};
    };
    return {axis(at), axis(at + 32), read_f64(at + 24), read_f64(at + 56), TextureUnit(unit)};
}

bool unpack_maps(const Entries& section, std::vector<TextureProjection>& maps, Damage& damage) {
    maps.reserve(section.count());
    for (std::size_t k = 0; k < section.count(); ++k) {
        const std::byte* at = section.at(k);
        const std::uint32_t unit = read_u32(at + 64);
        if (unit > std::uint32_t(TextureUnit::kMetres) || read_u32(at + 68) != 0)
            return damage.report(section.type(), k, "has flags that mean nothing");
        maps.push_back(projection_at(at, unit));
        if (!is_usable(maps.back()))
            return damage.report(section.type(), k, "its numbers are not finite, or too large");
    }
    return true;
}

bool unpack_entries(const Entries& section, std::size_t maps, Entries& outlines,
                    std::vector<FaceTextures::Entry>& faces, Damage& damage) {
    faces.reserve(section.count());
    for (std::size_t k = 0; k < section.count(); ++k) {
        const std::byte* at = section.at(k);
        const FaceTextures::Entry face{read_u32(at), read_u32(at + 4), std::uint32_t(outlines.taken()),
                                       read_u32(at + 8)};
        if (face.projection >= maps) return damage.report(section.type(), k, "names no projection");
        if (face.corner_count != 0 && (face.corner_count < 3 || face.corner_count > std::uint32_t(kMaxCorners)))
            return damage.report(section.type(), k, "does not have 3 to 64 corners, or none");
        if (face.corner_count > outlines.left())
            return damage.report(section.type(), k, "has more corners than there are");
        outlines.take(face.corner_count);
        if (!faces.empty() && face.source <= faces.back().source) {
            if (face.source < faces.back().source) return damage.report(section.type(), k, "is out of order");
            if (face.corner_count == 0 || faces.back().corner_count == 0)
                return damage.report(section.type(), k, "is one of several of a face, and has no outline");
        }
        faces.push_back(face);
    }
    if (outlines.left() > 0) return damage.report(outlines.type(), outlines.taken(), "belongs to no face");
    return true;
}

}  // namespace

std::shared_ptr<const FaceTextures> unpack_textures(Sections& sections, Damage& damage) {
    if (!sections.has(kTextureMapsSection)) return nullptr;
    const Entries maps = sections.entries(kTextureMapsSection, kTextureMapBytes);
    const Entries faces = sections.entries(kTexturedFacesSection, kTexturedFaceBytes);
    Entries outlines = sections.entries(kTextureOutlinesSection, kPointBytes);
    std::vector<TextureProjection> projections;
    std::vector<FaceTextures::Entry> entries;
    if (damage.error() || !unpack_maps(maps, projections, damage) ||
        !unpack_entries(faces, projections.size(), outlines, entries, damage))
        return nullptr;
    std::vector<GridPoint> corners(outlines.count());
    for (std::size_t k = 0; k < corners.size(); ++k)
        for (int axis = 0; axis < 3; ++axis) corners[k][axis] = read_i32(outlines.at(k) + 4 * axis);
    return std::make_shared<const FaceTextures>(std::move(projections), std::move(entries), std::move(corners));
}

}  // namespace firma
