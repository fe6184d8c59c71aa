// SPDX-License-Identifier: MIT
// Parts of a world replaced.
#include "world/replace.h"

#include "carve/judge_rules.h"

#include <utility>

namespace firma {
namespace {

World with_faces_by_room(std::shared_ptr<WorldData> data) {
    const BuiltStore solid = parts_of(data->solid.data().faces), castable = parts_of(data->castable);
    data->set_faces(faces_of_rooms(data->cells, {&solid, &castable}));
    return World(std::move(data));
}

}  // namespace

World with_solid(const World& world, const Solid& solid) {
    std::shared_ptr<WorldData> next = next_version(world.data());
    next->solid = solid;
    return with_faces_by_room(std::move(next));
}

World with_castable(const World& world, const FaceStore& castable) {
    std::shared_ptr<WorldData> next = next_version(world.data());
    next->castable = castable;
    return with_faces_by_room(std::move(next));
}

World with_cells(const World& world, const Cells& cells) {
    std::shared_ptr<WorldData> next = next_version(world.data());
    next->cells = cells;
    return with_faces_by_room(std::move(next));
}

Result<World> with_rules(const World& world, CarveRules rules) {
    if (auto error = judge_rules(rules, "")) return *std::move(error);
    auto data = std::make_shared<WorldData>(world.data());
    data->rules = std::make_shared<const CarveRules>(std::move(rules));
    return World(std::move(data));
}

}  // namespace firma
