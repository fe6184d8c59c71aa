// SPDX-License-Identifier: MIT
// The same course walked by Firma's movePlayer(), Jolt's CharacterVirtual and Rapier's KinematicCharacterController in node:
// who arrives, falls, sticks and jitters; then random walks in a cratered level, with the time a move.
//
//   node bench_players.mjs [--quick] [--csv FOLDER]
import { fileURLToPath } from 'node:url';
import { loadGames } from '../../bindings/js/src/games.js';
import { TICK } from './body_engines.mjs';
import { makeCourse, meshOfWorld, SIZE, SPEED, STANDS, STATIONS } from './course.mjs';
import { clock, count, finish, median, number, settings, times } from './race.mjs';
import { Rng } from './scene.mjs';
import { firmaMover, joltMover, rapierMover, STEP } from './walkers.mjs';

const root = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const ARRIVED = 0.4; // metres from a goal, seen from above
const WALKER = 0;

const flat = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Toward a goal at a speed, as seen from above; 0 at it. */
function toward(from, goal, speed) {
    const far = flat(from, goal);
    return far < 1e-9 ? [0, 0, 0] : [((goal[0] - from[0]) / far) * speed, ((goal[1] - from[1]) / far) * speed, 0];
}

/** Whether its middle is in solid, or it fell out of what there is. */
function isLost(world, low, at) {
    const middle = [at[0], at[1], at[2] + SIZE.height / 2];
    return !middle.every(Number.isFinite) || at[2] < low[2] - 1 || world.locate(middle).where === 'solid';
}

/** The largest distance between two of the places along one axis, metres. */
const spread = (places) =>
    Math.max(...[0, 1, 2].map((axis) => Math.max(...places.map((one) => one[axis])) - Math.min(...places.map((one) => one[axis]))));

/** Ticks until it is at the goal, or null. @param watch gets each place */
function walk(mover, goal, speed, ticks, watch = () => {}) {
    for (let k = 0; k < ticks; ++k) {
        const at = mover.at(WALKER);
        if (flat(at, goal) < ARRIVED) return k;
        mover.move(WALKER, toward(at, goal, speed), false);
        watch(mover.at(WALKER));
    }
    return null;
}

const stand = (mover, ticks) => {
    const places = [];
    for (let k = 0; k < ticks; ++k) {
        mover.move(WALKER, [0, 0, 0], false);
        places.push([...mover.at(WALKER)]);
    }
    return places;
};

/** Metres as millimetres; below a thousandth of one, none. */
const mm = (metres) => (metres < 1e-6 ? '0' : number(1e3 * metres));

/** Leaves a corner as far as it must: it sticks where it does not. */
function leaves(mover, back) {
    return walk(mover, back, SPEED, 120) !== null;
}

/** What happened at a station, in words; and places while it pressed into a corner. */
function visit(mover, station, { world, low }) {
    const speed = station.speed ?? SPEED;
    mover.place(WALKER, station.start);
    stand(mover, 30);
    let lost = false;
    let lowest = Infinity;
    let highest = -Infinity;
    const watch = (at) => {
        lost ||= isLost(world, low, at);
        lowest = Math.min(lowest, at[2]);
        highest = Math.max(highest, at[2]);
    };
    let ticks = 0;
    let arrived = true;
    for (const goal of station.goals) {
        const taken = walk(mover, goal, speed, Math.round(station.seconds / TICK) - ticks, watch);
        if (taken === null) {
            arrived = false;
            break;
        }
        ticks += taken;
    }
    const answer = { arrived, seconds: ticks * TICK, lost, lowest, highest };
    if (station.press !== undefined) {
        for (let k = 0; k < 60; ++k) mover.move(WALKER, toward(mover.at(WALKER), station.press, speed), false);
        const places = [];
        for (let k = 0; k < 60; ++k) {
            mover.move(WALKER, toward(mover.at(WALKER), station.press, speed), false);
            watch(mover.at(WALKER));
            places.push([...mover.at(WALKER)]);
        }
        answer.pressed = spread(places);
        answer.left = leaves(mover, station.back);
    }
    return answer;
}

