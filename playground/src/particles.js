// SPDX-License-Identifier: MIT
// Specks that fly and fade, drawn as points: dust, smoke, fire, sparks. Numbers in arrays; nothing is made anew while it goes on.
const kFields = 3 + 3 + 3; // place, velocity, colour of each

export class Particles {
    /** @param most  how many there may be; the oldest give way */
    constructor(most) {
        this.most = most;
        this.numbers = new Float32Array(kFields * most);
        this.age = new Float32Array(most).fill(Infinity);
        this.life = new Float32Array(most).fill(1);
        this.size = new Float32Array(most); // metres at birth
        this.growth = new Float32Array(most); // metres a second
        this.fall = new Float32Array(most); // metres a second, a second
        this.drag = new Float32Array(most); // of the velocity, a second
        this.strength = new Float32Array(most);
        this.next = 0;
    }

    /** @param colour  0..1 each @param strength  how much it hides at first, 0..1 */
    add({ at, velocity, colour, life, size, growth = 0, fall = 0, drag = 0, strength = 1 }) {
        const k = this.next;
        this.next = (k + 1) % this.most;
        this.numbers.set(at, kFields * k);
        this.numbers.set(velocity, kFields * k + 3);
        this.numbers.set(colour, kFields * k + 6);
        for (const [name, value] of Object.entries({ age: 0, life, size, growth, fall, drag, strength })) this[name][k] = value;
    }

    step(dt) {
        const { numbers } = this;
        for (let k = 0; k < this.most; ++k) {
            if (this.age[k] >= this.life[k]) continue;
            this.age[k] += dt;
            const keep = Math.exp(-this.drag[k] * dt);
            const at = kFields * k;
            for (let axis = 0; axis < 3; ++axis) {
                numbers[at + 3 + axis] *= keep;
                if (axis === 2) numbers[at + 5] -= this.fall[k] * dt;
                numbers[at + axis] += numbers[at + 3 + axis] * dt;
            }
        }
    }

    /**
     * Those that are there, packed for the graphics card: place and size of each into `places`, colour and strength into
     * `colours`, four numbers each. @returns how many
     */
    pack(places, colours) {
        let count = 0;
        for (let k = 0; k < this.most; ++k) {
            const share = this.age[k] / this.life[k];
            if (!(share < 1)) continue;
            const [at, to] = [kFields * k, 4 * count++];
            for (let c = 0; c < 3; ++c) {
                places[to + c] = this.numbers[at + c];
                colours[to + c] = this.numbers[at + 6 + c];
            }
            places[to + 3] = this.size[k] + this.growth[k] * this.age[k];
            colours[to + 3] = this.strength[k] * (1 - share) * Math.min(1, this.age[k] * 30 + 0.3);
        }
        return count;
    }

    clear() {
        this.age.fill(Infinity);
    }

    get count() {
        return this.age.reduce((sum, age, k) => sum + (age < this.life[k]), 0);
    }
}
