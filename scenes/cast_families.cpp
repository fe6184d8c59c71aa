// SPDX-License-Identifier: MIT
// The table of families.
#include "scenes/cast_families.h"

#include "scenes/cast_builder.h"
#include "scenes/exact_families.h"
#include "scenes/motion_families.h"
#include "scenes/shape_families.h"

namespace firma::scenes {

namespace {

template <void (*kMake)(CastBuilder&)>
void with_builder(Rng& rng, CastScene& scene) {
    CastBuilder builder(rng, scene);
    builder.floats = rng.chance(0.3);
    kMake(builder);
}

template <void (*kMake)(CastBuilder&)>
void in_double(Rng& rng, CastScene& scene) {
    CastBuilder builder(rng, scene);
    kMake(builder);
}

/// Moves everything, kilometres away where there is room; the casts' starts are rounded once more.
void move_scene(Rng& rng, CastScene& scene) {
    Steps by = random_steps(rng, 8000 * kMetre);
    by = {by.x / kInput * kInput, by.y / kInput * kInput, by.z / kInput * kInput};
    if (rng.chance(0.3)) by = {by.x, 0, 0};
    for (const GridPolygon& polygon : scene.polygons)
        for (const GridPoint& p : polygon) {
            const Steps to = steps(p) + by;
            if (!all_in_world({&to, 1})) return;
        }
    for (GridPolygon& polygon : scene.polygons)
        for (GridPoint& p : polygon) p = in_world(steps(p) + by);
    for (CastQuery& cast : scene.casts) cast.sphere.centre = cast.sphere.centre + to_metres(by);
}

}  // namespace

const std::vector<CastFamily>& cast_families() {
    static const std::vector<CastFamily> kFamilies = {
        {"generic_triangles", with_builder<generic_triangles>},
        {"generic_ngons", with_builder<generic_ngons>},
        {"surface_grid", with_builder<surface_grid>},
        {"many_corners", with_builder<many_corners>},
        {"collinear_corners", with_builder<collinear_corners>},
        {"terrain", with_builder<height_field>},
        {"fans", with_builder<fans>},
        {"slivers", with_builder<slivers>},
        {"knife_edges", with_builder<knife_edges>},
        {"thin_boxes", with_builder<thin_boxes>},
        {"far_away", with_builder<far_away>},
        {"range_border", with_builder<range_border>},
        {"huge_polygons", with_builder<huge_polygons>},
        {"tiny_polygons", with_builder<tiny_polygons>},
        {"radii", with_builder<radii>},
        {"extreme_radii", in_double<extreme_radii>},
        {"long_paths", with_builder<long_paths>},
        {"short_paths", with_builder<short_paths>},
        {"odd_paths", in_double<odd_paths>},
        {"from_outside", with_builder<from_outside>},
        {"huge_paths", in_double<huge_paths>},
        {"overlapping", with_builder<overlapping>},
        {"receding", with_builder<receding>},
        {"backface", with_builder<backface>},
        {"straddling", with_builder<straddling>},
        {"graze_edges", with_builder<graze_edges>},
        {"graze_corners", with_builder<graze_corners>},
        {"shallow", with_builder<shallow>},
        {"end_of_path", with_builder<end_of_path>},
        {"starts_on", with_builder<starts_on>},
        {"repeated", with_builder<repeated>},
        {"mixed_scales", with_builder<mixed_scales>},
        {"axis_aligned", in_double<axis_aligned>},
        {"parallel", in_double<parallel>},
        {"coplanar", in_double<coplanar>},
        {"lattice", in_double<lattice>},
        {"lattice_of_steps", in_double<lattice_of_steps>},
        {"exact_touch", in_double<exact_touch>},
        {"exact_graze", in_double<exact_graze>},
        {"exact_end", in_double<exact_end>},
        {"sliding", in_double<sliding>},
        {"shared_flat", in_double<shared_flat>},
        {"shared_folded", in_double<shared_folded>},
        {"exact_fractions", in_double<exact_fractions>},
    };
    return kFamilies;
}

CastScene make_cast_scene(const CastFamily& family, std::uint64_t seed, std::uint64_t index) {
    std::uint64_t mixed = 0xCBF29CE484222325ull;  // FNV-1a of the name, so that families do not share their randomness
    for (const char c : family.name) mixed = (mixed ^ std::uint64_t(std::uint8_t(c))) * 0x100000001B3ull;
    Rng seeds(mixed ^ (seed * 0x9E3779B97F4A7C15ull));
    Rng rng(seeds.next() + index * 0xD1B54A32D192ED03ull);
    rng.next();
    CastScene scene;
    family.make(rng, scene);
    if (rng.chance(0.2)) move_scene(rng, scene);
    return scene;
}

}  // namespace firma::scenes
