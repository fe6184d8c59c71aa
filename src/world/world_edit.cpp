// SPDX-License-Identifier: MIT
// Several edits that become one new version of the world.
#include "firma/carve.h"
#include "world/one_version.h"

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
    return as_one_version(before_, now_);
}

}  // namespace firma
