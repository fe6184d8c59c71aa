// SPDX-License-Identifier: MIT
// Where to begin in a level: a known place, or a free one with a floor below and a long view.
import { kCentres, kRadius } from './player.js';
import { kStopsWalk } from './masks.js';
import { direction } from './vector.js';

/** Feet, yaw, pitch for levels we know. */
const kKnown = {
    'first.obj': { feet: [42.5, 25.75, 0.01], yaw: Math.PI, pitch: 0.05 }, // in the hall, along the bridge
};

/** Where a level says that players start: { point, yaw } in metres and radians, or null. @param entities  of the level */
export function startOf(entities) {
    const start = entities.find(({ classname, origin }) => /^info_player_(start|deathmatch)$/.test(classname) && origin);
    if (!start) return null;
    return { point: start.origin, yaw: ((Number(start.values.get('angle')) || 0) * Math.PI) / 180 };
}

/** Feet on the floor below a point, or null: nothing there, or no room to stand. */
function standBelow(player, world, point) {
    if (world.locate(point).where === 'solid') return null;
    const hit = world.cast({ centre: point, radius: kRadius, path: [0, 0, -60] }, { mask: kStopsWalk });
    if (hit.status !== 'hit' || hit.normal[2] < 0.7) return null;
    const feet = [point[0], point[1], point[2] - 60 * hit.safeFraction - kCentres[0] + 0.001];
    return player.isFree(feet, world) ? feet : null;
}

/** How far one sees, and the direction in which that is farthest. */
function view(world, feet) {
    let best = { reach: 0, yaw: 0 };
    for (let k = 0; k < 16; ++k) {
        const yaw = (k * Math.PI) / 8;
        const d = direction(yaw, 0);
        const hit = world.cast({ centre: [feet[0], feet[1], feet[2] + 1.5], radius: 0, path: d.map((x) => x * 60) });
        const reach = hit.status === 'hit' ? 60 * hit.fraction : 0; // nothing to be seen is no view
        if (reach > best.reach) best = { reach, yaw };
    }
    return best;
}

/** Feet, yaw and pitch to begin with. @param start  what startOf() found; else looks at points of a growing lattice */
export function findSpawn(player, world, levelName, start = null) {
    const below = start && standBelow(player, world, start.point);
    if (below) return { feet: below, yaw: start.yaw, pitch: 0 };
    const known = kKnown[levelName];
    if (known && player.isFree(known.feet, world)) return known;
    const { low, high } = world.facts();
    for (const cells of [5, 11, 23, 37]) {
        let best = null;
        for (let i = 0; i < cells; ++i) {
            for (let j = 0; j < cells; ++j) {
                for (let k = 0; k < 5; ++k) {
                    const share = [(i + 0.5) / cells, (j + 0.5) / cells, (k + 0.5) / 5];
                    const feet = standBelow(player, world, share.map((s, a) => low[a] + s * (high[a] - low[a])));
                    if (!feet) continue;
                    const { reach, yaw } = view(world, feet);
                    if (!best || reach > best.reach) best = { reach, feet, yaw, pitch: 0 };
                }
            }
        }
        if (best && best.reach > 3) return best;
    }
    return { feet: low.map((x, a) => (x + high[a]) / 2), yaw: 0, pitch: 0 };
}
