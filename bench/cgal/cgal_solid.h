// SPDX-License-Identifier: MIT
// Firma's exact solids as CGAL's meshes with exact coordinates; for programs that find CGAL.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firma/solid.h"
#include "geometry/exact_point.h"
#include "solid/solid_patch.h"

namespace firma::bench {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// In input steps: each vertex where its three planes meet, as CGAL finds it; each face divided into triangles by CGAL,
/// in its exact plane.
class CgalSolid {
public:
    explicit CgalSolid(const Solid& solid);

    /// None where several of its edges run between the same points.
    std::optional<ExactMesh> mesh() const;

private:
    void add_face(const SolidPatch& patch, const PatchFace& face);

    std::vector<ExactKernel::Point_3> points_;
    std::vector<std::vector<std::size_t>> triangles_;
};

}  // namespace firma::bench
