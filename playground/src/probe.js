// SPDX-License-Identifier: MIT
// Casts through the world of the moment, counted and timed.
//
// Browsers round their clock (to 5 us where the page is isolated, else to 100 us), a cast takes some microseconds: so
// casts are timed in groups, and a group's time is divided by its casts. What is around them (a player's
// arithmetic) is counted in.
import { Samples } from './samples.js';

const kLeastGroup = 4; // casts: fewer say little by such a clock

const noCounts = () => ({ nodes: 0, boxes: 0, faces: 0, precise: 0 });

export class Probe {
    constructor(world) {
        this.world = world;
        this.microseconds = new Samples(240); // a cast, mean of a group
        this.group = { counts: noCounts(), casts: 0 }; // of the last group
    }

    /** Runs `work`, whose casts make a group. */
    measure(work) {
        this.group = { counts: noCounts(), casts: 0 };
        const start = performance.now();
        const result = work();
        const spent = (performance.now() - start) * 1000;
        if (this.group.casts >= kLeastGroup) this.microseconds.add(spent / this.group.casts);
        return result;
    }

    /** @param mask  what it is stopped by: masks.js; @param room  where it starts, if that is known; @param passed  gets the
     *     rooms on the way */
    cast(centre, radius, path, mask, room, passed) {
        this.group.casts += 1;
        return this.world.cast({ centre, radius, path }, { mask, room, passed, counts: this.group.counts });
    }
}
