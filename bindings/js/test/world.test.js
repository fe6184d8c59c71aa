// SPDX-License-Identifier: MIT
// Worlds from files and meshes, what they tell of themselves, and packing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FACE_SOLID, FACE_TWO_SIDED } from '../src/index.js';
import { boxMesh, brush, firma, levelBytes, readers, releasing, throwsCode, withLevel } from './helpers.js';
import { randomCasts } from './scenario.js';

const triangle = 'v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n';

test('an .obj as text and as bytes of every kind is the same world', () => {
    const text = new TextDecoder().decode(levelBytes);
    const copy = new Uint8Array(levelBytes);
    const all = [text, levelBytes, copy, copy.buffer, new DataView(copy.buffer)].map((file) =>
        readers.worldFromObj(file),
    );
    releasing(all, (first, ...others) => {
        for (const other of others) assert.equal(other.hash(), first.hash());
        assert.equal(typeof first.hash(), 'bigint');
        assert.ok(first.hash() > 0n);
    });
});

test('facts, check, measure, memory', () => {
    withLevel((world) => {
        const facts = world.facts();
        assert.deepEqual(
            { ...facts, materials: facts.materials.length },
            {
                version: 0,
                faceCount: 5944,
                roomCount: 1,
            portalCount: 0,
                low: [2, -10, -1.285888671875],
                high: [79, 48, 9.5],
                contactOffset: 0.001,
                materials: 10,
                edits: 0,
            },
        );
        assert.ok(facts.materials.includes('wall'));
        world.check();
        const { volume, area } = world.measure();
        assert.ok(Math.abs(volume + 15525.511392) < 1e-3 && Math.abs(area - 8646.83595) < 1e-3);
        assert.ok(world.memory() > 100_000);
        assert.equal(firma.memory([world]), world.memory());
        assert.equal(firma.memory([]), 0);
        releasing([world.copy()], (copy) => {
            assert.equal(copy.hash(), world.hash());
            assert.equal(firma.memory([world, copy]), world.memory());
        });
        throwsCode('BAD_CALL', () => firma.memory(world));
        throwsCode('BAD_HANDLE', () => firma.memory([world, null]));
    });
});

test('options are taken', () => {
    const scaled = readers.worldFromObj(triangle, { scale: 0.5, contactOffset: 0.25, name: 'a triangle' });
    releasing([scaled], (world) => {
        assert.deepEqual(world.facts().high, [2, 2, 0]);
        assert.equal(world.facts().contactOffset, 0.25);
    });
    const options = { surfaceArea: true, maxDepth: 3, facesPerLeaf: 2, minNodeVolume: 0.5 };
    releasing([readers.worldFromObj(levelBytes, options), readers.worldFromObj(levelBytes)], (chosen, usual) => {
        const [shallow, deep] = [chosen, usual].map((world) => {
            const counts = {};
            world.castBatch(randomCasts(200, usual.facts(), 3), { counts });
            return counts.faces + counts.boxes;
        });
        assert.ok(shallow > deep, `a shallow tree looks at more: ${shallow}, ${deep}`);
    });
    const wrong = [
        { maxDepth: 65 },
        { facesPerLeaf: 0 },
        { contactOffset: -1 },
        { contactOffset: NaN },
        { scale: Infinity },
        { scale: -1 },
    ];
    for (const one of wrong) throwsCode('INVALID', () => readers.worldFromObj(triangle, one));
    const bad = [
        { maxDepth: 1.5 },
        { facesPerLeaf: '2' },
        { contactOffset: '1' },
        { surfaceArea: 2 },
        { name: 5 },
        { name: 'a\0b' },
    ];
    for (const one of [...bad, null, 7])
        throwsCode('BAD_CALL', () => readers.worldFromObj(triangle, one), /^worldFromObj: /);
});

test('bad files say where', () => {
    throwsCode('MALFORMED', () => readers.worldFromObj('v 0 0 zero', { name: 'röhre.obj' }), /röhre\.obj/);
    throwsCode('OUT_OF_RANGE', () => readers.worldFromObj('v 0 0 0\nf 1 2 3\n'), /2/);
    throwsCode('MALFORMED', () => readers.worldFromBsp(new Uint8Array(10), { name: 'cut.bsp' }), /cut\.bsp/);
    throwsCode('BAD_CALL', () => readers.worldFromBsp('text'));
    for (const one of [undefined, null, 3, [1, 2]]) throwsCode('BAD_CALL', () => readers.worldFromObj(one));
});

