// SPDX-License-Identifier: MIT
// Debris, blasts, parts that break, paths, convex pieces and supports with arguments of every kind: an answer or a
// FirmaError, no handle left, and the module never stops.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FirmaError, Projectiles } from '../src/recordings.js';
import { boxCutter, boxWorld, holding, makeHungRoom, recordings } from './recording_helpers.js';
import { random } from './scenario.js';

const next = random(79);
const below = (count) => Math.floor(next() * count);
const pick = (list) => list[below(list.length)];
const odd = [0, -0, 1, -1, 0.5, 3, 1e-300, 1e9, 1e300, 2 ** 32 - 1, 2 ** 32, NaN, Infinity, -Infinity];
const vectorOf = (length) => Array.from({ length }, () => (next() < 0.9 ? next() * 8 : pick(odd)));
const flagOf = () => pick([true, false, undefined, 1]);
const few = () => pick([undefined, 0, 1, 4, 4, 12, -1, 0.5, 1e9]);

test('arguments of every kind', () => {
    holding((hold) => {
        const room = hold(makeHungRoom());
        const block = hold(boxWorld([-0.5, -0.5, 0], [0.5, 0.5, 1], true));
        const crater = hold(recordings.crater('rocky', 1));
        const cut = hold(boxCutter([2, 2, 5], [5, 5, 5.5]));
        const carved = room.carve(cut, { position: [0, 0, 0] }, { chunks: true });
        const [world, chunks] = [hold(carved.world), hold(carved.report.loose)];
        const [bodies, debris, parts] = [hold(recordings.bodies()), hold(recordings.debris()), hold(recordings.parts())];
        const supports = hold(recordings.findSupports(room, [{ low: [1, 1, 0], high: [2, 2, 1] }]));
        const released = recordings.debris();
        released.release();
        const shots = new Projectiles();
        shots.add({ position: [1, 1, 1], velocity: [100, 20, 3] });
        const handles = [room, block, crater, world, chunks, bodies, debris, parts, supports, released];
        const pose = () => ({ position: vectorOf(3), rotation: pick([undefined, vectorOf(4)]), scale: pick([undefined, 1, ...odd]) });
        const blast = () => ({ at: vectorOf(3), radius: pick([undefined, 4, ...odd]), impulse: pick([undefined, 100, ...odd]) });
        const pattern = () => ({
            style: pick(['lumps', 'bricks', 'shards', 'none']),
            sizeOfPiece: [0.2 + next(), 0.2 + next(), pick([0.4, 0.4, ...odd])],
            growth: pick([undefined, 0.5, ...odd]),
            crooked: pick([undefined, 0.5, ...odd]),
            axes: pick([undefined, null, vectorOf(4)]),
            brickCorner: pick([undefined, null, vectorOf(3)]),
        });
        const fracture = () => ({ maxPieces: few(), impact: pick([undefined, vectorOf(3)]), minVolume: pick([undefined, ...odd]), seed: pick([undefined, 2, 5n, -1]) });
        const breaks = () => ({ maxPieces: few(), maxSpheres: few(), fraction: pick([undefined, 0.5, ...odd]), seconds: pick([undefined, 1, ...odd]), unbroken: flagOf(), portals: pick([undefined, [], [0], [-1], 'x']) });
        const breakable = () => ({ matter: pick([null, 0, 9]), health: pick([1, ...odd]), whole: pick([1, ...odd]), maxTaken: pick([0.5, ...odd]), damage: pick([0, ...odd]), broken: flagOf() });
        const thing = () => ({ kind: pick([undefined, 'stands', 'hangs', 'floats']), low: vectorOf(3), high: vectorOf(3), reach: pick([undefined, 1, ...odd]), mask: pick([undefined, 1, ...odd]) });
        const makers = [
            () => undefined,
            () => null,
            () => pick([true, '', 'lumps', Symbol('s'), 5n]),
            () => pick(odd),
            () => vectorOf(pick([0, 3, 3, 4, 8])),
            () => Float64Array.from(vectorOf(pick([3, 4, 8]))),
            () => pick(bodies.list().concat([0n, 2n ** 64n])),
            () => ({ start: vectorOf(3), path: vectorOf(3) }),
            () => ({ panes: flagOf(), matters: flagOf(), mask: pick(odd), bothSides: flagOf() }),
            () => ({ maxPieces: few(), maxConcavity: pick(odd), density: pick(odd) }),
            () => ({ maxBodies: few(), maxAsleep: pick(odd), maxAge: pick(odd), toGround: flagOf(), keepClear: pick([undefined, vectorOf(4), 3]) }),
            () => ({ breakRadius: pick([undefined, ...odd]), maxPieces: few(), carve: pick([undefined, { material: 'x' }, { fill: true }, { chunks: false }]) }),
            () => ({ holdLargest: flagOf(), touch: pick([undefined, ...odd]), pieces: breaks(), breakable: pick([undefined, breakable()]) }),
            () => ({ world: pick([room, undefined]), parts, from: pick(odd) }),
            () => ({ resistance: pick(odd) }),
            () => shots,
            () => [thing(), thing()],
            pose,
            blast,
            pattern,
            fracture,
            breaks,
            breakable,
        ];
        const id = () => pick(bodies.list().concat([0n]));
        // Two times in three what such a call begins with.
        const first = {
            addChunk: () => [bodies, chunks, 0, { maxSpheres: 4 }],
            get: () => [bodies, id()],
            world: () => [bodies, id()],
            remove: () => [bodies, id()],
            shatter: () => [bodies, id(), pattern(), fracture()],
            tend: () => [bodies, world, pick([0.1, 1, ...odd])],
            explode: () => [bodies, world, blast(), pick([crater, null]), pose()],
            breakPart: () => [bodies, parts, below(parts.count()), world, breaks()],
            carvePart: () => [bodies, parts, below(parts.count()), world, crater, pose()],
            diff: () => [world, pick([room, undefined])],
            fracture: () => [block, pattern(), fracture()],
            fracturePattern: () => [room, 0],
            exposure: () => [world, vectorOf(3), vectorOf(4)],
            pushBlast: () => [world, bodies, blast()],
            blastShare: () => [blast(), next()],
            blastImpulse: () => [blast(), vectorOf(3), next()],
            partWorld: () => [parts, below(parts.count())],
            partPortals: () => [parts, below(parts.count()), world],
            breakable: () => [parts, below(parts.count())],
            hurt: () => [breakable(), pick([1, ...odd])],
            blastFelt: () => [parts, below(parts.count()), world, blast()],
            flyScene: () => [shots, { world, parts }, 1 / 64],
            pierce: () => [pick([room, world]), { start: vectorOf(3), path: vectorOf(3) }],
            convexPieces: () => [block],
            convexPiecesOfChunk: () => [chunks, 0],
            findSupports: () => [room, [thing()]],
        };
        const others = ['constructor', 'game', 'unpackGame', 'unpackRecording', 'kindOfBytes'];
        const answers = { returned: 0 };
        for (let round = 0; round < 120; ++round) {
            if (parts.count() < 8) parts.add({ world: block, motion: { position: vectorOf(3).map((x) => (Math.abs(x) < 8 ? x : 4)), path: [0, 0, next()] } });
            for (const object of [recordings, debris, supports]) {
                for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(object))) {
                    if (others.includes(name)) continue;
                    if (name === 'addChunk' && bodies.count() > 20) continue;
                    const given = Array.from({ length: below(5) }, () => (next() < 0.2 ? pick(handles) : pick(makers)()));
                    if (first[name] && next() < 0.67) {
                        const begin = first[name]();
                        given.splice(0, begin.length, ...begin);
                    }
                    const before = recordings.liveHandles();
                    try {
                        const answer = object[name](...given);
                        ++answers.returned;
                        for (const one of [answer, answer?.world, answer?.after, answer?.cutter])
                            if (typeof one?.release === 'function') one.release();
                    } catch (error) {
                        if (!(error instanceof FirmaError) || error.code === 'INTERNAL') {
                            error.message += ` (${name}, round ${round}, ${given.map((one) => typeof one)})`;
                            throw error;
                        }
                        assert.notEqual(error.message, '');
                        answers[error.code] = (answers[error.code] ?? 0) + 1;
                    }
                    assert.equal(recordings.liveHandles(), before, `${name} left handles`);
                }
            }
        }
        world.check();
        const seen = JSON.stringify(answers);
        assert.ok(answers.returned > 400, seen);
        for (const code of ['BAD_CALL', 'BAD_HANDLE', 'INVALID', 'OUT_OF_RANGE']) assert.ok(answers[code] > 3, seen);
    });
});
