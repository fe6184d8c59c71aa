// SPDX-License-Identifier: MIT
// Materials, records of rooms, and portals, on their way into sections.
#pragma once

#include <string>
#include <vector>

#include "save/sections.h"
#include "world/world_data.h"

namespace firma {

void put_text_bytes(ByteWriter& out, const std::string& text);
void add_materials(const WorldData& data, std::vector<NewSection>& sections);
/// Where Cells::known(): records; where there are any: portals.
void add_cells(const Cells& cells, std::vector<NewSection>& sections);

}  // namespace firma
