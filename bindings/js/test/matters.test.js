// SPDX-License-Identifier: MIT
// Matter: tables, what worlds say of places and faces, craters cut short, chunks of two matters. The numbers are those of
// docs/matter.md, as in tests/c/test_matters.c.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxMesh, brush, firma, readers, releasing, throwsCode } from './helpers.js';

const mapOf = (...brushes) => `{\n"classname" "worldspawn"\n${brushes.join('')}}\n`;

const wall = mapOf(brush([0, 0, 0], [8, 1, 4], 'old_brick'), brush([0, -8, -2], [8, 8, 0], 'planks'));
const three = mapOf(
    brush([0, 0, 0], [4, 4, 4], 'old_brick'),
    brush([4, 0, 0], [8, 4, 4], 'wood_panel'),
    brush([8, 0, 0], [12, 4, 4], 'steel'),
);
const table = 'matter vault brick\n  texture *brick*\n  hardness 1\nmatter oak\n  texture planks\n  inside oak/split\n';
const worldOf = (map, matters) => readers.worldFromMap(map, { scale: 1, matters });
const named = ({ matters }, name) => matters.findIndex((one) => one.name === name);

/** Square metres that edits left, by the name of the material. */
function insides(world) {
    const { materials } = world.facts();
    const area = new Map();
    const faces = world.faces();
    faces.ids.forEach((_, k) => {
        if (faces.sourceEdits[k] === 0) return;
        const at = (c) => faces.corners.subarray(3 * (faces.firstCorners[k] + c), 3 * (faces.firstCorners[k] + c) + 3);
        const sum = [0, 0, 0];
        const a = at(0);
        for (let c = 2; c < faces.cornerCounts[k]; ++c) {
            const [p, q] = [at(c - 1), at(c)];
            for (let i = 0; i < 3; ++i) {
                const [u, v] = [(i + 1) % 3, (i + 2) % 3];
                sum[i] += (p[u] - a[u]) * (q[v] - a[v]) - (p[v] - a[v]) * (q[u] - a[u]);
            }
        }
        const name = materials[faces.materials[k]];
        area.set(name, (area.get(name) ?? 0) + 0.5 * Math.hypot(...sum));
    });
    return Object.fromEntries([...area].map(([name, metres]) => [name, metres.toFixed(1)]));
}

test('tables: the built-in one, and one of a text', async () => {
    const usual = firma.defaultMatters();
    assert.deepEqual(usual.matters.map(({ name }) => name), ['', 'brick', 'concrete', 'wood', 'steel', 'glass', 'rock']);
    assert.deepEqual(usual.matters[4], {
        name: 'steel',
        inside: 'matter/steel',
        density: 7850,
        strength: 400,
        hardness: 0,
        fracture: 'bends',
    });
    assert.equal(usual.patterns.length, 20);
    assert.deepEqual(usual.patterns[2], { pattern: '*brick*', matter: 1 });
    const game = await firma.readMatters(table, 'game.matter');
    assert.deepEqual(game, readers.readMatters(new TextEncoder().encode(table)));
    assert.deepEqual(
        game.matters.map(({ name, inside, hardness }) => [name, inside, hardness]),
        [
            ['', '', 0],
            ['vault brick', '', 1],
            ['oak', 'oak/split', 0],
        ],
    );
    throwsCode('MALFORMED', () => readers.readMatters('matter a\ndensity 0\n', 't'), /^t:2: a density/);
    throwsCode('BAD_CALL', () => readers.readMatters(7), /the table/);
    assert.equal(firma.liveHandles(), 0);
});

test('what a world says of its places and faces', () => {
    releasing([worldOf(wall)], (world) => {
        const matters = world.matters();
        assert.deepEqual(matters, firma.defaultMatters());
        const [brick, wood] = [named(matters, 'brick'), named(matters, 'wood')];
        assert.equal(world.matterAt([4, 0.5, 2]), brick);
        assert.equal(world.matterAt([4, 0.5, -1]), wood);
        throwsCode('OUT_OF_RANGE', () => world.matterAt([NaN, 0, 0]), /finite/);
        throwsCode('BAD_CALL', () => world.matterAt([1, 2]), /point/);
        const hit = world.cast({ centre: [4, -4, 2], radius: 0, path: [0, 8, 0] });
        assert.equal(world.matterOf(hit), brick);
        throwsCode('INVALID', () => world.matterOf({ ...hit, face: 2 ** 30 }), /no such face/);
        throwsCode('BAD_CALL', () => world.matterOf(null), /face/);
        const counts = world.countMatters();
        assert.deepEqual([counts.pieces, counts.protectedPieces], [2, 0]);
        assert.deepEqual(counts.ofMatter, [0, 1, 0, 1, 0, 0, 0]);
        releasing([firma.unpackWorld(world.pack())], (read) => {
            assert.deepEqual(read.matters(), matters);
            assert.equal(read.matterAt([4, 0.5, 2]), brick);
        });
    });
});

