// SPDX-License-Identifier: MIT
// What every edit begins with: a cutter, where it goes, and options.
#pragma once

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"

namespace firma::c {

struct Order {
    const CutterObject* cutter = nullptr;
    Pose pose;
    CarveOptions options;
    CarveKind kind = CarveKind::kCarve;
};

inline firma_code read_order(firma_cutter cutter, const firma_pose* pose, const firma_carve_options* options,
                             Order& order, const char* function) {
    if (!pose) return bad_call(function, kNull);
    order.cutter = find<CutterObject>(cutter.id, function);
    if (!order.cutter) return FIRMA_ERROR_BAD_HANDLE;
    order.pose = pose_of(*pose);
    return read_options(options, order.options, order.kind, function);
}

}  // namespace firma::c
