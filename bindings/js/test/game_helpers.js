// SPDX-License-Identifier: MIT
// What the tests of games share: the module, worlds to move in.
import assert from 'node:assert/strict';
import { after } from 'node:test';
import { loadGames } from '../src/games.js';
import { boxMesh, releasing } from './helpers.js';

export const gamesUrl = new URL('../src/firma_games.wasm', import.meta.url);
export const TICK = 1 / 64;

/** One instance for a test file; at its end nothing may be left in it. */
export const games = await loadGames();
after(() => assert.equal(games.liveHandles(), 0, 'handles were left'));

/** A room of air in rock, 8 m on each side from the origin on, its floor at 0. */
export const makeRoom = (of = games) => of.worldFromMesh(boxMesh());

/** A solid box around the origin: its faces look outward. */
export function makeSlab(x, y, z, of = games) {
    const mesh = boxMesh([-x, -y, -z], [x, y, z]);
    return of.worldFromMesh({ ...mesh, corners: mesh.corners.reverse() });
}

/** A ball of this radius as a shape of bodies. */
export const makeBall = (radius = 0.5, of = games) =>
    of.bodyShape([0, 0, 0, radius], of.massOfBall(radius, 1000));

/** Runs work(room), and releases it. */
export const inRoom = (work) => releasing([makeRoom()], work);

export const near = (actual, expected, error) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);
