// SPDX-License-Identifier: MIT
// The faces of a saved world, in order of id.
#include "save/unpack_faces.h"

#include "geometry/polygon_shape.h"
#include "save/sections.h"

namespace firma {
namespace {

class FaceReader {
public:
    FaceReader(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact, Damage& damage)
        : data_(data), exact_(exact), damage_(damage) {
        faces_ = sections.entries(kFacesSection, kFaceBytes);
        vertices_ = sections.entries(kVerticesSection, kPointBytes);
        corners_ = sections.entries(kCornersSection, 4);
    }

    FaceSet read() {
        FaceSet read;
        if (damage_.error()) return read;
        if (faces_.count() != data_.faces)
            return damage_.report(faces_.type(), "has not as many entries as faces"), read;
        read.vertices.resize(vertices_.count());
        for (std::size_t k = 0; k < vertices_.count(); ++k) {
            const std::byte* at = vertices_.at(k);
            read.vertices[k] = {read_i32(at), read_i32(at + 4), read_i32(at + 8)};
        }
        read.faces.reserve(faces_.count());
        read.corners.reserve(corners_.count());
        for (std::size_t k = 0; k < faces_.count(); ++k)
            if (!read_face(k, read)) return read;
        if (corners_.left() > 0) damage_.report(corners_.type(), corners_.taken(), "belongs to no face");
        for (std::size_t k = 0; k < exact_.size(); ++k)
            if (exact_[k]->facets == 0) damage_.report(kExactFacesSection, k, "has no facets");
        return read;
    }

private:
    bool read_face(std::size_t entry, FaceSet& set) {
        const std::byte* at = faces_.at(entry);
        FaceSet::Entry face;
        face.id = {read_u32(at)};
        face.source = read_u32(at + 4);
        face.edit = read_u32(at + 8);
        face.material = read_u32(at + 12);
        face.mask = read_u32(at + 16);
        face.part = read_u32(at + 20);
        const std::uint32_t owner = read_u32(at + 24);
        face.corner_count = std::uint8_t(at[28]);
        const auto flags = std::uint8_t(at[29]);
        face.two_sided = flags & kTwoSidedFace;
        face.solid = flags & kSolidFace;
        const auto fault = [&](const char* reason) { return damage_.report(faces_.type(), entry, reason); };
        if (face.corner_count < 3 || face.corner_count > std::uint32_t(kMaxCorners))
            return fault("does not have 3 to 64 corners");
        if (face.material >= data_.material_count()) return fault("has a material that is not there");
        if (face.corner_count > corners_.left()) return fault("has corners that are not there");
        if (face.part >= data_.rooms) return fault("lies in a room that is not there");
        if (!set.faces.empty() && !(set.faces.back().id < face.id))
            return fault("does not have a higher id than the last");
        if (flags > (kTwoSidedFace | kSolidFace) || read_u16(at + 30) != 0) return fault("has flags that mean nothing");
        if (owner != kOwnFace && owner >= exact_.size()) return fault("has an exact face that is not there");
        if (owner != kOwnFace && !face.solid) return fault("bounds no solid, and yet has an exact face");
        if (owner != kOwnFace) {
            face.owner = exact_[owner].get();
            ++exact_[owner]->facets;
        }
        face.first_corner = std::uint32_t(set.corners.size());
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const std::size_t corner = corners_.taken();
            const std::uint32_t vertex = read_u32(corners_.take(1));
            if (vertex >= set.vertices.size())
                return damage_.report(corners_.type(), corner, "names a vertex that is not there");
            set.corners.push_back(vertex);
        }
        set.faces.push_back(face);
        return true;
    }

    const UnpackedData& data_;
    std::span<const Ref<SolidFace>> exact_;
    Damage& damage_;
    Entries faces_, vertices_, corners_;
};

}  // namespace

FaceSet unpack_faces(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact,
                     Damage& damage) {
    return FaceReader(sections, data, exact, damage).read();
}

}  // namespace firma
