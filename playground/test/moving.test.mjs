// SPDX-License-Identifier: MIT
// What moves and what is seen of it, where no engine is needed: weapons, rockets, specks, shaking, sticks, doors' plans.
import assert from 'node:assert/strict';
import test from 'node:test';
import { throwBlast } from '../src/blast_particles.js';
import { boxMesh } from '../src/box_mesh.js';
import { ContactShadows, ovalOf } from '../src/contact_shadows.js';
import { leafMesh, planDoor } from '../src/door_plans.js';
import { turnBetween } from '../src/obstacles.js';
import { kShares, Picture } from '../src/picture.js';
import { Particles } from '../src/particles.js';
import { Rockets } from '../src/rockets.js';
import { felt, Shake } from '../src/shake.js';
import { heard } from '../src/sound.js';
import { uprightAngle } from '../src/stage.js';
import { stickKeys } from '../src/touch.js';
import { aboutUp, back, combine, poseWithin, turned } from '../src/turns.js';
import { kWeapons, Weapons } from '../src/weapons.js';

const near = (a, b, within = 1e-12) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) <= within, `${a} and ${b}`));

test('a held button goes on firing, at its pace, whatever the frames', () => {
    for (const dt of [1 / 240, 1 / 60, 1 / 20]) {
        const weapons = new Weapons();
        let shots = 0;
        const steps = Math.round(4 / dt);
        for (let k = 0; k < steps; ++k) shots += weapons.step(dt, { rocket: true }).length;
        assert.ok(Math.abs(shots - 4 / kWeapons.rocket.every) <= 1.01, `${shots} shots with frames of ${dt} s`);
    }
    const weapons = new Weapons();
    assert.deepEqual(weapons.step(0.1, { rocket: true, grenade: true }), ['rocket', 'grenade']);
    assert.deepEqual(weapons.step(0.1, { rocket: true, grenade: true }), []);
    assert.deepEqual(weapons.step(5, {}), []);
    assert.deepEqual(weapons.step(0.1, { grenade: true }), ['grenade']);
});

test('rockets fly straight until they meet something', () => {
    const paths = [];
    const wall = { name: 'wall' };
    const rockets = new Rockets((from, path) => {
        paths.push([from, path]);
        return from[0] + path[0] >= 10 ? wall : null;
    });
    rockets.launch([0, 1, 2], [1, 0, 0], [0, 0, -1]);
    near(Rockets.seenAt(rockets.flying[0]), [0, 1, 1]);
    let met = [];
    for (let k = 0; k < 60 && met.length === 0; ++k) met = rockets.step(1 / 60);
    assert.deepEqual([met, rockets.flying.length], [[{ target: wall, direction: [1, 0, 0] }], 0]);
    // No gap between the path of one step and that of the next.
    for (let k = 1; k < paths.length; ++k) near(paths[k][0], paths[k - 1][0].map((x, axis) => x + paths[k - 1][1][axis]));
    rockets.launch([0, 0, 0], [0, 0, 1]);
    for (let k = 0; k < 500; ++k) rockets.step(1 / 60);
    assert.equal(rockets.flying.length, 0, 'out of the level');
});

test('specks fly, fall, fade, and give way to younger ones', () => {
    const specks = new Particles(4);
    specks.add({ at: [0, 0, 10], velocity: [3, 0, 0], colour: [1, 0.5, 0], life: 2, size: 1, growth: 2, fall: 10 });
    for (let k = 0; k < 100; ++k) specks.step(0.01);
    const [places, colours] = [new Float32Array(16), new Float32Array(16)];
    assert.equal(specks.pack(places, colours), 1);
    near(places.subarray(0, 4), [3, 0, 5, 3], 0.06);
    near(colours.subarray(0, 4), [1, 0.5, 0, 0.5], 0.02);
    specks.step(1.1);
    assert.deepEqual([specks.count, specks.pack(places, colours)], [0, 0]);
    for (let k = 0; k < 6; ++k) specks.add({ at: [k, 0, 0], velocity: [0, 0, 0], colour: [1, 1, 1], life: 1, size: 1 });
    assert.equal(specks.count, 4);
    specks.pack(places, colours);
    assert.deepEqual([0, 1, 2, 3].map((k) => places[4 * k]).sort(), [2, 3, 4, 5], 'the last four');
    specks.clear();
    assert.equal(specks.count, 0);
});

test('a blast throws fire, dust and sparks away from the wall, the sparks no farther than casts let them', () => {
    const [dust, glow] = [new Particles(400), new Particles(400)];
    const asked = [];
    const what = { point: [5, 0, 1], normal: [-1, 0, 0], colour: [255, 0, 0], metal: false, seed: 4 };
    throwBlast(dust, glow, (from, path) => (asked.push(path), 0.5), what);
    assert.ok(dust.count > 10 && asked.length > 20 && glow.count > asked.length);
    assert.ok(asked.every((path) => path[0] < 0), 'none into the wall');
    for (let k = 0; k < 200; ++k) [dust, glow].forEach((one) => one.step(0.02));
    assert.deepEqual([dust.count, glow.count], [0, 0]);
    const [steel, shining] = [new Particles(400), new Particles(400)];
    throwBlast(steel, shining, () => 1, { ...what, metal: true });
    assert.ok(shining.count > asked.length + 30, 'more sparks from steel');
});