test('a mesh, with all its arrays and with few', () => {
    const box = boxMesh();
    const extras = {
        materials: [0, 1, 0, 1, 0, 1],
        materialNames: ['fels', 'größe 日本'],
        masks: Uint32Array.of(1, 2, 4, 8, 16, 0xffffffff),
        twoSided: [false, false, true, false, false, false],
    };
    releasing([firma.worldFromMesh(box), firma.worldFromMesh({ ...box, ...extras }, { contactOffset: 0.01 })], (plain, full) => {
        assert.deepEqual(full.facts().materials.filter(Boolean), extras.materialNames);
        assert.equal(full.facts().contactOffset, 0.01);
        assert.deepEqual(full.facts().low, [0, 0, 0]);
        assert.deepEqual(full.facts().high, [8, 8, 8]);
        assert.deepEqual([...full.faces().masks], [...extras.masks]);
        assert.equal(full.faces().flags[2] & FACE_TWO_SIDED, FACE_TWO_SIDED);
        assert.ok(plain.faces().flags.every((flags) => flags === FACE_SOLID));
        assert.equal(plain.measure().volume, -512);
        assert.equal(plain.locate([4, 4, 4]).where, 'air');
        assert.equal(plain.locate([9, 4, 4]).where, 'solid');
    });
    const triangles = { positions: Float32Array.of(0, 0, 0, 4, 0, 0, 0, 4, 0), corners: Uint16Array.of(0, 1, 2) };
    releasing([firma.worldFromMesh(triangles)], (world) => assert.equal(world.facts().faceCount, 1));
    throwsCode('MALFORMED', () => firma.worldFromMesh({ positions: [], corners: [] }), /no faces/);
});

test('masks as operators make them, materials by their numbers', () => {
    const names = { materialNames: ['a', 'a', 'b'], materials: [0, 1, 2, 2, 2, 2] };
    const masks = [~0, ~1, 2, 0, -(2 ** 31), 2 ** 32 - 1];
    releasing([firma.worldFromMesh({ ...boxMesh(), masks, ...names })], (world) => {
        assert.deepEqual(Array.from(world.faces().masks), [2 ** 32 - 1, 2 ** 32 - 2, 2, 0, 2 ** 31, 2 ** 32 - 1]);
        assert.deepEqual(world.facts().materials, ['a', 'a', 'b']);
        assert.deepEqual(Array.from(world.faces().materials), [0, 1, 2, 2, 2, 2]);
    });
    releasing([firma.worldFromMesh({ ...boxMesh(), masks: Int32Array.of(-1, -2, 2, 0, 1, 3) })], (world) => {
        assert.deepEqual(Array.from(world.faces().masks), [2 ** 32 - 1, 2 ** 32 - 2, 2, 0, 1, 3]);
    });
    for (const mask of [2 ** 32, -(2 ** 31) - 1, 0.5, '1'])
        throwsCode('BAD_CALL', () => firma.worldFromMesh({ ...boxMesh(), masks: Array(6).fill(mask) }), /masks/);
});

test('bytes whose memory was transferred are refused', () => {
    const bytes = new Uint8Array(8);
    structuredClone(bytes, { transfer: [bytes.buffer] });
    throwsCode('BAD_CALL', () => readers.worldFromObj(bytes), /the file cannot be read/);
});

test('meshes whose arrays do not fit each other', () => {
    const box = boxMesh();
    const wrong = [
        null,
        { ...box, positions: box.positions.slice(1) },
        { ...box, corners: box.corners.slice(1) },
        { ...box, cornerCounts: undefined, corners: [0, 1] },
        { ...box, cornerCounts: [4, 4, 4, 4, 4, 5] },
        { ...box, corners: [...box.corners.slice(1), -1] },
        { ...box, corners: [...box.corners.slice(1), 1.5] },
        { ...box, positions: [...box.positions.slice(1), '1'] },
        { ...box, materials: [0] },
        { ...box, masks: [1, 2, 3, 4, 5, NaN] },
        { ...box, twoSided: [true] },
        { ...box, materialNames: 'rock' },
        { ...box, materialNames: [5] },
        { corners: box.corners },
    ];
    for (const mesh of wrong) throwsCode('BAD_CALL', () => firma.worldFromMesh(mesh), /^worldFromMesh: /);
    const far = { ...box, corners: [99, ...box.corners.slice(1)] };
    assert.throws(() => firma.worldFromMesh(far, { name: 'far' }), /far/);
    throwsCode('OUT_OF_RANGE', () => firma.worldFromMesh({ ...box, positions: box.positions.map(() => NaN) }));
    assert.throws(() => firma.worldFromMesh({ ...box, materials: [0, 0, 0, 0, 0, 9], materialNames: ['a'] }));
});

