// SPDX-License-Identifier: MIT
// Every function of the package as TypeScript sees it: compiled by types.test.js, never run.
import {
    FACE_SOLID,
    FACE_TWO_SIDED,
    FirmaError,
    HitBatch,
    loadFirma,
    NO_FACE,
    NO_PORTAL,
    STOPS_SIGHT,
    STOPS_WALK,
    type CarveReport,
    type CastCounts,
    type Chunk,
    type Chunks,
    type Command,
    type CommandFacts,
    type Cutter,
    type Diff,
    type EditLog,
    type Entity,
    type Face,
    type FaceInfos,
    type Faces,
    type Hit,
    type HitInfo,
    type Hull,
    type Level,
    type LevelPart,
    type LevelParts,
    type Location,
    type LogFacts,
    type Mass,
    type MatterCounts,
    type MatterTable,
    type MatterVolume,
    type Mesh,
    type Near,
    type Overlap,
    type Portal,
    type RegionMesh,
    type Replay,
    type ReplayFacts,
    type Rest,
    type RegionParts,
    type RegionRun,
    type Room,
    type StoreFacts,
    type TriangleRun,
    type Texture,
    type TextureUnit,
    type Triangles,
    type WholeMatterTable,
    type World,
    type WorldFacts,
} from 'firma';
import { loadReaders, type Readers } from 'firma/readers';
import {
    loadGames,
    Projectiles,
    type Bodies,
    type Body,
    type BodyContact,
    type BodyId,
    type BodyShape,
    type Firma,
    type FlyReport,
    type Games,
    type Parts,
    type Player,
    type PlayerMove,
    type PlayerShape,
    type Projectile,
    type Scene,
    type SceneHit,
    type SceneOverlap,
    type ShotEvent,
    type StepReport,
} from 'firma/games';
import {
    loadRecordings,
    type BodyHit,
    type BodyIndex,
    type Breakable,
    type ConvexPiece,
    type Debris,
    type DebrisPiece,
    type Explosion,
    type FracturePattern,
    type Game,
    type GameBlast,
    type GameEvent,
    type GameReport,
    type PierceSpan,
    type Recording,
    type Recordings,
    type ReplayState,
    type SceneNear,
    type SceneShotEvent,
    type SetHit,
    type SetPairHit,
    type Shattered,
    type Support,
    type SupportChange,
    type Supports,
    type Weapon,
} from 'firma/recordings';

const firma = await loadFirma();
await loadFirma('firma.wasm');
await loadFirma(new URL('http://localhost/firma.wasm'));
await loadFirma(fetch('firma.wasm'));
await loadFirma(new Uint8Array(8));
await loadFirma(await WebAssembly.compile(new ArrayBuffer(8)));

const version: string = firma.version;
const live: number = firma.liveHandles();

const world: World = await firma.worldFromObj('v 0 0 0', {
    name: 'a',
    contactOffset: 0.001,
    scale: 1,
    surfaceArea: true,
    maxDepth: 9,
    facesPerLeaf: 4,
    minNodeVolume: 1,
});
await firma.worldFromObj(new Uint8Array(1));
await firma.worldFromBsp(new ArrayBuffer(1), {});
(await firma.worldFromMap('{}', { scale: 1 })).release();
const readers: Readers = await loadReaders(firma);
const same: [World, World, World] = [
    readers.worldFromObj('', { name: 'a' }),
    readers.worldFromBsp(new ArrayBuffer(1)),
    readers.worldFromMap('{}', { scale: 1 }),
];
const levels: Level[] = [readers.levelFromMap('{}', { scale: 1 }), readers.levelFromBsp(new ArrayBuffer(1))];
const ofObj: Cutter = readers.cutterFromObj('', readers.version);
// @ts-expect-error no promise comes from a Firma's own
firma.worldFromObj('').release();
// @ts-expect-error meshes are read by the Firma
readers.worldFromMesh;
// @ts-expect-error not a Firma
await loadReaders(world);
await loadFirma(undefined, { readers: fetch('firma_readers.wasm') });
await loadFirma('firma.wasm', { readers: new URL('http://localhost/firma_readers.wasm') });
// @ts-expect-error an option that is none
await loadFirma('firma.wasm', { reader: 'readers.wasm' });
const mesh: Mesh = {
    positions: [0, 0, 0],
    corners: Uint32Array.of(0, 1, 2),
    cornerCounts: [3],
    materials: [0],
    materialNames: ['rock'],
    masks: [1],
    twoSided: [false],
};
firma.worldFromMesh(mesh, { contactOffset: 1 });
firma.unpackWorld(world.pack({ exact: true }), 'name');
// @ts-expect-error text is no .bsp
firma.worldFromBsp('text');
// @ts-expect-error an option that is none
firma.worldFromObj('', { skn: 1 });

