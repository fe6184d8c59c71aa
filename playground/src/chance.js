// SPDX-License-Identifier: MIT
// Numbers that look like chance and are the same each time, for what is only seen or heard.
export class Chance {
    constructor(seed = 1) {
        this.state = (Math.imul(seed, 0x9e3779b1) ^ 0x5bd1e995) >>> 0;
    }

    /** In [0, 1). */
    next() {
        this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
        let h = this.state;
        h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
        return ((h ^ (h >>> 13)) >>> 0) / 4294967296;
    }

    between(low, high) {
        return low + (high - low) * this.next();
    }

    /** A unit vector, any way. */
    way() {
        const z = this.between(-1, 1);
        const angle = this.between(0, 2 * Math.PI);
        const r = Math.sqrt(Math.max(0, 1 - z * z));
        return [r * Math.cos(angle), r * Math.sin(angle), z];
    }
}
