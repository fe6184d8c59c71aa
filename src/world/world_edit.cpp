// SPDX-License-Identifier: MIT
// Several edits that become one new version of the world.
#include "firma/carve.h"
#include "world/world_data.h"

namespace firma {

WorldEdit::WorldEdit(World world) : before_(world), now_(world) {}

CarveResult WorldEdit::carve(const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveResult result = firma::carve(now_, cutter, pose, options);
    now_ = result.world;
    return result;
}

CarveResult WorldEdit::fill(const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveResult result = firma::fill(now_, cutter, pose, options);
    now_ = result.world;
    return result;
}

World WorldEdit::finish() const {
    if (now_.version() - before_.version() <= 1) return now_;  // never below: there is no edit after the last version
    auto data = std::make_shared<WorldData>(now_.data());
    data->version = before_.version() + 1;
    return World(std::move(data));
}

}  // namespace firma
