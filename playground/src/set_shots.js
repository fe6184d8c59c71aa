// SPDX-License-Identifier: MIT
// Two scenes that the page plays by itself in our levels: a bridge shot at both ends, and a hole through a thin wall with
// a cast through it. `firma demo` shoots at the depot in the same way (cli/demo_depot.cpp).

/**
 * Of each level: where somebody stands to see it, and the shots. Metres and radians. `scale` and `seed` are those of a
 * rocky crater, which is not turned; `cast` is what is asked before and after.
 */
export const kSetShots = {
    'depot.map': {
        bridge: {
            stand: { feet: [20.5, 9.6, 0.01], yaw: 3.5, pitch: 0.3 },
            shots: [{ position: [14, 2, 3.75], scale: 2.2, seed: 3 }, { position: [14, 12, 3.75], scale: 2.2, seed: 3 }],
        },
        wall: {
            stand: { feet: [3.2, 16.4, 0.01], yaw: 0.5, pitch: -0.02 },
            shots: [{ position: [6.28125, 18, 1.5], scale: 0.5, seed: 7 }],
            cast: { from: [3, 18, 1.5], path: [12, 0, 0] },
        },
    },
    'first.obj': {
        bridge: {
            stand: { feet: [42.5, 25.2, 0.01], yaw: 2.4, pitch: 0.22 },
            shots: [{ position: [22, 29, 4.75], scale: 3, seed: 1 }, { position: [42, 29, 4.75], scale: 3, seed: 1 }],
        },
        wall: {
            stand: { feet: [13.2, 26.4, 0.01], yaw: 2.75, pitch: -0.05 },
            shots: [{ position: [10.025, 27.7, 1.4], scale: 0.5, seed: 7 }],
            cast: { from: [13, 27.7, 1.4], path: [-12, 0, 0] },
        },
    },
};

const kFirstWait = 0.5; // seconds: one looks there first
const kWait = 0.7; // between shots: each has a frame of its own

/** What a ray of the world meets, from room to room; null for nothing. @param name  of a room */
function look(world, { from, path }, materials, name) {
    const hit = world.cast({ centre: from, radius: 0, path }, { room: 'locate' });
    if (!hit.hit) return null;
    return { distance: hit.fraction * Math.hypot(...path), material: materials[hit.material], room: name(world.hitInfo(hit).room), point: hit.point };
}

export class SetShots {
    /** @param rooms  for their names */
    constructor(launcher, rooms, levelName) {
        this.launcher = launcher;
        this.rooms = rooms;
        this.plans = kSetShots[levelName] ?? {};
        this.told = null; // what came of the last scene, as numbers and names
        this.left = [];
    }

    /** Begins a scene; where to stand for it, or null where the level has none. */
    start(name) {
        const plan = this.plans[name];
        if (!plan) return null;
        this.left = [...plan.shots];
        this.cast = plan.cast ?? null;
        this.wait = kFirstWait;
        this.told = {
            name, shots: 0, all: plan.shots.length, done: 0, chunks: 0, crumbs: 0, volume: 0, mass: 0,
            largest: { volume: 0, mass: 0 }, portals: [], before: this.#look(), after: null,
        };
        return plan.stand;
    }

    /** What was not shot yet never is, and what came of the rest is no longer told. */
    stop() {
        this.left = [];
        this.told = null;
    }

    /** Time goes on; the shot that was fired within it, or null. At most one at a time. */
    step(dt) {
        if (this.left.length === 0) return null;
        this.wait -= dt;
        if (this.wait > 0) return null;
        this.wait = kWait;
        const { told } = this;
        const plan = this.left.shift();
        const shot = this.launcher.shootAt(plan);
        told.shots += 1;
        if (shot.status === 'done') this.#count(shot);
        if (this.left.length === 0) told.after = this.#look();
        return { ...shot, position: plan.position };
    }

    #count({ chunks, portals }) {
        const { told } = this;
        told.done += 1;
        told.chunks += chunks.count;
        told.crumbs += chunks.crumbs;
        told.volume += chunks.volume;
        told.mass += chunks.mass;
        if (chunks.largest.mass > told.largest.mass) told.largest = chunks.largest;
        told.portals.push(...portals);
    }

    #look() {
        return this.cast && look(this.launcher.world, this.cast, this.launcher.materials, (room) => this.rooms.name(room));
    }
}
