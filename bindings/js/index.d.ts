// SPDX-License-Identifier: MIT
// The types of the package: collision detection in polygon worlds that get carved.
//
// Units: metres, microseconds where said; right-handed. A surface's front is the side from which its corners run
// counter-clockwise. Every failure throws a FirmaError. Objects with release() hold memory of the module until then.
//
// Arguments of a wrong kind or length throw BAD_CALL, and so do members that options, poses, meshes, rules or zones do
// not have; released objects and those of another module throw BAD_HANDLE. This is not said again below.
//
// One rule says where a failure shows: where the answer has a status (cast(), castBatch(), castMany(), castManyAny()),
// bad numbers of the input and a room that is not there give status 'invalid'; everywhere else they throw, OUT_OF_RANGE for the numbers, INVALID for
// the room. Options that make no sense, and faces, portals and materials that the world does not have, throw INVALID
// everywhere. A search that finds nothing has not failed: it returns null, false or nothing in a list.
//
// Costs. A call costs what the module does for it, as said at each, and copying: arguments into the module's memory,
// answers out of it, into arrays and objects of their own. Every World, Level, Cutter, Job, Edit, Store, Chunks,
// Command, EditLog, Replay and Hull returned is a handle, which takes a little memory of the module. Where nothing else is said, a call costs the same for every
// world.

/// <reference lib="esnext.disposable" />

/** Three numbers: an array, or a typed array of length 3. */
export type Vector = ArrayLike<number>;
/** As it comes back: an array of its own. */
export type Vector3 = [x: number, y: number, z: number];
/** x, y, z, w. */
export type Quaternion = [x: number, y: number, z: number, w: number];
export type Numbers = Float64Array | Float32Array | readonly number[];
export type Words = Uint32Array | Uint16Array | Uint8Array | readonly number[];
export type Bytes = ArrayBuffer | ArrayBufferView;

export type ErrorCode =
    | 'CANNOT_READ' // a module cannot be read or fetched
    | 'MALFORMED' // data break their format
    | 'OUT_OF_RANGE' // a number is not finite, or beyond what Firma can hold
    | 'TOO_LARGE' // a count or size exceeds a limit
    | 'UNSUPPORTED' // a format or version that Firma does not read
    | 'INVALID' // arguments that make no sense
    | 'CANNOT_WRITE'
    | 'BAD_HANDLE' // released, of another kind, or of another module
    | 'BAD_CALL' // an argument of a wrong kind, a call out of order
    | 'NO_MEMORY' // not enough for the arguments: nothing happened
    | 'BROKEN' // check() found something that does not hold
    | 'INTERNAL'; // the module stopped (a trap, as when memory runs out within a call): load it anew

export class FirmaError extends Error {
    constructor(code: ErrorCode, message: string, options?: { cause?: unknown });
    readonly name: 'FirmaError';
    readonly code: ErrorCode;
}

/**
 * Loads the module of worlds, a new instance of it each time. The other module, of readers, which makes levels and
 * worlds of files, is loaded when the first file is read, or ahead by loadReaders() of 'firma/readers'.
 *
 * @param source nothing: the firma.wasm that comes with the package (fetched in browsers, read as a file in node). Or a
 *     URL (in node also a path), a Response, the bytes, a compiled module; or a promise of one of these
 * @throws {FirmaError} CANNOT_READ, MALFORMED (no WebAssembly), UNSUPPORTED (another module, or another version of it)
 *
 * Costs reading and compiling it; given a compiled module, only an instance and its memory.
 */
export function loadFirma(source?: Source | PromiseLike<Source>, options?: LoadOptions): Promise<Firma>;
export type Source = string | URL | Response | Bytes | WebAssembly.Module;

export interface LoadOptions {
    /**
     * The module of readers, given as `source` is. None: firma_readers.wasm beside `source`, where that is a URL or path
     * of a firma.wasm, or the Response of one; else the one that comes with the package. It is taken when the first
     * file is read: then errors of it show.
     */
    readers?: Source | PromiseLike<Source>;
}

/** What holds memory of the module. */
export interface Handle {
    /**
     * Gives the memory back; a second time throws BAD_HANDLE. What is never released is released some time after
     * nobody can reach it any more, which may be late: a few bytes here may hold megabytes there. Does nothing once the
     * module has stopped. Costs freeing what no other handle shares: of a world what an edit replaced, or all of it.
     */
    release(): void;
    readonly released: boolean;
    /** For `using`, where JavaScript has it: as release(), but nothing when that was done already. */
    [Symbol.dispose](): void;
}

export interface Firma {
    /** As '0.2.0'. */
    readonly version: string;
    /** Objects that are not released yet, levels too: 0 when nothing has leaked. */
    liveHandles(): number;

    // Files are read by the module of readers, which the first of these calls loads: so they give promises, and every
    // failure rejects. Arguments are checked, and the file copied, before the call returns. loadReaders() gives the same
    // functions without promises. What a file makes of the readers' memory does not concern this module: one that is too
    // large for it stops the readers alone, and the next call starts others.

    /**
     * A Wavefront .obj file, as a string or its bytes. Closed pieces can be carved, other faces only cast against. Time
     * and memory grow with the file, here and below: time a little faster than in proportion, as faces are sorted into
     * a tree, and with the pairs of faces close together, as they are tested for crossings. The file is copied into the
     * module of readers for as long as the call takes, and the world comes from there by pack() and unpackWorld(), which
     * adds a fifth (a large .bsp) to a half (a small .obj) to the time.
     * @throws {FirmaError} MALFORMED, OUT_OF_RANGE, TOO_LARGE, UNSUPPORTED, here and below; as loadFirma() where the
     *     module of readers is not to be had: the message says where it was looked for, and the next call tries again
     */
    worldFromObj(file: string | Bytes, options?: WorldOptions): Promise<World>;
    /** A Quake III .bsp file (version 46): its brushes, as of a .map. */
    worldFromBsp(file: Bytes, options?: WorldOptions): Promise<World>;
    /**
     * A Quake .map file, as a string or its bytes: brushes become one solid, the air rooms, divided by the portals that
     * its author placed. The cost grows also with the brushes and portals that each brush meets.
     */
    worldFromMap(file: string | Bytes, options?: WorldOptions): Promise<World>;
    /**
     * A level of brushes as its file has it: for its entities, and for a world of it. Time and memory grow with the
     * file, time also with the square of a brush's sides; brushes are not joined yet. Until it is released the memory is
     * that of the readers, as large as the largest file has made it.
     */
    levelFromMap(file: string | Bytes, options?: LevelOptions): Promise<Level>;
    levelFromBsp(file: Bytes, options?: LevelOptions): Promise<Level>;
    /** A cutter of a Wavefront .obj file: cutterFromMesh() of its faces, cut into triangles. */
    cutterFromObj(file: string | Bytes, name?: string): Promise<Cutter>;

    /** As worldFromObj(), of arrays, which are copied; without a promise, as this module does it. */
    worldFromMesh(mesh: Mesh, options?: WorldOptions): World;
    /**
     * What World.pack() gave, or a .firma file. `name` is for messages. Costs all faces, in time and memory, with the
     * checks of World.check(). @throws {FirmaError} MALFORMED, UNSUPPORTED, TOO_LARGE
     */
    unpackWorld(file: Bytes, name?: string): World;

    /**
     * Bytes that worlds hold together; what they share counts once. Goes through every block, room and portal of them:
     * grows with all faces.
     */
    memory(worlds: readonly World[]): number;