test('craters show insides, and are cut short', () => {
    const game = readers.readMatters(table, 'game.matter');
    releasing([worldOf(wall), worldOf(wall, game), firma.crater('rocky', 3)], (world, vault, crater) => {
        const foot = { position: [4, 0, 0], scale: 1.5 };
        const soft = world.carve(crater, foot);
        releasing([soft.world], () => {
            assert.equal(soft.report.cutShort, 0);
            assert.deepEqual(insides(soft.world), { 'matter/brick': '5.5', 'matter/wood': '14.9' });
        });
        const cut = vault.carve(crater, foot);
        const refused = vault.carve(crater, { position: [4, 0.5, 2], scale: 0.3 });
        releasing([cut.world, refused.world], () => {
            assert.equal(cut.report.cutShort, 1);
            assert.deepEqual(insides(cut.world), { '': '2.9', 'oak/split': '14.9' });
            assert.equal(refused.report.status, 'refused');
            assert.match(refused.report.reason, /matter vault brick may not be carved/);
            assert.equal(vault.countMatters().protectedPieces, 1);
        });
    });
});

test('tables that are none', () => {
    const mesh = boxMesh();
    const make = (matters) => firma.worldFromMesh(mesh, { matters });
    releasing([make({ matters: [{}] })], (world) => {
        assert.deepEqual(world.matters(), {
            matters: [{ name: '', inside: '', density: 2400, strength: 3, hardness: 0, fracture: 'chunks' }],
            patterns: [],
        });
    });
    throwsCode('INVALID', () => make({ matters: [] }), /none/);
    throwsCode('INVALID', () => make({ matters: [{ density: 0 }] }), /density/);
    throwsCode('INVALID', () => make({ matters: [{ hardness: 2 }] }), /hardness/);
    throwsCode('INVALID', () => make({ matters: [{}], patterns: [{ pattern: '*', matter: 1 }] }), /pattern 0/);
    throwsCode('BAD_CALL', () => make({ matters: [{ fracture: 'melts' }] }), /fracture/);
    throwsCode('BAD_CALL', () => make({ matters: [{ weight: 1 }] }), /there is no weight/);
    throwsCode('BAD_CALL', () => make({ matters: {} }), /array/);
    throwsCode('BAD_CALL', () => make({ matters: [{}], patterns: [{ pattern: '*' }] }), /pattern 0: matter/);
    throwsCode('BAD_CALL', () => make([]), /object/);
});

test('a chunk of wood and steel', () => {
    const { positions, corners } = boxMesh([3, -1, -1], [5.25, 5, 5]);
    const triangles = [];
    for (let k = 0; k < corners.length; k += 4) {
        const [a, b, c, d] = corners.slice(k, k + 4);
        triangles.push(a, c, b, a, d, c);
    }
    const blade = firma.cutterFromMesh(positions, triangles);
    const whole = worldOf(three);
    const world = whole.withAnchors({ hanging: false, materials: ['old_brick'] });
    releasing([blade, whole, world], () => {
        const close = (value, expected) => assert.ok(Math.abs(value - expected) <= 1e-12 * expected, `${value}`);
        for (const density of [undefined, 1000]) {
            const { world: after, report } = world.carve(blade, { position: [0, 0, 0] }, { chunks: { density } });
            releasing([after, report.loose], () => {
                const [chunk] = report.loose.list();
                assert.deepEqual(chunk.matters.map(({ matter }) => world.matters().matters[matter].name), ['wood', 'steel']);
                close(chunk.matters[0].volume, 44);
                close(chunk.matters[1].volume, 64);
                close(chunk.mass, density ? 1000 * 108 : 600 * 44 + 7850 * 64);
                // What the cut shows of it has a name, though nothing that stayed shows any wood.
                releasing([report.loose.world(0)], (piece) => {
                    const { materials } = piece.facts();
                    const { materials: of, sourceEdits } = piece.faces();
                    const cut = [...of].filter((_, k) => sourceEdits[k] > 0).map((material) => materials[material]);
                    assert.deepEqual(cut, ['matter/wood']);
                });
            });
        }
    });
});
