// SPDX-License-Identifier: MIT
// What there is of pieces that came loose, in numbers.

/** Of how crater shots carve: what is cut off leaves, as heavy as concrete, kg/m3. */
export const kDensity = 2400;

/** Cubic metres and kilograms. @param report  of a carving, `largest` the kilograms of the heaviest piece */
export function countChunks({ chunks, chunkVolume, crumbs, largest }) {
    return { count: chunks, volume: chunkVolume, mass: kDensity * chunkVolume, largest: { volume: largest / kDensity, mass: largest }, crumbs };
}
