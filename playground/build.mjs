// SPDX-License-Identifier: MIT
// Bundles the playground into build/playground: index.html, one script, the modules, the levels. Runs on nodejs 18 and 20.
//
//     node build.mjs [FOLDER]        after `cmake --build --preset wasm`, which makes the modules
import { cpSync, existsSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.dirname(here);
const target = path.resolve(process.argv[2] ?? path.join(root, 'build/playground'));
const wasm = process.env.FIRMA_WASM ?? path.join(root, 'build/wasm/bin/firma_recordings.wasm');
const readers = path.join(path.dirname(wasm), 'firma_readers.wasm');
for (const one of [wasm, readers])
    if (!existsSync(one)) {
        console.error(`firma: ${one} is not there; cmake --preset wasm && cmake --build --preset wasm`);
        process.exit(1);
    }

mkdirSync(target, { recursive: true });
await build({
    entryPoints: [path.join(here, 'src/main.js')],
    outfile: path.join(target, 'playground.js'),
    bundle: true,
    format: 'esm',
    target: 'es2022',
    minify: true,
    legalComments: 'inline', // three's licence
    alias: { 'firma/recordings': process.env.FIRMA_JS ?? path.join(root, 'bindings/js/src/recordings.js') },
    logLevel: 'warning',
});
for (const file of ['index.html', 'playground.css']) cpSync(path.join(here, file), path.join(target, file));
cpSync(wasm, path.join(target, 'firma_recordings.wasm'));
cpSync(readers, path.join(target, 'firma_readers.wasm'));
for (const level of ['depot.map', 'first.obj']) cpSync(path.join(root, 'levels', level), path.join(target, level));
console.log(`firma: playground in ${path.relative(process.cwd(), target) || '.'}`);
