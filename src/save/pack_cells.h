// SPDX-License-Identifier: MIT
// Materials, records of rooms, and portals, on their way into sections.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "save/exact_packer.h"
#include "save/sections.h"
#include "world/world_data.h"

namespace firma {

void put_text_bytes(ByteWriter& out, const std::string& text);
void add_materials(const WorldData& data, std::vector<NewSection>& sections);
/// Which version of the format has all that cells are.
enum class CellsVersion : std::uint8_t { kTwo, kThree };

/// Where Cells::known(): records; where there are any: portals.
/// @param exact  gives numbers to the portals' exact faces: before it packs, and behind faces of solids; null for a
///               file without an exact part, and no section of these faces
/// @return version 2 does without the section of the portals' faces
CellsVersion add_cells(const Cells& cells, ExactPacker* exact, std::vector<NewSection>& sections);

}  // namespace firma