test('the view shakes, less and less, and not for those who asked for less motion', () => {
    const shake = new Shake();
    shake.add(felt(0));
    shake.add(felt(50));
    const turns = [];
    for (let k = 0; k < 100; ++k) {
        shake.step(0.02);
        turns.push(Math.max(...shake.turn().map(Math.abs)));
    }
    assert.ok(Math.max(...turns.slice(0, 10)) > 0.005 && Math.max(...turns) < 0.06, `${turns.slice(0, 10)}`);
    assert.deepEqual(shake.turn().map(Math.abs), [0, 0, 0]);
    assert.ok(felt(1) > felt(5) && felt(5) > felt(40));
    const still = new Shake(true);
    still.add(1);
    still.step(0.01);
    assert.deepEqual(still.turn().map(Math.abs), [0, 0, 0]);
});

test('sounds are heard from where they are', () => {
    const ahead = heard([0, 0, 0], [1, 0, 0], [5, 0, 0]);
    const left = heard([0, 0, 0], [1, 0, 0], [0, 5, 0]);
    const right = heard([0, 0, 0], [1, 0, 0], [0, -5, 0]);
    assert.ok(ahead.side === 0 && left.side < -0.5 && right.side > 0.5);
    assert.ok(heard([0, 0, 0], [1, 0, 0], [1, 0, 0]).loud > ahead.loud && ahead.loud > heard([0, 0, 0], [1, 0, 0], [60, 0, 0]).loud);
    assert.ok(Number.isFinite(heard([0, 0, 0], [0, 0, 1], [0, 0, 0]).side));
});

test('a stick stands for keys', () => {
    const held = (x, y) => Object.entries(stickKeys(x, y)).filter(([, down]) => down).map(([name]) => name).sort();
    assert.deepEqual(held(2, 3), []);
    assert.deepEqual(held(0, -40), ['forward']);
    assert.deepEqual(held(3, -80), ['forward', 'run']);
    assert.deepEqual(held(40, 0), ['right']);
    assert.deepEqual(held(-30, 30), ['back', 'left']);
});

test('an upright phone sees as far to the sides as it can', () => {
    assert.equal(uprightAngle(16 / 9), 78);
    assert.ok(uprightAngle(390 / 844) > 95 && uprightAngle(390 / 844) <= 102);
    assert.ok(uprightAngle(1) >= 78);
});

test('the picture has fewer pixels where frames take long, and more again where they do not', () => {
    const after = (picture, dt, count) => {
        for (let k = 0; k < count; ++k) picture.frame(dt);
        return picture.share;
    };
    const quick = new Picture();
    assert.ok(quick.antialias && quick.share === 1);
    assert.equal(after(quick, 1 / 60, 10_000), 1);
    quick.frame(3); // somebody looked at another page
    assert.equal(after(quick, 1 / 60, 100), 1);
    assert.equal(after(quick, 1 / 20, 12), kShares[1]);
    assert.equal(after(quick, 1 / 30, 1000), kShares[1]);
    assert.equal(after(quick, 1 / 60, 1000), kShares[1], 'a step that was too slow is not tried again');
    const software = new Picture({ software: true });
    assert.deepEqual([software.antialias, software.share], [false, 0.5]);
    assert.equal(after(software, 1, 8), kShares.at(-1));
    assert.equal(after(software, 1, 100), kShares.at(-1));
    const wrong = new Picture({ software: true }); // it said that it has no graphics card, and is quick
    assert.equal(after(wrong, 1 / 144, 299), 0.5);
    assert.equal(after(wrong, 1 / 144, 1), 0.7);
    assert.equal(after(wrong, 1 / 144, 300), 1);
    const full = new Picture({ software: true, full: true });
    assert.deepEqual([full.antialias, after(full, 2, 100)], [true, 1]);
});

test('turns and poses', () => {
    const quarter = aboutUp(Math.PI / 2);
    near(turned(quarter, [1, 0, 5]), [0, 1, 5]);
    near(turned(back(quarter), turned(quarter, [1, 2, 3])), [1, 2, 3]);
    near(turned(combine(quarter, quarter), [1, 0, 0]), [-1, 0, 0]);
    const inside = poseWithin({ position: [10, 0, 0], rotation: quarter }, { position: [10, 2, 1], scale: 3 });
    near(inside.position, [2, 0, 1]);
    near(turned(combine(quarter, inside.rotation), [1, 2, 3]), [1, 2, 3]);
    assert.equal(inside.scale, 3);
    near(turnBetween(aboutUp(0.3), aboutUp(1)), [0, 0, 0.7]);
    near(turnBetween(aboutUp(1), aboutUp(0.3).map((x) => -x)), [0, 0, -0.7]);
    near(turnBetween(quarter, quarter), [0, 0, 0]);
});

