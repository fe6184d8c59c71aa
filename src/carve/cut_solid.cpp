// SPDX-License-Identifier: MIT
// Cuts of a solid that is no world's.
#include "carve/cut_job.h"
#include "carve/judge_rules.h"
#include "firma/solid.h"

namespace firma {
namespace {

SolidResult cut(const Solid& solid, const Cutter& cutter, const Pose& pose, const SolidCutOptions& options,
                CarveKind kind) {
    SolidResult result;
    result.solid = solid;
    if (options.rules)
        if (auto error = judge_rules(*options.rules, "")) {
            result.error = *std::move(error);
            return result;
        }
    CutTerms terms;
    terms.rules = options.rules;
    terms.material = options.material;
    CutJob job(solid, cutter, pose, terms, kind);
    while (job.step()) {
    }
    result.status = job.status();
    result.error = job.error();
    result.report = job.report();
    result.reproduction = job.reproduction();
    if (!result.done()) return result;
    SolidChange change = job.take_change();
    for (FaceSet::Entry& face : change.added.faces)
        if (face.part == kUnsetPart) face.part = 0;
    SolidEdit edit(solid, std::move(change));
    while (edit.step()) {
    }
    result.solid = edit.result();
    return result;
}

}  // namespace

SolidResult subtract(const Solid& solid, const Cutter& cutter, const Pose& pose, const SolidCutOptions& options) {
    return cut(solid, cutter, pose, options, CarveKind::kCarve);
}

SolidResult unite(const Solid& solid, const Cutter& cutter, const Pose& pose, const SolidCutOptions& options) {
    return cut(solid, cutter, pose, options, CarveKind::kFill);
}

}  // namespace firma