    /**
     * A shape of mean radius about 1 around the origin; equal seeds give equal ones on every machine. Takes memory for
     * its triangles: make it once and place it often.
     */
    crater(shape: Shape, seed: Seed): Cutter;
    /**
     * A closed mesh of triangles. Costs the vertices and triangles, copied, and sorting the edges.
     * @param positions three for each vertex
     * @param corners three for each triangle
     * @throws {FirmaError} MALFORMED for a mesh that is not closed, OUT_OF_RANGE, TOO_LARGE
     */
    cutterFromMesh(positions: Numbers, corners: Words, name?: string): Cutter;
    /**
     * The convex hull of up to 64 points, already turned, for casts: made once, and put anywhere. Costs some
     * microseconds for a box, some hundred for 64 points.
     * @param points three numbers for each, metres, from where it is put
     * @throws {FirmaError} TOO_LARGE for more points; OUT_OF_RANGE for a number that is not finite or beyond 2^199;
     *     INVALID for fewer than four, for points in one plane, and for a hull that the place it is put at lies
     *     outside of
     */
    hullFromPoints(points: Numbers): Hull;
    /**
     * A box around its middle, for casts.
     * @param half metres, > 0
     * @param axes three unit vectors, perpendicular to each other: nine numbers; upright unless given
     * @throws {FirmaError} as hullFromPoints()
     */
    hullBox(half: Vector, axes?: ArrayLike<number>): Hull;
    /**
     * The solid of a world: a chunk that cuts left, a prefab that has been carved. At scale 1, turned by quarter turns
     * about the axes, it cuts exactly, its position snapped to 1/4096 m; at any other pose it is what its facets bound
     * once snapped, and is refused where they cross. Costs its facets, copied.
     * @throws {FirmaError} INVALID for a world without solid faces, or with rock that reaches to infinity; TOO_LARGE
     */
    cutterFromWorld(world: World, name?: string): Cutter;
    /**
     * A world's solid where it came to rest, as a cutter: world.carve(cutter, pose, { fill: true }) makes it ground. By
     * quarter turns about the axes, at scale 1, it is placed exactly; at any other pose each corner of its facets is
     * snapped to 1/4096 m, and thin triangles that then cross others are taken out. Costs its facets, and testing those
     * near each other against each other, again for each time that some are mended.
     * @throws {FirmaError} as cutterFromWorld(); OUT_OF_RANGE for a pose that is not finite or leads out of the world;
     *     INVALID where triangles still cross, with a place: it stays a body then
     */
    cutterAtRest(world: World, pose: Pose, name?: string): Rest;

    /**
     * Puts the position and scale on steps of 1/4096, and the turn on four parts of 16 bits: few bytes. Doing it again
     * changes nothing. Off by at most 1/8192 m, 1/16,000 of a radian and 1/8192 m a unit of the cutter. What is not
     * finite or zero stays.
     */
    quantisePose(pose: Pose): FullPose;
    /**
     * An edit that carves or fills, as a value: for lockstep, replays, players who join late. A cutter of crater() is
     * stored as its shape and seed.
     * @param number of the edit: 1 to 2^21 - 1, above that of every command before it; `edit` of the options is not used
     */
    editCommand(number: number, cutter: Cutter, pose: Pose, options?: CarveOptions): Command;
    /** Opens or closes a portal. */
    doorCommand(number: number, portal: number, open: boolean): Command;
    /**
     * Several as one version; the numbers are those of the parts. Copies the parts; cutters are shared.
     * @throws {FirmaError} INVALID for none, for a group among them, and for numbers that do not ascend
     */
    groupCommand(parts: readonly Command[]): Command;
    /**
     * What Command.pack() gave, taken as hostile. Costs the bytes.
     * @throws {FirmaError} MALFORMED with the byte; UNSUPPORTED for another version; as cutters
     */
    unpackCommand(data: Bytes, name?: string): Command;
    /** A log that begins from this world, empty. */
    beginLog(level: World): EditLog;
    /** What EditLog.pack() gave, taken as hostile, with a checksum. Costs the bytes. @throws as unpackCommand() */
    unpackLog(data: Bytes, name?: string): EditLog;
    /**
     * The regions whose hashes differ, those that only one list has among them, ascending. Costs both lists, sorted.
     * @param a, b of hashRegions(), of two worlds
     */
    differingRegions(a: readonly RegionHash[], b: readonly RegionHash[]): Vector3[];
    /** The table that worlds are made by where none is given. */
    defaultMatters(): WholeMatterTable;
    /**
     * A table as text, as `firma carve --matter` takes it: docs/formats.md has the form. Costs the text.
     * @param name for messages @throws {FirmaError} MALFORMED, with the line
     */
    readMatters(text: string | Bytes, name?: string): Promise<WholeMatterTable>;
    /** A unit quaternion, evenly distributed; equal seeds give equal ones on every machine. */
    randomTurn(seed: Seed): Quaternion;

    /**
     * A history that begins with `world`, and shares it.
     * @param maxBytes what versions other than the current one may hold; 0: no undo, Infinity: no bound
     */
    openStore(world: World, maxBytes: number | bigint): Store;
}

/** An integer from 0: below 2^53 as a number, below 2^64 as a BigInt. */
export type Seed = number | bigint;
/** 'rocky' has 180 triangles and radii from 0.78 to 1.2; 'box' goes from -1 to 1. */
export type Shape = 'rocky' | 'spiky' | 'drill' | 'wedge' | 'box';

export interface WorldOptions {
    /** For messages. */
    name?: string;
    /** How far movers stay from surfaces, metres; 0.001 unless given. */
    contactOffset?: number;
    /** Metres a unit of the file or mesh; 0 or none: the format's own (1; 1/32 for .bsp and .map). */
    scale?: number;
    /** What the level is made of; defaultMatters() unless given. @throws {FirmaError} INVALID for a table that is none */
    matters?: MatterTable;
    /** Whether how textures lie is kept, for texture() and triangles(); true unless given. */
    textures?: boolean;
    /** Whether nodes are split by surface area (true unless given), not in half. Of several rooms, those of more than 64 faces always are. */
    surfaceArea?: boolean;
    /** 0..64 */
    maxDepth?: number;
    /** >= 1 */
    facesPerLeaf?: number;
    /** Cubic metres. */
    minNodeVolume?: number;
}

/** How something breaks, for what a game shows and hears of it: brick, wood, steel, glass. */
export type Fracture = 'chunks' | 'splinters' | 'bends' | 'pane';

export interface Matter {
    /** '' unless given; no two of a table have the same. */
    name?: string;
    /** The material of faces that a cut leaves in it; '' unless given. */
    inside?: string;
    /** Kilograms a cubic metre, above 0; 2400 unless given. */
    density?: number;
    /** Megapascals of tension that it bears, from 0; 3 unless given. */
    strength?: number;
    /**
     * 0..1, 0 unless given: 1 may not be carved, a crater is cut short there; below, a cutter whose centre is nearest to
     * this matter is shrunk to (1 - hardness) of its scale.
     */
    hardness?: number;
    /** 'chunks' unless given. */
    fracture?: Fracture;
}

/** `*` stands for any letters; case does not matter. Without `/` it is compared with what follows a name's last `/`. */
export interface MatterPattern {
    pattern: string;
    /** Index into MatterTable.matters. */
    matter: number;
}

/** What levels are made of: docs/matter.md. A world says everything of a matter by its number here. */
export interface MatterTable {
    /** At least one: the first is that of what no pattern fits. At most 4,096, as patterns. */
    matters: readonly Matter[];
    /** Which textures are of which; the first that fits counts. */
    patterns?: readonly MatterPattern[];
}

/** A table that a world or a file has. */
export interface WholeMatterTable {
    matters: Required<Matter>[];
    patterns: MatterPattern[];
}

export interface MatterCounts {
    /** Of the level, that bound solid: brushes, closed meshes. */
    pieces: number;
    /** Of these, how many may not be carved. */
    protectedPieces: number;
    /** How many pieces are of each matter of the table. */
    ofMatter: number[];
    /** The matter of what lies in no piece. */
    rest: number;
}

export interface LevelOptions {
    /** For messages. */
    name?: string;
    /** Metres a unit of the file; 0 or none: 1/32. */
    scale?: number;
}

/** A level of brushes; it never changes. */
export interface Level extends Handle {
    /**
     * As worldFromMap() makes it, at the same cost less the reading; the options' scale and name are ignored. No
     * promise: a level is only where there are readers.
     */
    world(options?: WorldOptions): World;
    /**
     * Its parts: of each entity that moves, or breaks, and has brushes, as plain data with a World in the part's frame, to
     * be released: docs/moving.md says which classes and keys. In 'firma/games' games.pathMotion() of its path gives
     * the motion of a tick, for Parts; in 'firma/recordings' all but `breakable` is a GamePart. Options and errors as of
     * world(). Costs what joining all these brushes costs, and moving each world.
     */
    parts(options?: WorldOptions): LevelParts;
    /** In the file's order; the first is the world. Copies all of them each time, as do notes() and omissions(). */
    entities(): Entity[];
    /** For people: what was dropped, replaced or not understood, with its place. */
    notes(): string[];
    /** What the file holds and casts will not meet. */
    omissions(): Omission[];
    /** Boxes around the brushes of its entities `firma_anchor`, metres: for World.withAnchors(). */
    anchorVolumes(): { low: Vector3; high: Vector3 }[];
    /** For numbers in the entities' values. */
    readonly metresPerUnit: number;
}

/** `notes`: entities that make no part, or not what their author meant, and why; numbers are those of entities(). */
export interface LevelParts {
    parts: LevelPart[];
    notes: { entity: number; note: string }[];
}

