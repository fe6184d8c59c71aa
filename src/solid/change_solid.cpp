// SPDX-License-Identifier: MIT
// The solid after a change.
#include "solid/change_solid.h"

namespace firma {

SolidEdit::SolidEdit(const Solid& solid, SolidChange change)
    : before_(solid),
      points_(std::move(change.points)),
      added_(std::uint32_t(change.added.faces.size())),
      edit_(solid.data().faces, solid.data().tree_options) {
    for (const FacetPlace& facet : change.removed) edit_.remove(facet);
    edit_.add(std::move(change.added));
}

bool SolidEdit::step() {
    if (edit_.step()) return true;
    auto data = std::make_shared<SolidData>(before_.data());
    data->faces = edit_.result();
    data->next_face += added_;
    ++data->edits;
    points_.add_to(data->points);
    data->point_sum += points_.total();
    result_ = Solid(std::move(data));
    return false;
}

}  // namespace firma
