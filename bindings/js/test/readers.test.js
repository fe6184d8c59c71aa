// SPDX-License-Identifier: MIT
// The module of readers: loaded once, when it is needed or ahead; where it is looked for; what happens when it is not
// there, or stops.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { FirmaError, loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';
import { boxMesh, brush, firma, levelBytes, readers, readersUrl, releasing, throwsCode, wasmUrl } from './helpers.js';

const core = await WebAssembly.compile(await readFile(wasmUrl));
const readersBytes = await readFile(readersUrl);
const map = `{ "classname" "worldspawn" ${brush([0, 0, 0], [64, 64, 64], 'rock')} }`;
const tetrahedron = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n';

const rejects = (code, promise, message) =>
    assert.rejects(promise, (error) => {
        assert.ok(error instanceof FirmaError, `not a FirmaError: ${error.stack}`);
        assert.equal(error.code, code, error.message);
        assert.match(error.message, message);
        return true;
    });

/** Serves both modules from a folder of their own until work(address, asked) is done; `asked` is every path so far. */
async function serving(work) {
    const asked = [];
    const files = { '/a/firma.wasm': wasmUrl, '/a/firma_readers.wasm': readersUrl, '/b/firma.wasm': wasmUrl };
    const server = createServer(async (request, response) => {
        asked.push(request.url);
        const file = files[request.url.replace(/\?.*/, '')];
        if (request.url === '/c/firma_readers.wasm')
            return response.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html>');
        if (!file) return response.writeHead(404).end();
        response.writeHead(200, { 'content-type': 'application/wasm' }).end(await readFile(file));
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    try {
        await work(`http://127.0.0.1:${server.address().port}`, asked);
    } finally {
        server.closeAllConnections?.();
        await new Promise((closed) => server.close(closed));
    }
}

/** Counts what is compiled and started while work() runs. */
async function counting(work) {
    const { compile, instantiate } = WebAssembly;
    const counts = { compiled: 0, started: 0 };
    WebAssembly.compile = (...args) => (++counts.compiled, compile(...args));
    WebAssembly.instantiate = (...args) => (++counts.started, instantiate(...args));
    try {
        await work(counts);
    } finally {
        Object.assign(WebAssembly, { compile, instantiate });
    }
}

test('nothing is loaded before a file is read, and then once', async () => {
    await counting(async (counts) => {
        const one = await loadFirma(core);
        one.worldFromMesh(boxMesh()).release();
        assert.deepEqual(counts, { compiled: 0, started: 1 });
        const made = await Promise.all([one.worldFromObj(levelBytes), one.worldFromMap(map), one.cutterFromObj(tetrahedron)]);
        assert.equal(counts.compiled, 1);
        const started = counts.started;
        made.push(await one.worldFromObj(levelBytes), await one.levelFromMap(map));
        const ahead = await loadReaders(one);
        made.push(ahead.worldFromObj(levelBytes));
        assert.deepEqual(counts, { compiled: 1, started });
        assert.equal(one.liveHandles(), 6);
        for (const object of made) object.release();
        assert.equal(one.liveHandles(), 0);
    });
});

test('loaded ahead, reading waits for nothing', async () => {
    const one = await loadFirma(core);
    const ahead = await loadReaders(one);
    await counting(async (counts) => {
        releasing([ahead.worldFromMap(map), await one.worldFromMap(map)], (a, b) => {
            assert.equal(a.hash(), b.hash());
            assert.equal(a.sameSolid(b), true);
        });
        assert.deepEqual(counts, { compiled: 0, started: 0 });
    });
    for (const none of [undefined, null, {}, 'firma', core, readers])
        await rejects('BAD_CALL', loadReaders(none), /^loadReaders: /);
});

test('both ways of reading give the same, and mistakes reject at once or throw', async () => {
    releasing([await firma.cutterFromObj(tetrahedron), readers.cutterFromObj(tetrahedron), readers.worldFromObj(levelBytes)], (a, b, world) => {
        const place = { position: [35, 29, 4], scale: 2 };
        releasing([world.carve(a, place).world, world.carve(b, place).world], (one, other) =>
            assert.equal(one.hash(), other.hash()),
        );
    });
    const wrong = [
        ['worldFromObj', [5]],
        ['worldFromObj', [levelBytes, { scal: 1 }]],
        ['worldFromBsp', ['text']],
        ['worldFromMap', [map, { name: 5 }]],
        ['levelFromMap', [map, { scale: '1' }]],
        ['levelFromBsp', []],
        ['cutterFromObj', [tetrahedron, 5]],
    ];
    const nowhere = await loadFirma(core, { readers: 'no/such/file.wasm' });
    for (const [name, args] of wrong) {
        await rejects('BAD_CALL', firma[name](...args), new RegExp(`^${name}: `));
        await rejects('BAD_CALL', nowhere[name](...args), new RegExp(`^${name}: `)); // before anything is looked for
        throwsCode('BAD_CALL', () => readers[name](...args), new RegExp(`^${name}: `));
    }
    await rejects('MALFORMED', firma.worldFromObj('v 0 0 zero', { name: 'röhre.obj' }), /^röhre\.obj/);
    await rejects('MALFORMED', firma.cutterFromObj('v 0 0 0', 'nothing.obj'), /nothing\.obj/);
    await rejects('MALFORMED', firma.cutterFromObj('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3'), /^obj: .*at least 4 triangles/);
});

test('a file may be changed as soon as the call has returned', async () => {
    const one = await loadFirma(core);
    const file = Uint8Array.from(levelBytes);
    const promise = one.worldFromObj(file);
    file.fill(0);
    releasing([await promise, readers.worldFromObj(levelBytes)], (world, same) => assert.equal(world.hash(), same.hash()));
});

test('a world of a file carves as one of the other module: the bytes between them lose nothing', async () => {
    const depot = readFileSync(new URL('../../../levels/depot.map', import.meta.url));
    for (const made of [readers.worldFromMap(depot, { maxDepth: 20, facesPerLeaf: 6, contactOffset: 0.01 }), readers.worldFromObj(levelBytes)])
        releasing([made, firma.crater('rocky', 3)], (world, cutter) => {
            const packed = world.pack();
            releasing([firma.unpackWorld(packed)], (again) => assert.deepEqual(again.pack(), packed));
            const { version, edits } = world.facts();
            assert.deepEqual([version, edits], [0, 0]);
            const hit = world.cast({ centre: [20, 9, 2], radius: 0, path: [50, 7, 3] });
            const { world: after, report } = world.carve(cutter, { position: hit.point, scale: 1.5 });
            releasing([after], () => assert.equal(report.status, 'done'));
            world.check();
        });
});

test('every kind of source', async () => {
    const module = await WebAssembly.compile(readersBytes);
    const sources = [readersUrl, readersUrl.href, fileURLToPath(readersUrl), readersBytes, module, Promise.resolve(module), new Response(readersBytes)];
    for (const source of sources) {
        const one = await loadFirma(core, { readers: source });
        (await one.worldFromMap(map)).release();
        assert.equal((await loadReaders(one)).version, firma.version);
    }
});

test('they are looked for beside the other module', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'firma-'));
    try {
        cpSync(wasmUrl, join(folder, 'firma.wasm'));
        const one = await loadFirma(join(folder, 'firma.wasm'));
        const place = (error) => error.code === 'CANNOT_READ' && error.message.includes(join(folder, 'firma_readers.wasm'));
        await assert.rejects(one.worldFromMap(map), place);
        await assert.rejects(loadReaders(one), place);
        cpSync(readersUrl, join(folder, 'firma_readers.wasm')); // the next call tries again
        (await one.worldFromMap(map)).release();
        cpSync(wasmUrl, join(folder, 'other.wasm')); // by another name: what the package has
        (await (await loadFirma(join(folder, 'other.wasm'))).worldFromMap(map)).release();
    } finally {
        rmSync(folder, { recursive: true });
    }
    await serving(async (address, asked) => {
        for (const source of [`${address}/a/firma.wasm?v=1`, new URL('/a/firma.wasm', address), fetch(`${address}/a/firma.wasm`)]) {
            const one = await loadFirma(source);
            (await one.worldFromMap(map)).release();
            (await one.worldFromMap(map)).release();
        }
        assert.deepEqual(asked, ['/a/firma.wasm', '/a/firma.wasm?v=1', '/a/firma_readers.wasm?v=1', '/a/firma.wasm', '/a/firma_readers.wasm', '/a/firma_readers.wasm']);
        const missing = await loadFirma(`${address}/b/firma.wasm`);
        const said = /^worldFromMap: http:\S+\/b\/firma_readers\.wasm: status 404 \(the module of readers was looked for at http:\S+\/b\/firma_readers\.wasm; loadFirma\(source, \{ readers \}\) says/;
        await rejects('CANNOT_READ', missing.worldFromMap(map), said);
        missing.worldFromMesh(boxMesh()).release();
        const page = await loadFirma(core, { readers: `${address}/c/firma_readers.wasm` });
        await rejects('MALFORMED', page.worldFromMap(map), /looked for at http:\S+\/c\/firma_readers\.wasm/);
    });
});