test('faces are copies, each found by its id', () => {
    withLevel((world) => {
        const faces = world.faces();
        assert.equal(faces.ids.length, world.facts().faceCount);
        assert.ok(faces.ids.every((id, k) => k === 0 || id > faces.ids[k - 1]));
        let corners = 0;
        faces.ids.forEach((_, k) => {
            assert.equal(faces.firstCorners[k], corners);
            corners += faces.cornerCounts[k];
            const [x, y, z] = faces.normals.subarray(3 * k, 3 * k + 3);
            assert.ok(Math.abs(x * x + y * y + z * z - 1) < 1e-12);
        });
        assert.equal(faces.corners.length, 3 * corners);
        const k = 17;
        const face = world.findFace(faces.ids[k]);
        const begin = 3 * faces.firstCorners[k];
        assert.deepEqual(face, {
            id: faces.ids[k],
            normal: [...faces.normals.subarray(3 * k, 3 * k + 3)],
            material: faces.materials[k],
            source: faces.sources[k],
            sourceEdit: 0,
            mask: 0xffffffff,
            flags: FACE_SOLID,
            room: 0,
            corner: [...faces.corners.subarray(begin, begin + 3)].map((x) => x * 262144),
            corners: faces.corners.slice(begin, begin + 3 * faces.cornerCounts[k]),
        });
        assert.equal(world.findFace(4_000_000), null);
        for (const id of [-1, 0.5, 2 ** 32, '1', undefined]) throwsCode('BAD_CALL', () => world.findFace(id));
        faces.corners.fill(0);
        assert.notEqual(world.faces().corners[0], 0);
    });
});

test('faces as triangles', () => {
    withLevel((world) => {
        const faces = world.faces();
        const all = world.triangles();
        assert.equal(all.sources.length, faces.ids.length);
        assert.equal(all.positions.length, faces.corners.length);
        assert.equal(all.corners.length, 3 * faces.cornerCounts.reduce((sum, count) => sum + count - 2, 0));
        assert.equal(all.runs.reduce((sum, run) => sum + run.triangleCount, 0), all.faces.length);
        assert.deepEqual(all.runs.map((run) => run.material), [...new Set(faces.materials)].sort((a, b) => a - b));
        for (let t = 0; t < all.corners.length; t += 3) {
            const [a, b, c] = [0, 1, 2].map((k) => all.positions.subarray(3 * all.corners[t + k], 3 * all.corners[t + k] + 3));
            const [u, v] = [b, c].map((p) => p.map((x, axis) => x - a[axis]));
            const normal = [0, 1, 2].map((axis) => u[(axis + 1) % 3] * v[(axis + 2) % 3] - u[(axis + 2) % 3] * v[(axis + 1) % 3]);
            const along = normal.reduce((sum, x, axis) => sum + x * all.normals[3 * all.corners[t] + axis], 0);
            assert.ok(along > 0, `triangle ${t / 3}`);
        }
        const moved = world.triangles({ origin: [32, 16, 2], room: 0 });
        assert.equal(moved.positions[0], all.positions[0] - 32);
        assert.equal(world.triangles({ mask: 0 }).corners.length, 0);
        assert.equal(world.triangles({ region: [-1, 0, 0] }).corners.length < all.corners.length, true);
        throwsCode('INVALID', () => world.triangles({ room: 7 }), /no such room/);
        throwsCode('INVALID', () => world.triangles({ room: 0, region: [0, 0, 0] }), /not both/);
        throwsCode('OUT_OF_RANGE', () => world.triangles({ origin: [0, NaN, 0] }), /origin/);
        for (const wrong of [5, { room: -1 }, { region: [1, 2] }, { region: [0.5, 0, 0] }, { origin: 3 }, { solidOnly: 1 }])
            throwsCode('BAD_CALL', () => world.triangles(wrong));
    });
});

