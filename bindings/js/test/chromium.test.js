// SPDX-License-Identifier: MIT
// The same cuts and casts in Chromium and in node, bit for bit.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { chromium } from 'playwright-core';
import { firma, levelBytes } from './helpers.js';
import { scenario } from './scenario.js';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const types = { js: 'text/javascript', wasm: 'application/wasm', obj: 'text/plain' };
/** All that the page may ask for. */
const served = /^\/(bindings\/js\/(src|test)\/\w+\.(js|wasm)|levels\/\w+\.obj)$/;

async function serve() {
    const server = createServer(async (request, response) => {
        const path = request.url === '/' ? '' : request.url;
        if (path === '')
            return response.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html><title>firma</title>');
        if (!served.test(path)) return response.writeHead(404).end();
        response.writeHead(200, { 'content-type': types[path.split('.').pop()] }).end(await readFile(root + path));
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return server;
}

test('Chromium gives the bits that node gives', { timeout: 120_000 }, async () => {
    const server = await serve();
    const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
    try {
        const page = await browser.newPage();
        const problems = [];
        page.on('pageerror', (error) => problems.push(error.message));
        page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
        await page.goto(`http://127.0.0.1:${server.address().port}/`);
        await page.evaluate(() => fetch('/favicon.ico')); // asked for anyway: its 404 is no problem of ours
        problems.length = 0;
        const inPage = await page.evaluate(async () => {
            const { FirmaError, loadFirma } = await import('/bindings/js/src/index.js');
            const { scenario } = await import('/bindings/js/test/scenario.js');
            const firma = await loadFirma();
            const level = await (await fetch('/levels/first.obj')).text();
            const start = performance.now();
            const result = await scenario(firma, level, 100, 1000);
            const codes = [];
            for (const source of ['/missing.wasm', '/levels/first.obj', 7])
                await loadFirma(source).catch((error) => codes.push(error instanceof FirmaError && error.code));
            return { result, codes, ms: performance.now() - start };
        });
        const start = performance.now();
        const inNode = await scenario(firma, levelBytes, 100, 1000);
        const ms = (performance.now() - start).toFixed();
        console.log(`100 cuts, 1000 casts: ${inPage.ms.toFixed()} ms in Chromium, ${ms} ms in node`);
        assert.deepEqual(inPage.result, inNode);
        assert.equal(inNode.left, 0);
        assert.ok(inNode.done > 90 && inNode.hitCount > 100, JSON.stringify(inNode));
        assert.deepEqual(inPage.codes, ['CANNOT_READ', 'MALFORMED', 'BAD_CALL']);
        assert.deepEqual(
            problems.filter((text) => !/404/.test(text)),
            [],
        );
    } finally {
        await browser.close();
        server.close();
    }
});
