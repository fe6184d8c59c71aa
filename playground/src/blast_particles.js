// SPDX-License-Identifier: MIT
// What flies from a blast: fire for a moment, dust of the colour of what was hit, sparks that casts end at walls.
import { Chance } from './chance.js';
import { along, dot, times } from './vector.js';

const kFire = 10;
const kDust = 16;
const kSparks = 36;
const kSteelSparks = 80;

/** A direction within the half space that a normal points into, more along it. */
function outward(chance, normal) {
    const way = chance.way();
    const turned = dot(way, normal) < 0 ? times(way, -1) : way;
    const mixed = turned.map((x, k) => x + 0.8 * normal[k]);
    return times(mixed, 1 / Math.hypot(...mixed));
}

/**
 * @param dust, glow  Particles: what hides, what shines
 * @param reach  (from, path) => the fraction of a path that is free
 * @param what  { point, normal, colour: 0..255 each, metal: whether it is steel, seed }
 */
export function throwBlast(dust, glow, reach, { point, normal, colour, metal, seed }) {
    const chance = new Chance(seed);
    const from = along(point, normal, 0.12);
    for (let k = 0; k < kFire; ++k) {
        const velocity = times(outward(chance, normal), chance.between(1.5, 6));
        glow.add({ at: along(from, velocity, 0.03), velocity, drag: 4, fall: -1, colour: [1, chance.between(0.35, 0.62), chance.between(0.06, 0.2)],
            life: chance.between(0.22, 0.5), size: chance.between(0.35, 0.8), growth: 2.2, strength: 0.85 });
    }
    for (let k = 0; k < kDust; ++k) {
        const velocity = times(outward(chance, normal), chance.between(1, 5));
        const light = chance.between(0.75, 1.1) / 255;
        dust.add({ at: from, velocity, drag: 2.4, fall: 0.25, colour: colour.map((c) => Math.min(1, c * light)), life: chance.between(1.2, 3),
            size: chance.between(0.3, 0.6), growth: chance.between(0.5, 0.9), strength: chance.between(0.3, 0.55) });
    }
    for (let k = 0; k < (metal ? kSteelSparks : kSparks); ++k) {
        const velocity = times(outward(chance, normal), chance.between(4, metal ? 18 : 13));
        const life = chance.between(0.25, metal ? 1.1 : 0.7);
        const free = reach(from, times(velocity, life));
        glow.add({ at: from, velocity, drag: 0.6, fall: 9.81, colour: [1, chance.between(0.6, 0.9), chance.between(0.25, 0.55)], life: life * Math.max(0.15, free),
            size: chance.between(0.03, 0.06), strength: 1 });
    }
}

/** Behind a rocket, for dt seconds of its flight. */
export function trail(dust, glow, at, direction, seed) {
    const chance = new Chance(seed);
    glow.add({ at: along(at, direction, -0.25), velocity: times(direction, -2), colour: [1, 0.7, 0.3], life: 0.12, size: 0.16, growth: 0.5, strength: 0.9 });
    dust.add({ at: along(at, direction, -0.4), velocity: times(chance.way(), 0.3), drag: 1, fall: -0.2, colour: [0.72, 0.72, 0.74], life: chance.between(0.6, 1.1), size: 0.1, growth: 0.45, strength: 0.3 });
}

/** Where a body hits the ground. @param size  metres, about how large it is */
export function puff(dust, at, colour, size, seed) {
    const chance = new Chance(seed);
    for (let k = 0; k < 5; ++k) {
        const way = chance.way();
        dust.add({ at, velocity: [way[0] * 1.2, way[1] * 1.2, 0.2 + 0.4 * Math.abs(way[2])], drag: 2, colour: colour.map((c) => (c / 255) * chance.between(0.8, 1.1)),
            life: chance.between(0.6, 1.4), size: Math.min(0.8, 0.15 + 0.25 * size), growth: 0.5, strength: 0.3 });
    }
}
