// SPDX-License-Identifier: MIT
// A crack: a thin slab that a body is cut by, across its longest side and a little askew.
import { Chance } from './chance.js';
import { combine } from './turns.js';

const kHalfThickness = 0.006; // metres
const kCorners = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5];

/** Triangles of a box around the origin, seen from outside. @param half  metres */
export function boxMesh([x, y, z]) {
    const positions = Array.from({ length: 8 }, (_, k) => [k & 1 ? x : -x, k & 2 ? y : -y, k & 4 ? z : -z]).flat();
    return { positions, corners: kCorners };
}

/**
 * @param low, high  of the body, in its frame @param seed  which crack
 * @returns { cutter, pose }: in the body's frame; the cutter is to be released
 */
export function makeCrack(firma, low, high, seed) {
    const chance = new Chance(seed + 17);
    const sides = low.map((x, axis) => high[axis] - x);
    const longest = sides.indexOf(Math.max(...sides));
    const half = sides.map(() => Math.max(...sides));
    half[longest] = kHalfThickness;
    const { positions, corners } = boxMesh(half);
    const position = low.map((x, axis) => x + sides[axis] * (axis === longest ? chance.between(0.38, 0.62) : 0.5));
    const lean = [0, 1, 2].map((axis) => (axis === longest ? 0 : chance.between(-0.16, 0.16)));
    const rotation = lean.reduce((turn, angle, axis) => {
        const part = [0, 0, 0, Math.cos(angle / 2)];
        part[axis] = Math.sin(angle / 2);
        return combine(part, turn);
    }, [0, 0, 0, 1]);
    return { cutter: firma.cutterFromMesh(positions, corners, 'crack'), pose: { position, rotation, scale: 1 } };
}
