// SPDX-License-Identifier: MIT
// V-HACD 4 by Khaled Mamou and others, from the npm package vhacd-js, compiled here.
#define ENABLE_VHACD_IMPLEMENTATION 1
#define VHACD_DISABLE_THREADING 1  // as the package builds it
#include <VHACD.h>

#include "convex/convex_peer.h"

namespace firma::bench {

PeerHulls vhacd_pieces(const PeerMesh& mesh, std::uint32_t voxels, std::uint32_t hulls) {
    std::vector<double> points;
    std::vector<std::uint32_t> corners;
    for (const Vec3& p : mesh.points) points.insert(points.end(), {p.x, p.y, p.z});
    for (const auto& triangle : mesh.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
    VHACD::IVHACD* const vhacd = VHACD::CreateVHACD();
    VHACD::IVHACD::Parameters parameters;
    parameters.m_resolution = voxels;
    parameters.m_maxConvexHulls = hulls;
    parameters.m_asyncACD = false;
    PeerHulls made;
    if (vhacd->Compute(points.data(), std::uint32_t(mesh.points.size()), corners.data(),
                       std::uint32_t(mesh.triangles.size()), parameters))
        for (std::uint32_t k = 0; k < vhacd->GetNConvexHulls(); ++k) {
            VHACD::IVHACD::ConvexHull hull;
            vhacd->GetConvexHull(k, hull);
            std::vector<Vec3>& own = made.emplace_back();
            for (const VHACD::Vertex& vertex : hull.m_points) own.push_back({vertex.mX, vertex.mY, vertex.mZ});
        }
    vhacd->Release();
    return made;
}

}  // namespace firma::bench