export interface LevelPart {
    /** Its solid, and what else casts meet of it, in its frame. */
    world: World;
    /** Its number in entities(). */
    entity: number;
    /** Met by what shares a bit with it, and with the face. */
    mask: number;
    /** Where its frame is by time. */
    path: WholePartPath;
    /** Its path is of the time since it is set off; else of the level's time. */
    waits: boolean;
    whenBlocked: WhenBlocked;
    /** What it bears, of one that is to be destroyed; null: of the others. */
    breakable: Breakable | null;
}

/** A place on a part's way. */
export interface PartStop {
    /** Of the part's frame, metres. */
    position?: Vector;
    /** Radians about the path's axis. */
    angle?: number;
    /** Seconds that it stands here; Infinity: it goes no further. */
    wait?: number;
    /** To the next stop, or from the last to the first; not above 0: it is there at once. */
    seconds?: number;
}

/** How a part moves by time: stops in turn, a swing, a spin. */
export interface PartPath {
    stops?: readonly PartStop[];
    /** Goes round for ever; else once round, and rests at the first stop. */
    repeats?: boolean;
    /** x, y, z, w, at angle 0; not turned unless given. */
    rotation?: ArrayLike<number>;
    /** Unit, of all angles; 0, 0, 1 unless given. */
    axis?: Vector;
    /** Radians a second about it. */
    spin?: number;
    /** Metres and radians to each side of the middle; seconds of a whole cycle, and where in it time 0 is. */
    swing?: { reach?: Vector; angle?: number; period?: number; phase?: number };
}

export type WhenBlocked = 'stops' | 'returns' | 'crushes';

/** As it comes back. */
export interface WholePartPath extends PartPath {
    stops: { position: Vector3; angle: number; wait: number; seconds: number }[];
    repeats: boolean;
    rotation: Quaternion;
    axis: Vector3;
    spin: number;
    swing: { reach: Vector3; angle: number; period: number; phase: number };
}

/** What a part bears, and what is left of that. All of it has to be given. */
export interface Breakable {
    /** Of all of it, a number in the part's world; null: that which its textures say. */
    matter: number | null;
    /** What is left, by the program's measure; not above 0: nothing hurts it. */
    health: number;
    /** Cubic metres of its solid before anything was taken of it. */
    whole: number;
    /** 0..1, of `whole`: what has lost a larger share breaks; 1: carving alone breaks it never. */
    maxTaken: number;
    /** Of the explosion that it makes, by the program's measure: nothing explodes by itself. */
    damage: number;
    broken: boolean;
}

/** Things of one kind, in the plural, how many, and the place of the first; '' where the format has none. */
export interface Omission {
    what: string;
    count: number;
    first: string;
}

/** A spawn point, a light, a door: what the author placed, by its keys. */
export interface Entity {
    /** '' where it has none. */
    classname: string;
    /** In the file's order, as written. */
    keys: [key: string, value: string][];
    /** By key: the first value of each. */
    values: Map<string, string>;
    /** Metres; null where `origin` is no three numbers. */
    origin: Vector3 | null;
    /** Where it begins in the file, from 1; 0 where the format has none. */
    line: number;
}

/** Polygons; each is divided where it is not convex and planar on the grid of 1/4096 m. */
export interface Mesh {
    /** Three for each vertex. */
    positions: Numbers;
    /** Indices of vertices, face after face, counter-clockwise seen from the air. */
    corners: Words;
    /** For each face, >= 3; none: all are triangles. Their sum is the length of `corners`. */
    cornerCounts?: Words;
    /** For each face, an index of `materialNames`; none: the first. */
    materials?: Words;
    /** The world numbers them so, too. */
    materialNames?: readonly string[];
    /** For each face, what casts choose by, ~0 or -1 for all; none: all bits. */
    masks?: Words | Int32Array;
    /** For each face; none: no face is. */
    twoSided?: Words | readonly boolean[];
    /** Texture coordinates, two for each of the corners, in repeats: they come out as they are given. */
    uvs?: Numbers;
}

export interface WorldFacts {
    /** 0 as read; every edit adds one. */
    version: number;
    faceCount: number;
    /** Those that edits joined to others counted. */
    roomCount: number;
    /** Those that edits left without polygons counted. */
    portalCount: number;
    /** Bounds of all faces; low > high when there are none. */
    low: Vector3;
    high: Vector3;
    contactOffset: number;
    /**
     * By the numbers that all of a world's materials go by: of a mesh, the caller's own; of a file, 0 is '', of faces
     * without one.
     */
    materials: string[];
    /** Cuts and fills so far. */
    edits: number;
}

/** Faces without their outlines, an array for each of their properties. */
export interface FaceInfos {
    /** Of the world's lifetime: a face keeps its id until an edit touches it. */
    ids: Uint32Array;
    /** Unit, three for each. */
    normals: Float64Array;
    materials: Uint32Array;
    /** Index of the face in the level's file; where sourceEdits is not 0, of a triangle of that edit's cutter. */
    sources: Uint32Array;
    /** 0: of the level's file; else the number of the edit. */
    sourceEdits: Uint32Array;
    masks: Uint32Array;
    /** Bits: FACE_TWO_SIDED, FACE_SOLID. */
    flags: Uint32Array;
    /** That they look into. */
    rooms: Uint32Array;
    /** The first corner of each, three integers, in steps of 1/262144 m: where World.face() looks for it. */
    firstPoints: Int32Array;
}

/** Faces with their outlines; face k has corners firstCorners[k] and on, cornerCounts[k] of them. */
export interface Faces extends FaceInfos {
    /** Counted in points. */
    firstCorners: Uint32Array;
    cornerCounts: Uint32Array;
    /** Three for each; convex, counter-clockwise seen from the front. */
    corners: Float64Array;
}
/** What faces stop: bits of their masks, and of casts'. Faces of formats that know no contents have all bits. */
export const STOPS_WALK: 1;
export const STOPS_SHOTS: 2;
export const STOPS_SIGHT: 4;
export const STOPS_LIQUID: 8;
/** In addition to what a wall stops: the sky is painted on it. */
export const IS_SKY: 16;
export const FACE_TWO_SIDED: 1;
/** Bounds a closed solid, which can be carved. */
export const FACE_SOLID: 2;
/** What ids of faces in a HitBatch are where there is none. */
export const NO_FACE: 0xffffffff;
/** What portals in a HitBatch are where there is none. */
export const NO_PORTAL: 0xffffffff;

export interface Face {
    id: number;
    normal: Vector3;
    material: number;
    source: number;
    sourceEdit: number;
    mask: number;
    flags: number;
    room: number;
    /** Its first, in steps of 1/262144 m. */
    corner: Vector3;
    /** Three for each. */
    corners: Float64Array;
}

/** Names a face: a Hit, a Near, a Face, or two numbers kept of one. */
export type FaceRef = { face: number | null; corner: ArrayLike<number> } | { id: number; corner: ArrayLike<number> };

/** Which faces: at most one of these. */
export interface FaceFilter {
    /** Those that look into this room, or into the one that it became part of. */
    room?: number;
    /** Those whose own box shares a point with this one. */
    box?: { low: Vector; high: Vector };
    /** Those whose lowest corner lies in the cube from region * 32 m on, 32 m wide: three integers. */
    region?: ArrayLike<number>;
}

/** What triangles() is limited to; all faces of the world, from its origin, unless given. */
export interface TriangleOptions {
    /** Faces that share a bit. */
    mask?: number;
    /** Without the faces that bound no solid. */
    solidOnly?: boolean;
    /** Only faces that look into this room. Not together with a region. */
    room?: number;
    /** Only faces whose lowest corner lies in the cube from region * 32 m on, 32 m wide: three integers. */
    region?: ArrayLike<number>;
    /** Metres: what positions are told from. Near the faces, floats lose least. */
    origin?: Vector;
    /** Texture coordinates too. */
    uvs?: boolean;
    /**
     * Texels across and down of pictures, two for each material, by its number: where both are above 0, texels become
     * repeats.
     */
    textureSizes?: Numbers;
}

/** What texture coordinates count: pixels of the picture, the whole picture, or metres, which no file says. */
export type TextureUnit = 'texels' | 'repeats' | 'metres';

/**
 * u = uAxis . p + uOffset of a point p of the face, in metres; v likewise. u goes to the right in the picture, v down.
 */
export interface Texture {
    uAxis: Vector3;
    uOffset: number;
    vAxis: Vector3;
    vOffset: number;
    unit: TextureUnit;
}