test('what is not the module of readers is refused', async () => {
    const withReaders = async (source) => (await loadFirma(core, { readers: source })).worldFromMap(map);
    await rejects('UNSUPPORTED', withReaders(wasmUrl), /^worldFromMap: not Firma's module of readers/);
    await rejects('UNSUPPORTED', loadFirma(readersBytes), /^loadFirma: not Firma's module$/);
    await rejects('MALFORMED', withReaders(new Uint8Array(0)), /^worldFromMap: /);
    await rejects('BAD_CALL', withReaders(7), /^worldFromMap: /);
    await assert.rejects(withReaders(Promise.reject(new Error('no network'))), /no network/);
    await rejects('BAD_CALL', loadFirma(core, { reader: readersUrl }), /there is no reader, only readers/);
    await rejects('BAD_CALL', loadFirma(core, null), /the options must be an object/);
});

/** A Firma whose readers have no more memory than they began with; those readers. */
async function loadSmall() {
    const one = await loadFirma(core);
    const { instantiate } = WebAssembly;
    let memory;
    WebAssembly.instantiate = async (...args) => {
        const instance = await instantiate(...args);
        memory = instance.exports.memory;
        return instance;
    };
    try {
        return [one, await loadReaders(one), memory];
    } finally {
        WebAssembly.instantiate = instantiate;
    }
}

test('readers that run out of memory stop alone; the next call starts others', async () => {
    const [one, small, memory] = await loadSmall();
    const world = one.worldFromMesh(boxMesh());
    const level = small.levelFromMap(map);
    for (let pages = 65536; pages >= 1; pages >>= 1) {
        try {
            for (;;) memory.grow(pages);
        } catch {
            // Fewer, then.
        }
    }
    const stopped = /^the module of readers stopped \(.*\), perhaps out of memory: loadReaders\(\) starts another$/;
    throwsCode('INTERNAL', () => {
        for (let k = 0; k < 100_000; ++k) small.levelFromMap(map); // until there is no room for another
    }, stopped);
    throwsCode('INTERNAL', () => small.worldFromMap(map), stopped);
    throwsCode('INTERNAL', () => level.entities(), stopped);
    level.release(); // went with them
    assert.equal(one.liveHandles(), 1);
    world.check();
    (await one.worldFromMap(map)).release();
    (await loadReaders(one)).worldFromMap(map).release();
    world.release();
    assert.equal(one.liveHandles(), 0);
});

test('readers that a large file has made large are not kept, and levels of theirs stay', async () => {
    const [one, , memory] = await loadSmall();
    const level = await one.levelFromMap(map);
    assert.equal(one.liveHandles(), 1);
    const padded = map + ' '.repeat(70 << 20);
    await counting(async (counts) => {
        (await one.worldFromMap(padded)).release();
        assert.ok(memory.buffer.byteLength > 70 << 20);
        assert.equal(counts.started, 0);
        const other = await one.levelFromMap(map); // of new ones
        assert.equal(counts.started, 1);
        assert.equal(one.liveHandles(), 2);
        releasing([level.world(), other.world()], (a, b) => assert.equal(a.hash(), b.hash()));
        other.release();
    });
    assert.equal(level.entities().length, 1);
    level.release();
    assert.equal(one.liveHandles(), 0);
});
