// SPDX-License-Identifier: MIT
// The programs that pages show print what the pages say.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** What a program prints, in a folder with the package and the levels. */
function run(program) {
    const folder = mkdtempSync(join(tmpdir(), 'firma-'));
    try {
        mkdirSync(join(folder, 'node_modules'));
        symlinkSync(join(root, 'bindings/js'), join(folder, 'node_modules/firma'));
        cpSync(join(root, 'levels'), join(folder, 'levels'), { recursive: true });
        writeFileSync(join(folder, 'shown.mjs'), program);
        const result = spawnSync(process.execPath, ['shown.mjs'], { cwd: folder, encoding: 'utf8' });
        assert.equal(result.status, 0, result.stderr);
        return result.stdout;
    } finally {
        rmSync(folder, { recursive: true });
    }
}

const read = (page) => readFileSync(join(root, page), 'utf8');
/** The programs of a page that import the package, each with what follows it. */
const programsOf = (page) =>
    [...read(page).matchAll(/```js\n(import [^]*?)```\n(?:\nprints\n\n```\n([^]*?)```)?/g)].map((m) => ({ program: m[1], output: m[2] }));
/** Lines of a page that are shown as those of its C++ program. */
const shownIn = (page, first) => {
    const lines = new RegExp(`\n((?:    .*\n)*    ${first}.*\n(?:    .*\n)*)`).exec(read(page))[1];
    return lines.replace(/^ {4}/gm, '');
};

test('programs with what they print beside them', () => {
    for (const [page, count] of [
        ['bindings/js/README.md', 2],
        ['docs/moving.md', 1],
        ['docs/projectiles.md', 2],
        ['docs/support.md', 1],
    ]) {
        const all = programsOf(page).filter(({ output }) => output !== undefined);
        assert.equal(all.length, count, page);
        for (const { program, output } of all) assert.equal(run(program), output, page);
    }
});

test('bodies, players, debris and convex pieces as in C++', () => {
    const [{ program: bodies }] = programsOf('docs/bodies.md');
    const native = shownIn('docs/bodies.md', '70638 kg').replace(' as 40 spheres', '').replace('yes', 'true');
    assert.equal(run(bodies), native);
    const [{ program: players }] = programsOf('docs/players.md');
    assert.equal(run(players), shownIn('docs/players.md', 'at 30.00 22.00'));
    const [{ program: debris }] = programsOf('docs/debris.md');
    assert.equal(run(debris), shownIn('docs/debris.md', 'a blast in the open'));
    const [{ program: convex }] = programsOf('docs/convex.md');
    assert.equal(run(convex), shownIn('docs/convex.md', '29.433 m3 came loose'));
});
