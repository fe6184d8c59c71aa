// SPDX-License-Identifier: MIT
// Facets on their way into sections.
#pragma once

#include "base/point_numbers.h"
#include "save/exact_packer.h"
#include "solid/block.h"

namespace firma {

/// Of three 32-bit coordinates.
template <class Point>
void put_point(ByteWriter& out, const Point& point) {
    for (int axis = 0; axis < 3; ++axis) out.i32(point[axis]);
}

class FacePacker {
public:
    /// @param exact  null: without exact faces, and without solids
    explicit FacePacker(ExactPacker* exact) : exact_(exact) {}

    /// In order of id.
    void add(const FacetPlace& place, std::uint32_t room) {
        const FaceRecord& face = place.record();
        const auto* owner = static_cast<const SolidFace*>(place.block->owner_of(face));
        for (const std::uint32_t number : {face.id.value, face.source, face.edit, face.material, face.mask, room})
            faces_.u32(number);
        faces_.u32(exact_ && owner ? exact_->number(owner) : kOwnFace);
        faces_.u8(face.corner_count);
        faces_.u8(std::uint8_t((face.two_sided ? kTwoSidedFace : 0) | (face.solid && exact_ ? kSolidFace : 0)));
        faces_.u16(0);
        for (std::uint32_t k = 0; k < face.corner_count; ++k) corners_.u32(vertex(place.block->corner(face, k)));
    }
    void add_to(std::vector<NewSection>& sections) {
        sections.push_back({kFacesSection, kRequiredSection, std::move(faces_)});
        sections.push_back({kVerticesSection, kRequiredSection, std::move(vertices_)});
        sections.push_back({kCornersSection, kRequiredSection, std::move(corners_)});
    }

private:
    /// Numbered in order of first use.
    std::uint32_t vertex(const GridPoint& point) {
        const std::size_t before = points_.count();
        const std::uint32_t number = points_.number(point);
        if (points_.count() > before) put_point(vertices_, point);
        return number;
    }

    ExactPacker* exact_;
    PointNumbers points_;
    ByteWriter faces_, vertices_, corners_;
};

}  // namespace firma
