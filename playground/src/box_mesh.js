// SPDX-License-Identifier: MIT
// A box as a mesh for Firma.worldFromMesh().
const kCorners = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];

/** Triangles of a box around the origin, seen from outside. @param half  metres */
export function boxMesh([x, y, z]) {
    const positions = Array.from({ length: 8 }, (_, k) => [k & 1 ? x : -x, k & 2 ? y : -y, k & 4 ? z : -z]).flat();
    return { positions, corners: kCorners };
}
