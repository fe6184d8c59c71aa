// SPDX-License-Identifier: MIT
// A course for players: a hall whose floor is of panels of two triangles, with steps, slopes, corners, a doorway, craters;
// and a room with bumps. Firma makes it, all get its triangles.
import { panelRooms, welded } from './scene.mjs';

export const SIZE = { radius: 0.3, height: 1.8 };
export const SPEED = 4; // metres a second

/** A prism over a polygon in x and z, counter-clockwise as seen from low y, from y0 to y1. */
function prism(firma, outline, y0, y1) {
    const n = outline.length;
    const positions = [...outline.flatMap(([x, z]) => [x, y0, z]), ...outline.flatMap(([x, z]) => [x, y1, z])];
    const corners = [];
    for (let k = 2; k < n; ++k) corners.push(0, k - 1, k, n, n + k, n + k - 1);
    for (let k = 0; k < n; ++k) {
        const next = (k + 1) % n;
        corners.push(k, n + k, n + next, k, n + next, next);
    }
    return firma.cutterFromMesh(positions, corners);
}

const box = (firma, low, high) =>
    prism(firma, [[low[0], low[2]], [high[0], low[2]], [high[0], high[2]], [low[0], high[2]]], low[1], high[1]);

/** A wall from a to b, 0.3 m thick to the left, 3 m high. */
function wall(firma, a, b) {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const far = Math.hypot(dx, dy);
    const [nx, ny] = [(-dy / far) * 0.3, (dx / far) * 0.3];
    const base = [a, b, [b[0] + nx, b[1] + ny], [a[0] + nx, a[1] + ny]];
    const positions = [-0.25, 3].flatMap((z) => base.flatMap(([x, y]) => [x, y, z]));
    return firma.cutterFromMesh(positions, [0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7]);
}

const SUNK = -0.25;
const tangent = (degrees) => Math.tan((degrees * Math.PI) / 180);

function fillings(firma) {
    const all = [];
    for (let k = 0; k < 6; ++k) all.push(box(firma, [4 + 0.35 * k, 2, SUNK], [12 - 0.35 * k, 5, 0.3 * (k + 1)]));
    const rise = 4 * tangent(30);
    all.push(prism(firma, [[18, SUNK], [26, SUNK], [26, 0], [22, rise], [18, 0]], 2, 5));
    const steep = 1.5 * tangent(60);
    all.push(prism(firma, [[32, SUNK], [35, SUNK], [35, 0], [33.5, steep], [32, 0]], 2, 5));
    all.push(wall(firma, [5, 12], [10, 12]), wall(firma, [10, 12.3], [10, 8])); // an inner corner of 90 degrees
    const open = 2.5 * tangent(15); // and one of 30
    all.push(wall(firma, [13.5, 12 + open], [16, 12]), wall(firma, [16, 12], [13.5, 12 - open]));
    // A wall with a door of 0.7 m.
    all.push(box(firma, [20, 7, SUNK], [20.3, 11.65, 3]), box(firma, [20, 12.35, SUNK], [20.3, 16, 3]));
    all.push(box(firma, [20, 11.65, 2.1], [20.3, 12.35, 3]));
    all.push(box(firma, [40, 19, SUNK], [40.0625, 29, 3])); // a thin wall to run against
    return all;
}

/** Craters in the floor: shallow ones to walk through, and some with steep rims. */
const CRATERS = [[27, 9.5, 1.1], [29, 11, 1.05], [31, 9, 1.15], [33, 10.5, 1], [35, 9.5, 1.1], [28, 13, 0.9], [31, 13.5, 0.95], [34, 13, 0.9]];

/** What each station asks: where to begin, where to go in turn, and for how long at most. */
export const STATIONS = [
    { name: 'seams of a flat floor', start: [2.25, 20.25, 0], goals: [[30.4, 27.3]], seconds: 12 },
    { name: 'a floor with bumps', start: [2, 42, 0], goals: [[22, 50], [2, 50], [22, 42]], seconds: 22 },
    { name: 'steps of 0.3 m, up and down', start: [2, 3.5, 0], goals: [[14, 3.5]], seconds: 8 },
    { name: 'steps, along their edges', start: [2, 3.5, 0], goals: [[8, 3.5], [8, 7]], seconds: 8 },
    { name: 'a slope of 30 degrees', start: [16, 3.5, 0], goals: [[28, 3.5]], seconds: 8 },
    { name: 'a slope of 60 degrees', start: [30, 3.5, 0], goals: [[37, 3.5]], seconds: 4, closed: true },
    { name: 'a corner of 90 degrees', start: [7, 9, 0], goals: [[9.7, 11.7]], press: [11, 13], back: [7, 9], seconds: 6 },
    { name: 'a corner of 30 degrees', start: [12.5, 12, 0], goals: [[14.6, 12]], press: [18, 12], back: [12.5, 12], seconds: 6 },
    { name: 'a doorway of 0.7 m, askew', start: [17, 10.5, 0], goals: [[23, 13]], seconds: 6 },
    { name: 'through shallow craters', start: [25, 10, 0], goals: [[37, 10], [25, 9]], seconds: 14 },
    { name: 'through steep craters', start: [25.5, 13.3, 0], goals: [[36.5, 13.3]], seconds: 10 },
    { name: 'against a thin wall at 40 m/s', start: [30, 24, 0], goals: [[46, 24]], seconds: 2, speed: 40, closed: true },
];

/** Where to stand for two seconds. */
export const STANDS = [
    { name: 'flat', start: [2.5, 20.5, 0] },
    { name: 'on the slope of 30 degrees', start: [20, 3.5, 2 * tangent(30)] },
    { name: 'on the edge of a step', start: [4.35, 3.5, 0.6] },
    { name: 'on bumps', start: [11.3, 46.1, 0.1] },
    { name: "on a crater's side", start: [27.7, 9.5, 0.1] },
];

/** @returns { world, mesh }: the world as it was carved, and its triangles */
export function makeCourse(firma) {
    const hall = { low: [0, 0, 0], size: [48, 32, 6], count: [48, 32, 6], bump: 0 };
    const bumps = { low: [0, 40, 0], size: [24, 12, 4], count: [36, 18, 6], bump: 0.06 };
    let world = firma.worldFromMesh(panelRooms([hall, bumps]));
    const change = (cutter, pose, options) => {
        const { world: after, report } = world.carve(cutter, pose, options);
        if (report.status !== 'done') throw new Error(`the course cannot be made: ${report.status} ${report.reason}`);
        world.release();
        world = after;
        cutter.release();
    };
    for (const cutter of fillings(firma)) change(cutter, { position: [0, 0, 0] }, { fill: true });
    CRATERS.forEach(([x, y, z], k) => change(firma.crater('rocky', k + 1), { position: [x, y, z], rotation: firma.randomTurn(k), scale: 1.4 }));
    return { world, mesh: meshOfWorld(world) };
}

/** A world's triangles; their corners are on 1/262144 m, which float32 holds exactly up to 64 m. */
export function meshOfWorld(world) {
    const { positions, corners } = world.triangles();
    return welded(positions, corners);
}
