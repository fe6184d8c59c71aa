// SPDX-License-Identifier: MIT
// The built playground in Debian's Chromium, served by `firma serve`: what the tests beside it share.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const kRoot = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const kFolder = process.env.FIRMA_PLAYGROUND ?? path.join(kRoot, 'build/playground');
export const kFirma = process.env.FIRMA ?? path.join(kRoot, 'build/release/bin/firma');
const kChromium = process.env.FIRMA_CHROMIUM ?? '/usr/bin/chromium';
const kShots = path.join(kRoot, 'build/playground_shots');
const kTimeout = 120_000; // milliseconds: graphics in software on a busy machine are slow, and no test is about that

/** Starts `firma serve` on a free port. */
function serve() {
    const server = spawn(kFirma, ['serve', kFolder, '--port', '0', '--json'], { stdio: ['ignore', 'pipe', 'inherit'] });
    return new Promise((resolve, reject) => {
        let text = '';
        server.on('error', reject);
        server.on('exit', (code) => reject(new Error(`firma serve ended with ${code}`)));
        server.stdout.on('data', (part) => {
            text += part;
            try {
                resolve({ server, url: JSON.parse(text).url });
            } catch {
                // not whole yet
            }
        });
    });
}

/** A server, a browser and a page size for the tests of a file. Call close() at the end. */
export async function open() {
    if (!existsSync(path.join(kFolder, 'playground.js'))) throw new Error(`${kFolder} is not built: node playground/build.mjs`);
    mkdirSync(kShots, { recursive: true });
    const { server, url } = await serve();
    const browser = await chromium.launch({
        executablePath: kChromium,
        args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    });
    return {
        url,
        browser,
        /** Ends both; the server's exit code. */
        async close() {
            await browser.close();
            const code = new Promise((resolve) => server.once('exit', resolve));
            server.kill('SIGINT');
            return code;
        },
    };
}

/** A page of the playground, loaded, its time stopped. @param device  of a phone: hasTouch, isMobile, ... */
export async function load(session, query = '', viewport = { width: 1120, height: 630 }, device = {}) {
    const page = await session.browser.newPage({ viewport, ...device });
    page.setDefaultTimeout(kTimeout);
    const errors = [];
    page.on('pageerror', (error) => errors.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
    await page.goto(`${session.url}/${query}`, { timeout: kTimeout });
    await page.waitForFunction(() => window.firmaPlayground?.done || window.firmaPlayground?.error);
    const error = await page.evaluate(() => window.firmaPlayground.error);
    if (error === null) await page.evaluate(() => window.firmaPlayground.pause());
    return { page, errors, error };
}

/** Calls a hook of the page: see src/main.js. */
export const call = (page, name, ...values) => page.evaluate(([n, v]) => window.firmaPlayground[n](...v), [name, values]);

/** Draws, `dt` seconds after the last time, and keeps a picture. */
export async function shoot(page, name, dt = 10, folder = kShots) {
    await page.evaluate(async (seconds) => {
        window.firmaPlayground.draw(seconds);
        await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    }, dt);
    const file = path.join(folder, `${name}.png`);
    await page.screenshot({ path: file, timeout: kTimeout });
    return file;
}
