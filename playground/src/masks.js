// SPDX-License-Identifier: MIT
// What faces stop: bits of their masks, as include/firma/level.h has them. Faces of meshes have all of them.
export const kStopsWalk = 1;
export const kStopsShots = 2;
export const kStopsSight = 4;
export const kStopsLiquid = 8;