test('meshes by region, and those that an edit changed', () => {
    withLevel((world) => {
        const kept = new Map();
        const replace = (meshes) => {
            for (const mesh of meshes) {
                if (mesh.faces.length > 0) kept.set(String(mesh.place), mesh);
                else kept.delete(String(mesh.place));
            }
        };
        const options = { size: 8 };
        replace(world.regionMeshes(options));
        releasing([firma.crater('rocky', 1)], (cutter) => {
            const { world: after } = world.carve(cutter, { position: [35, 29, 0], scale: 1.5 });
            releasing([after], () => {
                const changed = world.changedRegionMeshes(after, options);
                assert.ok(changed.length > 0 && changed.length < kept.size);
                replace(changed);
                const anew = after.regionMeshes(options);
                assert.deepEqual([...kept.values()].sort((a, b) => String(a.place).localeCompare(String(b.place))),
                    [...anew].sort((a, b) => String(a.place).localeCompare(String(b.place))));
                const faces = after.faces();
                const ids = anew.flatMap((mesh) => Array.from(mesh.parts.faces));
                assert.deepEqual(ids.sort((a, b) => a - b), Array.from(faces.ids));
                let cut = 0;
                for (const mesh of anew) {
                    assert.deepEqual(mesh.origin, mesh.place.map((x) => 8 * x));
                    const { parts } = mesh;
                    for (let p = 0; p < parts.faces.length; ++p) {
                        const face = faces.ids.indexOf(parts.faces[p]);
                        const own = faces.corners.subarray(3 * faces.firstCorners[face], 3 * (faces.firstCorners[face] + faces.cornerCounts[face]));
                        const from = parts.firstVertices[p];
                        assert.equal(parts.vertexCounts[p], faces.cornerCounts[face]);
                        assert.equal(parts.sourceEdits[p], faces.sourceEdits[face]);
                        own.forEach((x, k) => assert.equal(mesh.positions[3 * from + k] + mesh.origin[k % 3], x));
                        assert.equal(mesh.faces[parts.firstTriangles[p]], parts.faces[p]);
                        const blend = mesh.blends.subarray(4 * from, 4 * from + 4);
                        assert.equal(blend.reduce((sum, part) => sum + part, 0), 255);
                        assert.equal(blend[3], parts.sourceEdits[p] > 0 ? 0 : 255);
                    }
                    for (const run of mesh.runs) cut += run.cut ? run.triangleCount : 0;
                    assert.equal(mesh.tangents.length / 4, mesh.positions.length / 3);
                    assert.equal(mesh.uvs.length / 2, mesh.positions.length / 3);
                    assert.equal(mesh.normals.length, mesh.positions.length);
                }
                assert.ok(cut > 100);
                const ref = { id: anew[0].parts.faces[0], corner: anew[0].parts.faceCorners.slice(0, 3) };
                assert.equal(after.face(ref).id, ref.id);
                assert.equal(after.changedRegionMeshes(after).length, 0);
            });
        });
        const plain = world.regionMeshes({ textures: false })[0];
        assert.deepEqual([plain.uvs.length, plain.tangents.length, plain.blends.length], [0, 0, 0]);
        assert.equal(world.regionMeshes({ mask: 0 }).length, 0);
        throwsCode('INVALID', () => world.regionMeshes({ size: 0.5 }), /size: must be from 1 to 1024 m/);
        throwsCode('INVALID', () => world.changedRegionMeshes(world, { size: NaN }), /size/);
        throwsCode('INVALID', () => world.regionMeshes({ textureSizes: [-1, 1] }), /texture_sizes/);
        throwsCode('BAD_HANDLE', () => world.changedRegionMeshes(5), /not a world/);
        for (const wrong of [5, { size: '8' }, { textures: 1 }, { textureSizes: [1] }, { room: 0 }, { solidOnly: 1 }])
            throwsCode('BAD_CALL', () => world.regionMeshes(wrong));
    });
});

