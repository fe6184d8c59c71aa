// SPDX-License-Identifier: MIT
// The types of 'firma/games': all of 'firma', with what moves: bodies, players, parts of levels, projectiles.
//
// Units, errors and costs as index.d.ts says at its top. Seconds are seconds. Everything here gives the same bits on every
// machine and in every engine.
import type {
    CastInput,
    CastOptions,
    Chunks,
    Firma,
    FullPose,
    Handle,
    Hit,
    LoadOptions,
    Mass,
    MovingShape,
    Numbers,
    Overlap,
    PartPath,
    Pose,
    Quaternion,
    Source,
    Vector,
    Vector3,
    World,
} from './index.js';

export type * from './index.js';
export {
    FACE_SOLID,
    FACE_TWO_SIDED,
    FirmaError,
    HitBatch,
    IS_SKY,
    NO_FACE,
    NO_PORTAL,
    STOPS_LIQUID,
    STOPS_SHOTS,
    STOPS_SIGHT,
    STOPS_WALK,
} from './index.js';

/**
 * Loads the module of games, a new instance of it each time: in place of loadFirma(), of which it can do all. Objects of
 * one module cannot be used with another.
 *
 * @param source nothing: the firma_games.wasm that comes with the package; else as loadFirma()
 * @throws {FirmaError} as loadFirma()
 */
export function loadGames(source?: Source | PromiseLike<Source>, options?: LoadOptions): Promise<Games>;

export interface Games extends Firma {
    /** Of a solid ball around the origin. @param density kilograms a cubic metre @throws OUT_OF_RANGE unless both are above 0 */
    massOfBall(radius: number, density: number): Mass;
    /** Of a solid box around the origin. @param half metres @throws OUT_OF_RANGE unless all are above 0 */
    massOfBox(half: Vector, density: number): Mass;
    /**
     * What bodies are made of, shared by all that are; bodies keep it. Costs the spheres.
     * @param spheres 1 to 4,096, four numbers each: centre, radius > 0, metres
     * @param mass of the solid that they stand for, in the same frame: of massOfBox(), World.mass(), a chunk
     * @throws {FirmaError} INVALID for a number that is not finite, a radius, mass or inertia that is not above zero, none,
     *     and more
     */
    bodyShape(spheres: Numbers, mass: Mass): BodyShape;
    /** An empty list of bodies. */
    bodies(): Bodies;

    /** An empty list of parts. */
    parts(): Parts;
    /**
     * Where a part is at a time, its scale 1; before 0 it stands at its first stop, but for swing and spin. This and the
     * next two cost a copy of the stops. @throws {FirmaError} OUT_OF_RANGE for a time, place or spin that is not finite
     */
    pathPose(path: PartPath, seconds: number): FullPose;
    /** From one time to another, for Parts: both ends are exact, between them it goes evenly. @throws as pathPose() */
    pathMotion(path: PartPath, from: number, to: number): Required<Motion>;
    /** Whether it stands at its first stop: a door that is shut. */
    pathAtFirstStop(path: PartPath, seconds: number): boolean;
    /**
     * The first touch of a shape with the level, or with a part that moves meanwhile; of several at the same fraction the
     * level's, then that of the part with the lowest number. A path of zero is met by parts that come. Against a part that
     * turns a touch is at most 0.06 mm early. `room` of the options is of the level. Costs a cast through the level, a
     * look at each part's bounds, and a cast through each part that is near: of one that turns, some searches for the
     * nearest points with each face near the way. Status 'invalid' as cast(), and for a stretch of the scene that is none.
     */
    castScene(scene: Scene, input: CastInput, options?: CastOptions): SceneHit;
    /** Whether there is any touch. @throws {FirmaError} OUT_OF_RANGE where castScene() has status 'invalid' */
    castSceneAny(scene: Scene, input: CastInput, options?: CastOptions): boolean;
    /**
     * What a shape overlaps, of the level first, then part by part, in no particular order within one.
     * @throws {FirmaError} as World.overlapShape(); OUT_OF_RANGE for a fraction or a stretch that is none
     */
    overlapScene(scene: Scene, shape: MovingShape, options?: SceneNearOptions): SceneOverlap[];

