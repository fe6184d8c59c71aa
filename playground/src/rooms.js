// SPDX-License-Identifier: MIT
// Which room somebody is in, what rooms are called, and which portal he looks at.
import { cross, dot, subtract } from './vector.js';

export class Rooms {
    constructor(world) {
        this.here = null; // the room that was located last
        this.learn(world);
    }

    /** After each change of the world: edits join rooms and take portals away, doors open and close. */
    learn(world) {
        this.world = world;
        const { roomCount, portalCount } = world.facts();
        this.portals = Array.from({ length: portalCount }, (_, k) => world.portal(k));
        this.rooms = Array.from({ length: roomCount }, (_, k) => world.room(k));
        this.here = this.rooms[this.here]?.mergedInto ?? null;
    }

    /** The room that a point is in; on a face, or in the rock, the last one that was known. */
    locate(point) {
        const { room } = this.world.locate(point);
        if (room !== null) this.here = room;
        return this.here;
    }

    /** A name for people: the author's, or the number. */
    name(room) {
        return this.rooms[room]?.name || `${room}`;
    }

    /** The first portal along a view, with its distance; null when there is none within reach. */
    portalAlong(eye, direction, reach) {
        let best = null;
        this.portals.forEach(({ polygons }, portal) => {
            for (const corners of polygons) {
                const distance = distanceTo(corners, eye, direction);
                if (distance <= (best?.distance ?? reach)) best = { portal, distance };
            }
        });
        return best;
    }
}

/** Square metres of convex polygons, as portals have them. */
export function areaOf(polygons) {
    let sum = 0;
    for (const corners of polygons) {
        const at = (k) => [corners[k], corners[k + 1], corners[k + 2]];
        for (let k = 3; k + 3 < corners.length; k += 3) {
            const normal = cross(subtract(at(k), at(0)), subtract(at(k + 3), at(0)));
            sum += Math.sqrt(dot(normal, normal)) / 2;
        }
    }
    return sum;
}

/** How far a ray goes to a convex polygon, from either side; Infinity when it passes by. */
function distanceTo(corners, eye, direction) {
    const at = (k) => [corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]];
    const count = corners.length / 3;
    const normal = cross(subtract(at(1), at(0)), subtract(at(2), at(0)));
    const along = dot(normal, direction);
    const distance = dot(normal, subtract(at(0), eye)) / along;
    if (!(along !== 0 && distance > 0)) return Infinity;
    const point = eye.map((x, axis) => x + distance * direction[axis]);
    for (let k = 0; k < count; ++k) {
        const from = at(k);
        const edge = subtract(at((k + 1) % count), from);
        if (dot(cross(edge, subtract(point, from)), normal) < 0) return Infinity;
    }
    return distance;
}
