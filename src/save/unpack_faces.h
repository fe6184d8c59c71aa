// SPDX-License-Identifier: MIT
// The faces of a saved world, of either version of the format.
#pragma once

#include <span>

#include "save/entries.h"
#include "save/unpack_data.h"
#include "solid/face_set.h"
#include "solid/solid_face.h"

namespace firma {

/// The faces in the file's order, each with its room as its part. Check the Damage before using them.
/// @param exact  the exact faces that facets name; nothing else may hold them yet: their facets are counted here
/// Every index in what comes back is good; what faces are like is for check_world() to find out.
FaceSet unpack_faces(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact,
                     Damage& damage);

/// The same of version 1, whose faces stand block by block.
FaceSet unpack_faces_of_version_1(Sections& sections, const UnpackedData& data, std::span<const Ref<SolidFace>> exact,
                                  Damage& damage);

}  // namespace firma
