// SPDX-License-Identifier: MIT
// What same_games.c does, through the JavaScript API: the same numbers in the same order, in node or in a browser.
//
//   node same_games.mjs FIRMA_GAMES.wasm LEVEL.obj STEPS
import { loadGames, Projectiles } from '../../bindings/js/src/games.js';

const [BODIES, PLAYERS, SHOTS, PORTION] = [60, 6, 8, 100];
const TICK = 1 / 60;
const SHAPES = ['rocky', 'spiky', 'drill', 'wedge', 'box'];
const NONE = 0xffffffff;

/** All that a run draws from and adds to. */
class Run {
    state = 18018;
    hashA = 1;
    hashB = 2;
    /** Of numbers whose bits are mixed. */
    #double = new Float64Array(1);
    #words = new Uint32Array(this.#double.buffer);

    below(count) {
        this.state = (this.state + 0x9e3779b9) | 0;
        let z = this.state;
        z = Math.imul(z ^ (z >>> 16), 0x85ebca6b);
        z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
        return ((z ^ (z >>> 16)) >>> 0) % count;
    }
    within(most) {
        return ((this.below(2001) - 1000) * most) / 1000;
    }
    three(most) {
        return [this.within(most), this.within(most), this.within(most)];
    }

    mix(word) {
        this.hashA = Math.imul(this.hashA ^ word, 0x9e3779b1);
        this.hashA ^= this.hashA >>> 15;
        this.hashB = Math.imul((this.hashB + word) | 0, 0x85ebca6b);
        this.hashB ^= this.hashB >>> 13;
    }
    mixLong(value) {
        this.mix(Number(BigInt.asIntN(32, value)));
        this.mix(Number(BigInt.asIntN(32, value >> 32n)));
    }
    mixDouble(value) {
        this.#double[0] = value;
        this.mix(this.#words[0]);
        this.mix(this.#words[1]);
    }
    mixThree(values) {
        for (let axis = 0; axis < 3; ++axis) this.mixDouble(values[axis]);
    }
    get hash() {
        return [this.hashA, this.hashB].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('');
    }
}

function findAir(run, world, { low, high }) {
    for (;;) {
        const place = [0, 1, 2].map((axis) => {
            const cells = Math.trunc((high[axis] - low[axis]) * 64);
            return low[axis] + run.below(cells + 1) / 64;
        });
        if (world.locate(place).where === 'air' && world.closest(place, 1) === null) return place;
    }
}

function makeShape(games, kind) {
    if (kind === 0) return games.bodyShape([0, 0, 0, 0.25], games.massOfBall(0.25, 800));
    if (kind === 1) {
        const corner = (k) => [0, 1, 2].map((axis) => ((k >> axis) & 1 ? 0.125 : -0.125));
        const spheres = Array.from({ length: 8 }, (_, k) => [...corner(k), 0.125]);
        return games.bodyShape(spheres.flat(), games.massOfBox([0.25, 0.25, 0.25], 500));
    }
    const spheres = Array.from({ length: 5 }, (_, k) => [0.25 * (k - 2), 0, 0, 0.125]);
    return games.bodyShape(spheres.flat(), games.massOfBox([0.625, 0.125, 0.125], 700));
}

function makeBodies(run, games, world, facts) {
    const bodies = games.bodies();
    for (let k = 0; k < BODIES; ++k) {
        const shape = makeShape(games, k % 3);
        const position = findAir(run, world, facts);
        const rotation = [...run.three(1), 1];
        const id = bodies.add(shape, { position, rotation });
        const velocity = run.three(k % 5 ? 8 : 200);
        bodies.set(id, { velocity, spin: run.three(20) });
        shape.release();
    }
    return bodies;
}

function makeLift(games) {
    const positions = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, -1, -1, 0.25, 1, -1, 0.25, 1, 1, 0.25, -1, 1, 0.25];
    const corners = [3, 2, 1, 0, 5, 6, 7, 4, 1, 5, 4, 0, 2, 6, 5, 1, 3, 7, 6, 2, 0, 4, 7, 3];
    return games.worldFromMesh({ positions, corners, cornerCounts: [4, 4, 4, 4, 4, 4] });
}

function cut(run, games, world, facts) {
    const shape = SHAPES[run.below(5)];
    const cutter = games.crater(shape, run.below(1000));
    const position = world.closest(findAir(run, world, facts), 1e3).point;
    const { world: after, report } = world.carve(cutter, { position, scale: (10 + run.below(11)) / 8 });
    run.mix(['done', 'nothing', 'refused'].indexOf(report.status));
    cutter.release();
    world.release();
    return after;
}

function shoot(run, games, world, facts, bodies, shots, step) {
    if (step % 30 === 0) {
        shots.clear();
        for (let k = 0; k < SHOTS; ++k) {
            const position = findAir(run, world, facts);
            shots.add({ position, velocity: run.three(400) });
        }
    }
    const report = games.fly(shots, world, TICK, { other: { resistance: 1500 }, bodies });
    run.mix(report.impacts);
    const kinds = ['ricochet', 'entered', 'left', 'passed', 'stopped', 'expired'];
    for (const event of report.events) {
        run.mix(kinds.indexOf(event.kind));
        run.mix(event.projectile);
        run.mix(event.face ?? NONE);
        run.mixDouble(event.time);
        run.mixThree(event.point);
        run.mixThree(event.velocity);
        run.mixDouble(event.thickness);
    }
    run.mixLong(games.hashProjectiles(shots));
}

function walk(run, games, scene, shapes, players, wishes, step) {
    for (let k = 0; k < PLAYERS; ++k) {
        if (step % 40 === 0) {
            const velocity = run.three(7);
            wishes[k] = { velocity, crouch: run.below(4) === 0 };
        }
        wishes[k].jump = run.below(20) === 0;
        const move = games.movePlayer(scene, shapes[k % 2], players[k], wishes[k], TICK);
        const { player } = move;
        run.mixThree(player.position);
        run.mixThree(player.velocity);
        run.mix(player.onGround + 2 * player.crouched + 4 * player.stuck + 8 * move.jumped);
        run.mix(move.contacts.length);
        for (const contact of move.contacts) {
            run.mix(['ground', 'wall', 'ceiling'].indexOf(contact.kind));
            run.mix(contact.face ?? NONE);
            run.mixThree(contact.point);
        }
        players[k] = player;
    }
}

/** @param module, level what loadGames() takes, and the bytes of the .obj file; @param print gets each line */
export async function runGames(module, level, steps, print) {
    const run = new Run();
    const games = await loadGames(module);
    let world = await games.worldFromObj(level, { name: 'level' });
    const facts = world.facts();
    const bodies = makeBodies(run, games, world, facts);
    const slab = makeLift(games);
    const [x, y, base] = findAir(run, world, facts);
    const parts = games.parts();
    parts.add({ world: slab, motion: { position: [x, y, base] } });
    const shapes = [games.playerCapsule(), games.playerBox()];
    const players = Array.from({ length: PLAYERS }, () => ({ position: findAir(run, world, facts) }));
    const wishes = Array.from({ length: PLAYERS }, () => ({}));
    const shots = new Projectiles();
    for (let step = 0; step < steps; ++step) {
        if (step % 50 === 49) world = cut(run, games, world, facts);
        const down = Math.trunc(step / 30) % 2 === 1;
        const z = base + (down ? 30 - (step % 30) : step % 30) / 64;
        parts.setMotions([{ position: [x, y, z], path: [0, 0, (down ? -1 : 1) / 64], turn: [0, 0, 1 / 32] }]);
        const scene = { world, parts };
        const report = bodies.step(scene, TICK);
        run.mix(report.contacts);
        run.mix(report.bounces);
        run.mix(report.awake);
        walk(run, games, scene, shapes, players, wishes, step);
        shoot(run, games, world, facts, bodies, shots, step);
        const hash = bodies.hash();
        run.mixLong(hash);
        if ((step + 1) % PORTION === 0 || step + 1 === steps)
            print(`steps=${step + 1} awake=${report.awake} bodies=${hash.toString(16).padStart(16, '0')} games=${run.hash}`);
    }
    for (const one of [...shapes, parts, slab, bodies, world]) one.release();
    if (games.liveHandles() !== 0) throw new Error(`${games.liveHandles()} handles have leaked`);
}

if (typeof process !== 'undefined' && process.argv[1]?.endsWith('same_games.mjs')) {
    const { readFile } = await import('node:fs/promises');
    const [module, level, steps] = process.argv.slice(2);
    if (steps === undefined) throw new Error('usage: node same_games.mjs FIRMA_GAMES.wasm LEVEL.obj STEPS');
    await runGames(module, await readFile(level), Number(steps), console.log);
}
