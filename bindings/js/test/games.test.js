// SPDX-License-Identifier: MIT
// The module of games: loaded from anywhere, it does all that the module of worlds does; its objects when they are
// released, forgotten or of another module; arguments of every kind.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { FirmaError, loadGames, Projectiles } from '../src/games.js';
import { loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';
import { games, gamesUrl, makeBall, makeRoom, makeSlab, TICK } from './game_helpers.js';
import { boxMesh, firma, levelBytes, releasing, throwsCode, wasmUrl } from './helpers.js';
import { random, scenario } from './scenario.js';

const pose = { position: [4, 4, 4] };
const ball = { centre: [4, 4, 4], radius: 0.5 };

test('every kind of source gives a module of its own, and no other does', async () => {
    const bytes = readFileSync(gamesUrl);
    for (const source of [gamesUrl, gamesUrl.href, fileURLToPath(gamesUrl), bytes, await WebAssembly.compile(bytes), new Response(bytes)]) {
        const one = await loadGames(source);
        assert.equal(one.version, firma.version);
        const world = await one.worldFromObj(levelBytes); // its readers lie where the package has them
        assert.deepEqual([one.liveHandles(), games.liveHandles()], [1, 0]);
        world.release();
    }
    const refuses = (load, code, message) =>
        assert.rejects(load, (error) => {
            assert.ok(error instanceof FirmaError, error.stack);
            assert.equal(error.code, code);
            assert.match(error.message, message);
            return true;
        });
    await refuses(loadGames(wasmUrl), 'UNSUPPORTED', /^loadGames: not Firma's module of games$/);
    await refuses(loadGames('no/such.wasm'), 'CANNOT_READ', /^loadGames: no\/such\.wasm/);
    await refuses(loadGames(undefined, { reader: 1 }), 'BAD_CALL', /^loadGames: the options: there is no reader/);
    // The module of games is one of worlds, too.
    const worlds = await loadFirma(gamesUrl);
    assert.equal(worlds.version, firma.version);
});

test('it makes the cuts and casts that the module of worlds makes', async () => {
    assert.deepEqual(await scenario(games, levelBytes, 40, 400), await scenario(firma, levelBytes, 40, 400));
});

test('every function of the main entry is there', async () => {
    const main = await import('../src/index.js');
    const entry = await import('../src/games.js');
    for (const name of Object.keys(main)) if (name !== 'loadFirma') assert.equal(entry[name], main[name], name);
    for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(firma))) assert.ok(name in games, name);
    const readers = await loadReaders(games);
    releasing([readers.worldFromObj(levelBytes)], (world) => assert.ok(world.facts().faceCount > 0));
});

/** One of each kind that only games have, and a world. */
function everything(module) {
    const world = makeRoom(module);
    const bodies = module.bodies();
    const parts = module.parts();
    const shape = makeBall(0.5, module);
    parts.add({ world });
    return { world, bodies, parts, shape, capsule: module.playerCapsule(), id: bodies.add(shape, pose) };
}
const handlesOf = ({ id, ...handles }) => Object.values(handles);

const callsOf = ({ world, bodies, parts, shape, capsule, id }, module) => ({
    copy: () => bodies.copy(),
    count: () => bodies.count(),
    list: () => bodies.list(),
    poses: () => bodies.poses(),
    get: () => bodies.get(id),
    set: () => bodies.set(id, {}),
    pose: () => bodies.pose(id),
    wake: () => bodies.wake(id),
    push: () => bodies.push(id, [0, 0, 1], [4, 4, 4]),
    step: () => bodies.step(world, TICK),
    contacts: () => bodies.contacts(),
    hash: () => bodies.hash(),
    add: () => bodies.add(shape, pose),
    remove: () => bodies.remove(id),
    partCount: () => parts.count(),
    addPart: () => parts.add({ world }),
    setPart: () => parts.set(0, { world }),
    setMotions: () => parts.setMotions([{}, {}]),
    movePlayer: () => module.movePlayer(world, capsule, pose, {}, TICK),
    playerFits: () => module.playerFits(world, capsule, [4, 4, 4]),
    castScene: () => module.castScene({ world, parts }, { ...ball, path: [0, 0, 1] }),
    castSceneAny: () => module.castSceneAny({ world, parts }, { ...ball, path: [0, 0, 1] }),
    overlapScene: () => module.overlapScene({ world, parts }, ball),
    fly: () => module.fly(new Projectiles(), world, TICK, { bodies }),
});