test('textures come out as coordinates', () => {
    const wall = {
        positions: [0, 0, 0, 4, 0, 0, 4, 0, 2, 0, 0, 2],
        corners: [0, 1, 2, 3],
        cornerCounts: [4],
        uvs: [0, 1, 2, 1, 2, 0, 0, 0],
    };
    releasing([firma.worldFromMesh(wall)], (world) => {
        assert.deepEqual(world.texture(0), {
            uAxis: [0.5, 0, 0], uOffset: 0, vAxis: [0, 0, -0.5], vOffset: 1, unit: 'repeats',
        });
        assert.deepEqual(world.texture(world.cast({ centre: [2, -1, 1], radius: 0, path: [0, 4, 0] })), world.texture(0));
        for (const face of [world.findFace(0), world.closest([2, -1, 1])])
            assert.deepEqual(world.texture(face), world.texture(0));
        assert.equal(world.triangles().uvs.length, 0);
        const made = world.triangles({ uvs: true });
        assert.equal(made.sources[0].uvUnit, 'repeats');
        for (let v = 0; v < 4; ++v) {
            assert.equal(made.uvs[2 * v], made.positions[3 * v] / 2);
            assert.equal(made.uvs[2 * v + 1], 1 - made.positions[3 * v + 2] / 2);
        }
        throwsCode('INVALID', () => world.texture(7), /no such face/);
        for (const wrong of [-1, null, undefined, 'a', {}, { face: 0 }])
            throwsCode('BAD_CALL', () => world.texture(wrong));
        throwsCode('INVALID', () => world.texture({ face: null, corner: [0, 0, 0] })); // as of a miss
        releasing([firma.worldFromMesh(wall, { textures: false })], (plain) => {
            assert.equal(plain.texture(0).unit, 'metres');
        });
        throwsCode('BAD_CALL', () => firma.worldFromMesh(wall, { textures: 0 }), /textures/);
        for (const wrong of [{ uvs: 1 }, { textureSizes: 64 }, { textureSizes: [64] }, { textureSizes: ['a', 1] }])
            throwsCode('BAD_CALL', () => world.triangles(wrong));
    });
    throwsCode('BAD_CALL', () => firma.worldFromMesh({ ...wall, uvs: [0, 1] }), /8, not 2/);
    throwsCode('OUT_OF_RANGE', () => firma.worldFromMesh({ ...wall, uvs: wall.uvs.fill(NaN) }), /not finite/);

    const map = `{\n"classname" "worldspawn"\n${brush([-256, -256, -256], [256, 256, 256], 'wall')}}\n`;
    releasing([readers.worldFromMap(map), firma.crater('rocky', 1)], (world, cutter) => {
        const { world: after } = world.carve(cutter, { position: [0, 0, 8] });
        releasing([after, firma.unpackWorld(after.pack())], (...worlds) => {
            for (const one of worlds) {
                const sizes = one.facts().materials.flatMap((name) => (name === 'wall' ? [64, 128] : [0, 0]));
                const made = one.triangles({ uvs: true, textureSizes: Float64Array.from(sizes) });
                const units = new Set(made.sources.map(({ sourceEdit, uvUnit }) => `${sourceEdit > 0} ${uvUnit}`));
                assert.deepEqual([...units].sort(), ['false repeats', 'true metres']);
                for (const { sourceEdit, firstVertex: first, vertexCount } of made.sources) {
                    if (sourceEdit > 0 || made.normals[3 * first + 2] < 0.5) continue;
                    for (let v = first; v < first + vertexCount; ++v) {
                        assert.ok(Math.abs(made.uvs[2 * v] - made.positions[3 * v] / 2) < 1e-4);
                        assert.ok(Math.abs(made.uvs[2 * v + 1] + made.positions[3 * v + 1] / 4) < 1e-4);
                    }
                }
                assert.equal(one.texture(made.sources.find(({ sourceEdit }) => sourceEdit > 0).face).unit, 'metres');
                assert.equal(one.texture(made.sources.find(({ sourceEdit }) => sourceEdit === 0).face).unit, 'texels');
            }
        });
    });
});

test('packed and unpacked it is the same; without the exact part it cannot be carved', () => {
    withLevel((world) => {
        const whole = world.pack();
        const light = world.pack({ exact: false });
        assert.ok(light.length < whole.length);
        assert.deepEqual(world.pack({ exact: true }), whole);
        releasing(
            [firma.unpackWorld(whole, 'a'), firma.unpackWorld(light), firma.crater('rocky', 1)],
            (again, lighter, cutter) => {
                assert.equal(again.hash(), world.hash());
                assert.deepEqual(again.facts(), world.facts());
                assert.deepEqual(again.faces(), world.faces());
                again.check();
                const cast = { centre: [40, 20, 4], radius: 0.1, path: [30, 1, 0] };
                assert.deepEqual(lighter.cast(cast), world.cast(cast));
                const { world: after, report } = lighter.carve(cutter, { position: world.cast(cast).point });
                after.release();
                assert.notEqual(report.status, 'done');
            },
        );
        throwsCode('MALFORMED', () => firma.unpackWorld(whole.subarray(0, 1000), 'half.firma'), /half\.firma/);
        throwsCode('MALFORMED', () => firma.unpackWorld(whole.map((byte, k) => (k === 5000 ? byte ^ 1 : byte))));
        throwsCode('MALFORMED', () => firma.unpackWorld(new Uint8Array(0)));
        throwsCode('BAD_CALL', () => firma.unpackWorld('text'));
        throwsCode('BAD_CALL', () => world.pack({ exact: 1 }));
        throwsCode('BAD_CALL', () => world.pack(null));
    });
});
