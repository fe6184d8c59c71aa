// SPDX-License-Identifier: MIT
// Runs a script in Chromium, from a server of its own on this machine; the page sends back what the script would print.
import { spawn } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const TYPES = { js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm', obj: 'text/plain' };
const LONGEST = 900_000; // milliseconds

const pageOf = (script) => `<!doctype html><meta charset="utf-8"><title>Firma</title>
<script type="module">
const lines = [];
let ok = false;
const print = (line) => lines.push(line);
const bytesOf = async (path) => new Uint8Array(await (await fetch(path)).arrayBuffer());
try {
    ${script}
    ok = true;
} catch (error) {
    lines.push(String(error.stack ?? error));
}
await fetch('/done', { method: 'POST', body: JSON.stringify({ ok, lines }) });
</script>`;

async function bodyOf(request) {
    const parts = [];
    for await (const part of request) parts.push(part);
    return Buffer.concat(parts).toString();
}

/** Serves the page and the repository's files; `done` is called with what the page sends. */
function serve(html, done) {
    return createServer(async (request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        try {
            if (path === '/') return response.setHeader('content-type', 'text/html').end(html);
            if (path === '/done') return done(JSON.parse(await bodyOf(request))), response.end();
            const bytes = await readFile(join(ROOT, path));
            response.setHeader('content-type', TYPES[path.split('.').pop()] ?? 'application/octet-stream');
            response.end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    });
}

/**
 * Prints the script's lines, and ends this process: with 1 where it threw.
 *
 * @param {string} script  of a module, with print(line) and bytesOf(path); paths are below the repository, from `/`
 */
export async function runInChromium(script) {
    const profile = await mkdtemp(join(tmpdir(), 'firma-chromium-'));
    let browser;
    const result = await new Promise((done) => {
        const server = serve(pageOf(script), done).listen(0, '127.0.0.1', () => {
            const options = ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run'];
            const url = `http://127.0.0.1:${server.address().port}/`;
            browser = spawn(process.env.CHROMIUM ?? 'chromium', [...options, `--user-data-dir=${profile}`, url], { stdio: 'ignore' });
            browser.on('error', (error) => done({ ok: false, lines: [String(error)] }));
            browser.on('exit', (code) => done({ ok: false, lines: [`chromium ended with ${code}`] }));
            setTimeout(() => done({ ok: false, lines: ['chromium took too long'] }), LONGEST);
        });
    });
    browser.removeAllListeners('exit');
    const ended = new Promise((done) => browser.on('exit', done));
    if (browser.exitCode === null && browser.pid) browser.kill(), await ended;
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
    result.lines.forEach((line) => (result.ok ? console.log : console.error)(line));
    process.exit(result.ok ? 0 : 1);
}
