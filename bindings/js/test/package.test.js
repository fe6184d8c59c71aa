// SPDX-License-Identifier: MIT
// What belongs to the package beside the code: types, layouts of structs, its files, the program in the README.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, symlinkSync, mkdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import * as gamesPackage from '../src/games.js';
import * as firmaPackage from '../src/index.js';
import * as readersPackage from '../src/readers.js';
import * as recordingsPackage from '../src/recordings.js';
import { games, makeRoom } from './game_helpers.js';
import { recordings } from './recording_helpers.js';
import { firma, readers } from './helpers.js';

const root = fileURLToPath(new URL('..', import.meta.url));
const run = (command, ...args) => spawnSync(command, args, { cwd: root, encoding: 'utf8' });

/** What users of the package see of it: a folder with node_modules/firma. */
function asUser(work) {
    const folder = mkdtempSync(join(tmpdir(), 'firma-'));
    try {
        mkdirSync(join(folder, 'node_modules'));
        symlinkSync(root, join(folder, 'node_modules/firma'));
        work(folder);
    } finally {
        rmSync(folder, { recursive: true });
    }
}

test('structs are laid out as clang has them', () => {
    const result = run(process.execPath, 'tools/make_layout.js', '--check');
    assert.equal(result.status, 0, result.stderr);
});

test('types fit a program that uses every function', () => {
    const common = { noEmit: true, strict: true, noUncheckedIndexedAccess: true, target: 'es2022', types: [] };
    for (const [module, moduleResolution] of [
        ['nodenext', 'nodenext'],
        ['esnext', 'bundler'],
    ]) {
        asUser((folder) => {
            writeFileSync(
                join(folder, 'tsconfig.json'),
                JSON.stringify({ compilerOptions: { ...common, module, moduleResolution } }),
            );
            writeFileSync(join(folder, 'types.mts'), readFileSync(join(root, 'test/types.ts')));
            const result = run(process.execPath, 'node_modules/typescript/bin/tsc', '--pretty', 'false', '-p', folder);
            assert.equal(result.status, 0, result.stdout + result.stderr);
        });
    }
});

test('types name what there is, and nothing else', () => {
    const typesOf = (file) => readFileSync(join(root, file), 'utf8');
    for (const [file, entry] of [
        ['index.d.ts', firmaPackage],
        ['readers.d.ts', readersPackage],
        ['games.d.ts', gamesPackage],
        ['recordings.d.ts', recordingsPackage],
    ]) {
        const declared = [...typesOf(file).matchAll(/^export (?:const|class|function) (\w+)/gm)].map((m) => m[1]);
        for (const [, names] of typesOf(file).matchAll(/^export {([^}]*)} from/gm)) declared.push(...names.match(/\w+/g));
        assert.deepEqual(declared.sort(), Object.keys(entry).sort());
    }
    const types = ['index.d.ts', 'readers.d.ts', 'games.d.ts', 'recordings.d.ts'].map(typesOf).join('');
    const world = firma.worldFromMesh({ positions: [0, 0, 0, 4, 0, 0, 0, 4, 0], corners: [0, 1, 2] });
    const cutter = firma.crater('box', 1);
    const objects = {
        Firma: firma,
        Readers: readers,
        World: world,
        Cutter: cutter,
        Edit: world.edit(),
        Store: firma.openStore(world, 1),
        Chunks: world.pieces(),
        Command: firma.doorCommand(1, 0, true),
        EditLog: firma.beginLog(world),
        Games: games,
        Bodies: games.bodies(),
        Parts: games.parts(),
        Recordings: recordings,
        Debris: recordings.debris(),
    };
    const level = makeRoom(recordings);
    objects.Game = recordings.game(level);
    objects.Game.record();
    objects.Recording = objects.Game.recording();
    objects.Supports = recordings.findSupports(level, []);
    level.release();
    objects.Replay = objects.EditLog.replay(world);
    objects.Job = world.startCarve(cutter, { position: [0, 0, 0] });
    for (const [name, object] of Object.entries(objects)) {
        const body = new RegExp(`^export interface ${name} [^{]*{(}|[^]*?^})`, 'm').exec(types)[0];
        const members = [...body.matchAll(/^ {4}(?:readonly )?(\w+)[(:]/gm)].map((m) => m[1]);
        const actual = Object.getOwnPropertyNames(Object.getPrototypeOf(object)).filter((one) => one !== 'constructor');
        assert.deepEqual(members.sort(), actual.sort(), name);
        object.release?.();
    }
});

test('the package has its files, and the lock names no host', () => {
    const result = spawnSync('npm', ['pack', '--dry-run', '--json'], { cwd: root, encoding: 'utf8' });
    const files = JSON.parse(result.stdout)[0].files.map((file) => file.path);
    const code = ['index', 'readers', 'games', 'recordings', 'layout'].map((name) => `src/${name}.js`);
    for (const name of ['src/firma.wasm', 'src/firma_games.wasm', 'src/firma_recordings.wasm', 'src/firma_readers.wasm', ...code, 'index.d.ts', 'readers.d.ts', 'games.d.ts', 'recordings.d.ts', 'README.md', 'LICENSE', 'package.json'])
        assert.ok(files.includes(name), `${name} is not in the package`);
    assert.ok(
        files.every((name) => !/^(test|tools|node_modules)\//.test(name)),
        files.join(' '),
    );
    const lock = readFileSync(join(root, 'package-lock.json'), 'utf8');
    assert.doesNotMatch(lock, /"resolved"/);
    assert.doesNotMatch(lock, /https?:\/\/(?!github\.com)[^"]*\.tgz/);
    assert.equal(Object.keys(JSON.parse(readFileSync(join(root, 'package.json'))).dependencies ?? {}).length, 0);
});

test('the program in the README prints what the README says', () => {
    const readme = readFileSync(join(root, 'README.md'), 'utf8');
    const [, program, output] = /```js\n([^]*?)```\s+prints\s+```\n([^]*?)```/.exec(readme);
    asUser((folder) => {
        writeFileSync(join(folder, 'hello.mjs'), program);
        const result = spawnSync(process.execPath, ['hello.mjs'], { cwd: folder, encoding: 'utf8' });
        assert.equal(result.stdout, output, result.stderr);
    });
});