function wordsOf(station, { arrived, seconds, lost, highest, pressed, left }) {
    if (lost) return 'falls through';
    if (station.closed) return arrived ? 'passes' : `stops, ${highest.toFixed(2)} m up`;
    if (pressed !== undefined) return `${mm(pressed)} mm, ${left ? 'leaves' : 'sticks'}`;
    return arrived ? `${number(seconds)} s` : 'does not arrive';
}

/** Of walking straight over seams: how far z, and the speed, come from what they should be. */
function straight(mover) {
    mover.place(WALKER, [2.25, 20.25, 0]);
    stand(mover, 30);
    const places = [];
    for (let k = 0; k < 360; ++k) {
        mover.move(WALKER, [SPEED * 0.97, SPEED * Math.sqrt(1 - 0.97 ** 2), 0], false);
        if (k >= 10) places.push([...mover.at(WALKER)]);
    }
    const heights = places.map((one) => one[2]);
    const speeds = places.slice(1).map((one, k) => flat(one, places[k]) / TICK);
    return { height: Math.max(...heights) - Math.min(...heights), slowest: Math.min(...speeds), fastest: Math.max(...speeds) };
}

async function walkCourse(games, csv) {
    const course = makeCourse(games);
    const place = { world: course.world, low: [0, 0, 0] };
    const movers = [firmaMover(games, course.world), await joltMover(course.mesh), await rapierMover(course.mesh)];
    const names = movers.map((mover) => mover.name);
    const rows = STATIONS.map((station) => [station.name, ...movers.map((mover) => wordsOf(station, visit(mover, station, place)))]);
    await finish('node_course', ['station', ...names], rows, csv);

    const still = STANDS.map((one) => [
        `stands ${one.name}, mm`,
        ...movers.map((mover) => {
            mover.place(WALKER, one.start);
            stand(mover, 60);
            return mm(spread(stand(mover, 120)));
        }),
    ]);
    const ways = movers.map(straight);
    still.push(['walks straight over seams: height, mm', ...ways.map(({ height }) => mm(height))]);
    still.push([`its speed, m/s, of ${SPEED}`, ...ways.map(({ slowest, fastest }) => `${slowest.toFixed(3)} to ${fastest.toFixed(3)}`)]);
    await finish('node_jitter', ['', ...names], still, csv);
    console.log(`\ncourse: ${count(course.mesh.corners.length / 3)} triangles`);
}

// ---- random walks

const CHANGE = 120; // ticks that a wish lasts
const SECOND = 60;

/** Our level, shot at. */
async function crateredLevel(games, craters) {
    const { readFile } = await import('node:fs/promises');
    let world = await games.worldFromObj(await readFile(root('levels/first.obj')));
    const { low, high } = world.facts();
    const rng = new Rng(3);
    for (let k = 0; k < craters; ) {
        const at = low.map((from, axis) => rng.uniform(from, high[axis]));
        if (world.locate(at).where !== 'air') continue;
        const cutter = games.crater('rocky', k);
        const position = world.closest(at).point;
        const { world: after, report } = world.carve(cutter, { position, rotation: games.randomTurn(k), scale: rng.uniform(0.8, 2) });
        cutter.release();
        world.release();
        world = after;
        k += report.status === 'done';
    }
    const bounds = world.facts(); // craters reach deeper
    return { world, low: bounds.low, high: bounds.high, mesh: meshOfWorld(world) };
}

/** Where a player can begin, in the air above something. */
function startsIn(games, { world, low, high }, count) {
    const rng = new Rng(9);
    const capsule = games.playerCapsule(SIZE);
    const starts = [];
    while (starts.length < count) {
        const at = low.map((from, axis) => rng.uniform(from, high[axis]));
        if (!games.playerFits(world, capsule, at)) continue;
        const down = world.cast({ centre: [at[0], at[1], at[2] + 1], radius: 0.3, path: [0, 0, -30] });
        if (down.status === 'hit') starts.push(at);
    }
    capsule.release();
    return starts;
}