const hull: Hull = firma.hullFromPoints([0, 0, 1, 1, 1, -1, -1, 1, -1, 0, -1, -1]);
const crate: Hull = firma.hullBox([1, 1, 1], [1, 0, 0, 0, 1, 0, 0, 0, 1]);
const hullCorners: Float64Array = hull.corners();
const pill = { from: [0, 0, 0], to: [0, 0, 1], radius: 0.3 };
const resting: Hit = world.cast({ hull: crate, at: [0, 0, 0], path: [0, 0, -1] }, { room: 0 });
const points: [number, number, number][] = world.contactPoints(crate, resting);
const grazes: boolean = world.castAny({ ...pill, path: [1, 0, 0] });
const stuck: Overlap[] = world.overlapShape({ hull, at: [0, 0, 0] }, { mask: 1 });
const inside: boolean = world.overlapShapeEach(pill, (found) => found.depth < 1);
const columns = { x: [0], y: [0], z: new Float32Array(1), pathX: [1], pathY: [0], pathZ: [0] };
const manyHits: HitBatch = world.castMany({ ...columns, hulls: [hull], hullOf: [0] }, { counts: {} });
const statuses: Uint8Array = world.castManyAny(columns, { progress: (done, count) => done < count });
// @ts-expect-error a path is missing
world.cast(pill);
// @ts-expect-error no such option
world.castMany(columns, { order: 'random' });

const level: Level = await firma.levelFromMap('{}', { name: 'a', scale: 1 });
const entity: Entity | undefined = level.entities()[0];
const spawn: number = (entity?.origin?.[0] ?? 0) + level.metresPerUnit + level.notes().length;
level.world({ contactOffset: 0.1 }).release();

const facts: WorldFacts = world.facts();
const [x, y, z]: [number, number, number] = facts.low;
const names: string[] = facts.materials;
const hash: bigint = world.hash();
world.check();
const volume: number = world.measure().volume + world.measure().area;
const memory: number = world.memory() + firma.memory([world, world.copy()]);
const faces: Faces = world.faces();
const flags: number = faces.flags[0]! & (FACE_SOLID | FACE_TWO_SIDED);
const face: Face = world.findFace(0) ?? world.face({ id: 0, corner: [0, 0, 0] });
const some: Faces = world.faces({ box: { low: [0, 0, 0], high: [1, 1, 1] } });
const regions: number = world.hashRegions()[0]!.region[0] + Number(world.hashSolid()) + some.firstPoints[0]!;
const triangles: Triangles = world.triangles({ room: 0, origin: [1, 2, 3], mask: 1, solidOnly: true });
const run: TriangleRun | undefined = triangles.runs[0];
const units: TextureUnit[] = world.triangles({ uvs: true, textureSizes: [64, 64] }).sources.map((source) => source.uvUnit);
const lies: Texture = world.texture(face);
world.texture(world.closest([1, 2, 3]) ?? 0);
world.texture({ id: 0, corner: new Int32Array(3) });
const laid: number = lies.uAxis[0] + lies.uOffset + triangles.uvs[0]! + units.length;
const origin: number = triangles.positions[0]! + triangles.sources[0]!.face + (run?.material ?? 0);

const meshes: RegionMesh[] = world.regionMeshes({ size: 16, mask: ~8, solidOnly: true, textureSizes: [64, 64] });
const newer: RegionMesh[] = world.changedRegionMeshes(world.copy(), { textures: false });
const drawn: RegionRun | undefined = meshes[0]?.runs[0];
const partsDrawn: RegionParts = newer[0]!.parts;
world.face({ id: partsDrawn.faces[0]!, corner: partsDrawn.faceCorners.subarray(0, 3) });
const laidOut: number = meshes[0]!.tangents[3]! + meshes[0]!.blends[3]! + meshes[0]!.place[0] + (drawn?.cut ? 1 : 0);

