// SPDX-License-Identifier: MIT
// From a glTF level to a World, in rooms.
#include <vector>

#include "firma/read_gltf.h"
#include "firma/rooms.h"

namespace firma {

Result<World> make_world(const GltfLevel& gltf, const WorldOptions& options, GltfRooms* report) {
    std::vector<LevelPortal> portals;
    for (const GltfPortal& portal : gltf.portals) portals.push_back({portal.name, portal.polygons});
    return make_divided_world(gltf.level, portals, options, report);
}

}  // namespace firma
