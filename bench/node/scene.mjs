// SPDX-License-Identifier: MIT
// The scenes that all contenders get: triangles with corners on the grid of 1/4096 m, which float32 holds exactly.
import { readFile } from 'node:fs/promises';

/** Seeded random numbers, the same in every run. */
export class Rng {
    #state;
    constructor(seed) {
        this.#state = seed;
    }
    next() {
        this.#state = (this.#state + 0x9e3779b9) | 0;
        let z = this.#state;
        z = Math.imul(z ^ (z >>> 16), 0x85ebca6b);
        z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
        return (z ^ (z >>> 16)) >>> 0;
    }
    below(count) {
        return this.next() % count;
    }
    uniform(low = 0, high = 1) {
        return low + (high - low) * (this.next() / 2 ** 32);
    }
}

/** To the nearest multiple of 1/4096, halves to even, as Firma snaps. */
export function snap(value) {
    const steps = value * 4096;
    const whole = Math.round(steps);
    return (Math.abs(steps - Math.trunc(steps)) === 0.5 && whole % 2 !== 0 ? whole - 1 : whole) / 4096;
}

/** Vertices by their grid point, triangles by the numbers of these. */
class MeshMaker {
    positions = [];
    corners = [];
    #numbers = new Map();
    vertex(point) {
        const key = point.join();
        let number = this.#numbers.get(key);
        if (number === undefined) {
            number = this.positions.length / 3;
            this.#numbers.set(key, number);
            this.positions.push(...point);
        }
        return number;
    }
    triangle(a, b, c) {
        this.corners.push(this.vertex(a), this.vertex(b), this.vertex(c));
    }
    mesh() {
        return { positions: Float64Array.from(this.positions), corners: Uint32Array.from(this.corners) };
    }
}

/** A level's polygons as fans of triangles; they are convex.
 * @param scale metres a unit of the file */
export async function meshOfObj(path, scale) {
    const vertices = [];
    const maker = new MeshMaker();
    for (const line of (await readFile(path, 'utf8')).split('\n')) {
        const [word, ...rest] = line.trim().split(/\s+/);
        if (word === 'v') vertices.push(rest.slice(0, 3).map((x) => snap(Number(x) * scale)));
        if (word !== 'f') continue;
        const face = rest.map((corner) => vertices[parseInt(corner, 10) - 1]);
        for (let k = 2; k < face.length; ++k) maker.triangle(face[0], face[k - 1], face[k]);
    }
    return maker.mesh();
}

export const triangulatedObj = (path) => meshOfObj(path, 1);

const SIZE = [12, 12, 6]; // of a room, metres
const SPACING = 13.5;
const HULL = 8;
const PANELS = [18, 18, 9];
const BUMP = 0.12;

/** The surface of a box in panels of two triangles, corners within a side moved; a room's fronts look inward. */
function addPanelBox(maker, rng, low, size, count, bump, room) {
    const moved = new Map();
    const corner = (at) => {
        const key = at.join();
        if (moved.has(key)) return moved.get(key);
        const point = at.map((k, axis) => low[axis] + (size[axis] * k) / count[axis]);
        const sides = at.map((k, axis) => k === 0 || k === count[axis]);
        if (bump > 0 && sides.filter(Boolean).length === 1) point[sides.indexOf(true)] += rng.uniform(-bump, bump);
        const snapped = point.map(snap);
        moved.set(key, snapped);
        return snapped;
    };
    for (let axis = 0; axis < 3; ++axis)
        for (let side = 0; side < 2; ++side) {
            const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            for (let i = 0; i < count[u]; ++i)
                for (let k = 0; k < count[v]; ++k) {
                    const panel = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([du, dv]) => {
                        const at = [0, 0, 0];
                        at[axis] = side * count[axis];
                        at[u] = i + du;
                        at[v] = k + dv;
                        return corner(at);
                    });
                    if ((side === 1) === room) panel.reverse();
                    const turn = rng.below(2);
                    maker.triangle(panel[turn], panel[1 + turn], panel[2 + turn]);
                    maker.triangle(panel[turn], panel[2 + turn], panel[(3 + turn) % 4]);
                }
        }
}

/** A mesh whose vertices at one place are one: what libraries find the neighbours of an edge by. */
export function welded(positions, corners) {
    const maker = new MeshMaker();
    const point = (k) => Array.from(positions.subarray(3 * k, 3 * k + 3));
    for (let k = 0; k < corners.length; k += 3) maker.triangle(point(corners[k]), point(corners[k + 1]), point(corners[k + 2]));
    return maker.mesh();
}

/** Rooms in rock that reaches to infinity, { low, size, count, bump } each: panels of two triangles, count of them along each axis. */
export function panelRooms(rooms) {
    const rng = new Rng(7);
    const maker = new MeshMaker();
    for (const { low, size, count, bump } of rooms) addPanelBox(maker, rng, low, size, count, bump, true);
    return maker.mesh();
}