const input = { centre: [1, 2, 3], radius: 0.4, path: Float64Array.of(1, 2, 3) };
const counts: CastCounts = { nodes: 0, boxes: 0, faces: 0, precise: 0 };
const hit: Hit = world.cast(input, { mask: 1, bothSides: true, contactOffset: 0.1, counts });
if (hit.status === 'hit' && hit.face !== null) world.findFace(hit.face);
// @ts-expect-error a name that no status has
if (hit.status === 'nothing') throw new Error();
const any: boolean = world.castAny(input);
const all: Hit[] = world.castAll(input, { mask: 1 });
const met: boolean = world.castEach(input, (h) => (h.material === STOPS_WALK ? 1 : h.fraction), { mask: STOPS_SIGHT });
const whole: boolean = world.eachFace({ room: 0 }, (f) => f.corners.length < 12);
const every: boolean = world.eachFace(undefined, (f) => console.log(f.id)) || whole;
const touched: boolean = world.overlapEach([1, 2, 3], 1, (o) => o.depth < 1) || met;
const again: Face = world.face(hit);
const batch: HitBatch = world.castBatch(new Float64Array(7), { counts: {} }, new HitBatch());
const one: Hit | null = batch.hit(0);
const where: number = batch.point[0]! + batch.status[0]! + batch.count;
const none: boolean = batch.face[0] === NO_FACE;
const near: Overlap[] = world.overlap([1, 2, 3], 1, { mask: 1, room: 0 });
const deep: number = near[0]!.depth + near[0]!.direction[0];
const closest: Near | null = world.closest([1, 2, 3], 5, { mask: 1 });
const info: HitInfo = world.hitInfo(hit);
const across: number | null = info.otherFace;

const place: Location = world.locate([1, 2, 3]);
const passed: number[] = [];
if (place.room !== null) world.cast(input, { room: place.room, passed }).hit.valueOf();
world.castAny(input, { room: 'locate' });
// @ts-expect-error no such word
world.castAny(input, { room: 'here' });
const room: Room = world.room(0);
const portal: Portal = world.portal(room.portals[0] ?? NO_PORTAL);
const rim: Float64Array | undefined = portal.polygons[0];
const door: World = world.setPortalOpen(0, false);
const path: number[] | null = door.path(0, portal.rooms[1], { allOpen: true });
const beside: number[] = world.neighbours(0);

