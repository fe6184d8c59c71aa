// SPDX-License-Identifier: MIT
// Faces of a block as queries want them.
#include "world/block_faces.h"

namespace firma {

Face describe_face(const Block& block, const FaceRecord& record) {
    const FaceShape shape(block, record);
    Face face;
    face.id = record.id;
    face.source = record.source;
    face.material = record.material;
    face.mask = record.mask;
    face.two_sided = record.two_sided;
    face.corners.assign(shape.polygon.corners.begin(), shape.polygon.corners.end());
    const auto neighbours = block.corner_neighbours.begin() + record.first_corner;
    face.neighbours.assign(neighbours, neighbours + record.corner_count);
    face.normal = shape.polygon.unit_normal();
    return face;
}

}  // namespace firma
