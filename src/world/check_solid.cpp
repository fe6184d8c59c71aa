// SPDX-License-Identifier: MIT
// The solid of a world: taken out of its rooms, then checked, measured, hashed.
#include "firma/solid.h"
#include "solid/check_boundary.h"
#include "solid/hash_boundary.h"
#include "solid/measure_boundary.h"
#include "world/world_data.h"

namespace firma {
namespace {

Boundary boundary_of(const World& world) {
    std::vector<const Block*> roots;
    for (const Ref<const Room>& room : world.data().rooms) roots.push_back(room->tree.get());
    return take_boundary(roots);
}

}  // namespace

std::optional<SolidFault> check_solid(const World& world) {
    return check_boundary(boundary_of(world));
}

SolidMeasures measure_solid(const World& world) {
    constexpr double kSquareMetre = kInputSteps * kInputSteps;
    constexpr double kCubicSurface = kSurfaceSteps * kSurfaceSteps * kSurfaceSteps;
    const Boundary boundary = boundary_of(world);
    const BoundaryMeasures sums = measure_boundary(boundary);
    SolidMeasures measures;
    measures.volume = rounded(sums.volume) / (kSquareMetre * kInputSteps);
    measures.area = rounded(sums.area) / kSquareMetre;
    measures.facet_volume = double(sums.facet_sixths) / kCubicSurface / 6;
    measures.faces = boundary.patch.faces.size();
    measures.facets = boundary.facets.size();
    return measures;
}

std::uint64_t hash_solid(const World& world) {
    const auto& materials = world.data().materials;
    return hash_boundary(boundary_of(world),
                         materials ? std::span<const std::string>(*materials) : std::span<const std::string>());
}

}  // namespace firma