const cutter = firma.crater('rocky', 5n);
firma.cutterFromMesh([0, 0, 0], [0, 1, 2], 'name');
const mould: Cutter = await firma.cutterFromObj('', 'name');
firma.cutterFromWorld(world, 'name');
// @ts-expect-error no such shape
firma.crater('round', 1);
const rotation: [number, number, number, number] = firma.randomTurn(7);
const { world: after, report } = world.carve(
    cutter,
    { position: hit.point, rotation, scale: 2 },
    { fill: true, material: 'a' },
);
const refused: CarveReport = report;
const short: number = report.cutShort;
const table: WholeMatterTable = await firma.readMatters('matter a', 'a.matter');
const given: MatterTable = { matters: [{}, { name: 'oak', fracture: 'splinters' }], patterns: [{ pattern: 'o*', matter: 1 }] };
firma.worldFromMesh(mesh, { matters: given }).release();
firma.worldFromMesh(mesh, { matters: firma.defaultMatters() }).release();
// @ts-expect-error a style that is none
firma.worldFromMesh(mesh, { matters: { matters: [{ fracture: 'melts' }] } });
const counted: MatterCounts = world.countMatters();
const dense: number = world.matters().matters[world.matterAt([1, 2, 3])]!.density + readers.readMatters('').patterns.length;
const ofFace: number = world.matterOf(world.faces().ids.length ? { face: 1, corner: [0, 0, 0] } : { id: 1, corner: [0, 0, 0] });
const total: number = refused.times.total + refused.times.place;
const job = world.startCarve(cutter, { position: [1, 2, 3] });
while (!job.run(1000));
job.result().world.release();
const edit = world.edit();
edit.carve(cutter, { position: [1, 2, 3] }).reason.length;
edit.finish().release();
const held: World = world.withAnchors({ hanging: false, materials: ['a'], sources: Uint32Array.of(1), volumes: level.anchorVolumes() });
const loose: Chunks | null = held.carve(cutter, { position: [1, 2, 3] }, { chunks: { minVolume: 1 }, edit: 7 }).report.loose;
const chunk: Chunk | undefined = loose?.list()[0];
const woods: MatterVolume[] = chunk?.matters ?? [];
const body: Mass = loose?.world(0).mass(1000) ?? world.pieces(500).list()[0]!;
const rest: Rest = firma.cutterAtRest(world, { position: chunk?.origin ?? [0, 0, 0] }, 'name');
const weight: number = body.inertia[8]! + refused.chunkVolume + refused.crumbs + refused.times.chunks + rest.mended;
const command: Command = firma.editCommand(1, rest.cutter, firma.quantisePose(rest.pose), { fill: true });
const shut: Command = firma.doorCommand(2, 0, true);
const said: CommandFacts = firma.unpackCommand(firma.groupCommand([command.quantised(), shut]).pack(), 'name').facts();
if (said.kind === 'group' && said.options === null) command.part(0).release();
const applied: CarveReport = world.apply(command).report;
world.startApply(shut).run(5);
const log: EditLog = firma.beginLog(world);
log.append(command);
log.checkpoint(after);
const told: LogFacts = firma.unpackLog(log.compact(world, 1).pack(), 'name').facts();
const replay: Replay = log.replay(world, log.command(0).facts().number);
const behind: ReplayFacts = replay.facts();
const late: World = replay.run(Infinity) ? replay.result() : world;
const differing = firma.differingRegions(world.hashRegions(), late.hashRegions());
const mended: World = world.applyPatch(late.makePatch(world.listFaces(differing), 'name'), 'name');
mended.applyPatch(late.patchFrom(mended)).release();
const numbers: number = weight + applied.volume + told.patchBytes + behind.applied;
// @ts-expect-error a log is no command
world.apply(log);
const diff: Diff = world.diff(after, 1);
const corners: Float64Array = diff.added.corners;
const left: FaceInfos = diff.removedFaces;
const rooms: number = left.rooms.length + left.sources.length;
world.withRules({
    mergeShare: 0.5,
    zones: [{ name: 'a', low: [0, 0, 0], high: [1, 1, 1], hardness: 1 }],
    hardness: [0],
    maxFaces: 5,
    maxCutterSize: 3,
});
// @ts-expect-error a world is no cutter for carving
world.carve(world, { position: 5 });

const store = firma.openStore(world, Infinity);
store.publish(store.current(), after);
for (const kept of [store.undo(), store.redo(), store.at(0)]) kept.release();
const storeFacts: StoreFacts = store.facts();
const waiting: number = store.collect() + storeFacts.bytes;
store.release();
store[Symbol.dispose]();
const gone: boolean = store.released;

try {
    world.release();
} catch (error) {
    if (error instanceof FirmaError && error.code === 'BAD_HANDLE') console.log(error.message);
}
{
    using kept = world.copy();
    kept.check();
}
export const used = [
    version,
    live,
    spawn,
    x,
    y,
    z,
    names,
    hash,
    volume,
    memory,
    flags,
    face,
    origin,
    any,
    all,
    one,
    where,
    none,
    near,
    deep,
    closest,
    across,
    passed,
    total,
    corners,
    waiting,
    gone,
    same,
    levels,
    ofObj,
    mould,
    numbers,
    hullCorners,
    points,
    grazes,
    stuck,
    inside,
    manyHits,
    statuses,
];

// ---- games

