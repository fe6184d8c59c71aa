// SPDX-License-Identifier: MIT
// The solid after a change.
#include "solid/change_solid.h"

namespace firma {

SolidEdit::SolidEdit(const Solid& solid, SolidChange change)
    : before_(solid),
      points_(std::move(change.points)),
      next_face_(change.next_face > 0 ? change.next_face
                                      : solid.data().next_face + std::uint32_t(change.added.faces.size())),
      number_(change.edit > 0 ? change.edit : solid.data().edits + 1),
      edit_(solid.data().faces, solid.data().tree_options) {
    for (const FacetPlace& facet : change.removed) edit_.remove(facet);
    edit_.add(std::move(change.added));
}

bool SolidEdit::step() {
    if (edit_.step()) return true;
    auto data = std::make_shared<SolidData>(before_.data());
    data->faces = edit_.result();
    data->next_face = next_face_;
    data->edits = number_;
    points_.add_to(data->points);
    data->point_sum += points_.total();
    result_ = Solid(std::move(data));
    return false;
}

}  // namespace firma
