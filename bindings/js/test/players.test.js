// SPDX-License-Identifier: MIT
// Players: they fall, walk, jump, crouch, step, are pushed, ride; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { games, inRoom, makeSlab, near, TICK } from './game_helpers.js';
import { releasing, throwsCode } from './helpers.js';

/** work(room, capsule, walk), where walk(scene, player, wish, ticks) gives the last move. */
const withCapsule = (work) =>
    inRoom((room) =>
        releasing([games.playerCapsule()], (capsule) => {
            const walk = (scene, player, wish, ticks, rules) => {
                let move;
                for (let k = 0; k < ticks; ++k) {
                    move = games.movePlayer(scene, capsule, player, wish, TICK, rules);
                    player = move.player;
                }
                return move;
            };
            return work(room, capsule, walk);
        }),
    );

test('a player falls, stands, walks, and stops at a wall', () => {
    withCapsule((room, capsule, walk) => {
        const landed = walk(room, { position: [4, 4, 1] }, {}, 64);
        const { player } = landed;
        assert.deepEqual([player.onGround, player.stuck, player.groundPart], [true, false, null]);
        assert.equal(player.worldHash, room.hash());
        assert.equal(player.room, 0);
        near(player.position[2], 0.001, 1e-3);
        assert.deepEqual(player.groundNormal, [0, 0, 1]);
        const [ground] = landed.contacts;
        assert.deepEqual([ground.kind, ground.part, ground.portal], ['ground', null, null]);
        assert.equal(room.face(ground).normal[2], 1);
        // It stands to the bit.
        assert.deepEqual(walk(room, player, undefined, 64).player, { ...player, velocity: [0, 0, 0] });

        const before = structuredClone(player);
        const one = games.movePlayer(room, capsule, player, { velocity: [2, 0, 0] }, TICK);
        assert.deepEqual(player, before);
        near(one.player.velocity[0], 60 * TICK, 1e-9);
        const walked = walk(room, player, { velocity: [2, 0, 0] }, 64);
        near(walked.player.velocity[0], 2, 1e-9);
        const stopped = walk(room, player, { velocity: [6, 0, 0] }, 128);
        near(stopped.player.position[0], 7.7, 0.003);
        assert.deepEqual(stopped.contacts.map((one) => one.kind).sort(), ['ground', 'wall']);
        const wall = stopped.contacts.find((one) => one.kind === 'wall');
        near(wall.normal[0], -1, 1e-9);
        near(wall.point[0], 8, 1e-6);
    });
});

test('jumps land again, with the speed said', () => {
    withCapsule((room, capsule, walk) => {
        let move = walk(room, { position: [4, 4, 0.1] }, {}, 64);
        move = games.movePlayer(room, capsule, move.player, { jump: true }, TICK);
        assert.equal(move.jumped, true);
        assert.equal(move.player.onGround, false);
        let [top, landed] = [0, 0];
        for (let k = 0; k < 64 && landed === 0; ++k) {
            move = games.movePlayer(room, capsule, move.player, {}, TICK);
            top = Math.max(top, move.player.position[2]);
            landed = move.landedSpeed;
        }
        near(top, (4.4 * 4.4) / (2 * 9.81), 0.02);
        near(landed, 4.4, 0.2);
        const high = games.movePlayer(room, capsule, move.player, { jump: true }, TICK, { jumpSpeed: 8 });
        near(high.player.velocity[2], 8 - 9.81 * TICK, 0.1);
    });
});