/** Faces as triangles, none of them without area on the surface grid. Vertices are not shared between faces. */
export interface Triangles {
    /** Three for each vertex, metres from the origin of the options. */
    positions: Float32Array;
    /** Three for each vertex, unit. */
    normals: Float32Array;
    /** Two for each vertex, in the unit that the source says; empty unless asked for. */
    uvs: Float32Array;
    /** Three for each triangle: vertices, counter-clockwise seen from the front. */
    corners: Uint32Array;
    /** Of each triangle. */
    faces: Uint32Array;
    /** Triangles of one material, one behind the other, in order of material. */
    runs: TriangleRun[];
    /** The faces, in order of material, then id. */
    sources: TriangleSource[];
}

/** A draw call: no other run's triangles name its vertices. */
export interface TriangleRun {
    material: number;
    firstTriangle: number;
    triangleCount: number;
    firstVertex: number;
    vertexCount: number;
}

export interface TriangleSource {
    face: number;
    /** That the face looks into. */
    room: number;
    source: number;
    sourceEdit: number;
    material: number;
    mask: number;
    /** Bits: FACE_TWO_SIDED, FACE_SOLID. */
    flags: number;
    firstTriangle: number;
    triangleCount: number;
    firstVertex: number;
    vertexCount: number;
    /** 'metres' also where no texture coordinates were asked for. */
    uvUnit: TextureUnit;
}

/** What regionMeshes() makes; all faces in cubes of 16 m unless given. */
export interface RegionMeshOptions {
    /** Metres: the edge of each cube, from 1 to 1024, in whole sixteenths; 16 unless given. */
    size?: number;
    /** Faces that share a bit. */
    mask?: number;
    /** Without the faces that bound no solid. */
    solidOnly?: boolean;
    /** Whether there are tangents, uvs and blends; true unless given. */
    textures?: boolean;
    /** As in TriangleOptions, each finite and not negative. */
    textureSizes?: Numbers;
}

/**
 * The triangles of the faces whose lowest corner (by x, then y, then z) lies in one cube. Vertices are not shared
 * between faces. docs/drawing.md says how to draw it.
 */
export interface RegionMesh {
    /** The cube is from place * size to (place + 1) * size along each axis. */
    place: Vector3;
    /** Metres: place * size; what positions are told from. */
    origin: Vector3;
    /** Metres: around all corners; low is above high in an empty mesh. */
    low: Vector3;
    high: Vector3;
    /** Three for each vertex: metres from the origin, exact up to 64 m. */
    positions: Float32Array;
    /** Three for each vertex, unit. */
    normals: Float32Array;
    /** Four for each vertex: unit, along the face where u grows and v stays; 1, or -1 where the picture is mirrored. */
    tangents: Float32Array;
    /** Two for each vertex, in the unit that the run says. */
    uvs: Float32Array;
    /** Four for each vertex, 255 in all: how much of the pictures along x, y and z, and of that by uvs. */
    blends: Uint8Array;
    /** Three for each triangle: vertices, counter-clockwise seen from the front. */
    corners: Uint32Array;
    /** Of each triangle. */
    faces: Uint32Array;
    /** In order of material, cut, twoSided, uvUnit. */
    runs: RegionRun[];
    parts: RegionParts;
}

/** Triangles that are drawn alike, one behind the other: a draw call. No other run's triangles name its vertices. */
export interface RegionRun {
    material: number;
    /** Of faces that edits made. */
    cut: boolean;
    /** Also seen from behind. */
    twoSided: boolean;
    /** What their uvs count. */
    uvUnit: TextureUnit;
    firstTriangle: number;
    triangleCount: number;
    firstVertex: number;
    vertexCount: number;
}

/** The faces of a mesh, in the order of its runs, an entry for each in every array. */
export interface RegionParts {
    faces: Uint32Array;
    /** Three for each: the first corner of the face. With its id it names the face: { face, corner }. */
    faceCorners: Int32Array;
    sources: Uint32Array;
    /** 0: of the level's file; else the number of the edit that made the face. */
    sourceEdits: Uint32Array;
    masks: Uint32Array;
    /** Bits: FACE_TWO_SIDED, FACE_SOLID. */
    flags: Uint32Array;
    firstTriangles: Uint32Array;
    triangleCounts: Uint32Array;
    firstVertices: Uint32Array;
    vertexCounts: Uint32Array;
}

/** A sphere; of radius 0 a particle. */
export interface SphereShape {
    centre: Vector;
    radius: number;
}

/** All within a radius of a segment, any way it lies; with both ends at one place a sphere. */
export interface CapsuleShape {
    from: Vector;
    to: Vector;
    radius: number;
}

/** A hull or box, put at a place. */
export interface HullShape {
    hull: Hull;
    at: Vector;
}

/** What moves, or is there. */
export type MovingShape = SphereShape | CapsuleShape | HullShape;

/** A shape that moves along `path`, without turning. */
export type CastInput = MovingShape & { path: Vector };

/**
 * Many casts of one kind, as columns: cast k starts at x[k], y[k], z[k] (a sphere's centre, an end of a capsule's
 * segment, the place where a hull is put) and goes along pathX[k], pathY[k], pathZ[k]. Fastest as Float64Arrays.
 */
export interface CastColumns {
    x: Numbers;
    y: Numbers;
    z: Numbers;
    pathX: Numbers;
    pathY: Numbers;
    pathZ: Numbers;
    /** Of spheres and capsules; 0 for all unless given. */
    radius?: Numbers;
    /** The other ends of capsules' segments: with these the casts are of capsules. */
    toX?: Numbers;
    toY?: Numbers;
    toZ?: Numbers;
    /** With these the casts are of hulls. */
    hulls?: readonly Hull[];
    /** Which of the hulls each cast is of; the first unless given. */
    hullOf?: Words;
}

export interface CastOptions {
    /** Faces that share a bit are met; all unless given. */
    mask?: number;
    /** Whether faces are met from behind too. */
    bothSides?: boolean;
    /** Metres, finite; the world's unless given, and where it is negative. */
    contactOffset?: number;
    /**
     * The room that the start lies in, and the cast goes on through portals; or 'locate': it finds out; 'any' (the
     * default): all rooms are asked. From the air, clear of all faces, the answer is the same.
     */
    room?: number | 'any' | 'locate';
}

/**
 * Where a point is; 'unknown' in a fold of the surface that rounding to the grid made. `room` is null unless the point
 * is in the air of one.
 */
export interface Location {
    where: 'air' | 'solid' | 'surface' | 'unknown';
    room: number | null;
}

/** A volume of air, bounded by faces and portals. Rooms and portals keep their numbers through edits. */
export interface Room {
    /** '' where the level gives none. */
    name: string;
    /** Bounds of its faces and portals; low > high when there are none. */
    low: Vector3;
    high: Vector3;
    faceCount: number;
    /** Reaches to infinity. */
    exterior: boolean;
    /** Itself; of a room that an edit joined to another: that one, and it is empty. */
    mergedInto: number;
    /** Ascending. */
    portals: number[];
}

/** Where the air of one room passes into that of another. */
export interface Portal {
    name: string;
    low: Vector3;
    high: Vector3;
    rooms: [number, number];
    material: number;
    /** What it stops while it is closed. */
    mask: number;
    open: boolean;
    /**
     * Convex, three numbers a corner, counter-clockwise seen from rooms[0]. None: an edit joined its rooms, or filled
     * it, and it leads nowhere.
     */
    polygons: Float64Array[];
}

/** What casts tested. */
export interface CastCounts {
    nodes: number;
    boxes: number;
    faces: number;
    precise: number;
}

/** `counts`: an object whose four numbers are added to. */
export interface CountedCastOptions extends CastOptions {
    counts?: Partial<CastCounts>;
}

export interface SingleCastOptions extends CountedCastOptions {
    /**
     * An array that gets the rooms that the cast reached, in their order, the first included; none when all rooms of a
     * world of several were asked.
     */
    passed?: number[];
    /**
     * An array that gets for each of these rooms the portal that it was reached through first; null for the first room.
     */
    passedPortals?: (number | null)[];
}

export interface ManyOptions extends CountedCastOptions {
    /** Is told how many casts are done, after some ten thousand each time and at the end; false: no more are made. */
    progress?: (done: number, count: number) => boolean | void;
}

/** What overlap() and closest() are limited to. */
export interface NearOptions {
    /** Faces and closed portals that share a bit; all unless given. */
    mask?: number;
    /** Only what bounds this room; all rooms unless given. */
    room?: number;
}

/**
 * 'invalid': a number of the input is non-finite or out of range, or the world does not have the room: nothing was
 * asked. 'touching': at the start, and moving closer.
 */
export type Status = 'miss' | 'hit' | 'touching' | 'invalid';
export type Feature = 'face' | 'edge' | 'vertex';

/**
 * A miss has fraction and safeFraction 1, and the end of the path as its centre; 'invalid' has fraction 0. The rest of
 * the fields mean something where `hit` is true.
 */
