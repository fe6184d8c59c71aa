// SPDX-License-Identifier: MIT
// The program of docs/hello.md in JavaScript: reads a level, moves a sphere through it, says what it met.
import { readFile } from 'node:fs/promises';
import { loadFirma } from 'firma';

const firma = await loadFirma();
const world = await firma.worldFromObj(await readFile('levels/first.obj'), { name: 'first.obj' });

const ball = { centre: [35, 29, 2], radius: 0.5, path: [0, 0, 10] };
const hit = world.cast(ball);
if (hit.status === 'miss') {
  console.log('nothing in the way');
} else {
  const stop = ball.centre[2] + ball.path[2] * hit.safeFraction;
  const material = world.material(hit.material);
  console.log(`met ${material} after ${hit.fraction.toFixed(3)} of the path; stops at z = ${stop.toFixed(3)}`);
}
world.release();