test('a call on a released object throws BAD_HANDLE, whatever came to live after it', () => {
    const all = everything(games);
    assert.equal(games.liveHandles(), 5);
    const calls = callsOf(all, games);
    for (const name in calls) calls[name]()?.release?.();
    for (const one of handlesOf(all)) {
        one.release();
        assert.equal(one.released, true);
        throwsCode('BAD_HANDLE', () => one.release(), /released already/);
        if (Symbol.dispose) one[Symbol.dispose]();
    }
    const others = everything(games);
    for (const name in calls) throwsCode('BAD_HANDLE', calls[name], /released already/);
    const { world, bodies, parts, capsule } = others;
    throwsCode('BAD_HANDLE', () => bodies.step(all.world, TICK), /world/);
    throwsCode('BAD_HANDLE', () => bodies.step({ world, parts: all.parts }, TICK), /parts/);
    throwsCode('BAD_HANDLE', () => bodies.add(all.shape, pose), /body shape/);
    throwsCode('BAD_HANDLE', () => parts.add({ world: all.world }), /world/);
    throwsCode('BAD_HANDLE', () => games.movePlayer(world, all.capsule, pose, {}, TICK), /player shape/);
    throwsCode('BAD_HANDLE', () => games.movePlayer(all.world, capsule, pose, {}, TICK), /world/);
    throwsCode('BAD_HANDLE', () => games.fly(new Projectiles(), world, TICK, { bodies: all.bodies }), /bodies/);
    for (const one of handlesOf(others)) one.release();
});

test('objects of another module are told from ours', async () => {
    const other = await loadGames();
    const [theirs, ours] = [everything(other), everything(games)];
    for (const call of [
        () => ours.bodies.step(theirs.world, TICK),
        () => ours.bodies.step({ world: ours.world, parts: theirs.parts }, TICK),
        () => ours.bodies.add(theirs.shape, pose),
        () => ours.parts.add({ world: theirs.world }),
        () => games.movePlayer(ours.world, theirs.capsule, pose, {}, TICK),
        () => games.castScene(theirs.world, { ...ball, path: [1, 0, 0] }),
        () => games.fly(new Projectiles(), ours.world, TICK, { bodies: theirs.bodies }),
        () => games.fly(new Projectiles(), theirs.world, TICK),
    ])
        throwsCode('BAD_HANDLE', call, /another module/);
    // What is data is of no module.
    const shots = new Projectiles();
    shots.add({ position: [4, 4, 4], velocity: [9, 0, 0] });
    const copy = shots.copy();
    games.fly(shots, ours.world, TICK);
    other.fly(copy, theirs.world, TICK);
    assert.equal(games.hashProjectiles(shots), other.hashProjectiles(copy));
    for (const one of [...handlesOf(ours), ...handlesOf(theirs)]) one.release();
    assert.equal(other.liveHandles(), 0);
});

test('what was forgotten is released by and by', () => {
    const program = `
        import { loadGames } from ${JSON.stringify(new URL('../src/games.js', import.meta.url).href)};
        const games = await loadGames();
        for (let k = 0; k < 50; ++k) for (const make of ['bodies', 'parts', 'playerBox']) games[make]();
        const kept = games.bodies();
        for (let k = 0; k < 50 && games.liveHandles() > 1; ++k) {
            gc();
            await new Promise((resolve) => setTimeout(resolve, 10));
        }
        console.log(games.liveHandles(), kept.released);`;
    const result = spawnSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', program], { encoding: 'utf8' });
    assert.equal(result.stdout, '1 false\n', result.stderr);
});

test('a module that stopped says so of all that it made', async () => {
    const one = await loadGames();
    const all = everything(one);
    const core = all.world[Object.getOwnPropertySymbols(all.world).find((symbol) => symbol.description === 'core')];
    core.stop(new Error('a trap'));
    const calls = callsOf(all, one);
    for (const name in calls) throwsCode('INTERNAL', calls[name], /stopped \(a trap\).*loadGames\(\)/);
    for (const handle of handlesOf(all)) handle.release(); // nothing is left to be given back
});

const next = random(78);
const below = (count) => Math.floor(next() * count);
const pick = (list) => list[below(list.length)];
const odd = [0, -0, 1, -1, 0.5, 3, 1e-300, 1e9, 1e300, 2 ** 32 - 1, 2 ** 32, NaN, Infinity, -Infinity];
const vectorOf = (length) => Array.from({ length }, () => (next() < 0.9 ? next() * 8 : pick(odd)));
const flagOf = () => pick([true, false, undefined, 1]);

