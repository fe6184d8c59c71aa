// SPDX-License-Identifier: MIT
// What came of an edit, as handles and numbers.
#include "bindings/c/results.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>

#include "bindings/c/convert.h"

namespace firma::c {
namespace {

/// Whether a caller's report is as long as this version's.
bool takes_chunks(const firma_carve_report* report) {
    return report && report->size >= offsetof(firma_carve_report, loose) + sizeof report->loose;
}

void add_report(CarveReport& sum, const CarveReport& part) {
    sum.candidate_faces += part.candidate_faces;
    sum.faces_cut += part.faces_cut;
    sum.faces_removed += part.faces_removed;
    sum.faces_added += part.faces_added;
    sum.faces_castable_only += part.faces_castable_only;
    sum.open_trimmed += part.open_trimmed;
    sum.open_removed += part.open_removed;
    sum.panes += part.panes;
    sum.clips += part.clips;
    sum.portals += part.portals;
    sum.rooms += part.rooms;
    sum.cut_short += part.cut_short;
    sum.scale = std::min(sum.scale, part.scale);
    sum.volume += part.volume;
    sum.chunks += part.chunks;
    sum.chunk_volume += part.chunk_volume;
    sum.crumbs += part.crumbs;
    sum.crumb_volume += part.crumb_volume;
    sum.faces_searched += part.faces_searched;
    using Times = CarveReport::Times;
    for (const auto phase : {&Times::place, &Times::gather, &Times::cut, &Times::label, &Times::trace, &Times::facets,
                             &Times::chunks, &Times::tree})
        sum.times.*phase += part.times.*phase;
}

}  // namespace

firma_code give_result(CarveResult result, firma_world* after, firma_carve_report* report, const char* function) {
    firma_world made{};
    if (after)
        if (const firma_code code = give(std::make_unique<WorldObject>(result.world), &made, function)) return code;
    firma_chunks loose{};
    if (!result.chunks.empty() && takes_chunks(report)) {
        auto object = std::make_unique<ChunksObject>(std::move(result.chunks), result.world);
        if (const firma_code code = give(std::move(object), &loose, function)) {
            release<WorldObject>(made.id, function);
            return code;
        }
    }
    if (after) *after = made;
    if (report) put_report(result, loose, report);
    if (result.status == CarveStatus::kRefused) fail(result.error);
    return FIRMA_OK;
}

CarveResult carve_result(CommandResult result) {
    CarveResult sum;
    sum.status = result.status;
    sum.world = std::move(result.world);
    sum.error = std::move(result.error);
    for (CarveResult& part : result.edits) {
        add_report(sum.report, part.report);
        sum.chunks.insert(sum.chunks.end(), std::make_move_iterator(part.chunks.begin()),
                          std::make_move_iterator(part.chunks.end()));
    }
    return sum;
}

}  // namespace firma::c
