// SPDX-License-Identifier: MIT
// The module from every kind of source, and what is no module.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { FirmaError, loadFirma } from '../src/index.js';
import { boxMesh, firma, levelBytes, readersUrl, wasmUrl } from './helpers.js';

const bytes = await readFile(wasmUrl);
const gamesUrl = new URL('../src/firma_games.wasm', import.meta.url);
const recordingsUrl = new URL('../src/firma_recordings.wasm', import.meta.url);

/** Serves the module, and what goes wrong, until work(address) is done. */
async function serving(work) {
    const server = createServer((request, response) => {
        if (request.url === '/missing') return response.writeHead(404).end();
        if (request.url === '/broken') {
            response.writeHead(200, { 'content-type': 'application/wasm', 'content-length': bytes.length });
            response.write(bytes.subarray(0, 1000));
            return setTimeout(() => response.destroy(), 20);
        }
        const type = request.url === '/plain' ? 'application/octet-stream' : 'application/wasm';
        response.writeHead(200, { 'content-type': type }).end(bytes);
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    try {
        await work(`http://127.0.0.1:${server.address().port}`);
    } finally {
        server.closeAllConnections?.();
        await new Promise((closed) => server.close(closed));
    }
}

const rejects = (code, source, message = /^loadFirma: /) =>
    assert.rejects(loadFirma(source), (error) => {
        assert.ok(error instanceof FirmaError, `not a FirmaError: ${error.stack}`);
        assert.equal(error.code, code, error.message);
        assert.match(error.message, message);
        return true;
    });

test('the version is that of the package', async () => {
    const { version } = JSON.parse(await readFile(new URL('../package.json', import.meta.url)));
    assert.equal(firma.version, version);
});

test('every kind of source gives a module of its own', async () => {
    const { buffer } = new Uint8Array(bytes);
    const view = new Uint8Array(bytes.length + 3);
    view.set(bytes, 3);
    const sources = [
        wasmUrl,
        wasmUrl.href,
        fileURLToPath(wasmUrl),
        bytes,
        buffer,
        view.subarray(3),
        new DataView(buffer),
    ];
    sources.push(await WebAssembly.compile(bytes), Promise.resolve(bytes));
    sources.push(new Response(bytes), new Response(bytes, { headers: { 'content-type': 'application/wasm' } }));
    for (const source of sources) {
        const one = await loadFirma(source);
        const world = await one.worldFromObj(levelBytes);
        assert.equal(one.liveHandles(), 1);
        assert.equal(firma.liveHandles(), 0);
        world.release();
        assert.equal(one.liveHandles(), 0);
    }
});

test('the module over http, and what goes wrong there', async () => {
    await serving(async (address) => {
        for (const path of ['/', '/plain']) assert.equal((await loadFirma(address + path)).version, firma.version);
        assert.equal((await loadFirma(fetch(new URL('/', address)))).version, firma.version);
        await rejects('CANNOT_READ', `${address}/missing`, /404/);
        await assert.rejects(loadFirma(`${address}/broken`), FirmaError);
    });
    await rejects('CANNOT_READ', 'http://127.0.0.1:1/');
    await rejects('CANNOT_READ', new URL('missing.wasm', import.meta.url), /missing\.wasm/);
    await rejects('CANNOT_READ', 'no/such/file.wasm');
});

test('what is not the module is refused', async () => {
    for (const source of [null, 7, {}, [1, 2], true]) await rejects('BAD_CALL', source);
    await rejects('MALFORMED', new Uint8Array(0));
    await rejects('MALFORMED', bytes.subarray(0, 5000));
    await rejects('MALFORMED', new Response('<html>'));
    const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
    await rejects('UNSUPPORTED', empty, /not Firma's module/);
    // One that asks for an import that is not given.
    const asks = [...empty, 1, 4, 1, 0x60, 0, 0, 2, 7, 1, 1, 0x61, 1, 0x62, 0, 0];
    await rejects('UNSUPPORTED', new Uint8Array(asks), /not Firma's module/);
});

test('the modules ask their host for the time and for visitors alone', async () => {
    const importsOf = async (url) => WebAssembly.Module.imports(await WebAssembly.compile(await readFile(url)));
    const now = { module: 'firma', name: 'now', kind: 'function' };
    const visit = { module: 'firma', name: 'visit', kind: 'function' };
    for (const url of [wasmUrl, gamesUrl, recordingsUrl]) assert.deepEqual(await importsOf(url), [now, visit]);
    for (const one of await importsOf(readersUrl)) assert.deepEqual(one, now);
});

test('the modules are small', async () => {
    for (const [name, url, bound] of [
        ['firma.wasm', wasmUrl, 450_000],
        ['firma_games.wasm', gamesUrl, 550_000],
        ['firma_recordings.wasm', recordingsUrl, 660_000],
        ['firma_readers.wasm', readersUrl, 240_000],
    ]) {
        const module = await readFile(url);
        const size = gzipSync(module, { level: 9 }).length;
        console.log(`${name}: ${module.length} bytes, ${size} by gzip -9`);
        assert.ok(size < bound, `${name}: ${size} bytes by gzip -9`);
    }
});