export interface Hit {
    status: Status;
    /** Whether anything was met: 'hit' or 'touching'. */
    hit: boolean;
    /** Of the path, 0..1. */
    fraction: number;
    /** How far to go so that the contact offset is kept. */
    safeFraction: number;
    /** Of the sphere at `fraction`; the middle of a capsule's segment, the place where a hull is put. */
    centre: Vector3;
    /** Of the surface. */
    point: Vector3;
    /** Unit, from `point` toward the centre. */
    normal: Vector3;
    faceNormal: Vector3;
    feature: Feature;
    /** Corner of the vertex, or of the edge's first corner. */
    featureIndex: number;
    /** Null also where a closed portal was met. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m: where hitInfo() looks for it. */
    corner: Vector3;
    /** The closed portal that was met. */
    portal: number | null;
    /** Of the face, or of the portal. */
    material: number;
}

/** What only some ask of a hit. */
export interface HitInfo {
    /** That the face looks into; of a closed portal the one on the side that was met. */
    room: number;
    /** As in Faces; 0 for a portal. */
    source: number;
    sourceEdit: number;
    mask: number;
    twoSided: boolean;
    /** The face bounds a closed solid, which can be carved. */
    solid: boolean;
    /** Across the edge that was met; null elsewhere, and where not exactly two faces share the edge. */
    otherFace: number | null;
}

/**
 * The answers of castBatch() and castMany(), an array for each field of a Hit; they may be longer than `count`. Numbers stand for
 * names: status 0 'miss', 1 'hit', 2 'touching', 3 'invalid'; feature 0 'face', 1 'edge', 2 'vertex'; NO_FACE and
 * NO_PORTAL for null.
 */
export class HitBatch {
    /** An empty one, to be given as `out`. */
    constructor();
    readonly count: number;
    readonly status: Uint8Array;
    readonly feature: Uint8Array;
    readonly fraction: Float64Array;
    readonly safeFraction: Float64Array;
    /** Three for each, as are the next ones. */
    readonly centre: Float64Array;
    readonly point: Float64Array;
    readonly normal: Float64Array;
    readonly faceNormal: Float64Array;
    readonly featureIndex: Uint32Array;
    readonly face: Uint32Array;
    /** Three for each. */
    readonly corner: Int32Array;
    readonly portal: Uint32Array;
    readonly material: Uint32Array;
    /** Answer k as cast() gives it, an object of its own; null when there is no such answer. */
    hit(k: number): Hit | null;
}

/** A face or a closed portal near a point: one of `face` and `portal` is null. */
export interface Near {
    /** The nearest of the face. */
    point: Vector3;
    /** Metres. */
    distance: number;
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    portal: number | null;
    material: number;
    feature: Feature;
    featureIndex: number;
}

/** What a sphere overlaps, and the way out. */
export interface Overlap extends Near {
    /**
     * Unit: moved this way by `depth` metres, the sphere touches this face in a point at most. Out of the solid for a
     * centre behind a one-sided face.
     */
    direction: Vector3;
    depth: number;
}

/** Where a cutter goes: turned, scaled, moved. */
export interface Pose {
    position: Vector;
    /** x, y, z, w, of any length but zero; not turned unless given. */
    rotation?: ArrayLike<number>;
    /** Metres a unit of the cutter, > 0; 1 unless given. */
    scale?: number;
}

/** As it comes back. */
export interface FullPose {
    position: Vector3;
    rotation: Quaternion;
    scale: number;
}

export interface CarveOptions {
    /** Adds the cutter instead of taking it away. */
    fill?: boolean;
    /** Name of the material of the faces it leaves; '' unless given. */
    material?: string;
    /**
     * Where the shot came from, metres: what a carving opens between rooms becomes air of the room that this lies in,
     * where it touches that.
     */
    from?: Vector;
    /**
     * Whether to look for pieces that the cut leaves loose: they leave the world within the same edit, and the report
     * has them. Ask for it in all edits of a world, or in none. World.withAnchors() says what holds a piece.
     */
    chunks?: boolean | ChunkOptions;
    /**
     * The number of the edit: 0 or none, the one after the last; or 1 to 2^21 - 1, above that of every edit made before,
     * for worlds that are to agree on it although they may lack others.
     */
    edit?: number;
}

export interface ChunkOptions {
    /** Cubic metres: smaller pieces leave the world too, but are only counted, as crumbs. 0 or none: 0.001. */
    minVolume?: number;
    /** Kilograms a cubic metre, of all of a chunk. 0 or none: of each matter its own. */
    density?: number;
}

export interface CarveReport {
    /** 'nothing': the cutter meets nothing. 'refused': rules, limits or the pose do not allow it. */
    status: 'done' | 'nothing' | 'refused';
    /** Why it was refused; '' when it was not. */
    reason: string;
    /** Always 0, as no cutter is moved. */
    retries: number;
    candidateFaces: number;
    facesCut: number;
    facesRemoved: number;
    facesAdded: number;
    /** That reach into the cutter and are left as they are: liquids, and what may not be carved. */
    facesCastableOnly: number;
    /** Of faces that bound no solid: of which the cutter took a part; that went whole. */
    openTrimmed: number;
    openRemoved: number;
    /** Panes that went whole, each with all its faces. */
    panes: number;
    /** Of `openTrimmed` and `openRemoved`: that stop walkers alone, or shots alone. */
    clips: number;
    /** That it made: holes between rooms. */
    portals: number;
    /** That it made: pockets in rock. */
    rooms: number;
    /** What zones and materials left of the cutter's scale, 0..1. */
    scale: number;
    /** Zones and pieces of the level that may not be carved, and took part of the cutter. */
    cutShort: number;
    /** Cubic metres taken; negative when added. */
    volume: number;
    /** Pieces that came loose, in `loose`, and their cubic metres: not in `volume`. */
    chunks: number;
    chunkVolume: number;
    /** Those that were too small for that: removed, too. */
    crumbs: number;
    crumbVolume: number;
    /** Exact faces read beyond the candidates, to find out what is loose. */
    facesSearched: number;
    /** A handle of its own, to be released; null where nothing came loose. */
    loose: Chunks | null;
    /** Microseconds, `total` their sum. */
    times: Record<'place' | 'gather' | 'cut' | 'label' | 'trace' | 'facets' | 'chunks' | 'tree' | 'total', number>;
}

/** Of a body. */
export interface Mass {
    /** Cubic metres. */
    volume: number;
    /** Kilograms. */
    mass: number;
    /** Of mass, metres. */
    centre: Vector3;
    /** The tensor about the centre, kg m2, a row after the other: nine numbers, symmetric. */
    inertia: number[];
}

/** How much of a chunk is of one matter. */
export interface MatterVolume {
    /** Its number in World.matters() of the world that the chunk left. */
    matter: number;
    /** Cubic metres. */
    volume: number;
}

/** A piece as a body. */
export interface Chunk extends Mass {
    /** Where its frame's origin lay in the world, metres: a point of it lay at origin + point. */
    origin: Vector3;
    faceCount: number;
    /** Bounds in its frame, metres. */
    low: Vector3;
    high: Vector3;
    /** What it is made of, ascending; none of World.pieces(). */
    matters: MatterVolume[];
}

/** Pieces, in an order that is the same everywhere; they never change. */
export interface Chunks extends Handle {
    /** Costs an object for each. */
    list(): Chunk[];
    /**
     * A world of one room around a chunk, in its frame: to cast at, to draw, to cut. Sources, numbers and names of
     * materials and the contact offset are those that it had; rules are the defaults. Costs a look at each of its faces.
     * @throws {FirmaError} OUT_OF_RANGE for one that is not there
     */
    world(chunk: number): World;
}

/** What holds a piece: docs/chunks.md. */
export interface Anchors {
    /** Whether what hangs free now stays by intent; true unless given. */
    hanging?: boolean;
    /** Faces of these hold; names that the world does not have hold nothing. */
    materials?: readonly string[];
    /** Faces that come from these of the level's file hold; of brushes, from these sides. */
    sources?: Words;
    /**
     * Solid that reaches into one of these is held: of a level of brushes, those of Level.anchorVolumes(). One that is
     * empty, or not finite, holds nothing.
     */
    volumes?: readonly { low: Vector; high: Vector }[];
}

export interface Rest {
    cutter: Cutter;
    /** Where it goes. */
    pose: FullPose;
    /** Cubic metres that snapping added; negative where it took some. */
    volumeChange: number;
    /** Triangles that were taken out. */
    mended: number;
}