    /** An upright capsule. @throws {FirmaError} INVALID for a size that is none, as of PlayerSize */
    playerCapsule(size?: PlayerSize): PlayerShape;
    /** A box as wide and as deep as twice the radius; it may be lower than it is wide, and does not turn. */
    playerBox(size?: PlayerSize): PlayerShape;
    /**
     * Spheres around a middle axis that leads up from the origin, four numbers each: centre, radius.
     * @param crouched as standing unless given @param up 0, 0, 1 unless given
     * @throws {FirmaError} INVALID for a number that is not finite, a radius that is not above zero, none, more than 4,096
     */
    playerSpheres(standing: Numbers, crouched?: Numbers, up?: Vector): PlayerShape;
    /**
     * Moves a player by one tick, among parts that go along the scene's stretch of their motions meanwhile: part k has to
     * be the same one from tick to tick. Nothing is kept between calls, and `player` stays as it is. Costs two to four
     * casts on plain ground, some more at walls and steps; at most a few hundred where a way out is looked for, and some
     * thousand, milliseconds, where none is near, in the first move in a world alone.
     * @param player what the move before gave; of the first one only its position has to be said
     * @param wish what is wished of it for this tick; none: to stand
     * @param seconds 0 to 1
     * @throws {FirmaError} OUT_OF_RANGE for a number that is not finite or out of range
     */
    movePlayer(scene: Scene, shape: PlayerShape, player: PlayerLike, wish: PlayerWish | undefined, seconds: number, rules?: PlayerRules): PlayerMove;
    /**
     * Whether there is room for a player, its middle in air: for places to begin at. Parts are where they are at `from`
     * of the scene. @throws {FirmaError} OUT_OF_RANGE for a position that is not finite
     */
    playerFits(scene: Scene, shape: PlayerShape, position: Vector, options?: PlayerFitOptions): boolean;

    /**
     * Lets projectiles fly on, those that fly, and says what happened. What is met of `bodies` is pushed once all have
     * flown. Costs a cast for each chord of the way, three more for each impact, two searches for each way through solid,
     * and copying the projectiles.
     * @param seconds above 0, at most 1
     * @throws {FirmaError} OUT_OF_RANGE for seconds that are not, and for a projectile with a number that is not finite or
     *     out of range, with its index; INVALID for options out of range; TOO_LARGE where gravity and maxBow divide the
     *     step into more than 4,096 chords. Then nothing has moved
     */
    fly(projectiles: Projectiles, world: World, seconds: number, options?: FlyOptions): FlyReport;
    /** Of all that the next steps depend on. */
    hashProjectiles(projectiles: Projectiles): bigint;
}

// ---- bodies

/** What bodies are made of. It never changes; bodies keep it when it is released. */
export interface BodyShape extends Handle {}

/**
 * Names a body for as long as it is there; a key of a Map. Calls throw INVALID for a body that is there no more: a name is
 * not used again.
 */
export type BodyId = bigint;

/** What may be set of a body. */
export interface BodyState {
    /** Of the centre of mass, metres. */
    position?: Vector;
    /** x, y, z, w, of the shape's frame; not all zero. */
    rotation?: ArrayLike<number>;
    /** Of the centre of mass, metres a second. */
    velocity?: Vector;
    /** Radians a second, in the world's axes. */
    spin?: Vector;
    /** Newtons, besides gravity; kept from step to step. */
    force?: Vector;
    /** Newton metres. */
    torque?: Vector;
    /** Faces and bodies that share a bit are met; all unless set. */
    mask?: number;
    /** >= 0, 0.6 unless set: of two that touch the geometric mean counts, with the world's. */
    friction?: number;
    /** 0..1, 0.1 unless set: of two that touch the larger counts. */
    restitution?: number;
    /** >= 0, 0.02 unless set: resistance to rolling, in radii of the sphere that rolls. */
    rolling?: number;
    /** Kilograms. This and what follows is told, not taken. */
    mass?: number;
    asleep?: boolean;
    /** A sphere's centre was in solid in the last step. */
    stuck?: boolean;
    /** A part came upon it in the last step, and it could not give way. */
    crushed?: boolean;
}

