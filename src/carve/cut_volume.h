// SPDX-License-Identifier: MIT
// What a cut took: how much, and of which faces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "carve/cut_state.h"

namespace firma {

/// Cubic metres that the solid has less, by the faces that go and come: by integers and sums of 100 bits about the
/// cutter's middle, rounded to double once or twice, wherever in the world it is.
double volume_taken(const Cut& cut);

/// Whether a face that goes was cut or taken, not only divided.
bool takes_something_of(const Cut& cut, std::uint32_t face);

/// The index of a material's name, or the one it will get at the end.
std::uint32_t material_index(const std::vector<std::string>& materials, const std::string& name);
/// The same list, or a longer one when the name is new.
std::shared_ptr<const std::vector<std::string>> with_material(
    const std::shared_ptr<const std::vector<std::string>>& materials, const std::string& name);

}  // namespace firma
