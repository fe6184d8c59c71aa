// SPDX-License-Identifier: MIT
// Faces of a block as users see them.
#include "world/block_faces.h"

namespace firma {

FaceInfo face_info(RoomId room, const Block& block, const FaceRecord& record, const PolygonShape& polygon) {
    const FaceOwner* owner = block.owner_of(record);
    return {.id = record.id,
            .corner = block.corner(record, 0),
            .room = room,
            .source = record.source,
            .source_edit = record.edit,
            .material = record.material,
            .mask = record.mask,
            .two_sided = record.two_sided != 0,
            .solid = record.solid != 0,
            .normal = owner ? owner->normal : polygon.unit_normal()};
}

Vec3 unit_normal_of(const Block& block, const FaceRecord& face) {
    if (const FaceOwner* owner = block.owner_of(face)) return owner->normal;
    const FaceShape shape(block, face);
    return shape.polygon.has_area() ? shape.polygon.unit_normal() : Vec3{};
}

Face describe_face(RoomId room, const Block& block, const FaceRecord& record) {
    const FaceShape shape(block, record);
    return {face_info(room, block, record, shape.polygon),
            {shape.polygon.corners.begin(), shape.polygon.corners.end()}};
}

}  // namespace firma