/** What one edit does; it never changes. */
export interface Command extends Handle {
    facts(): CommandFacts;
    /** A part of a group, as a command of its own. @throws {FirmaError} OUT_OF_RANGE for one that is not there */
    part(part: number): Command;
    /**
     * The same with its poses and `from` quantised, but for turns that are those of the crater's seed (randomTurn()),
     * which take no bytes. Who shoots does this before anybody applies it, himself included: then all cut alike.
     */
    quantised(): Command;
    /**
     * About 25 bytes and the name of the material for a crater with a quantised pose; other cutters are stored whole.
     * @throws {FirmaError} INVALID, TOO_LARGE for numbers that are none, OUT_OF_RANGE for a pose that is not finite
     */
    pack(): Uint8Array<ArrayBuffer>;
}

export interface CommandFacts {
    kind: 'carve' | 'fill' | 'door' | 'group';
    /** Of a group 0. */
    number: number;
    /** Of a group that of its last part, else `number`. */
    lastNumber: number;
    /** Of a group. */
    partCount: number;
    /** Of a door; else null. */
    portal: number | null;
    open: boolean | null;
    /** Of a crater; null for another cutter. */
    shape: Shape | null;
    seed: bigint | null;
    /** Of what carves or fills; else null. */
    pose: FullPose | null;
    options: CarveOptions | null;
}

/** Commands in order, and the world that they begin from, by its hashes. docs/edit_log.md */
export interface EditLog extends Handle {
    /**
     * Puts a command at the end. @throws {FirmaError} as Command.pack(); INVALID for a number that is not above the last
     * one
     */
    append(command: Command): void;
    /** Says what the world's hash is after the commands so far: a replay compares it. */
    checkpoint(world: World): void;
    facts(): LogFacts;
    /** From 0. @throws {FirmaError} OUT_OF_RANGE for one that is not there */
    command(index: number): Command;
    /** Costs the bytes. */
    pack(): Uint8Array<ArrayBuffer>;
    /**
     * The same log with a patch in place of its commands up to a number, which is tried: for players who join late.
     * Costs a replay, and making and applying the patch.
     * @throws {FirmaError} INVALID where `level` is not the world it begins from, or the number is below that of a patch
     *     that it has; MALFORMED where a checkpoint does not hold
     */
    compact(level: World, number: number): EditLog;
    /**
     * The log applied to the level it begins from, in slices; commands with numbers above `lastNumber` are left out.
     * Costs comparing hashes, and a copy of the log.
     */
    replay(level: World, lastNumber?: number): Replay;
}

export interface LogFacts {
    /** hash() of the world it begins from. */
    levelHash: bigint;
    /** Of the same world's rules for carving. */
    rulesHash: bigint;
    /** Edits of the world it begins from: numbers of commands are above it. */
    levelEdits: number;
    commandCount: number;
    checkpointCount: number;
    /** Of the patch that stands for a beginning that was compacted; else 0. */
    patchBytes: number;
    /** Of the last command's edit; levelEdits without any. The next one's is above it. */
    lastNumber: number;
    /** Of the last edit that the patch stands for; 0 without one. */
    patchedNumber: number;
}

export interface Replay extends Handle {
    /** As Job.run(); a patch is applied in one piece. @throws {FirmaError} INVALID for a negative time */
    run(microseconds: number): boolean;
    facts(): ReplayFacts;
    /**
     * The world after the commands that were applied, whether it is finished or not; where it ended early, why.
     * @throws {FirmaError} INVALID for another level or other rules than the log's, and a lastNumber before its patch;
     *     MALFORMED for a checkpoint that does not hold, with the command; as applyPatch()
     */
    result(): World;
}

export interface ReplayFacts {
    finished: boolean;
    /** It, of `commandsInAll`. */
    commandsBehind: number;
    commandsInAll: number;
    /** Commands; of these `done`, `nothing` and `refused`. */
    applied: number;
    done: number;
    nothing: number;
    refused: number;
    /** That were compared and hold. */
    checkpoints: number;
    /** Why it ended early, "place: reason", null where it did not; result() throws that, with a code. */
    error: string | null;
}

/** `world` is always a handle of its own, to be released; of the world before when nothing was done. */
export interface CarveResult {
    world: World;
    report: CarveReport;
}

/** What changed from one world to another: take `removed` out of the faces, put `added` in. Numbers are ascending. */
export interface Diff {
    /** Ids of faces. */
    removed: Uint32Array;
    /** The same faces as the world before had them, with rooms and sources; its face() has their outlines. */
    removedFaces: FaceInfos;
    /** In order of id. */
    added: Faces;
    /** Rooms that a face left or came to, that became part of another, or that one world only has. */
    rooms: Uint32Array;
    /** Portals of both worlds. */
    opened: Uint32Array;
    closed: Uint32Array;
    /** Portals with polygons in one world only. */
    portalsAdded: Uint32Array;
    portalsRemoved: Uint32Array;
    /** Portals of both, with other rooms, polygons or names. */
    portalsChanged: Uint32Array;
    /** Three for each: the cell from tile * tileSize to (tile + 1) * tileSize. */
    tiles: Int32Array;
    /** Bounds of all that changed; low > high when nothing did. */
    low: Vector3;
    high: Vector3;
    /** Too much changed: `tiles` is empty. */
    tooManyTiles: boolean;
}

/** A region that refuses a cut (hardness 1) or shrinks it. */
export interface Zone {
    name?: string;
    low: Vector;
    high: Vector;
    /** 0..1 */
    hardness: number;
}

/** 0 or none takes a limit's default. */
export interface Rules {
    zones?: readonly Zone[];
    /** By the material's number in WorldFacts.materials, 0..1; missing ones are 0. */
    hardness?: Numbers;
    maxFaces?: number;
    maxCandidateFaces?: number;
    maxNewFaces?: number;
    maxCutterTriangles?: number;
    maxPairs?: number;
    maxCorners?: number;
    /** Metres. */
    maxCutterSize?: number;
    /**
     * Rooms become one where open portals that carvings made between them are larger than this share of the walls of the
     * one that has less; never across a closed portal. 0: they stay apart.
     */
    mergeShare?: number;
    /**
     * Whether a carving also takes, of faces that bound no solid (sheets, decals, clips, glass), what lies in the
     * cutter; true unless given. Liquids stay, and what else stops neither walkers nor shots nor sight.
     */
    openFaces?: boolean;
}

export interface RegionHash {
    /** From region * 32 m to (region + 1) * 32 m along each axis. */
    region: Vector3;
    /** Of the faces whose lowest corner lies there. */
    faces: bigint;
    /** Of the solid's corners there. */
    points: bigint;
}