/** Whether a capsule that is a step higher has a free way of half a metre along the wish. */
function isOpen({ world }, at, wish) {
    const far = Math.hypot(...wish);
    if (far < 0.5) return false;
    const [low, high] = [at[2] + STEP + SIZE.radius, at[2] + SIZE.height - SIZE.radius];
    const shape = { from: [at[0], at[1], low], to: [at[0], at[1], high], radius: SIZE.radius - 0.02 };
    if (world.overlapShape(shape).length > 0) return false;
    return !world.castAny({ ...shape, path: wish.map((part) => (part / far) * 0.5) });
}

/** One library's walkers, some ticks at a time. */
class Crowd {
    constructor(mover, level, starts) {
        Object.assign(this, { mover, level, starts, tick: 0, lost: 0, stuck: 0, metres: 0, times: [] });
        this.rng = new Rng(4);
        this.walkers = starts.map((start, k) => {
            mover.place(k, start);
            return { wish: [0, 0, 0], jump: false, from: [...start], still: 0, open: 0 };
        });
    }

    run(ticks) {
        let spent = 0;
        for (let k = 0; k < ticks; ++k) {
            this.walkers.forEach((walker) => this.#wish(walker));
            const before = clock();
            this.walkers.forEach((walker, index) => this.mover.move(index, walker.wish, walker.jump));
            spent += clock() - before;
            if (++this.tick % SECOND === 0) this.walkers.forEach((walker, index) => this.#judge(walker, index));
        }
        this.times.push((1e3 * spent) / (ticks * this.walkers.length));
    }

    #wish(walker) {
        if (this.tick % CHANGE === 0) {
            const angle = this.rng.uniform(0, 2 * Math.PI);
            const speed = this.rng.uniform(2, 6);
            walker.wish = [speed * Math.cos(angle), speed * Math.sin(angle), 0];
        }
        walker.jump = this.rng.below(120) === 0;
    }

    /** Each second: is it somewhere, and did it get on where there is a way? */
    #judge(walker, index) {
        const at = [...this.mover.at(index)];
        const moved = flat(at, walker.from);
        if (isLost(this.level.world, this.level.low, at)) {
            ++this.lost;
            this.mover.place(index, this.starts[index]);
            walker.from = [...this.starts[index]];
            return;
        }
        this.metres += moved;
        // The wish is that of the whole second.
        if (moved < 0.05 && isOpen(this.level, at, walker.wish)) ++this.stuck;
        walker.from = at;
    }
}

async function walkAtRandom(games, quick, csv) {
    const level = await crateredLevel(games, quick ? 5 : 60);
    const starts = startsIn(games, level, quick ? 4 : 24);
    const movers = [firmaMover(games, level.world), await joltMover(level.mesh), await rapierMover(level.mesh)];
    const crowds = movers.map((mover) => new Crowd(mover, level, starts));
    const rounds = quick ? 2 : 15;
    for (let round = 0; round < rounds; ++round)
        for (let k = 0; k < crowds.length; ++k) crowds[(round + k) % crowds.length].run(CHANGE);
    const seconds = (rounds * CHANGE * starts.length) / SECOND;
    const laps = crowds.map((crowd) => median(crowd.times.slice(1))); // the first is for the engine, which compiles
    const rows = crowds.map((crowd, k) => [
        crowd.mover.name,
        number(laps[k]),
        k === 0 ? '' : times(laps[k] / laps[0]),
        count(crowd.lost),
        count(crowd.stuck),
        count(Math.round(crowd.metres)),
    ]);
    const columns = ['library', 'us a move', "of Firma's time", 'lost', `seconds stuck, of ${count(seconds)}`, 'metres walked'];
    await finish('node_players', columns, rows, csv);
    console.log(`\nlevel: ${count(level.mesh.corners.length / 3)} triangles, ${starts.length} players, ${(rounds * CHANGE) / SECOND} s each`);
}

const { quick, csv } = settings();
const games = await loadGames(root('build/wasm/bin/firma_games.wasm'));
await walkCourse(games, csv);
await walkAtRandom(games, quick, csv);
process.exit(0);
