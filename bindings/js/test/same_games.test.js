// SPDX-License-Identifier: MIT
// The run of tests/full/same_games.c: bodies, players, parts and projectiles, whose native hashes the module must have too.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { runGames } from '../../../tests/full/same_games.mjs';
import { gamesUrl } from './game_helpers.js';
import { levelBytes } from './helpers.js';

test('600 steps of bodies, players and projectiles end as natively', async () => {
    const lines = [];
    await runGames(gamesUrl, levelBytes, 600, (line) => lines.push(line));
    assert.equal(lines.length, 6);
    // What `same_games levels/first.obj 600` prints last, of any compiler.
    assert.equal(lines.at(-1), 'steps=600 awake=21 bodies=f15e22d577be9ab8 games=e9c9b0561edf579e');
});