const games: Games = await loadGames();
await loadGames(fetch('firma_games.wasm'), { readers: new URL('http://localhost/firma_readers.wasm') });
const alsoFirma: Firma = games;
await loadReaders(games);
const level3: World = await games.worldFromObj('v 0 0 0');
const heavy: Mass = games.massOfBox([1, 1, 1], 1000);
const ballShape: BodyShape = games.bodyShape([0, 0, 0, 1], games.massOfBall(1, 1000));
games.bodyShape(new Float32Array(4), heavy).release();
const bodies: Bodies = games.bodies();
const bodyId: BodyId = bodies.add(ballShape, { position: [0, 0, 1] });
const chunkId: bigint = bodies.addChunk(level3.pieces(), 0, { maxSpheres: 12, maxError: 0.1, margin: 0 });
const state: Body = bodies.get(bodyId);
bodies.set(chunkId, { ...state, velocity: Float64Array.of(1, 2, 3) });
bodies.push(bodyId, [0, 0, 1], state.position);
const ids: BodyId[] = bodies.list();
const places: Float64Array = bodies.poses(new Float64Array(7 * bodies.count()));
const parts: Parts = games.parts();
const levelParts: LevelParts = levels[0]!.parts({ contactOffset: 0.001 });
const leaf: LevelPart = levelParts.parts[0]!;
parts.add({ world: leaf.world, mask: leaf.mask, motion: games.pathMotion(leaf.path, 0, 1 / 60) });
const doorShut: boolean = games.pathAtFirstStop(leaf.path, games.pathPose({ stops: [{ wait: Infinity }] }, 1).scale);
const levelNote: string = levelParts.notes[0]!.note;
const lift: number = parts.add({ world: level3, mask: 1, motion: { position: [0, 0, 0], path: [0, 0, 1] } });
parts.set(lift, { world: level3 });
parts.setMotions([{ turn: [0, 0, 1] }]);
const scene: Scene = { world: level3, parts, from: 0, to: 1 };
const stepped: StepReport = bodies.step(scene, 1 / 60, { gravity: [0, 0, -1], substepsASecond: 240 });
bodies.step(level3, 1 / 60);
const pressed: BodyContact[] = bodies.contacts();
const other: bigint | null = pressed[0]?.other ?? null;
const sceneHit: SceneHit = games.castScene(scene, { ...pill, path: [0, 0, 1] }, { mask: 1 });
const partOf: number | null = sceneHit.part;
const sceneAny: boolean = games.castSceneAny(level3, { ...pill, path: [0, 0, 1] });
const overlapped: SceneOverlap[] = games.overlapScene(scene, pill, { fraction: 0.5 });
const capsule: PlayerShape = games.playerCapsule({ radius: 0.3, height: 1.8 });
games.playerBox().release();
games.playerSpheres([0, 0, 1, 1], [0, 0, 0.5, 0.5], [0, 0, 1]).release();
const moved: PlayerMove = games.movePlayer(scene, capsule, { position: [0, 0, 0] }, { velocity: [1, 0, 0], jump: true }, 1 / 60);
const player: Player = games.movePlayer(level3, capsule, moved.player, undefined, 1 / 60, { maxSlope: 0.8 }).player;
const fits: boolean = games.playerFits(level3, capsule, player.position, { crouched: true });
const shots = new Projectiles();
const shotIndex: number = shots.add({ position: [0, 0, 0], velocity: [100, 0, 0] });
const shot: Projectile = shots.get(shotIndex);
const flown: FlyReport = games.fly(shots, level3, 1 / 60, { bodies, matters: [{ resistance: 1000 }], ofBodies: {} });
const events: ShotEvent[] = flown.events;
const shotHash: bigint = games.hashProjectiles(shots.copy());
// @ts-expect-error no such member
bodies.step(level3, 1 / 60, { substeps: 4 });
// @ts-expect-error a name of a body is a BigInt
bodies.get(0);
// @ts-expect-error nothing that moves is of the main entry
firma.bodies();
// @ts-expect-error no such wish
games.movePlayer(level3, capsule, player, { run: true }, 1 / 60);
// @ts-expect-error a state that is none
shots.add({ state: 'gone' });
export { alsoFirma, ids, where, stepped, other, partOf, sceneAny, overlapped, fits, shot, events, shotHash };

// ---- recordings

