// SPDX-License-Identifier: MIT
// Everything: levels in, worlds out, casts through them, craters into them.
#pragma once

#include "firma/batch.h"
#include "firma/brush_level.h"
#include "firma/brush_world.h"
#include "firma/capsule.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/cutter.h"
#include "firma/edit_log.h"
#include "firma/function_ref.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "firma/hull.h"
#include "firma/level.h"
#include "firma/mass.h"
#include "firma/matter.h"
#include "firma/memory.h"
#include "firma/mesh.h"
#include "firma/polygon.h"
#include "firma/queries.h"
#include "firma/region_meshes.h"
#include "firma/result.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "firma/texture.h"
#include "firma/tree_options.h"
#include "firma/triangles.h"
#include "firma/vec.h"
#include "firma/versions.h"
#include "firma/world.h"
#include "firma/world_patch.h"

#if __has_include("firma/read_gltf.h")  // of firma::gltf, a library of its own
#include "firma/read_gltf.h"
#endif
