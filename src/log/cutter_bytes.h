// SPDX-License-Identifier: MIT
// Cutters that no seed makes, as bytes: meshes by vertices and triangles, solids as .firma files.
#pragma once

#include "firma/cutter.h"
#include "log/byte_reader.h"

namespace firma {

/// @param cutter  valid()
void put_cutter(ByteWriter& out, const Cutter& cutter);
/// All that is left of `in`. @return not valid() where the reader has an error
Cutter take_cutter(ByteReader& in);

}  // namespace firma