test('steps, a beam to crouch under, and what it is too low for', () => {
    withCapsule((room, capsule, walk) => {
        const box = games.crater('box', 1);
        // A step of 0.25 m from x = 5 on: the box is 2 m wide.
        const { world: stepped } = room.carve(box, { position: [6, 4, -0.75] }, { fill: true });
        const { world: beamed } = stepped.carve(box, { position: [2, 4, 2.25] }, { fill: true });
        releasing([box, stepped, beamed], () => {
            const start = walk(beamed, { position: [4, 4, 0.1] }, {}, 64).player;
            let seen = false;
            let player = start;
            for (let k = 0; k < 48; ++k) {
                const move = games.movePlayer(beamed, capsule, player, { velocity: [2, 0, 0] }, TICK);
                seen ||= move.stepped;
                player = move.player;
            }
            assert.equal(seen, true);
            near(player.position[2], 0.251, 2e-3);
            assert.equal(player.onGround, true);
            // The beam is 1.25 m above the floor.
            const held = walk(beamed, start, { velocity: [-3, 0, 0] }, 64).player;
            assert.ok(held.position[0] > 3.2, `${held.position}`);
            const under = walk(beamed, start, { velocity: [-3, 0, 0], crouch: true }, 100).player;
            assert.ok(under.position[0] < 2.9 && under.crouched, `${under.position}`);
            const still = walk(beamed, { ...under, position: [2, 4, under.position[2]] }, {}, 10).player;
            assert.equal(still.crouched, true);
            assert.equal(games.playerFits(beamed, capsule, [2, 4, 0.01]), false);
            assert.equal(games.playerFits(beamed, capsule, [2, 4, 0.01], { crouched: true }), true);
            assert.equal(games.playerFits(beamed, capsule, [4, 4, 0.01]), true);
            assert.equal(games.playerFits(beamed, capsule, [-4, 4, 0.01]), false);
            assert.equal(games.playerFits(beamed, capsule, [2, 4, 0.01], { mask: 0 }), true);
        });
    });
});

test('what is filled where it stands pushes it out', () => {
    withCapsule((room, capsule, walk) => {
        const { player } = walk(room, { position: [4, 4, 0.1] }, {}, 64);
        const box = games.crater('box', 1);
        const { world: filled } = room.carve(box, { position: [3.2, 4, 1] }, { fill: true });
        releasing([box, filled], () => {
            const move = games.movePlayer(filled, capsule, player, {}, TICK);
            near(move.pushed[0], 0.5, 0.01);
            assert.equal(move.player.stuck, false);
            assert.equal(move.player.worldHash, filled.hash());
        });
    });
});

test('a lift carries it, a door pushes it, and between two it is crushed', () => {
    withCapsule((room, capsule) => {
        releasing([games.parts(), makeSlab(1, 1, 0.125), makeSlab(0.25, 1, 1)], (parts, lift, door) => {
            const scene = { world: room, parts };
            assert.equal(parts.add({ world: lift, motion: { position: [4, 4, 0.125] } }), 0);
            let move = { player: { position: [4, 4, 0.3] } };
            const tick = (wish) => (move = games.movePlayer(scene, capsule, move.player, wish, TICK));
            for (let k = 0; k < 32; ++k) tick({});
            assert.equal(move.player.groundPart, 0);
            for (let k = 0; k < 64; ++k) {
                parts.setMotions([{ position: [4, 4, 0.125 + k * TICK], path: [0, 0, TICK] }]);
                tick({});
            }
            near(move.player.position[2], 1.251, 5e-3);
            near(move.carried[2], TICK, 1e-3);
            near(move.player.groundVelocity[2], 1, 1e-6);
            assert.equal(move.contacts[0].part, 0);

            parts.set(0, { world: door, motion: { position: [1, 4, 1] } });
            move = { player: { position: [4, 4, 0.01] } };
            let pushed = null;
            let crushed = null;
            for (let k = 0; k < 256; ++k) {
                parts.setMotions([{ position: [1 + (k * 2) / 64, 4, 1], path: [2 / 64, 0, 0] }]);
                tick({});
                pushed ??= move.pushedBy;
                crushed ??= move.crushedBy;
                assert.equal(move.player.position[0] < 7.7, true);
            }
            assert.deepEqual([pushed, crushed], [0, 0]);
        });
    });
});