const recordings: Recordings = await loadRecordings();
await loadRecordings(fetch('firma_recordings.wasm'), { readers: new URL('http://localhost/firma_readers.wasm') });
const alsoGames: Games = recordings;
const level4: World = await recordings.worldFromObj('v 0 0 0');
const game: Game = recordings.game(level4, 60);
game.setRules({ ...game.rules(), seed: 2n, chunks: false, debris: { maxBodies: 9 }, bodies: { gravity: [0, 0, -1] } });
const weapon: Required<Weapon> = game.weapon(1);
game.setWeapon(1, { ...weapon, charge: { crater: 1, shape: 'spiky', material: 'soot' } });
const mortar: number = game.addWeapon({ name: 'mortar', terms: { friction: 1 }, lies: true });
const doorPart: number = game.addPart({ world: level4, waits: true, path: { stops: [{ wait: Infinity }], swing: { period: 2 } }, portals: [1] });
const status: 'done' | 'nothing' | 'refused' = game.edit(recordings.doorCommand(1, 0, true));
game.explode([0, 0, 0], { breakRadius: 2 });
game.fire(mortar, [0, 0, 0], [1, 0, 0]);
const put: BodyId = game.addBody(ballShape, { position: [0, 0, 0] }, { velocity: [1, 0, 0], friction: 0.5 });
const came: number = game.addPlayer({ shape: capsule, player: { position: [0, 0, 0] }, wish: { jump: true }, rules: { maxSlope: 1 } });
game.wish(came, { velocity: [1, 0, 0] });
game.setOff(doorPart);
game.record('level');
game.step();
const started: number | null = game.part(doorPart).started;
const tall: number = game.playerSize(came).height;
const eye: Player = game.player(came).player;
const flying: Projectiles = game.projectiles(1);
const gameReport: GameReport = game.report();
const gameBlast: GameBlast | undefined = gameReport.blasts[0];
const shotBy: number | undefined = gameReport.shotEvents[0]?.weapon;
const shotAt: number | null | undefined = gameReport.shotEvents[0]?.part;
const solids: World[] = [game.world(), game.bodySolid(put)];
const spheres: Float64Array = game.bodySpheres(put);
const gameHash: bigint = game.hash();
const parted: Uint32Array = game.hashItems('part');
const packed: Uint8Array = game.pack();
const taped: Recording = game.recording();
const tapedEvent: GameEvent = taped.event(0);
const replayed: Game = recordings.unpackRecording(taped.pack(), 'a').replay();
const replayState: ReplayState = replayed.replayState();
const kindOf: 'other' | 'game' | 'recording' = recordings.kindOfBytes(packed);
const made: Game[] = [taped.start(), taped.end(), recordings.unpackGame(packed), game.copy()];
// @ts-expect-error no such item
game.hashItems('door');
// @ts-expect-error a pose says where it is
game.addBody(ballShape, { position: [0, 0, 0] }, { position: [1, 0, 0] });
// @ts-expect-error nothing recorded is of games
games.game(level4);
export { alsoGames, status, started, tall, eye, flying, gameBlast, shotBy, shotAt, solids, spheres, gameHash, parted, tapedEvent, replayState, kindOf, made };

// ---- debris, blasts, parts that break, paths, convex pieces, supports