/** Rooms of 12 x 12 x 6 m in a block of rock, so many each way; walls bumpy, 2592 triangles a room. */
export function bumpyRooms(rooms) {
    const rng = new Rng(7);
    const maker = new MeshMaker();
    const width = rooms * SPACING;
    addPanelBox(maker, rng, [-HULL, -HULL, -HULL], [width + 2 * HULL, width + 2 * HULL, SIZE[2] + 2 * HULL], [1, 1, 1], 0, false);
    for (let a = 0; a < rooms; ++a)
        for (let b = 0; b < rooms; ++b) addPanelBox(maker, rng, [a * SPACING, b * SPACING, 0], SIZE, PANELS, BUMP, true);
    return maker.mesh();
}

const PHI = (1 + Math.sqrt(5)) / 2;
const ICOSAHEDRON = {
    vertices: [
        [-1, PHI, 0], [1, PHI, 0], [-1, -PHI, 0], [1, -PHI, 0], [0, -1, PHI], [0, 1, PHI],
        [0, -1, -PHI], [0, 1, -PHI], [PHI, 0, -1], [PHI, 0, 1], [-PHI, 0, -1], [-PHI, 0, 1],
    ],
    triangles: [
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
        [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
    ],
};

/** A rough ball of 180 triangles: an icosahedron's divided into nine, radii 0.78 to 1.2. */
export function rockyBall(seed) {
    const rng = new Rng(seed);
    const numbers = new Map();
    const positions = [];
    const corners = [];
    const vertex = (triangle, thirds) => {
        const parts = triangle.map((corner, k) => [corner, thirds[k]]).filter(([, third]) => third > 0);
        const key = parts.sort(([a], [b]) => a - b).join();
        if (!numbers.has(key)) {
            numbers.set(key, positions.length / 3);
            const sum = [0, 1, 2].map((axis) => parts.reduce((s, [k, third]) => s + third * ICOSAHEDRON.vertices[k][axis], 0));
            const radius = rng.uniform(0.78, 1.2) / Math.hypot(...sum);
            positions.push(...sum.map((x) => x * radius));
        }
        return numbers.get(key);
    };
    for (const triangle of ICOSAHEDRON.triangles) {
        const at = (i, j) => vertex(triangle, [3 - i - j, i, j]);
        for (let i = 0; i < 3; ++i)
            for (let j = 0; j < 3 - i; ++j) {
                corners.push(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j < 2) corners.push(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    return { positions: Float64Array.from(positions), corners: Uint32Array.from(corners) };
}

/** The crater's vertices where Firma puts them: turned, scaled, moved, snapped, in the order of operations of place_cutter(). */
export function placed(mesh, { position, rotation, scale }) {
    const reach = Math.max(...rotation.map(Math.abs));
    const q = rotation.map((part) => part / reach);
    const size = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const [x, y, z, w] = q.map((part) => part / size);
    const rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ].map((row) => row.map((part) => part * scale));
    const p = mesh.positions;
    const positions = Float64Array.from(p, (_, k) => {
        const row = rows[k % 3];
        const v = k - (k % 3);
        return snap(row[0] * p[v] + row[1] * p[v + 1] + row[2] * p[v + 2] + position[k % 3]);
    });
    return { positions, corners: mesh.corners };
}

/** Crater number k, of radius 1.6 m, its middle 0.7 m behind to 0.3 m before a wall, floor or ceiling of any room, or within
 * 4.2 m of one corner of the first one. */
export function craterPose(firma, rooms, inCorner, k) {
    const rng = new Rng(Math.imul(k + 1, 0x9e3779b1) + (inCorner ? 1 : 0));
    const [a, b] = [rng.below(rooms), rng.below(rooms)];
    const low = inCorner ? [0, 0, 0] : [a * SPACING, b * SPACING, 0];
    const wall = rng.below(3);
    const high = rng.below(2) === 1 && !inCorner;
    const out = rng.uniform(-0.7, 0.3);
    const position = low.map((at, axis) => {
        const along = rng.uniform() * (inCorner ? 0.35 : 1);
        if (axis !== wall) return at + SIZE[axis] * along;
        return high ? at + SIZE[axis] - out : at + out;
    });
    return { position, rotation: firma.randomTurn(rng.next()), scale: 1.6 };
}

/** Casts from the air, seven numbers each, the sphere free at its start by a centimetre; half of them near a surface. */
export function castsInAir(world, low, high, radius, shortest, longest, count, seed) {
    const rng = new Rng(seed);
    const inputs = new Float64Array(7 * count);
    for (let k = 0; k < count; ) {
        const centre = low.map((from, axis) => rng.uniform(from, high[axis]));
        const near = k % 2 === 1;
        if (world.locate(centre).where === 'solid' || world.closest(centre, radius + 0.01) !== null) continue;
        if (near && world.closest(centre, radius + 0.3) === null) continue;
        const direction = [0, 1, 2].map(() => rng.uniform(-1, 1));
        const square = Math.hypot(...direction);
        if (square > 1 || square < 0.05) continue;
        const length = rng.uniform(shortest, longest) / square;
        // Numbers that float32 holds, so that all get the same.
        inputs.set([...centre, radius, ...direction.map((part) => part * length)].map(Math.fround), 7 * k++);
    }
    return inputs;
}
