// SPDX-License-Identifier: MIT
// Rockets: straight and fast, a particle cast for each of them in each step, until it meets something.
import { along, times } from './vector.js';

export const kSpeed = 42; // metres a second
const kSeconds = 6; // then it is out of the level

export class Rockets {
    /** @param cast  (from, path) => what is met, as Launcher.meet(), or null */
    constructor(cast) {
        this.cast = cast;
        this.flying = []; // { position, direction, age, number }
        this.fired = 0;
    }

    /** @param direction  a unit vector @param shift  metres, where it is drawn at first beside where it is */
    launch(position, direction, shift = [0, 0, 0]) {
        this.flying.push({ position: [...position], direction: [...direction], shift, age: 0, number: ++this.fired });
    }

    /** Time goes on; what was met: [{ target, direction }], in the order of launching. */
    step(dt) {
        const met = [];
        this.flying = this.flying.filter((rocket) => {
            const path = times(rocket.direction, kSpeed * dt);
            const target = this.cast(rocket.position, path);
            if (target) met.push({ target, direction: rocket.direction });
            rocket.position = along(rocket.position, path, 1);
            rocket.age += dt;
            return !target && rocket.age < kSeconds;
        });
        return met;
    }

    /** Where one is drawn: it comes from beside the eye. */
    static seenAt({ position, shift, age }) {
        return along(position, shift, Math.max(0, 1 - age * 5));
    }

    clear() {
        this.flying = [];
    }
}
