// SPDX-License-Identifier: MIT
// Everything: levels in, worlds out, casts through them, craters into them.
#pragma once

#include "firma/carve.h"
#include "firma/carve_rules.h"
#include "firma/check_mesh.h"
#include "firma/cutter.h"
#include "firma/diff_worlds.h"
#include "firma/grid.h"
#include "firma/hit.h"
#include "firma/level.h"
#include "firma/memory.h"
#include "firma/mesh.h"
#include "firma/polygon.h"
#include "firma/result.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "firma/tolerance.h"
#include "firma/tree_options.h"
#include "firma/vec.h"
#include "firma/world.h"
#include "firma/world_store.h"
#include "firma/write_obj.h"
