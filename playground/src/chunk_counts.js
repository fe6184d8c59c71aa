// SPDX-License-Identifier: MIT
// What there is of pieces that came loose, in numbers.

/** Cubic metres and kilograms. @param report  of a carving */
export function countChunks({ loose, crumbs }) {
    const list = loose?.list() ?? [];
    const sum = (of) => list.reduce((total, chunk) => total + of(chunk), 0);
    const largest = list.reduce((best, { volume, mass }) => (mass > best.mass ? { volume, mass } : best), { volume: 0, mass: 0 });
    return { count: list.length, volume: sum((chunk) => chunk.volume), mass: sum((chunk) => chunk.mass), largest, crumbs };
}
