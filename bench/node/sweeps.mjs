// SPDX-License-Identifier: MIT
// The sweeps of scenes/sweeps.cpp, number for number: many overlapping capsules, cylinders and boxes along a path through
// a block. Sums, products, quotients and square roots alone, in the same order.

const RADIUS = 0.0625; // of a block whose edge is 1
const LENGTH = 0.03125;
const SIDES = 16;
const FIRST = 24;
const STRAIGHT = 40;

export const TOOLS = ['capsules', 'cylinders', 'boxes'];
export const LARGEST_SWEEP = 13;
export const SWEEP_CUTS = 120;

/** Sine and cosine of k sixteenths of a turn. */
function turn() {
    const root = Math.sqrt(2);
    const quarter = [1, Math.sqrt(2 + root) / 2, root / 2, Math.sqrt(2 - root) / 2, 0];
    const at = Array.from({ length: SIDES }, (_, k) => {
        const [c, s] = [quarter[k % 4], quarter[4 - (k % 4)]];
        return [[c, s], [-s, c], [-c, -s], [s, -c]][Math.floor(k / 4)];
    });
    return { cosine: at.map(([c]) => c), sine: at.map(([, s]) => s) };
}

const meshOf = (vertices, triangles) => ({ positions: Float64Array.from(vertices.flat()), corners: Uint32Array.from(triangles.flat()) });

/** Rings around z from the lowest to the highest, closed by a point below and one above. */
function turned(rings, lowest, highest) {
    const { cosine, sine } = turn();
    const vertices = rings.flatMap(([radius, height]) => cosine.map((c, k) => [radius * c, radius * sine[k], height]));
    const low = vertices.length;
    vertices.push([0, 0, lowest], [0, 0, highest]);
    const triangles = [];
    for (let k = 0; k < SIDES; ++k) {
        const next = (k + 1) % SIDES;
        triangles.push([low, next, k]);
        for (let ring = 0; ring + SIDES < low; ring += SIDES) {
            triangles.push([ring + k, ring + next, ring + SIDES + next]);
            triangles.push([ring + k, ring + SIDES + next, ring + SIDES + k]);
        }
        triangles.push([low - SIDES + k, low - SIDES + next, low + 1]);
    }
    return meshOf(vertices, triangles);
}

function box(half) {
    const vertices = Array.from({ length: 8 }, (_, k) => half.map((size, axis) => (k & (1 << axis) ? size : -size)));
    return meshOf(vertices, [
        [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
        [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
    ]);
}

function toolMesh(tool) {
    const half = LENGTH / 2;
    if (tool === 'boxes') return box([RADIUS, RADIUS / 2, half]);
    if (tool === 'cylinders') return turned([[RADIUS, -half], [RADIUS, half]], -half, half);
    const { cosine, sine } = turn();
    const rings = [];
    for (let k = -3; k <= 3; ++k) {
        const [radius, rise] = [RADIUS * cosine[Math.abs(k)], RADIUS * sine[Math.abs(k)]];
        if (k <= 0) rings.push([radius, -half - rise]);
        if (k >= 0) rings.push([radius, half + rise]);
    }
    return turned(rings, -half - RADIUS, half + RADIUS);
}

const CONTROL = [
    [-0.5625, -0.4375, -0.25], [-0.25, -0.5, 0.25], [0.125, -0.375, 0.375], [0.3125, -0.125, 0.25], [0.5, 0.125, 0.125],
    [0.375, 0.4375, -0.1875], [0.0625, 0.375, -0.0625], [-0.25, 0.3125, 0.0625], [-0.375, 0.0625, 0.25], [-0.0625, 0, 0.5625],
];

const blend = (a, b, t) => a.map((from, axis) => from + (b[axis] - from) * t);

/** A place and a direction on the curve, t from 0 to 1: three pieces of degree 3. */
function alongCurve(t) {
    const piece = t < 1 / 3 ? 0 : t < 2 / 3 ? 1 : 2;
    const u = t * 3 - piece;
    const p = CONTROL.slice(3 * piece, 3 * piece + 4);
    const [ab, bc, cd] = [blend(p[0], p[1], u), blend(p[1], p[2], u), blend(p[2], p[3], u)];
    const [abc, bcd] = [blend(ab, bc, u), blend(bc, cd, u)];
    return { place: blend(abc, bcd, u), direction: bcd.map((to, axis) => to - abc[axis]) };
}

function poseAt(k, scale) {
    let at;
    if (k < FIRST) at = { place: [-0.375 + LENGTH * k, -0.375, 0.46875], direction: [1, 0, 0] };
    else if (k < STRAIGHT) at = { place: [0.375, -0.375 + LENGTH * (k - FIRST), 0.46875], direction: [0, 1, 0] };
    else at = alongCurve((k - STRAIGHT) / (SWEEP_CUTS - STRAIGHT - 1));
    const [x, y, z] = at.direction;
    return { position: at.place.map((part) => part * scale), rotation: [-y, x, 0, z + Math.sqrt(x * x + y * y + z * z)], scale };
}

/** @returns the block and the tool as meshes, and where the tool goes */
export function makeSweep(tool, exponent) {
    const scale = 2 ** exponent;
    return {
        block: box([scale / 2, scale / 2, scale / 2]),
        tool: toolMesh(tool),
        poses: Array.from({ length: SWEEP_CUTS }, (_, k) => poseAt(k, scale)),
    };
}
