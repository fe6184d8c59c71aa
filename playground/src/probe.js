// SPDX-License-Identifier: MIT
// Casts through the world of the moment, and what they tested.

const noCounts = () => ({ nodes: 0, boxes: 0, faces: 0, precise: 0 });

export class Probe {
    constructor(world) {
        this.world = world;
        this.group = { counts: noCounts(), casts: 0 }; // of the last group
    }

    /** Runs `work`, whose casts make a group. */
    measure(work) {
        this.group = { counts: noCounts(), casts: 0 };
        return work();
    }

    /** @param mask  what it is stopped by: masks.js; @param room  where it starts, if that is known; @param passed  gets the
     *     rooms on the way */
    cast(centre, radius, path, mask, room, passed) {
        this.group.casts += 1;
        return this.world.cast({ centre, radius, path }, { mask, room, passed, counts: this.group.counts });
    }
}
