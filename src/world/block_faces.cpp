// SPDX-License-Identifier: MIT
// Faces of a block as users see them.
#include "world/block_faces.h"

#include "solid/find_neighbour.h"

namespace firma {

Face describe_face(const Block& block, const FaceRecord& record) {
    const FaceShape shape(block, record);
    Face face;
    face.id = record.id;
    face.source = record.source;
    face.material = record.material;
    face.mask = record.mask;
    face.two_sided = record.two_sided;
    face.source_edit = record.edit;
    face.solid = record.solid;
    face.corners.assign(shape.polygon.corners.begin(), shape.polygon.corners.end());
    const FaceOwner* owner = block.owner_of(record);
    face.normal = owner ? owner->normal : shape.polygon.unit_normal();
    return face;
}

Face describe_face(const Node& root, const Block& block, const FaceRecord& record) {
    Face face = describe_face(block, record);
    face.neighbours.reserve(record.corner_count);
    for (std::uint32_t corner = 0; corner < record.corner_count; ++corner)
        face.neighbours.push_back(find_neighbour(root, block, record, corner));
    return face;
}

}  // namespace firma
