// SPDX-License-Identifier: MIT
// The cuts of tests/full/same_cuts.cpp, whose native hash the module must have too.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { firma, levelBytes } from './helpers.js';

/** scenes/rng.h: splitmix64. */
class Rng {
    #state;
    constructor(seed) {
        this.#state = BigInt(seed);
    }
    next() {
        const cut = (z) => BigInt.asUintN(64, z);
        this.#state = cut(this.#state + 0x9e3779b97f4a7c15n);
        let z = this.#state;
        z = cut((z ^ (z >> 30n)) * 0xbf58476d1ce4e5b9n);
        z = cut((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
        return z ^ (z >> 31n);
    }
    uniform(low = 0, high = 1) {
        return low + (high - low) * (Number(this.next() >> 11n) * 2 ** -53);
    }
    below(count) {
        return Number(((this.next() >> 32n) * BigInt(count)) >> 32n);
    }
}

test('sixty cuts leave the world that the native library leaves', async () => {
    let world = await firma.worldFromObj(levelBytes, { name: 'first.obj' });
    const { low, high } = world.facts();
    const rng = new Rng(20031);
    const shapes = ['rocky', 'spiky', 'drill', 'wedge', 'box'];
    let [done, retries] = [0, 0];
    for (let cut = 0; cut < 60; ++cut) {
        const position = [0, 1, 2].map((axis) => {
            const at = rng.uniform(low[axis], high[axis]);
            return cut % 3 ? at : Math.trunc(at);
        });
        const turn = rng.next();
        const rotation = cut % 3 ? firma.randomTurn(turn) : undefined;
        const scale = rng.uniform(0.5, 3);
        const shape = shapes[rng.below(5)];
        const cutter = firma.crater(shape, rng.next());
        const { world: after, report } = world.carve(
            cutter,
            { position, rotation, scale },
            { fill: rng.uniform() < 0.1 },
        );
        done += report.status === 'done';
        retries += report.retries;
        cutter.release();
        world.release();
        world = after;
    }
    const hash = world.hash().toString(16).padStart(16, '0');
    const said = `done=${done} retries=${retries} faces=${world.facts().faceCount} world=${hash}`;
    world.check();
    world.release();
    // What `same_cuts levels/first.obj 60` prints, of any compiler.
    assert.equal(said, 'done=48 retries=0 faces=10702 world=3a73c54938257306');
});