/** As it comes back. */
export interface Body extends Required<BodyState> {
    position: Vector3;
    rotation: Quaternion;
    velocity: Vector3;
    spin: Vector3;
    force: Vector3;
    torque: Vector3;
}

/** How spheres are fitted into a solid. */
export interface FitOptions {
    /** 1 to 4,096; 64 unless given, or 0. */
    maxSpheres?: number;
    /** Metres that a point of the surface may be from the nearest sphere; unless given, or 0, a twentieth of the chunk's longest side. */
    maxError?: number;
    /** Metres that spheres are inside by; 0 unless given. */
    margin?: number;
}

export interface StepOptions {
    /** At least: 1 to 10,000; 240 unless given. */
    substepsASecond?: number;
    /** Of one body on its way in one step, at most 1,000; 4 unless given. */
    maxBounces?: number;
    /** 0, 0, -9.81 m/s2 unless given. */
    gravity?: Vector;
    /** Of the world, >= 0; 0.6 unless given. */
    contactFriction?: number;
    /** Metres that spheres may sink in; unless given, or 0, the world's. */
    contactOffset?: number;
    /** Metres a second: what moves less at any point is still; 0.05 unless given. */
    sleepSpeed?: number;
    /** Seconds still; Infinity: never; 0.5 unless given. */
    sleepAfter?: number;
}

export interface StepReport {
    awake: number;
    contacts: number;
    /** Bodies that were swept along their way. */
    swept: number;
    bounces: number;
    woken: number;
    /** Bodies with a sphere whose centre is in solid that came where they were: they move out. */
    stuck: number;
    /** Bodies that a part came upon and that could not give way: the part goes over them. */
    crushed: number;
}

/** What was pressed together in the last step. */
export interface BodyContact {
    body: BodyId;
    /** Null: the level or a part. */
    other: BodyId | null;
    /** Metres. */
    point: Vector3;
    /** Unit, toward `body`. */
    normal: Vector3;
    /** Along the normal, newtons. */
    force: number;
    /** Of the level or the part; null of a body or a closed portal. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    portal: number | null;
    /** That the face is of; null: of the level. */
    part: number | null;
}

/**
 * Rigid bodies of spheres that hit a level, parts and each other, come to rest and sleep. They are outside of worlds: a
 * snapshot of a game is a World and a copy of its bodies.
 */
export interface Bodies extends Handle {
    /** Others that go the same way from here: a snapshot. Costs their arrays; shapes are shared. */
    copy(): Bodies;
    /** How many there are. */
    count(): number;
    /** All that are there, in the order of poses(). */
    list(): BodyId[];
    /**
     * A body at rest, its shape's frame at a pose, whose scale does not count.
     * @throws {FirmaError} OUT_OF_RANGE for a pose that is not finite, or a rotation of zero
     */
    add(shape: BodyShape, pose: Pose): BodyId;
    /**
     * A chunk of `report.loose` as a body at rest where it came loose: spheres fitted into its solid, its mass. Costs the
     * fit: some thousand searches for nearest facets, and their product with the surface's points.
     * @throws {FirmaError} OUT_OF_RANGE for a chunk that is not there; INVALID for one without mass, one without room for
     *     spheres, and bad options
     */
    addChunk(chunks: Chunks, chunk: number, fit?: FitOptions): BodyId;
    /** What it touched wakes up. */
    remove(id: BodyId): void;
    get(id: BodyId): Body;
    /**
     * Sets the members that are given, and wakes it with what sleeps with it.
     * @throws {FirmaError} OUT_OF_RANGE for a number that is not finite or out of its range, and a rotation of zero
     */
    set(id: BodyId, body: BodyState): void;
    /** Where its shape's frame is, at scale 1: where to draw what the shape was made of; of a chunk its world. */
    pose(id: BodyId): FullPose;
    /**
     * The same of all, in the order of list(): seven numbers each, position and rotation.
     * @param out is filled and returned when it is long enough; what is beyond stays
     */
    poses(out?: Float64Array): Float64Array;
    /** And what sleeps with it. */
    wake(id: BodyId): void;
    /** A push at a point: newton seconds, metres; wakes it. @throws {FirmaError} OUT_OF_RANGE for what is not finite */
    push(id: BodyId, impulse: Vector, point: Vector): void;
    /**
     * Moves all bodies on, while parts go along the scene's stretch of their motions. No sphere of a body that was clear of
     * the level ends deeper in it than the contact offset, and none passes a wall, at any speed. Bodies do not move parts.
     * Costs the bodies that are awake, with the faces near them.
     * @param seconds above 0; of more than a quarter of a second, a quarter is made
     * @throws {FirmaError} OUT_OF_RANGE for seconds, options and a stretch that are not finite or out of range
     */
    step(scene: Scene, seconds: number, options?: StepOptions): StepReport;
    /** Of the last step, by body, then by `other`. */
    contacts(): BodyContact[];
    /** Of all that the next steps depend on. Costs all of it. */
    hash(): bigint;
}

