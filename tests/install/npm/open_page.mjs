// SPDX-License-Identifier: MIT
// open_page.mjs FOLDER PAGE: serves the folder, opens the page in Chromium, prints the title that it gets. A failure is
// also whatever the page could not load.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { chromium } from 'playwright-core';

const [folder, name] = process.argv.slice(2);
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm', '.obj': 'text/plain' };

const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, 'http://page').pathname);
    try {
        const bytes = await readFile(join(folder, path));
        response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
        response.writeHead(404).end();
    }
});
await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage();
const problems = [];
page.on('pageerror', (error) => problems.push(error.message));
page.on('response', (response) => response.ok() || /favicon/.test(response.url()) || problems.push(response.url()));
await page.goto(`http://127.0.0.1:${server.address().port}/${name}`);
await page.waitForFunction(() => document.title !== 'waiting', null, { timeout: 60_000 }).catch((error) => problems.push(error.message));
const title = await page.title();
await browser.close();
server.close();
console.log(title);
for (const problem of problems) console.error(problem);
process.exitCode = problems.length === 0 ? 0 : 1;
