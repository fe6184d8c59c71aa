// SPDX-License-Identifier: MIT
// All that rules and anchors say, as words.
#include "log/hash_rules.h"

#include "base/hasher.h"
#include "world/add_text.h"

namespace firma {

std::uint64_t hash_rules(const CarveRules& rules, const Anchors* anchors) {
    Hasher hasher;
    hasher.add(rules.zones.size());
    for (const CarveZone& zone : rules.zones) {
        add_text(hasher, zone.name);
        for (const Vec3& corner : {zone.box.low, zone.box.high})
            for (int axis = 0; axis < 3; ++axis) hasher.add(corner[axis]);
        hasher.add(zone.hardness);
    }
    hasher.add(rules.hardness.size());
    for (const double hardness : rules.hardness) hasher.add(hardness);
    for (const std::size_t limit : {rules.max_faces, rules.max_candidate_faces, rules.max_new_faces,
                                    rules.max_cutter_triangles, rules.max_pairs, rules.max_corners})
        hasher.add(limit);
    hasher.add(rules.max_cutter_size);
    hasher.add(rules.merge_share);
    if (!rules.open_faces) hasher.add(std::uint32_t(1));
    if (!anchors) return hasher.value();
    const auto add = [&](const auto& list) {
        hasher.add(list.size());
        for (const auto value : list) hasher.add(value);
    };
    add(anchors->materials);
    add(anchors->sources);
    add(anchors->edits);
    add(anchors->hanging);
    hasher.add(anchors->volumes.size());
    for (const GridBox& volume : anchors->volumes)
        for (const GridPoint& corner : {volume.low, volume.high})
            for (int axis = 0; axis < 3; ++axis) hasher.add(std::uint32_t(corner[axis]));
    return hasher.value();
}

}  // namespace firma
