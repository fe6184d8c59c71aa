// SPDX-License-Identifier: MIT
// The program of docs/guide.md in JavaScript: loads a level, walks through it, shoots, carves, undoes, saves.
import { readFile, writeFile } from 'node:fs/promises';
import { loadFirma, STOPS_SHOTS, STOPS_WALK } from 'firma';

const plus = (a, b, s = 1) => a.map((x, k) => x + b[k] * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const print = (point) => `(${point.map((x) => x.toFixed(3)).join(', ')})`;

// Where the first entity stands that has this value under this key.
function place(level, key, value) {
  const entity = level.entities().find((one) => one.origin && one.values.get(key) === value);
  if (!entity) throw new Error(`no place with ${key} ${value}`);
  return entity.origin;
}

// One step of 1/60 s toward a place, at 4 m/s, and down. Returns false once the ball is there.
function walk(world, ball, to) {
  const way = [to[0] - ball.centre[0], to[1] - ball.centre[1], 0];
  const length = Math.sqrt(dot(way, way));
  if (length < 0.1) return false;
  ball.fall -= 9.81 / 60;
  let path = plus([0, 0, ball.fall / 60], way, 4 / 60 / length);
  for (let k = 0; k < 4; ++k) { // along four surfaces at most
    const hit = world.cast({ centre: ball.centre, radius: ball.radius, path }, { mask: STOPS_WALK });
    ball.centre = plus(ball.centre, path, hit.safeFraction);
    if (!hit.hit) break;
    if (hit.normal[2] > 0.7) ball.fall = 0; // it stands on something
    path = path.map((x) => x * (1 - hit.safeFraction));
    path = plus(path, hit.normal, -dot(path, hit.normal)); // what is left of it, along the surface
  }
  return true;
}

function shoot(who, world, shot) {
  const hit = world.cast(shot, { mask: STOPS_SHOTS });
  if (hit.hit) {
    const material = world.material(hit.material);
    console.log(`${who} meets ${material} of ${world.room(world.hitInfo(hit).room).name} at ${print(hit.point)}`);
  } else {
    console.log(`${who} meets nothing`);
  }
  return hit;
}

const firma = await loadFirma();
const level = await firma.levelFromMap(await readFile('levels/depot.map'), { name: 'levels/depot.map' });
const world = level.world();
const facts = world.facts();
console.log(`${facts.faceCount} faces, ${facts.roomCount} rooms, ${facts.portalCount} portals`);

const ball = { centre: place(level, 'classname', 'info_player_start'), radius: 0.5, fall: 0 };
let room = world.locate(ball.centre).room;
console.log(`the player starts in ${world.room(room).name} at ${print(ball.centre)}`);

const goal = place(level, 'name', 'office_west');
const portals = world.path(room, world.locate(goal).room);
if (!portals) throw new Error('no way to office_west');
const middle = ({ low, high }) => plus(low, high).map((x) => x * 0.5);
const stops = [...portals.map((portal) => middle(world.portal(portal))), goal];

let steps = 0;
for (const stop of stops)
  for (; walk(world, ball, stop); ++steps) {
    const here = world.locate(ball.centre);
    if (here.where !== 'air' || steps === 600) throw new Error('stuck, or in a wall');
    if (here.room === room) continue;
    const door = world.portal(world.path(room, here.room)[0]);
    console.log(`step ${steps}: through ${door.name} into ${world.room(here.room).name}`);
    room = here.room;
  }
console.log(`step ${steps}: there, at ${print(ball.centre)}`);

const shot = { centre: plus(ball.centre, [0, 0, 0.6]), radius: 0, path: [20, 0.5, 0] };
const hit = shoot('the shot', world, shot);
console.log(`face ${hit.face}, side ${world.hitInfo(hit).source} of the map`);

const crater = firma.crater('rocky', 7);
const { world: after, report } = world.carve(crater, { position: hit.point, scale: 0.5 }, { material: 'rubble' });
if (report.status !== 'done') throw new Error(`nothing carved: ${report.reason}`);

const diff = world.diff(after);
console.log(`carved ${report.volume.toFixed(3)} m3: ${diff.removed.length} faces removed, ${diff.added.ids.length} added`);
for (const changed of diff.rooms)
  console.log(`draw ${after.room(changed).name} anew: ${after.triangles({ room: changed }).faces.length} triangles`);
for (const hole of diff.portalsAdded) {
  const [from, to] = after.portal(hole).rooms;
  console.log(`a hole leads from ${after.room(from).name} to ${after.room(to).name}`);
}

shoot('the same shot', after, shot);
shoot('without the crater it', world, shot); // undo

await writeFile('build/guide.firma', after.pack());
const loaded = firma.unpackWorld(await readFile('build/guide.firma'), 'build/guide.firma');
const hash = loaded.hash();
console.log(`saved, loaded: hash ${hash.toString(16).padStart(16, '0')}, ${hash === after.hash() ? 'the same' : 'another one'}`);

for (const object of [loaded, after, crater, world, level]) object.release();
