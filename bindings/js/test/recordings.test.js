// SPDX-License-Identifier: MIT
// Games as one value: what they go by, what happens in them, saved and loaded, recorded and replayed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { FirmaError, loadRecordings, Projectiles } from '../src/recordings.js';
import { loadGames } from '../src/games.js';
import { levelBytes, throwsCode } from './helpers.js';
import { BALL, boxWorld, fight, holding, makeGame, makeHungRoom, recordings, recordingsUrl } from './recording_helpers.js';

test('the module is one of games, too, and no other module is it', async () => {
    const games = await loadGames(recordingsUrl);
    const world = await games.worldFromObj(levelBytes); // its readers lie where the package has them
    world.release();
    const one = await loadRecordings(new Response(readFileSync(recordingsUrl)));
    assert.equal(one.version, recordings.version);
    await assert.rejects(loadRecordings(new URL('../src/firma_games.wasm', import.meta.url)), (error) => {
        assert.ok(error instanceof FirmaError);
        assert.equal(error.code, 'UNSUPPORTED');
        assert.match(error.message, /^loadRecordings: not Firma's module of recordings$/);
        return true;
    });
    for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(games))) assert.ok(name in recordings, name);
});

test('rules and weapons are told, set, and refused', () => {
    holding((hold) => {
        const game = hold(recordings.game(hold(makeHungRoom()), 120));
        const { tick, rate, weapons, recorded, replay } = game.facts();
        assert.deepEqual([tick, rate, weapons, recorded, replay], [0, 120, 3, false, false]);
        const before = game.hash();
        game.setRules(game.rules());
        for (const k of [0, 1, 2]) game.setWeapon(k, game.weapon(k));
        assert.equal(game.hash(), before);
        assert.deepEqual(
            [0, 1, 2].map((k) => [game.weapon(k).name, game.weapon(k).charge?.crater]),
            [
                ['bullet', undefined],
                ['rocket', 1.2],
                ['grenade', 0.8],
            ],
        );
        game.setRules({ chunks: false, seed: 2n ** 63n, bodies: { gravity: [0, 0, -3] }, debris: { maxBodies: 7, toGround: true } });
        const rules = game.rules();
        assert.deepEqual(
            [rules.chunks, rules.seed, rules.bodies.gravity[2], rules.debris.maxBodies, rules.debris.toGround],
            [false, 2n ** 63n, -3, 7, true],
        );
        assert.equal(rules.maxBlastSpeed, 30);
        const index = game.addWeapon({ name: 'mörser', terms: { restitution: 0.5 }, charge: { shape: 'spiky', material: 'soot' } });
        assert.equal(index, 3);
        const made = game.weapon(3);
        assert.deepEqual([made.name, made.charge.shape, made.charge.material], ['mörser', 'spiky', 'soot']);
        assert.deepEqual([made.terms.restitution, made.terms.friction, made.fuse], [0.5, 0.3, 10]);
        const now = game.hash();
        throwsCode('INVALID', () => game.addWeapon({ name: 'x', mass: 0 }), /weapon x/);
        throwsCode('BAD_CALL', () => game.addWeapon({ mas: 1 }), /there is no mas/);
        throwsCode('BAD_CALL', () => game.addWeapon({ charge: { shape: 'round' } }), /shape must be one of/);
        throwsCode('OUT_OF_RANGE', () => game.weapon(4), /weapon 4/);
        throwsCode('OUT_OF_RANGE', () => game.setRules({ debris: { maxAge: -1 } }));
        throwsCode('BAD_CALL', () => game.setRules({ debris: { maxBodies: -1 } }), /maxBodies/);
        throwsCode('INVALID', () => recordings.game(hold(makeHungRoom()), 2), /rate/);
        assert.equal(game.hash(), now);
    });
});

