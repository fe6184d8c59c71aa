// SPDX-License-Identifier: MIT
// HACD by Khaled Mamou, from Debian's libbullet-extras-dev.
#include <hacdHACD.h>

#include "convex/convex_peer.h"

namespace firma::bench {

PeerHulls hacd_pieces(const PeerMesh& mesh, double concavity) {
    std::vector<HACD::Vec3<HACD::Real>> points;
    std::vector<HACD::Vec3<long>> triangles;
    for (const Vec3& p : mesh.points) points.emplace_back(p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(long(a), long(b), long(c));
    HACD::HACD hacd;
    hacd.SetPoints(points.data());
    hacd.SetNPoints(points.size());
    hacd.SetTriangles(triangles.data());
    hacd.SetNTriangles(triangles.size());
    // As its sample sets it, but for the concavity: that is in its own units, the mesh's diagonal being the scale.
    hacd.SetCompacityWeight(0.1);
    hacd.SetVolumeWeight(0);
    hacd.SetNClusters(1);
    hacd.SetNVerticesPerCH(100);
    Vec3 low = mesh.points[0], high = low;
    for (const Vec3& p : mesh.points)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    hacd.SetConcavity(concavity / length(high - low) * hacd.GetScaleFactor());
    hacd.SetAddExtraDistPoints(false);
    hacd.SetAddNeighboursDistPoints(false);
    hacd.SetAddFacesPoints(false);
    PeerHulls made;
    if (!hacd.Compute()) return made;
    for (std::size_t k = 0; k < hacd.GetNClusters(); ++k) {
        std::vector<HACD::Vec3<HACD::Real>> corners(hacd.GetNPointsCH(k));
        std::vector<HACD::Vec3<long>> sides(hacd.GetNTrianglesCH(k));
        hacd.GetCH(k, corners.data(), sides.data());
        std::vector<Vec3>& own = made.emplace_back();
        for (const auto& corner : corners) own.push_back({corner.X(), corner.Y(), corner.Z()});
    }
    return made;
}

}  // namespace firma::bench
