// SPDX-License-Identifier: MIT
// Puts a peer scene's mesh on Firma's grid before any query is made for it: what every peer then sees.
//
// run.sh puts a call of this into its copy of ../shared/peers/gen.cpp. Multiples of 1/4096 m below 4 km are floats, so
// nobody loses anything by it. Triangles that the snap leaves without area go.
#pragma once

#include <common.h>

#include <cmath>
#include <cstdio>

inline long long snapped_steps(float metres) {
    return std::llrint(double(metres) * 4096);
}

inline void snap_scene(Mesh& mesh) {
    for (float& x : mesh.v) x = float(double(snapped_steps(x)) / 4096);
    std::vector<std::uint32_t> kept;
    for (std::size_t t = 0; t < mesh.nt(); ++t) {
        long long e[2][3];
        for (int edge = 0; edge < 2; ++edge)
            for (int axis = 0; axis < 3; ++axis)
                e[edge][axis] = snapped_steps(mesh.v[3 * std::size_t(mesh.i[3 * t + 1 + edge]) + axis]) -
                                snapped_steps(mesh.v[3 * std::size_t(mesh.i[3 * t]) + axis]);
        bool flat = true;
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            flat = flat && e[0][u] * e[1][v] == e[0][v] * e[1][u];
        }
        if (!flat) kept.insert(kept.end(), &mesh.i[3 * t], &mesh.i[3 * t] + 3);
    }
    std::printf("snapped to 1/4096 m: %zu of %zu triangles stay\n", kept.size() / 3, mesh.nt());
    mesh.i = std::move(kept);
}