// ---- parts that move

/** The frame's origin goes straight, at an even pace, while all else turns about it, evenly as well. */
export interface Motion {
    /** Of the origin at the start, metres; the origin unless given. */
    position?: Vector;
    /** x, y, z, w, at the start; not turned unless given, and not all zero. */
    rotation?: ArrayLike<number>;
    /** Of the origin, metres; it stands unless given. */
    path?: Vector;
    /** Axis times angle, radians, in the world's axes; at most 8 long; none unless given. */
    turn?: Vector;
}

export interface Part {
    /** The solid in the part's frame, of one room; shared, so it may be released. */
    world: World;
    /** Met by what shares a bit with it, and with the face; all unless given. */
    mask?: number;
    motion?: Motion;
}

/** Doors, lifts, trains, blades: solids that move. They are known by their numbers, in the order in which they were added. */
export interface Parts extends Handle {
    count(): number;
    /**
     * Puts a part at the end. @returns its number
     * @throws {FirmaError} INVALID for a world of several rooms; OUT_OF_RANGE for a motion with a number that is not finite,
     *     a rotation of zero, or a turn longer than 8
     */
    add(part: Part): number;
    /** Another part in place of one, as after a cut of its world. @throws as add(); OUT_OF_RANGE for one that is not there */
    set(index: number, part: Part): void;
    /**
     * The motions of all parts for this tick, one each: all, or none when one is refused.
     * @throws as add(); INVALID for another count than there are parts
     */
    setMotions(motions: readonly Motion[]): void;
}

/**
 * A level, with the parts that move in it. `from` and `to`, 0 and 1 unless given: which stretch of the parts' motions a
 * question's fractions stand for, 0 <= from <= to <= 1; equal: they stand there.
 */
export type Scene = World | { world: World; parts?: Parts; from?: number; to?: number };

/** What is met or overlapped is of a part, or of the level. */
export interface OfPart {
    /** Null: of the level, or a miss. Face, corner and material are those of the part's world. */
    part: number | null;
    /** Of the part's surface there: metres from fraction 0 to 1 at that pace. */
    surfaceVelocity: Vector3;
}
export interface SceneHit extends Hit, OfPart {}
export interface SceneOverlap extends Overlap, OfPart {}

export interface SceneNearOptions {
    /** Where the parts are: of the scene's stretch, 0..1; 0 unless given. */
    fraction?: number;
    mask?: number;
    room?: number;
}

// ---- players

/** Metres, ends of a capsule included. None may be 0; a capsule's height is at least twice the radius. */
export interface PlayerSize {
    /** 0.3 unless given. */
    radius?: number;
    /** 1.8 unless given. */
    height?: number;
    /** 1.1 unless given. */
    crouchedHeight?: number;
    /** 0, 0, 1 unless given; made unit. */
    up?: Vector;
}

/** What a player is, standing and crouched; it never changes. */
export interface PlayerShape extends Handle {}