const debris: Debris = recordings.debris();
const broken: Chunks = recordings.fracture(level4, { sizeOfPiece: [1, 1, 1] }, { maxPieces: 4, impact: [0, 0, 0], density: 1000, seed: 2n });
const chunkBody: BodyId = debris.addChunk(bodies, broken, 0, { maxSpheres: 8 });
const crackPattern: FracturePattern = recordings.fracturePattern(level4, 0);
const shattered: Shattered = debris.shatter(bodies, chunkBody, { ...crackPattern, style: 'bricks', axes: null }, { world: level4, maxSpheres: 4 });
const debrisPiece: DebrisPiece = debris.get(bodies, shattered.pieces[0]!);
const debrisSolids: World[] = [debris.world(bodies, chunkBody), recordings.partWorld(parts, 0)];
debris.remove(bodies, chunkBody);
const tended = debris.tend(bodies, level4, 1 / 60, { toGround: true, keepClear: [0, 0, 0, 1] });
const filled = debris.fill(0);
const filledWorld: World = tended.world.carve(filled.cutter, filled.pose, { fill: true, material: filled.material }).world;
const exploded: { world: World; report: Explosion } = debris.explode(bodies, level4, { at: [0, 0, 0] }, null);
debris.explode(bodies, level4, { radius: 4 }, filled.cutter, { position: [0, 0, 0] }, { breakRadius: 2, mask: 1, maxSpeed: Infinity, carve: { material: 'soot' } });
const blastNumbers: number[] = [recordings.blastShare({}, 2), recordings.exposure(level4, [0, 0, 0], [0, 0, 0, 1], STOPS_SIGHT)];
const blastPush: number[] = recordings.blastImpulse({ impulse: 5 }, [0, 0, 1], 2);
const pushedBodies: number = recordings.pushBlast(level4, bodies, {}, { maxSpeed: 3 }).pushed;
const doorPortals: number[] = recordings.partPortals(parts, 0, level4);
const bears: Breakable = { ...recordings.breakable(parts, 0), health: 40 };
const { breakable: hurtCrate, breaks } = recordings.hurt(bears, 40 * recordings.blastFelt(parts, 0, level4, {}, 0.5));
const brokenPart: BodyId[] = debris.breakPart(bodies, parts, 0, level4, { breakable: hurtCrate, portals: [1], unbroken: breaks }).report.pieces;
const cutPart: BodyId[] | undefined = debris.carvePart(bodies, parts, 0, level4, filled.cutter, filled.pose, { holdLargest: true, pieces: { seed: 3 } }).report.rest?.pieces;
const sceneEvents: SceneShotEvent[] = recordings.flyScene(shots, { world: level4, parts, to: 0.5 }, 1 / 60, { bodies }).events;
const index: BodyIndex = recordings.bodyIndex(bodies, 0.5);
const bodyHits: BodyHit[] = [
    index.cast({ centre: [0, 0, 0], radius: 0, path: [1, 0, 0] }, { mask: 1, except: chunkBody }),
    index.castSet(new Float64Array(4), { turn: [0, 0, 1] }),
];
const fitted: Float64Array = recordings.fitSpheres(level4, { maxSpheres: 9 }).spheres;
const setHit: SetHit = recordings.castSet(level4, fitted, { path: [1, 0, 0] }, { room: 'any' });
const setPairHit: SetPairHit = recordings.castSetPair(fitted, {}, [0, 0, 0, 1], { path: [1, 0, 0] });
const nearest: SceneNear | null = recordings.closestInScene({ world: level4, parts }, [0, 0, 0], { reach: 2, fraction: 0.5 });
const nextStop: number = recordings.pathNextStop(leaf.path, 1);
const { breakable: bearsOfLevel, ...gamePart } = leaf;
game.addPart(gamePart);
recordings.flyScene(shots, level4, 1 / 60, { rule: (impact, matter, usual) => ({ resistance: matter + impact.mass + usual.friction }) });
// @ts-expect-error rules are of flyScene()
games.fly(shots, level3, 1 / 60, { rule: () => undefined });
const spans: PierceSpan[] = recordings.pierce(level4, { start: [0, 0, 0], path: [1, 0, 0] }, { panes: false, matters: true }).spans;
const convexPieces: ConvexPiece[] = [...recordings.convexPieces(level4, { maxConcavity: 0.1 }), ...recordings.convexPiecesOfChunk(broken, 0)];
const supports: Supports = recordings.findSupports(level4, [{ kind: 'hangs', low: [0, 0, 0], high: [1, 1, 1], reach: 1 }]);
const support: Support = supports.get(0);
const supportFaces: { face: number; area: number }[] = supports.faces(0);
const supportChanges: SupportChange[] = supports.diff(level4, level4).changes;
const gameDebris: bigint = game.debris().copy().hash();
// @ts-expect-error a breakable has to be whole
recordings.hurt({ health: 3 }, 1);
// @ts-expect-error a crater or null
debris.explode(bodies, level4, {});
// @ts-expect-error no fill
debris.explode(bodies, level4, {}, null, undefined, { carve: { fill: true } });
// @ts-expect-error debris is of recordings
games.debris();
export { doorPortals, debrisPiece, debrisSolids, filledWorld, exploded, blastNumbers, blastPush, pushedBodies, brokenPart, cutPart, sceneEvents, spans, convexPieces, support, supportFaces, supportChanges, gameDebris };
