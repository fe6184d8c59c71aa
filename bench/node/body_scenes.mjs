// SPDX-License-Identifier: MIT
// Scenes of bodies that all contenders get: the same level of triangles, the same sets of spheres with the same mass.
import { Rng } from './scene.mjs';

/** A body's kind: its spheres (four numbers each, middle at the origin), half of its box, kilograms, and the inertia about its axes. */
function kindOf(name, spheres, half, density) {
    const [x, y, z] = half;
    const mass = 8 * x * y * z * density;
    const inertia = [y * y + z * z, x * x + z * z, x * x + y * y].map((sum) => (mass * sum) / 3);
    const reach = Math.max(...spheres.map(([a, b, c, r]) => Math.hypot(a, b, c) + r));
    return { name, spheres: Float64Array.from(spheres.flat()), half, mass, inertia, reach };
}

function ball() {
    const r = 0.25;
    const mass = (4 / 3) * Math.PI * r ** 3 * 1000;
    const inertia = Array(3).fill(0.4 * mass * r * r);
    return { name: 'ball', spheres: Float64Array.of(0, 0, 0, r), half: null, mass, inertia, reach: r };
}

/** Eight balls in the corners of a box of half a metre: as bench/bodies has it. */
function crate(density) {
    const corner = (k, axis) => ((k >> axis) & 1 ? 0.125 : -0.125);
    return kindOf('crate', Array.from({ length: 8 }, (_, k) => [corner(k, 0), corner(k, 1), corner(k, 2), 0.125]), [0.25, 0.25, 0.25], density);
}

function plank() {
    return kindOf('plank', Array.from({ length: 9 }, (_, k) => [(k - 4) * 0.15, 0, 0, 0.1]), [0.7, 0.1, 0.1], 700);
}

/** Pairs of balls, opposite each other, so that the middle is that of every library. */
function rock(rng) {
    const spheres = [[0, 0, 0, 0.2]];
    for (let k = 0; k < 6; ++k) {
        const at = [0, 1, 2].map(() => rng.uniform(-0.2, 0.2));
        const radius = rng.uniform(0.06, 0.14);
        spheres.push([...at, radius], [...at.map((x) => -x), radius]);
    }
    return { ...kindOf('rock', spheres, [0.25, 0.25, 0.25], 1400), half: null };
}

/** Where a body has room: in the air, clear of the level and of those before. */
function roomFor(rng, world, low, high, reach, taken) {
    for (;;) {
        const at = low.map((from, axis) => rng.uniform(from, high[axis]));
        if (taken.some((one) => Math.hypot(...one.at.map((x, axis) => x - at[axis])) < one.reach + reach)) continue;
        if (world.locate(at).where !== 'air' || world.closest(at, reach + 0.02) !== null) continue;
        taken.push({ at, reach });
        return at;
    }
}

/** @param least, most  metres a second */
function scattered(name, level, count, least, most, seed) {
    const rng = new Rng(seed);
    const rocks = Array.from({ length: 8 }, () => rock(rng));
    const [one, box, long] = [ball(), crate(1000), plank()];
    const taken = [];
    const bodies = Array.from({ length: count }, (_, k) => {
        const kind = [box, long, rocks[k % 8], one][k % 4];
        const position = roomFor(rng, level.world, level.low, level.high, kind.reach, taken);
        const turn = [0, 1, 2, 3].map(() => rng.uniform(-1, 1));
        const size = Math.hypot(...turn);
        const way = [0, 1, 2].map(() => rng.uniform(-1, 1));
        const speed = most === 0 ? 0 : least * (most / least) ** rng.uniform();
        const far = Math.hypot(...way);
        const spin = [0, 1, 2].map(() => (most === 0 ? 0 : rng.uniform(-5, 5)));
        return { kind, position, rotation: turn.map((part) => part / size), velocity: way.map((x) => (x * speed) / far), spin };
    });
    return { name, level, bodies, seconds: 6 };
}

/** A floor of 256 m, 4 m thick. */
function slab(firma) {
    const positions = [];
    for (let k = 0; k < 8; ++k) positions.push(k & 1 ? 128 : -128, k & 2 ? 128 : -128, k & 4 ? 0 : -4);
    const quads = [0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6];
    const corners = [];
    for (let k = 0; k < 24; k += 4) {
        const [a, b, c, d] = quads.slice(k, k + 4);
        corners.push(a, b, c, a, c, d);
    }
    const mesh = { positions: Float64Array.from(positions), corners: Uint32Array.from(corners) };
    return { mesh, world: firma.worldFromMesh(mesh), low: [-128, -128, 0], high: [128, 128, 20] };
}

/** @param highest  kilograms a cubic metre, of the highest crate of each */
function stacks(name, firma, count, height, highest) {
    const [kind, top] = [crate(1000), crate(highest)];
    const bodies = [];
    for (let stack = 0; stack < count; ++stack)
        for (let k = 0; k < height; ++k)
            bodies.push({ kind: k + 1 < height ? kind : top, position: [2 * stack, 0, 0.25 + 0.5 * k], rotation: [0, 0, 0, 1], velocity: [0, 0, 0], spin: [0, 0, 0] });
    return { name, level: slab(firma), bodies, seconds: 6 };
}

/** @param mesh of the level, triangles */
const levelOf = (mesh, world) => ({ mesh, world, ...(({ low, high }) => ({ low, high }))(world.facts()) });

/** @param depot  world of levels/depot.map: the others get its triangles */
export function bodyScenes(firma, mesh, depot, quick) {
    const level = levelOf(mesh, firma.worldFromMesh(mesh));
    const { positions, corners } = depot.triangles({ solidOnly: true });
    const hall = levelOf({ positions: Float64Array.from(positions), corners }, depot);
    const share = quick ? 15 : 1;
    const scenes = [
        scattered('dropped', level, 150 / share, 0, 0, 5),
        scattered('thrown at 1-30 m/s', level, 150 / share, 1, 30, 6),
        scattered('shot at 100-300 m/s', level, 150 / share, 100, 300, 7),
        scattered('thrown, depot', hall, 150 / share, 1, 30, 8),
        stacks('stacks', firma, quick ? 1 : 15, 10, 1000),
        stacks('heavy on light', firma, quick ? 1 : 15, 4, 1_000_000),
    ];
    for (const scene of scenes) if (quick) scene.seconds = 0.5;
    return scenes;
}