/** One player between two moves: plain data, to be copied (structuredClone() takes it), saved and rolled back. */
export interface Player {
    /** Of the feet, metres. */
    position: Vector3;
    /** Metres a second; on the ground over what it stands on. */
    velocity: Vector3;
    /** Of the face that it stands on; with onGround. */
    groundNormal: Vector3;
    /** Of the part that it stands on, at its feet, metres a second. */
    groundVelocity: Vector3;
    /** Of the world that it was last moved in; 0n before. */
    worldHash: bigint;
    /** Faces that share a bit are met; all unless set. */
    mask: number;
    /** Where its middle was last in air; null before. */
    room: number | null;
    /** That it stands on. */
    groundPart: number | null;
    onGround: boolean;
    crouched: boolean;
    /** It overlaps, and no place to go was found. */
    stuck: boolean;
}

/** A player as it is given: what is missing is as of one who is in the air, at rest, at the origin. */
export type PlayerLike = { [Name in keyof Player]?: Player[Name] extends Vector3 ? Vector : Player[Name] };

export interface PlayerWish {
    /** Metres a second; what of it is along `up` does not count. None: 0. */
    velocity?: Vector;
    /** From the ground. */
    jump?: boolean;
    /** As long as it is set, and on as long as there is no room to stand. */
    crouch?: boolean;
    /** It does not walk where the ground is more than PlayerRules.maxDrop lower. */
    careful?: boolean;
}

export interface PlayerRules {
    /** 9.81 m/s2, against `up`. */
    gravity?: number;
    /** A quarter of pi, radians: of faces that it walks on. */
    maxSlope?: number;
    /** 0.45 m: higher steps are walls. */
    stepHeight?: number;
    /** 0.6 m; see PlayerWish.careful. */
    maxDrop?: number;
    /** 0.7 radii: so far beyond an edge its middle may be where nothing is below. */
    overhang?: number;
    /** 4.4 m/s. */
    jumpSpeed?: number;
    /** 60 m/s2. */
    groundAcceleration?: number;
    /** 12 m/s2. */
    airAcceleration?: number;
    /** 0.5 of the speed that is wished. */
    crouchedSpeed?: number;
    /** 4 m: so far at most it is moved out of what came where it was. */
    maxPush?: number;
    /** Metres kept from what it touches; unless given, or 0, the world's. */
    contactOffset?: number;
}

/** What a player touched on its way. */
export interface PlayerContact {
    kind: 'ground' | 'wall' | 'ceiling';
    /** Metres. */
    point: Vector3;
    /** Unit, toward the player. */
    normal: Vector3;
    /** Unit; of ground, of the flattest face there. */
    faceNormal: Vector3;
    /** Null of a closed portal. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    portal: number | null;
    /** That the face is of; null: of the level. */
    part: number | null;
    material: number;
}

/** Where a move led to. */
export interface PlayerMove {
    player: Player;
    /** At most eight. */
    contacts: PlayerContact[];
    /** Metres: the way out of what came where it was, and what it backed off by. */
    pushed: Vector3;
    /** Metres: with the part that it stood on, and out of the way of parts. */
    carried: Vector3;
    /** Metres a second against the ground, where it came down; else 0. */
    landedSpeed: number;
    /** A part that came where it was, the last one. */
    pushedBy: number | null;
    /** A part that it is pressed by without room to give way: it overlaps that, never the level. The game decides what comes of it. */
    crushedBy: number | null;
    jumped: boolean;
    /** Up a step. */
    stepped: boolean;
}

export interface PlayerFitOptions {
    crouched?: boolean;
    /** All unless given. */
    mask?: number;
}

// ---- projectiles

/** 'stopped': at a face, in solid or at a body. 'expired': flew longer than FlyOptions.maxAge, or out of reach, 16,384 m. */
export type ProjectileState = 'flying' | 'stopped' | 'expired';

/** As it comes back. */
export interface Projectile {
    /** Metres. */
    position: Vector3;
    /** Metres a second. */
    velocity: Vector3;
    /** Kilograms. */
    mass: number;
    /** Seconds that it flew. */
    age: number;
    /** Faces, closed portals and bodies that share a bit are met. */
    mask: number;
    /** The caller's, an integer of 32 bits: no answer depends on it. */
    user: number;
    /** Of the world that it flew in last; 0n before. */
    worldHash: bigint;
    state: ProjectileState;
}