test('arguments of every kind: an answer or a FirmaError, and the module never stops', async () => {
    const all = everything(games);
    const { world, bodies, parts, shape, capsule } = all;
    const slab = makeSlab(1, 1, 0.25);
    const gone = games.playerBox();
    gone.release();
    const shots = new Projectiles();
    const handles = [world, bodies, parts, shape, capsule, slab, gone];
    const motion = () => ({ position: vectorOf(3), rotation: pick([undefined, vectorOf(4)]), path: vectorOf(3), turn: vectorOf(3) });
    const scene = () => pick([world, { world, parts }, { world, parts, from: next(), to: pick(odd) }, { world: slab }]);
    const makers = [
        () => undefined,
        () => null,
        () => pick([true, '', 'ball', Symbol('s'), 5n]),
        () => pick(odd),
        () => vectorOf(pick([0, 3, 3, 4, 8, 9])),
        () => new Float64Array(vectorOf(pick([3, 4, 8, 28]))),
        () => pick(bodies.list().concat([0n, 2n ** 64n])),
        () => ({ position: vectorOf(3), rotation: vectorOf(4) }),
        () => ({ centre: vectorOf(3), radius: pick(odd), path: vectorOf(3) }),
        () => ({ position: vectorOf(3), velocity: vectorOf(3), mask: pick(odd), onGround: flagOf(), worldHash: pick([0n, 7n, 7]) }),
        () => ({ velocity: vectorOf(3), jump: flagOf(), crouch: flagOf() }),
        () => ({ velocity: vectorOf(3), spin: vectorOf(3), friction: pick(odd), restitution: next() }),
        () => ({ gravity: vectorOf(3), substepsASecond: pick([1, 60, 1e5]), maxBounces: pick(odd), maxImpacts: pick(odd) }),
        () => ({ gravity: pick(odd), stepHeight: pick(odd), maxSlope: next() }),
        () => ({ world: slab, mask: pick(odd), motion: motion() }),
        () => [motion(), motion()],
        () => games.massOfBox([1, 1, 1], 1 + next()),
        () => ({ bodies, other: { resistance: pick(odd) }, events: flagOf(), matters: [{}, { friction: pick(odd) }] }),
        () => shots,
        scene,
    ];
    // Once in two times what such a call begins with.
    const first = {
        add: () => pick([[shape, { position: vectorOf(3) }], [{ world: slab, motion: motion() }], [{ position: vectorOf(3), velocity: vectorOf(3) }]]),
        step: () => [scene(), pick([TICK, TICK, 0.5, 1e-3])],
        movePlayer: () => [scene(), capsule, pick(makers)(), pick(makers)(), TICK],
        playerFits: () => [scene(), capsule, vectorOf(3)],
        castScene: () => [scene(), { centre: vectorOf(3), radius: next(), path: vectorOf(3) }],
        castSceneAny: () => [scene(), { from: vectorOf(3), to: vectorOf(3), radius: next(), path: vectorOf(3) }],
        overlapScene: () => [scene(), { centre: vectorOf(3), radius: next() }],
        bodyShape: () => [vectorOf(4), games.massOfBall(1, 1)],
        fly: () => [shots, world, TICK],
        setMotions: () => [Array.from({ length: parts.count() }, motion)],
    };
    const answers = { returned: 0 };
    for (let round = 0; round < 400; ++round) {
        for (const object of [games, bodies, parts, shape, capsule, shots]) {
            for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(object))) {
                if (['constructor', 'count', 'version'].includes(name)) continue;
                const given = Array.from({ length: below(4) }, () => (next() < 0.2 ? pick(handles) : pick(makers)()));
                if (first[name] && next() < 0.6) given.splice(0, 5, ...first[name]());
                if (/^(get|set|pose|wake|push|remove)$/.test(name) && next() < 0.7 && bodies.count()) given[0] = pick(bodies.list());
                if (name === 'remove' && bodies.count() < 3) continue;
                if (name === 'add' && (bodies.count() > 30 || parts.count() > 12)) continue;
                try {
                    const answer = await object[name](...given);
                    ++answers.returned;
                    if (typeof answer?.release === 'function') answer.release();
                } catch (error) {
                    if (!(error instanceof FirmaError) || error.code === 'INTERNAL') {
                        error.message += ` (${name}, round ${round}, ${given.map((one) => typeof one)})`;
                        throw error;
                    }
                    assert.notEqual(error.message, '');
                    answers[error.code] = (answers[error.code] ?? 0) + 1;
                }
            }
        }
    }
    world.check();
    const seen = JSON.stringify(answers);
    for (const code of ['returned', 'BAD_CALL', 'BAD_HANDLE', 'INVALID', 'OUT_OF_RANGE'])
        assert.ok(answers[code] > 3, seen);
    for (const one of [...handlesOf(all), slab]) if (!one.released) one.release();
});