test('boxes, and spheres of a form of one\'s own, walk too', () => {
    inRoom((room) => {
        const shapes = [
            games.playerBox({ radius: 0.4, height: 0.5, crouchedHeight: 0.4 }),
            games.playerSpheres([0, 0, 0.5, 0.5, 0.5, 0, 0.5, 0.5]),
            games.playerSpheres(new Float64Array([0, 0, 0.5, 0.5]), [0, 0, 0.25, 0.25], [0, 0, 2]),
        ];
        releasing(shapes, () => {
            for (const shape of shapes) {
                let player = { position: [4, 4, 0.5] };
                for (let k = 0; k < 200; ++k)
                    ({ player } = games.movePlayer(room, shape, player, { velocity: [0, 3, 0] }, TICK));
                assert.equal(player.onGround, true);
                assert.ok(player.position[1] > 7 && player.position[1] < 8, `${player.position}`);
            }
        });
    });
});

test('bad numbers, by name', () => {
    withCapsule((room, capsule) => {
        const here = { position: [4, 4, 1] };
        const move = (changes) => {
            const { scene = room, shape = capsule, player = here, wish = {}, seconds = TICK, rules } = changes;
            return games.movePlayer(scene, shape, player, wish, seconds, rules);
        };
        move({});
        for (const seconds of [NaN, -1, 2]) throwsCode('OUT_OF_RANGE', () => move({ seconds }), /seconds/);
        throwsCode('OUT_OF_RANGE', () => move({ player: { position: [NaN, 0, 0] } }), /player/);
        throwsCode('OUT_OF_RANGE', () => move({ player: { ...here, groundVelocity: [Infinity, 0, 0] } }), /ground velocity/);
        throwsCode('OUT_OF_RANGE', () => move({ wish: { velocity: [Infinity, 0, 0] } }), /wish/);
        throwsCode('OUT_OF_RANGE', () => move({ rules: { gravity: NaN } }), /rules/);
        throwsCode('OUT_OF_RANGE', () => move({ scene: { world: room, from: 1, to: 0 } }), /stretch/);
        throwsCode('BAD_CALL', () => move({ player: { postion: [4, 4, 1] } }), /there is no postion/);
        throwsCode('BAD_CALL', () => move({ player: { position: [4, 4] } }), /position must have 3/);
        throwsCode('BAD_CALL', () => move({ player: { ...here, onGround: 1 } }), /onGround must be true or false/);
        throwsCode('BAD_CALL', () => move({ player: { ...here, worldHash: 'x' } }), /worldHash/);
        throwsCode('BAD_CALL', () => move({ player: { ...here, room: -1 } }), /room/);
        throwsCode('BAD_CALL', () => games.movePlayer(room, capsule, undefined, {}, TICK), /the player must be an object/);
        throwsCode('BAD_CALL', () => move({ wish: { speed: 3 } }), /the wish: there is no speed/);
        throwsCode('BAD_CALL', () => move({ wish: { jump: 1 } }), /jump must be true or false/);
        throwsCode('BAD_CALL', () => move({ rules: { slope: 3 } }), /the rules: there is no slope/);
        throwsCode('BAD_CALL', () => move({ seconds: null }), /seconds must be a number/);
        throwsCode('BAD_HANDLE', () => move({ shape: room }), /player shape/);
        throwsCode('BAD_HANDLE', () => move({ scene: capsule }), /world/);
        for (const size of [{ radius: 0 }, { height: 0.1 }, { crouchedHeight: 5 }, { up: [0, 0, 0] }, { radius: NaN }])
            throwsCode('INVALID', () => games.playerCapsule(size));
        throwsCode('BAD_CALL', () => games.playerBox({ width: 1 }), /there is no width/);
        throwsCode('INVALID', () => games.playerSpheres([]));
        throwsCode('BAD_CALL', () => games.playerSpheres([0, 0, 1]), /4 numbers/);
        throwsCode('INVALID', () => games.playerSpheres([0, 0, 1, -1]));
        throwsCode('OUT_OF_RANGE', () => games.playerFits(room, capsule, [NaN, 0, 0]), /position/);
        throwsCode('BAD_CALL', () => games.playerFits(room, capsule, [0, 0, 0], { crouch: true }), /there is no crouch,/);
        // A world that was read elsewhere, a hash that is none: it is only looked whether it overlaps.
        assert.equal(move({ player: { ...here, worldHash: 5, room: 99 } }).player.room, 0);
    });
});