/** As it is given. */
export interface ProjectileLike {
    /** To begin with in air; the origin unless given. */
    position?: Vector;
    /** At most 2^20 m/s. */
    velocity?: Vector;
    /** > 0; 0.01 kg unless given. */
    mass?: number;
    age?: number;
    mask?: number;
    user?: number;
    worldHash?: bigint | number;
    state?: ProjectileState;
}

/** Projectiles in a row: data of JavaScript's, of no module, that need no release. A copy is a snapshot. */
export class Projectiles {
    /** None, or a copy. */
    constructor(from?: Projectiles);
    readonly count: number;
    /** @returns its index */
    add(projectile: ProjectileLike): number;
    /** An object of its own. @throws {FirmaError} OUT_OF_RANGE for one that is not there, here and below */
    get(index: number): Projectile;
    /** Sets the members that are given. */
    set(index: number, projectile: ProjectileLike): void;
    /** Three numbers each. @param out is filled and returned when it is long enough; what is beyond stays */
    positions(out?: Float64Array): Float64Array;
    /** Those that do not fly any more leave; the others keep their order and get new indices. @returns how many left */
    removeEnded(): number;
    clear(): void;
    copy(): Projectiles;
}

/** What something does to a projectile that meets it. */
export interface ShotTerms {
    /** Radians between path and face: at less it ricochets; 0: never; 0.25 unless given. */
    ricochetBelow?: number;
    /** 0..1: what is left of the speed along the normal; 0.4 unless given. */
    restitution?: number;
    /** Of the change of speed along the normal, so much is lost along the face; 0.3 unless given. */
    friction?: number;
    /** Newtons: joules that it loses for each metre it goes through; not entered unless given. */
    resistance?: number;
}

export interface FlyOptions {
    /** 0, 0, -9.81 m/s2 unless given. */
    gravity?: Vector;
    /** Of one projectile in one step, 1 to 1,000: with the last one it stops; 8 unless given. */
    maxImpacts?: number;
    /** Metres: no chord of the parabola is farther from it; 0.001 unless given. */
    maxBow?: number;
    /** Seconds; 10 unless given. */
    maxAge?: number;
    /** Metres a second: what an impact leaves slower stops there; 1 unless given. */
    stopSpeed?: number;
    /** Metres through solid: what would take more stops; 4 unless given. */
    maxThickness?: number;
    /** Joules that it takes to go through a pane; none does unless given. */
    paneEnergy?: number;
    /** By number of matter of the world; of what is left out of one, and of those beyond, `other` is taken. */
    matters?: readonly ShotTerms[];
    other?: ShotTerms;
    /** Of bodies; their resistance does not count: what does not ricochet stops. */
    ofBodies?: ShotTerms;
    /** That projectiles meet and push. */
    bodies?: Bodies;
    /** Whether events are told; true unless given. */
    events?: boolean;
}

export interface FlyReport {
    /** How many still do. */
    flying: number;
    chords: number;
    impacts: number;
    /** By time, then projectile, then number. */
    events: ShotEvent[];
}

export interface ShotEvent {
    /** 'entered': went into solid; 'left' or 'stopped' comes next. 'passed': went through a pane. */
    kind: 'ricochet' | 'entered' | 'left' | 'passed' | 'stopped' | 'expired';
    /** Its index. */
    projectile: number;
    /** Among the events of this projectile in this step. */
    number: number;
    /** Seconds from the start of the step. */
    time: number;
    /** Metres; where it stopped or left. */
    point: Vector3;
    /** Unit, of what was met, toward where it came from; of 'left' out of the solid. */
    normal: Vector3;
    /** Metres a second, after it. */
    velocity: Vector3;
    /** Newton seconds that it gave to what it met. */
    impulse: Vector3;
    /** Joules that it lost. */
    energy: number;
    /** Metres that it went through: of 'left', and of 'stopped' in solid. */
    thickness: number;
    /** That was met, or where it came out; null of portals, bodies, and none. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    portal: number | null;
    body: BodyId | null;
    /** Of the face or portal. */
    material: number;
    /** Of the face; of 'left' the last one, of 'stopped' where it stopped. */
    matter: number;
    /** What it went through, in order, by fractions of the way. */
    lengths: { from: number; to: number; matter: number }[];
}