test('what happens is in the report, and what is there can be asked', () => {
    holding((hold) => {
        const room = hold(makeHungRoom());
        const game = hold(makeGame(room));
        fight(game, 0, 8);
        assert.equal(game.part(0).atFirstStop, false);
        assert.deepEqual([game.part(0).name, game.part(0).started, game.part(0).waits], ['door', 2, true]);
        assert.ok(game.part(0).motion.path[2] > 0);
        const rockets = game.projectiles(1);
        assert.ok(rockets instanceof Projectiles);
        assert.ok(rockets.count === 0 || rockets.get(0).mass === 2);
        game.explode([3.5, 2.9, 6.5], { crater: 1.6 });
        const alone = game.report();
        assert.deepEqual([alone.blasts.length, alone.moves.length, alone.edits], [1, 0, 1]);
        const [blast] = alone.blasts;
        assert.deepEqual([blast.at, blast.status], [[3.5, 2.9, 6.5], 'done']);
        assert.ok(alone.loose > 2 && blast.loose.length === alone.loose);
        game.step();
        const report = game.report();
        assert.equal(report.moves.length, 1);
        assert.deepEqual(report.moves[0].player, game.player(0).player);
        assert.ok(report.bodies.awake > 1);
        assert.equal(report.blasts.length, 1);
        assert.deepEqual(game.player(0).wish.velocity, [1, 0, 0]);
        const { up, ...size } = game.playerSize(0);
        assert.deepEqual([size, up], [{ radius: 0.3, height: 1.8, crouchedHeight: 1.1 }, [0, 0, 1]]);
        // Bodies: one of them a ball, those of the column with their solids.
        const bodies = hold(game.bodies());
        assert.equal(bodies.count(), game.facts().bodies);
        assert.deepEqual(Array.from(game.bodySpheres(BALL)), [0, 0, 0, 0.25]);
        const solid = hold(game.bodySolid(blast.loose[0]));
        assert.ok(solid.facts().faceCount >= 4);
        const debris = hold(game.debris());
        assert.equal(debris.get(bodies, blast.loose[0]).faceCount, solid.facts().faceCount);
        throwsCode('INVALID', () => game.bodySolid(BALL), /no debris/);
        throwsCode('INVALID', () => game.bodySpheres(77n), /no such body/);
        throwsCode('BAD_CALL', () => game.bodySpheres(7), /BigInt/);
        // A bullet, until it meets something.
        game.fire(0, [6, 6, 2], [40, 10, 0]);
        let events = [];
        for (let k = 0; k < 60 && events.length === 0; ++k) {
            game.step();
            events = game.report().shotEvents.filter((event) => event.weapon === 0);
        }
        assert.ok(['ricochet', 'stopped', 'entered'].includes(events[0].kind));
        assert.ok(!('lengths' in events[0]));
        assert.deepEqual([events[0].part, events[0].inPart], [null, [0, 0, 0]]);
        // One at the door.
        const leaf = game.part(0).motion.position;
        game.fire(0, [leaf[0], leaf[1] + 1, leaf[2] + 1], [0, -100, 0]);
        game.step();
        const [met] = game.report().shotEvents.filter((event) => event.weapon === 0);
        assert.equal(met.part, 0);
        assert.ok(Math.abs(met.inPart[1] - 0.125) < 1e-3, `${met.inPart}`);
        const log = hold(game.log());
        assert.ok(log.facts().commandCount >= 1);
        assert.equal(hold(game.parts()).count(), 1);
        assert.notEqual(hold(game.world()).hash(), room.hash());
        for (const item of ['world', 'part', 'player', 'body', 'debris', 'rest']) assert.ok(game.hashItems(item).length > 0);
        throwsCode('BAD_CALL', () => game.hashItems('door'), /item must be one of/);
        const before = game.hash();
        throwsCode('INVALID', () => game.fire(9, [0, 0, 0], [0, 0, 0]), /weapon 9/);
        throwsCode('INVALID', () => game.setOff(3), /part 3/);
        throwsCode('OUT_OF_RANGE', () => game.explode([NaN, 0, 0]), /blast/);
        throwsCode('BAD_CALL', () => game.wish(0, { run: true }), /there is no run/);
        throwsCode('BAD_CALL', () => game.addPart(), /must be an object/);
        throwsCode('BAD_CALL', () => game.addPart({ world: room, whenBlocked: 'waits' }), /one of stops, returns, crushes/);
        throwsCode('BAD_HANDLE', () => game.addPlayer({ shape: room }), /player shape/);
        assert.equal(game.hash(), before);
    });
});