/** A value: it never changes, edits make others that share with it what they did not touch. */
export interface World extends Handle {
    /** Another handle to the same value. */
    copy(): World;
    /**
     * Costs a few walks through the index, for the bounds (more where many faces reach to within a float's rounding of
     * them), and a string for each material.
     */
    facts(): WorldFacts;
    /** The name of a material. @throws {FirmaError} INVALID for one that the world does not have */
    material(material: number): string;
    /**
     * The first room of a name, the first portal of a name; null when there is none. Costs a look at each room or
     * portal, up to the one found.
     */
    findRoom(name: string): number | null;
    findPortal(name: string): number | null;
    /**
     * Of everything the world holds: equal edits in equal order give equal ones on every machine. Kept as edits go:
     * costs a few nanoseconds a material, whatever the faces.
     */
    hash(): bigint;
    /** Of the solid's set of points alone: equal for equal solids, however they came about. Kept as edits go. */
    hashSolid(): bigint;
    /**
     * Whether the solids of two worlds are the same set of points, exactly, however their surfaces are divided. Ids,
     * materials, rooms and faces that are castable only do not count. Different hashes of solids cost nothing; else the
     * cost grows with the faces of what the worlds do not share.
     */
    sameSolid(other: World): boolean;
    /**
     * Of each cube of 32 m with anything in it: so two machines can find where their worlds differ. Kept as edits go:
     * costs the cubes that hold or held anything, whatever the faces.
     */
    hashRegions(): RegionHash[];
    /**
     * Costs all faces, in time and memory, and sorting them.
     * @throws {FirmaError} BROKEN when an invariant of faces, trees or the exact solid does not hold
     */
    check(): void;
    /**
     * The solid's volume, cubic metres (where rock reaches to infinity, minus that of its air), and area, square
     * metres. Costs all faces, in time and memory.
     */
    measure(): { volume: number; area: number };
    /** Bytes that this world holds, those shared with others counted. Grows with all faces, as Firma.memory(). */
    memory(): number;
    /**
     * Copies of all faces, in order of id; of some by a filter, in no particular order. Costs the faces copied, sorting
     * them where it is all, and by a filter the walk through the index down to them.
     * @throws {FirmaError} INVALID for a room that is not there, OUT_OF_RANGE for a box that is not finite
     */
    faces(filter?: FaceFilter): Faces;
    /**
     * Faces one by one, in no particular order, until visit returns false: all of them by {}. What `visit` throws ends
     * it and is thrown. Takes no memory of the module but for a filter. Costs the walk through the index down to the
     * faces, of a room its faces, and each an object and a call out of the module.
     * @returns whether visit let it come to an end: true also where there was no face to show
     * @throws {FirmaError} INVALID for a room that is not there, OUT_OF_RANGE for a box that is not finite
     */
    eachFace(filter: FaceFilter | undefined, visit: (face: Face) => boolean | void): boolean;
    /**
     * The face of a hit, or another. Costs a walk through the index.
     * @throws {FirmaError} INVALID for a miss, and where this world has no such face: cut since, or of another world
     */
    face(ref: FaceRef): Face;
    /**
     * Copies of faces as triangles, for a renderer or another engine's collider. Costs the faces that the options take,
     * sorting them, an object for each (Triangles.sources), and with texture coordinates a search for each.
     * @throws {FirmaError} INVALID for a room that is not there, OUT_OF_RANGE for an origin that is not finite
     */
    triangles(options?: TriangleOptions): Triangles;
    /**
     * A renderer's meshes: copies of all faces as triangles, in a mesh for each cube that has any, in order of place.
     * Costs some microseconds a face.
     * @throws {FirmaError} INVALID for a size, or sizes of textures, that are none
     */
    regionMeshes(options?: RegionMeshOptions): RegionMesh[];
    /**
     * The meshes of the cubes that differ between this world and `after`, another version of the level, as they are in
     * `after`: they replace those of before. A cube that has nothing to draw any more has an empty mesh. Costs the
     * faces that only one of the worlds has, and all faces of those cubes.
     * @throws {FirmaError} INVALID as regionMeshes()
     */
    changedRegionMeshes(after: World, options?: RegionMeshOptions): RegionMesh[];
    /**
     * How the texture lies on a face, as the level's file says it of the face that it was cut from. Of a face that an
     * edit made, and where the file says nothing, its unit is 'metres': straight along the axis nearest to its normal.
     * @param face one of a hit or of faces: costs a walk through the index, and a search among the faces of the file;
     *     or an id: then all faces are searched
     * @throws {FirmaError} INVALID for a face that the world does not have
     */
    texture(face: FaceRef | number): Texture;
    /** Null when the world has no such face. Goes through all faces of the world. */
    findFace(id: number): Face | null;

    /** The table that the world was made by. Costs a copy of it. */
    matters(): WholeMatterTable;
    /**
     * What a place is made of, whether or not a cut has made air of it since: the number of a matter. Where pieces of
     * the level overlap, one that may not be carved wins, then the lower number. Costs the pieces whose boxes hold it.
     * @throws {FirmaError} OUT_OF_RANGE for a point that is not finite
     */
    matterAt(point: Vector): number;
    /**
     * That of a face of a hit or of faces: of its brush or closed mesh; of a face that an edit made what is just behind
     * its middle. @throws {FirmaError} INVALID for a face that the world does not have
     */
    matterOf(face: FaceRef): number;
    /** Goes through the pieces of the level. */
    countMatters(): MatterCounts;

    /**
     * The first touch. Numbers of the input that are not finite or too large, a negative radius, and a room that is not
     * there give status 'invalid'; a contact offset that is not finite throws INVALID. What casts cost grows with the
     * logarithm of the faces, and with the faces near the path: up to the first touch here, up to any for castAny(), up
     * to where visit ends it for castEach(), along all of it for castAll(). By room it is the faces of the rooms
     * reached alone, and the box of each of their portals; room 'locate' adds locate(). Of many casts castBatch() costs
     * least, as it makes no objects. With `passed` or `passedPortals`, where more than 64 rooms are reached, the cast
     * is made twice.
     */
    cast(input: CastInput, options?: SingleCastOptions): Hit;
    /**
     * More about the face or portal that a cast met. Costs a walk through the index, and another one at an edge.
     * @throws {FirmaError} INVALID for a miss, and where this world has no such face or portal: cut since, or of
     *     another world
     */
    hitInfo(hit: Hit): HitInfo;
    /**
     * Whether there is any touch.
     * @throws {FirmaError} OUT_OF_RANGE for numbers that are non-finite or out of range, INVALID for a room that is not
     *     there
     */
    castAny(input: CastInput, options?: CastOptions): boolean;
    /**
     * Every face and closed portal met along the whole path, by fraction, then id. Costs an object for each, and
     * sorting them; where they are more than some 1,400, the cast is made twice.
     * @throws {FirmaError} OUT_OF_RANGE, INVALID as castAny()
     */
    castAll(input: CastInput, options?: CastOptions): Hit[];
    /**
     * Every face and closed portal that the sphere would meet along the path, as if alone, in no particular order: to
     * filter, to stop early, to collect. What `visit` throws ends the cast and is thrown. Each costs an object and a
     * call out of the module.
     * @param visit returns the fraction up to which to look on: hit.fraction asks for nothing later than this hit; true
     *     or nothing: on as before; false or 0: enough
     * @returns whether visit was given anything @throws {FirmaError} OUT_OF_RANGE, INVALID as castAny()
     */
    castEach(input: CastInput, visit: (hit: Hit) => number | boolean | void, options?: CastOptions): boolean;
    /**
     * Many casts: answer k is what cast() gives for input k. Costs its casts and copying numbers; makes no objects, and
     * no arrays where those of `out` are long enough.
     * @param inputs seven numbers a cast: centre, radius, path; fastest as a Float64Array
     * @param out    a HitBatch whose arrays are used again where they are long enough; it is returned; a call that
     *     fails leaves the answers of before
     */
    castBatch(inputs: Numbers, options?: CountedCastOptions, out?: HitBatch): HitBatch;
    /**
     * Many casts of spheres, capsules or hulls, given as columns: answer k is what cast() gives for cast k. Casts that
     * `progress` left out have status 'invalid'. Costs its casts and copying numbers, some ten thousand casts at a
     * time.
     * @param out as of castBatch()
     * @throws {FirmaError} INVALID for a cast whose hull there is not
     */
    castMany(casts: CastColumns, options?: ManyOptions, out?: HitBatch): HitBatch;
    /**
     * Whether each of many casts touches anything: of each a number, 0 'miss', 1 'hit', 2 'touching', 3 'invalid'. 1
     * also stands for a touch where another face would have said 2. Costs less than castMany().
     * @throws {FirmaError} as castMany()
     */
    castManyAny(casts: CastColumns, options?: ManyOptions): Uint8Array;
    /**
     * Where a hull touches the face or closed portal that it met: up to four points of that, in order around the
     * normal; none for a miss. Of a portal of several polygons those of the one nearest to hit.point.
     * @param hull that was cast
     * @throws {FirmaError} INVALID where this world has no such face or portal: cut since, or of another world
     */
    contactPoints(hull: Hull, hit: Hit): Vector3[];
    /**
     * Faces that a closed ball touches, by id, then closed portals. Costs a walk through the index to the faces near
     * the ball, an object for each that it touches, and sorting them; where these are more than some 2,200, it is asked
     * twice. By room, where any portal of the world is closed, also a look at each portal of the room, as closest().
     * @throws {FirmaError} OUT_OF_RANGE for numbers that are non-finite or out of range, or a negative radius; INVALID
     *     for a room that is not there
     */
    overlap(centre: Vector, radius: number, options?: NearOptions): Overlap[];
    /**
     * The same one by one, in no particular order, until visit returns false. Each costs an object and a call out of
     * the module. @returns whether there were any
     */
    overlapEach(centre: Vector, radius: number, visit: (found: Overlap) => boolean | void, options?: NearOptions): boolean;
    /**
     * The same of a capsule or hull where it is, or a sphere. Of a capsule the nearest point of its segment stands for
     * the centre, and for what is behind a one-sided face its middle; where the segment meets the face itself, and of a
     * hull, the way out is the shortest one. Of a hull `point` is where on the face it still touches when it is out,
     * and `distance` is 0. Costs as a sphere that holds it, and for each face near that what a cast costs.
     * @throws {FirmaError} as overlap()
     */
    overlapShape(shape: MovingShape, options?: NearOptions): Overlap[];
    /** The same one by one, as overlapEach(). */
    overlapShapeEach(shape: MovingShape, visit: (found: Overlap) => boolean | void, options?: NearOptions): boolean;
    /**
     * The nearest point of all faces and closed portals within `reach` metres, anywhere unless given; null when there
     * is none. Costs a walk through the index to the faces about as near as the nearest; a short reach where nothing is
     * near costs least.
     * @throws {FirmaError} OUT_OF_RANGE for numbers that are non-finite or out of range, or a negative reach; INVALID
     *     for a room that is not there
     */
    closest(point: Vector, reach?: number, options?: NearOptions): Near | null;

