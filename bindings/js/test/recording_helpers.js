// SPDX-License-Identifier: MIT
// What the tests of recordings share: the module, worlds as the C tests have them, and a small game.
import assert from 'node:assert/strict';
import { after } from 'node:test';
import { loadRecordings } from '../src/recordings.js';
import { boxMesh } from './helpers.js';

export const recordingsUrl = new URL('../src/firma_recordings.wasm', import.meta.url);

/** One instance for a test file; at its end nothing may be left in it. */
export const recordings = await loadRecordings();
after(() => assert.equal(recordings.liveHandles(), 0, 'handles were left'));

/** Runs work, and releases what `held` got meanwhile. */
export function holding(work) {
    const held = [];
    const hold = (object) => (held.push(object), object);
    try {
        return work(hold);
    } finally {
        for (const object of held) if (!object.released) object.release();
    }
}

/** The box from one corner to the other, its fronts outward or inward. */
export function boxWorld(low, high, outward) {
    const mesh = boxMesh(low, high);
    return recordings.worldFromMesh(outward ? { ...mesh, corners: mesh.corners.reverse() } : mesh);
}

/** A cutter: the box from one corner to the other. */
export const boxCutter = (low, high) => holding((hold) => recordings.cutterFromWorld(hold(boxWorld(low, high, true))));

/** A room of 8 x 8 x 4 m in rock, its corner at the origin: face 0 is the floor, 1 the ceiling. @param more  of the mesh */
export const makeLowRoom = (more = {}) =>
    recordings.worldFromMesh({
        positions: [0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0, 0, 0, 4, 8, 0, 4, 8, 8, 4, 0, 8, 4],
        corners: [0, 1, 2, 3, 4, 7, 6, 5, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0],
        cornerCounts: [4, 4, 4, 4, 4, 4],
        materials: [0, 1, 2, 2, 2, 2],
        materialNames: ['floor', 'ceiling', 'wall'],
        ...more,
    });

/** A room of 8 m in rock, with a column that hangs from its ceiling. */
export function makeHungRoom() {
    return holding((hold) => {
        const room = hold(boxWorld([0, 0, 0], [8, 8, 8], false));
        const column = hold(recordings.cutterFromWorld(hold(boxWorld([3, 3, 4], [4, 4, 9], true))));
        const { world } = room.carve(column, { position: [0, 0, 0] }, { fill: true });
        return hold(world).withAnchors();
    });
}

/** The name of the ball of makeGame(). */
export const BALL = 1n << 32n;
/** A door, a player who walks, a ball. */
export function makeGame(room) {
    return holding((hold) => {
        const game = recordings.game(room, 60);
        const stops = [
            { position: [6, 2, 0], seconds: 1 },
            { position: [6, 2, 2], wait: 1, seconds: 1 },
        ];
        const world = hold(boxWorld([-0.5, -0.125, 0], [0.5, 0.125, 2], true));
        assert.equal(game.addPart({ world, path: { stops }, name: 'door', waits: true }), 0);
        const shape = hold(recordings.playerCapsule());
        const player = { shape, player: { position: [1, 6, 0.01] }, wish: { velocity: [1, 0, 0] } };
        assert.equal(game.addPlayer(player), 0);
        const ball = hold(recordings.bodyShape([0, 0, 0, 0.25], recordings.massOfBall(0.25, 1000)));
        assert.equal(game.addBody(ball, { position: [2, 5, 1.5] }, { velocity: [1, 0, 0] }), BALL);
        return game;
    });
}

/** What happens by ticks, and the ticks from one to another. */
export function fight(game, from, to) {
    for (let tick = from; tick < to; ++tick) {
        if (tick === 2) game.setOff(0);
        if (tick === 5) game.fire(1, [6, 6, 2], [-30, -12, 4]);
        if (tick === 8) game.explode([3.5, 2.9, 6.5], { crater: 1.6 });
        if (tick === 20) game.wish(0, { velocity: [1, -1, 0], jump: true });
        if (tick === 20) game.fire(2, [6, 6, 2], [-3, 1, 2]);
        if (tick === 50)
            holding((hold) => {
                const crater = hold(recordings.crater('wedge', 4));
                const cut = hold(recordings.editCommand(1, crater, { position: [6, 6, 0], scale: 0.5 }));
                assert.equal(game.edit(cut), 'done');
            });
        game.step();
    }
}