test('a lift that would crush a ball against the ceiling waits, goes back, or goes on', () => {
    for (const [whenBlocked, crushes] of [['stops', false], ['returns', false], ['crushes', true]])
        holding((hold) => {
            const room = hold(makeHungRoom());
            const game = hold(recordings.game(room, 60));
            const slab = hold(boxWorld([-0.5, -0.5, -0.25], [0.5, 0.5, 0], true));
            const top = 8;
            const stops = [
                { position: [2, 6, 0.5], seconds: 2 },
                { position: [2, 6, top - 0.1], wait: 0.5, seconds: 2 },
            ];
            game.addPart({ world: slab, path: { stops }, waits: true, whenBlocked });
            const ball = hold(recordings.bodyShape([0, 0, 0, 0.25], recordings.massOfBall(0.25, 1000)));
            game.addBody(ball, { position: [2, 6, 0.76] });
            game.setOff(0);
            let highest = -Infinity;
            let crushed = 0;
            for (let tick = 0; tick < 130; ++tick) {
                game.step();
                crushed += game.report().bodies.crushed > 0;
                highest = Math.max(highest, game.part(0).motion.position[2] + game.part(0).motion.path[2]);
            }
            assert.equal(game.part(0).whenBlocked, whenBlocked);
            assert.equal(crushed > 0, crushes, `${whenBlocked}: ${crushed}`);
            assert.equal(highest > top - 0.45, crushes, `${whenBlocked}: ${top - highest}`);
        });
});

test('a saved game goes on as what was not saved', () => {
    holding((hold) => {
        const room = hold(makeHungRoom());
        const game = hold(makeGame(room));
        fight(game, 0, 40);
        const bytes = game.pack();
        assert.equal(recordings.kindOfBytes(bytes), 'game');
        assert.equal(recordings.kindOfBytes(new Uint8Array(3)), 'other');
        const loaded = hold(recordings.unpackGame(bytes, 'half.firma'));
        assert.equal(loaded.hash(), game.hash());
        assert.equal(hold(recordings.unpackWorld(bytes)).hash(), hold(game.world()).hash());
        for (const one of [game, loaded]) fight(one, 40, 80);
        assert.equal(loaded.hash(), game.hash());
        assert.deepEqual(loaded.pack(), game.pack());
        throwsCode('MALFORMED', () => recordings.unpackGame(bytes.subarray(0, bytes.length >> 1), 'half'), /half/);
        throwsCode('MALFORMED', () => recordings.unpackGame(room.pack()), /game/);
    });
});

test('a recording replays to the same hashes', () => {
    holding((hold) => {
        const game = hold(makeGame(hold(makeHungRoom())));
        throwsCode('BAD_CALL', () => game.recording(), /not being recorded/);
        game.record('room');
        throwsCode('BAD_CALL', () => game.record(), /already/);
        throwsCode('BAD_CALL', () => game.setRules({}), /recorded/);
        fight(game, 0, 70);
        const recording = hold(game.recording());
        const { levelHash, ...facts } = recording.facts();
        assert.deepEqual(facts, { rate: 60, firstTick: 0, ticks: 70, events: 6, level: 'room' });
        const events = Array.from({ length: 6 }, (_, k) => recording.event(k));
        assert.deepEqual(
            events.map(({ kind, tick }) => [kind, tick]),
            [
                ['part', 2],
                ['fire', 5],
                ['blast', 8],
                ['wish', 20],
                ['fire', 20],
                ['edit', 50],
            ],
        );
        assert.deepEqual([events[1].index, events[1].velocity], [1, [-30, -12, 4]]);
        throwsCode('OUT_OF_RANGE', () => recording.event(6), /event 6/);

        const bytes = recording.pack();
        assert.equal(recordings.kindOfBytes(bytes), 'recording');
        const read = hold(recordings.unpackRecording(bytes, 'fight.firmarec'));
        assert.deepEqual(read.pack(), bytes);
        const replay = hold(read.replay());
        assert.equal(replay.hash(), hold(read.start()).hash());
        throwsCode('BAD_CALL', () => replay.setOff(0), /replay/);
        while (!replay.replayState().finished) replay.step();
        const { ticks, ticksInAll, differs, text } = replay.replayState();
        assert.deepEqual([ticks, ticksInAll, differs, text], [70, 70, false, '']);
        assert.equal(replay.hash(), game.hash());
        assert.equal(hold(read.end()).hash(), game.hash());
        throwsCode('BAD_CALL', () => replay.step(), /over/);
        throwsCode('BAD_CALL', () => game.replayState(), /no replay/);
        throwsCode('MALFORMED', () => recordings.unpackRecording(bytes.subarray(1), 'cut'), /cut/);
    });
});