    /**
     * Where a point is: in the air of a room, in the solid, on its surface. Costs a cast or two; up to eight, and a
     * search of the faces around the point, for one on the surface; among several rooms a look at each for one that
     * sees nothing.
     * @throws {FirmaError} OUT_OF_RANGE for numbers that are non-finite or out of range
     */
    locate(point: Vector): Location;
    /**
     * Costs copying the list of its portals.
     * @throws {FirmaError} INVALID for a room or portal that the world does not have, here and below
     */
    room(room: number): Room;
    /** Costs copying its polygons. */
    portal(portal: number): Portal;
    /**
     * The same world with a door opened or closed, one version on; another handle to this one when it is so already or
     * has no polygons. Costs a few small copies, however many portals and faces there are, and the corners of this portal.
     */
    setPortalOpen(portal: number, open: boolean): World;
    /**
     * The rooms that portals, open or closed, join to a room, ascending. Costs the room's portals, and sorting them.
     */
    neighbours(room: number): number[];
    /**
     * The portals on the way between two rooms that passes the fewest; null when there is none. Goes through the
     * rooms no farther from `to` than `from` is, and their portals; takes memory for each room of the world.
     * @param options `allOpen`: closed ones lead on, too
     */
    path(from: number, to: number, options?: { allOpen?: boolean }): number[] | null;

    /**
     * One edit, exactly where the cutter lies, also where it touches: nothing is moved. A pose with bad numbers, too,
     * is refused in the report, not thrown. The cost grows with the cutter's triangles and with the faces near them
     * (CarveReport.candidateFaces), and with the logarithm of the world's faces; a cutter that touches is cut up to
     * twice; where rooms are joined also with their portals. The material is searched by its name among the world's,
     * and a new one copies their list. Takes memory for what is made anew; all else is shared. withRules() bounds it.
     */
    carve(cutter: Cutter, pose: Pose, options?: CarveOptions): CarveResult;
    /** One edit, in slices of time. Does nothing yet but to search the material. */
    startCarve(cutter: Cutter, pose: Pose, options?: CarveOptions): Job;
    /** Several edits that become one version. */
    edit(): Edit;
    /**
     * As carve(), for any command. The report of a group adds up its parts', with the smallest scale and the chunks of
     * all. Refused, too, where it carves or fills and its number is not above that of the last edit, for a portal that
     * is not there, and for what no command may be. Numbers of doors do not matter here: put them in order first. Costs
     * what its edits cost.
     */
    apply(command: Command): CarveResult;
    /** The same in slices of time. Makes the crater of a seed; all else is left to the job. */
    startApply(command: Command): Job;
    /**
     * The same world with what holds its pieces said anew, of the same version. Edits and files keep it, no hash sees
     * it. A cut that looks for loose pieces in a world of which nothing is said takes the defaults, at this cost: say it
     * when the level is read. Costs all faces, in time and memory.
     */
    withAnchors(anchors?: Anchors): World;
    /**
     * Of the exact solid; all 0 for one without faces, and for one with rock that reaches to infinity. Costs all faces,
     * in time and memory.
     * @param density kilograms a cubic metre @throws {FirmaError} OUT_OF_RANGE for one that is not finite, or negative
     */
    mass(density: number): Mass;
    /**
     * The bodies that the solid is made of, what faces that share edges enclose, each with its hollows: what is left of
     * a chunk that was cut. They stay in this world's frame: their origin is 0. In order of the lowest id of their
     * faces, but rock that reaches to infinity is the first. Costs all faces, and a search among the bodies for each
     * hollow.
     * @param density for their mass; 2000 unless given @throws {FirmaError} as mass()
     */
    pieces(density?: number): Chunks;
    /**
     * What it has in some regions, as bytes for another peer: 12 a face, and a hash of its rooms and portals. Costs the
     * faces there, sorted.
     */
    listFaces(regions: readonly Vector[]): Uint8Array<ArrayBuffer>;
    /**
     * The patch that makes this world out of the one that a list was made of, which is taken as hostile. Costs the faces
     * of the regions, and those around the ones that differ. @throws {FirmaError} MALFORMED for bytes that are no list
     */
    makePatch(list: Bytes, name?: string): Uint8Array<ArrayBuffer>;
    /** The same from a world at hand, whose ids, rules and textures it shares: in the regions where they differ. */
    patchFrom(from: World): Uint8Array<ArrayBuffer>;
    /**
     * The world that a patch makes of this one, which is taken as hostile: of damage, of faces that do not close with
     * those around them, and of any world whose hash is not the one that the patch says, nothing comes. Shares what the
     * patch leaves. Time grows with the patch and with all faces of the world, which are judged as by check().
     * @throws {FirmaError} INVALID for another world than the one it was made for; else as unpackWorld()
     */
    applyPatch(patch: Bytes, name?: string): World;
    /**
     * What changed from this world to `after`. What the two share is not compared: for versions a few edits apart the
     * cost follows the edits, with a walk through the index for each face added; worlds that share nothing cost all
     * faces of both. Tiles cost three numbers for each tile in a changed face's box, and sorting them.
     * @param tileSize metres, at least 1/16; 0 or none: no tiles
     * @throws {FirmaError} INVALID for another tileSize
     */
    diff(after: World, tileSize?: number): Diff;
    /**
     * The same world under other rules for carving; shares all else. Costs the zones and hardnesses.
     * @throws {FirmaError} INVALID for a hardness that is not within 0..1, a box that is empty, a size that is no
     *     length
     */
    withRules(rules: Rules): World;
    /**
     * The bytes of a .firma file. Costs all faces, in time and memory, and sorting them; the bytes are held twice until
     * it returns.
     * @param options `exact: false` leaves the exact part out: the world read back can be cast against, not carved
     */
    pack(options?: { exact?: boolean }): Uint8Array<ArrayBuffer>;
}

/** A shape to carve with; it never changes. */
export interface Cutter extends Handle {}

/** A convex hull or box that can be cast, turned as it is; it never changes. */
export interface Hull extends Handle {
    /** Those of the points that it needs, in no particular order, three numbers each. */
    corners(): Float64Array;
}

export interface Job extends Handle {
    /**
     * Goes on for about so long, and does at least one piece of work (some ten microseconds with a cutter of some
     * hundred triangles, more where placing or judging one of many thousand is the piece); whether it is finished.
     * Infinity: to the end. Browsers tell the time in steps, of 5 or 100 microseconds: it may go on for one longer.
     * @throws {FirmaError} INVALID for a negative time
     */
    run(microseconds: number): boolean;
    /** As of carve(), a new handle each time, whose cost is all. @throws {FirmaError} BAD_CALL before it is finished */
    result(): CarveResult;
}

export interface Edit extends Handle {
    /** On the world as edited so far: as World.carve(), and at its cost. */
    carve(cutter: Cutter, pose: Pose, options?: CarveOptions): CarveReport;
    /**
     * The world as edited so far, one version on. The edit can go on afterwards. Costs the same for any number of
     * edits.
     */
    finish(): World;
}

/** `oldest`, `current`, `newest` are versions; `versions` counts those held, undone ones included. */
export interface StoreFacts {
    oldest: number;
    current: number;
    newest: number;
    versions: number;
    /** Held beside the newest version. */
    bytes: number;
    /** Dropped versions that somebody held when it was last looked. */
    waiting: number;
}

/** The current world and those before it, for undo. Worlds it gives are handles of their own, to be released. */
export interface Store extends Handle {
    /** Costs a handle, whatever the world. */
    current(): World;
    /**
     * Makes `after` the current world; drops what was undone, and the oldest versions beyond the bytes. Costs what the
     * two do not share, and freeing what is dropped.
     * @throws {FirmaError} INVALID, and nothing changed, when `before` (which it was made from) is not the current one,
     *     or the version of `after` is not greater
     */
    publish(before: World, after: World): void;
    /**
     * The world that is current then. Costs a few handles, whatever the versions differ in, and freeing what was
     * dropped and nobody holds any more. @throws {FirmaError} INVALID when there is none
     */
    undo(): World;
    redo(): World;
    /** Costs a binary search among the versions held. @throws {FirmaError} INVALID for a version that is not held */
    at(version: number | bigint): World;
    /** Costs the same however many versions are held. */
    facts(): StoreFacts;
    /**
     * Frees dropped versions that nobody holds any more; how many are still held. Costs a look at each that waits, and
     * what is freed.
     */
    collect(): number;
}
