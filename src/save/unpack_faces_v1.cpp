// SPDX-License-Identifier: MIT
// The faces of a world saved by version 1 of the format: block by block, room by room. How those blocks made trees is
// passed over, as worlds build their own.
#include "geometry/polygon_shape.h"
#include "save/sections.h"
#include "save/unpack_faces.h"

namespace firma {
namespace {

constexpr std::uint16_t kOwnFaceV1 = 0xFFFF;  // in place of an owner: the face is its own exact face

class BlockReader {
public:
    BlockReader(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact, Damage& damage)
        : data_(data), exact_(exact), damage_(damage) {
        rooms_ = sections.entries(kRoomsSection, 4);
        blocks_ = sections.entries(kBlocksSection, kBlockBytesOfVersion1);
        bins_ = sections.entries(kBinsSection, kBinBytes);
        faces_ = sections.entries(kFacesSection, kFaceBytesOfVersion1);
        vertices_ = sections.entries(kVerticesSection, kPointBytes);
        corners_ = sections.entries(kCornersSection, 2);
        if (data.exact) owners_ = sections.entries(kOwnersSection, 4);
    }

    FaceSet read() {
        if (damage_.error()) return {};
        if (rooms_.count() != data_.rooms)
            return damage_.report(rooms_.type(), "has not as many entries as rooms"), FaceSet();
        if (faces_.count() != data_.faces)
            return damage_.report(faces_.type(), "has not as many entries as faces"), FaceSet();
        for (room_ = 0; room_ < data_.rooms; ++room_) {
            const std::uint32_t count = read_u32(rooms_.at(room_));
            if (count > blocks_.left())
                return damage_.report(rooms_.type(), room_, "has more blocks than there are"), FaceSet();
            for (std::uint32_t k = 0; k < count; ++k)
                if (!read_block()) return {};
        }
        for (const Entries* part : {&blocks_, &bins_, &faces_, &vertices_, &corners_, &owners_})
            if (part->left() > 0) damage_.report(part->type(), part->taken(), "belongs to no block and no room");
        for (std::size_t k = 0; k < exact_.size(); ++k)
            if (exact_[k]->facets == 0) damage_.report(kExactFacesSection, k, "has no facets");
        return std::move(read_);
    }

private:
    bool read_block() {
        const std::byte* at = blocks_.take(1);
        const std::uint32_t bins = read_u16(at), children = read_u16(at + 2), faces = read_u16(at + 4),
                            vertices = read_u16(at + 6), corners = read_u16(at + 8), owners = read_u16(at + 10);
        const auto fault = [&](const char* reason) {
            return damage_.report(blocks_.type(), blocks_.taken() - 1, reason);
        };
        if ((children == 0) == (faces == 0)) return fault("holds both faces and blocks, or neither");
        if (bins > bins_.left() || faces > faces_.left() || vertices > vertices_.left() || corners > corners_.left() ||
            owners > owners_.left())
            return fault("holds more than there is");
        bins_.take(bins);
        FaceSet& set = read_;
        first_vertex_ = std::uint32_t(set.vertices.size());
        at = vertices_.take(vertices);
        for (std::uint32_t k = 0; k < vertices; ++k, at += kPointBytes)
            set.vertices.push_back({read_i32(at), read_i32(at + 4), read_i32(at + 8)});
        const std::size_t first_corner = corners_.taken();
        of_block_.clear();
        at = corners_.take(corners);
        for (std::uint32_t k = 0; k < corners; ++k) {
            of_block_.push_back(read_u16(at + 2 * k));
            if (of_block_.back() >= vertices)
                return damage_.report(corners_.type(), first_corner + k, "names a vertex that is not there");
        }
        of_block_owners_.clear();
        for (std::uint32_t k = 0; k < owners; ++k) {
            const std::size_t entry = owners_.taken();
            of_block_owners_.push_back(read_u32(owners_.take(1)));
            if (of_block_owners_.back() >= exact_.size())
                return damage_.report(owners_.type(), entry, "names an exact face that is not there");
        }
        for (std::uint32_t k = 0; k < faces; ++k)
            if (!read_face()) return false;
        return true;
    }

    bool read_face() {
        const std::size_t entry = faces_.taken();
        const std::byte* at = faces_.take(1);
        FaceSet& set = read_;
        FaceSet::Entry face;
        face.id = {read_u32(at)};
        face.source = read_u32(at + 4);
        face.edit = read_u32(at + 8);
        face.material = read_u32(at + 12);
        face.mask = read_u32(at + 16);
        const std::uint32_t first = read_u16(at + 20), owner = read_u16(at + 22);
        face.corner_count = std::uint8_t(at[24]);
        const auto flags = std::uint8_t(at[25]);
        face.two_sided = flags & kTwoSidedFace;
        face.solid = flags & kSolidFace;
        face.part = std::uint32_t(room_);
        const auto fault = [&](const char* reason) { return damage_.report(faces_.type(), entry, reason); };
        if (face.corner_count < 3 || face.corner_count > std::uint32_t(kMaxCorners))
            return fault("does not have 3 to 64 corners");
        if (face.material >= data_.material_count()) return fault("has a material that is not there");
        if (std::size_t(first) + face.corner_count > of_block_.size()) return fault("has corners that are not there");
        if (owner != kOwnFaceV1 && owner >= of_block_owners_.size())
            return fault("has an exact face that is not there");
        if (owner != kOwnFaceV1 && !face.solid) return fault("bounds no solid, and yet has an exact face");
        if (flags > (kTwoSidedFace | kSolidFace) || read_u16(at + 26) != 0) return fault("has flags that mean nothing");
        if (owner != kOwnFaceV1) {
            face.owner = exact_[of_block_owners_[owner]].get();
            ++exact_[of_block_owners_[owner]]->facets;
        }
        face.first_corner = std::uint32_t(set.corners.size());
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            set.corners.push_back(first_vertex_ + of_block_[first + k]);
        set.faces.push_back(face);
        return true;
    }

    const UnpackedData& data_;
    std::span<const Ref<SolidFace>> exact_;
    Damage& damage_;
    Entries rooms_, blocks_, bins_, faces_, vertices_, corners_, owners_;
    std::size_t room_ = 0;
    std::uint32_t first_vertex_ = 0;
    std::vector<std::uint32_t> of_block_, of_block_owners_;
    FaceSet read_;
};

}  // namespace

FaceSet unpack_faces_of_version_1(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact,
                                  Damage& damage) {
    return BlockReader(sections, data, exact, damage).read();
}

}  // namespace firma
