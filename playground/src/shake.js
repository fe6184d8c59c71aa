// SPDX-License-Identifier: MIT
// How a blast shakes who is near: the view turns to and fro, less and less. Not for those who asked for less motion.
const kFades = 5; // a second
const kMost = 0.05; // radians

/** How strong a blast is felt, 0..1, so many metres away. */
export const felt = (distance) => 1 / (1 + (distance / 5) ** 2);

export class Shake {
    /** @param still  nothing shakes */
    constructor(still = false) {
        this.still = still;
        this.strength = 0;
        this.time = 0;
    }

    /** @param strength  0..1 */
    add(strength) {
        if (!this.still) this.strength = Math.min(1, this.strength + strength);
    }

    step(dt) {
        this.time += dt;
        this.strength *= Math.exp(-kFades * dt);
        if (this.strength < 1e-3) this.strength = 0;
    }

    /** Radians to add to yaw, pitch and roll. */
    turn() {
        const size = kMost * this.strength;
        const t = this.time;
        return [size * Math.sin(47 * t), size * Math.sin(61 * t + 1), 0.7 * size * Math.sin(39 * t + 2)];
    }
}