const portal = (corners, name = 'a_b') => {
    const [low, high] = [Math.min, Math.max].map((pick) => [0, 1, 2].map((axis) => pick(...corners.map((corner) => corner[axis]))));
    return { name, low, high, polygons: [Float64Array.from(corners.flat())] };
};

test('doors are for upright openings as wide as people', () => {
    const open = portal([[3, 1, 0], [3, 2, 0], [3, 2, 2.2], [3, 1, 2.2]]);
    const plan = planDoor(open);
    assert.equal(plan.along, 1);
    assert.ok(plan.width < 0.98 && plan.width > 0.9 && plan.height < 2.2 && plan.hinge[0] === 3 && plan.hinge[1] > 1);
    for (const none of [
        portal([[3, 1, 0], [3, 5, 0], [3, 5, 2.2], [3, 1, 2.2]]), // a gate
        portal([[3, 1, 1], [3, 2, 1], [3, 2, 2.2], [3, 1, 2.2]]), // a window
        portal([[3, 1, 0], [4, 2, 0], [4, 2, 2.2], [3, 1, 2.2]]), // askew
        portal([[0, 0, 2], [1, 0, 2], [1, 2, 2], [0, 2, 2]]), // a hatch
        portal([[3, 1, 0], [3, 2, 0], [3, 1.5, 2.2]]), // no rectangle
        { ...open, name: '' }, // of a crater
        { ...open, polygons: [] },
    ]) assert.equal(planDoor(none), null, JSON.stringify(none));
});

/** What a mesh encloses. */
function volume({ positions, corners, cornerCounts = Array(corners.length / 3).fill(3) }) {
    let sum = 0;
    let first = 0;
    const at = (k) => positions.slice(3 * corners[k], 3 * corners[k] + 3);
    for (const count of cornerCounts) {
        for (let k = 1; k + 1 < count; ++k) {
            const [p, q, r] = [at(first), at(first + k), at(first + k + 1)];
            sum += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6;
        }
        first += count;
    }
    return sum;
}

test('the ground below a body is darker, the less the higher it is', () => {
    const oval = ovalOf([3, 1, 0.5], aboutUp(0.6));
    near([oval.long, oval.short, oval.angle, oval.high], [3, 1, 0.6, 0.5]);
    const upright = ovalOf([3, 1, 0.5], [0, Math.SQRT1_2, 0, Math.SQRT1_2]); // its long side along z
    near([upright.long, upright.short, upright.high], [1, 0.5, 3]);
    near([Math.abs(Math.sin(upright.angle))], [1]);

    let casts = 0;
    /** Level ground at a height. */
    const groundAt = (z) => ({
        cast({ centre, path }) {
            ++casts;
            const fraction = (z - centre[2]) / path[2];
            return { hit: fraction >= 0 && fraction <= 1, fraction, point: [centre[0], centre[1], z], normal: [0, 0, 1] };
        },
    });
    const shadows = new ContactShadows();
    const piece = { id: 1n, low: [-1, -1, -0.5], high: [1, 1, 0.5], asleep: false };
    shadows.change({ added: [piece], removed: [] });
    const [ground, hole] = [groundAt(0), groundAt(-9)];
    const darkAt = (z, level = ground) => {
        shadows.update({ pose: () => ({ position: [4, 5, z], rotation: [0, 0, 0, 1] }) }, level);
        const [mesh] = shadows.group.children;
        return mesh.visible ? mesh.material.opacity : 0;
    };
    const dark = [0.5, 1, 2, 2.9, 3.1].map((z) => darkAt(z));
    assert.ok(dark[0] > 0.5 && dark.every((one, k) => k === 0 || one < dark[k - 1]) && dark[3] > 0 && dark[4] === 0, `${dark}`);
    darkAt(1);
    near(shadows.group.children[0].position.toArray(), [4, 5, 0.02]);
    piece.asleep = true;
    casts = 0;
    const lain = darkAt(0.5);
    darkAt(0.5);
    assert.equal(casts, 1, 'once, when it has come to rest');
    assert.ok(lain > 0.5);
    assert.equal(darkAt(0.5, hole), 0, 'the ground went');
    shadows.change({ added: [], removed: [piece] });
    assert.equal(shadows.group.children.length, 0);
});

test('meshes of leaves and boxes are seen from outside', () => {
    assert.ok(Math.abs(volume(boxMesh([1, 2, 3])) - 48) < 1e-9);
    assert.ok(Math.abs(volume(leafMesh({ width: 1, height: 2 })) - 0.1236) < 1e-9);
});
