// SPDX-License-Identifier: MIT
// The types of 'firma/recordings': all of 'firma/games', and games as one value: made, stepped, saved, recorded, replayed;
// debris, blasts, parts that break; what a path goes through, convex pieces, what faces hold.
//
// Units, errors and costs as index.d.ts says at its top. The same game given the same events goes through the same bits on
// every machine and in every engine. Memory that runs out within a call stops the module, as everywhere.
import type {
    Bodies,
    BodyId,
    BodyShape,
    BodyState,
    Breakable,
    CarveOptions,
    CastOptions,
    CarveReport,
    Chunks,
    Command,
    Cutter,
    EditLog,
    FitOptions,
    FlyOptions,
    FlyReport,
    FullPose,
    Games,
    Handle,
    Hit,
    LoadOptions,
    Mass,
    Motion,
    Near,
    Numbers,
    OfPart,
    PartPath,
    Parts,
    Player,
    PlayerLike,
    PlayerMove,
    PlayerRules,
    PlayerShape,
    PlayerSize,
    PlayerWish,
    Pose,
    Projectiles,
    Scene,
    Shape,
    ShotEvent,
    ShotTerms,
    Source,
    Status,
    StepOptions,
    StepReport,
    Vector,
    Vector3,
    WhenBlocked,
    Words,
    World,
} from './games.js';

export type * from './games.js';
export {
    FACE_SOLID,
    FACE_TWO_SIDED,
    FirmaError,
    HitBatch,
    IS_SKY,
    NO_FACE,
    NO_PORTAL,
    Projectiles,
    STOPS_LIQUID,
    STOPS_SHOTS,
    STOPS_SIGHT,
    STOPS_WALK,
} from './games.js';

/**
 * Loads the module of recordings, a new instance of it each time: in place of loadGames(), of which it can do all. Objects of
 * one module cannot be used with another.
 *
 * @param source nothing: the firma_recordings.wasm that comes with the package; else as loadFirma()
 * @throws {FirmaError} as loadFirma()
 */
export function loadRecordings(source?: Source | PromiseLike<Source>, options?: LoadOptions): Promise<Recordings>;

export interface Recordings extends Games {
    /**
     * A game in a level, at tick 0, with the weapons 0 "bullet", 1 "rocket" and 2 "grenade". Where loose pieces are to be held
     * by something else than by default, say so first: World.withAnchors().
     * @param rate ticks a second, 4 to 1,000; 60 unless given @throws {FirmaError} INVALID for another rate
     */
    game(level: World, rate?: number): Game;
    /**
     * The game of the bytes of Game.pack(), taken as hostile; stepped on, it gives the same bits.
     * @throws {FirmaError} as unpackWorld(); MALFORMED for a file with a world alone
     */
    unpackGame(data: ArrayBuffer | ArrayBufferView, name?: string): Game;
    /** The recording of the bytes of Recording.pack(), or of a .firmarec file; as unpackGame(). */
    unpackRecording(data: ArrayBuffer | ArrayBufferView, name?: string): Recording;
    /** What bytes begin as; 'other': a world alone, too. Reads the head alone. */
    kindOfBytes(data: ArrayBuffer | ArrayBufferView): 'other' | 'game' | 'recording';

    /**
     * Where bodies are, or go within `seconds`, for many casts at them: they go on as they move meanwhile, straight and
     * turning evenly, whatever they meet; 0, or not given: they stand. It holds what it needs: the bodies may change, or be
     * released. Costs a sort of the bodies. @throws {FirmaError} OUT_OF_RANGE for seconds that are not finite or below 0
     */
    bodyIndex(bodies: Bodies, seconds?: number): BodyIndex;
    /**
     * The first touch of a set of spheres, which may turn on its way, with a world. Of one that does not turn it is that of
     * each sphere's own cast, the smallest fraction, then the lowest number; of one that turns it is at most 0.06 mm
     * early, and at most 0.03 mm late, where an arc turns away from a face it has just begun to come nearer to. `room` of
     * the options has to hold all of the set. Status 'invalid' as World.cast(), and for a rotation of zero or a turn beyond
     * 2^20 radians; 'miss' for no sphere. Costs a look for what a sphere around all of it comes near; where that finds
     * anything, a cast for each sphere, when turning one for each piece of its arc that comes near anything.
     * @param spheres four numbers each: centre, radius >= 0, metres, in the frame that moves
     * @throws {FirmaError} TOO_LARGE for more than 4,096
     */
    castSet(world: World, spheres: Numbers, motion: Motion, options?: CastOptions): SetHit;
    /** The same in a level with parts, which move meanwhile: what castScene() says of these holds here. */
    castSetScene(scene: Scene, spheres: Numbers, motion: Motion, options?: CastOptions): SetPartHit;
    /** The first touch of two sets, which move at once. All else as castSet(); costs the pairs of spheres that come near each other. */
    castSetPair(a: Numbers, motionA: Motion, b: Numbers, motionB: Motion): SetPairHit;
    /**
     * Spheres that cover a world's solid from inside: of a closed mesh, a chunk, a part; for bodyShape(), with World.mass().
     * Four numbers each, largest first, in the world's frame. `error`: metres that a point of the surface may be from the
     * nearest sphere; more than maxError where maxSpheres did not do, or a thin edge has no room for spheres near it. Costs
     * some thousand searches for nearest facets, and their product with the surface's points.
     * @throws {FirmaError} INVALID for a world without solid, with rock that reaches to infinity, or without room for any
     *     sphere, and for bad options
     */
    fitSpheres(world: World, fit?: FitOptions): { spheres: Float64Array; error: number };
    /**
     * The nearest point of a level and its parts, the parts where they are at a fraction of the scene's stretch; null where
     * there is none within `reach`. Costs a search in the level, and in each part that may be nearer.
     * @throws {FirmaError} as World.closest(); OUT_OF_RANGE for a fraction or a stretch that is none
     */
    closestInScene(scene: Scene, point: Vector, options?: SceneClosestOptions): SceneNear | null;

    /** No debris yet: it is kept beside a list of bodies. */
    debris(): Debris;
    /** How a matter of a world breaks: bricks, splinters, shards, lumps. @throws {FirmaError} INVALID for a matter that the world does not have */
    fracturePattern(world: World, matter: number): Required<FracturePattern>;
    /**
     * Breaks a world's solid into pieces that fill it exactly: chunks in its frame, their origins 0, their matters not told.
     * Costs two subtractions a crack.
     * @throws {FirmaError} INVALID for a world without solid or with rock that reaches to infinity, and for a pattern or
     *     options out of range; OUT_OF_RANGE at the world's rim
     */
    fracture(world: World, pattern: FracturePattern, options?: FractureOptions): Chunks;

    /**
     * What is left of a blast at a distance: (1 - distance / radius)^2, 0 from the radius on.
     * @throws {FirmaError} OUT_OF_RANGE for a distance that is not finite, or negative, and for a blast out of range; likewise below
     */
    blastShare(blast: Blast, distance: number): number;
    /**
     * The push that a blast gives at a point: newton seconds.
     * @param area square metres that face it, >= 0 @param seen 0..1, the share that is not covered; 1 unless given
     */
    blastImpulse(blast: Blast, point: Vector, area: number, seen?: number): Vector3;
    /**
     * The share of spheres that is seen from a point, 0..1; 0 of none. Costs five rays a sphere. Closed portals and the fronts
     * of faces cover, of parts from where they are as the scene's stretch begins.
     * @param spheres four numbers each: centre, radius, metres @param mask of faces that cover; all unless given
     * @throws {FirmaError} OUT_OF_RANGE for a number that is not finite, or a radius below 0
     */
    exposure(scene: Scene, from: Vector, spheres: Numbers, mask?: number): number;
    /** Pushes all bodies near a blast, weaker farther away, and by what stands before them. */
    pushBlast(scene: Scene, bodies: Bodies, blast: Blast, options?: PushOptions): PushReport;

    /** A part's solid, in its frame: to draw after carvePart(). @throws {FirmaError} OUT_OF_RANGE for a part that is not there, and below */
    partWorld(parts: Parts, part: number): World;
    /** The portals of a level that a part closes where its motion begins, ascending: for a door that is shut, World.setPortalOpen(). */
    partPortals(parts: Parts, part: number, level: World): number[];
    /**
     * What a part bears, a plain object that the program keeps: matter null, health 0, maxTaken 0.5, damage 0, whole its
     * volume. Give it a health. Costs its faces.
     */
    breakable(parts: Parts, part: number): Breakable;
    /** The first time after `seconds` at which a part arrives at, or leaves, a stop; Infinity where there is none. @throws as pathPose() */
    pathNextStop(path: PartPath, seconds: number): number;
    /**
     * Takes from its health. `breaks`: this used it up: call Debris.breakPart().
     * @param breakable stays as it is @throws {FirmaError} OUT_OF_RANGE for a damage that is not finite, or negative
     */
    hurt(breakable: Breakable, damage: number): { breakable: Breakable; breaks: boolean };
    /**
     * The share of a blast that a part feels at its nearest point, 0..1; 0 where the level stands before that.
     * @param fraction of the part's motion; 0 unless given @throws {FirmaError} OUT_OF_RANGE for a fraction out of 0..1
     */
    blastFelt(parts: Parts, part: number, level: World, blast: Blast, fraction?: number): number;

    /**
     * fly() among parts that go along the scene's stretch of their motions meanwhile. They are met by the velocity that their
     * surfaces see; what stops at one goes along with it until the step ends. Without parts the answers have the same bits.
     * @throws {FirmaError} as fly(); OUT_OF_RANGE for a stretch that is none; INVALID for a part that goes faster than 2^60 m/s
     */
    flyScene(projectiles: Projectiles, scene: Scene, seconds: number, options?: SceneFlyOptions): SceneFlyReport;
    /**
     * All solid that a straight path goes through, and the panes, in the order of the path. In and out alternate, exactly;
     * what runs along a face is in the air. docs/projectiles.md has the contract. Costs a cast of all that it meets.
     * @throws {FirmaError} OUT_OF_RANGE for a number that is not finite or too large
     */
    pierce(world: World, way: { start: Vector; path: Vector }, options?: PierceOptions): Piercing;

    /**
     * A world's solid as convex pieces that fill it, for another engine: none crosses another, and their exact volumes add up
     * to its volume. In an order that is the same everywhere; they need no release. Costs microseconds for a box with a notch,
     * a second for some hundred reflex edges.
     * @throws {FirmaError} INVALID for a world without solid or with rock that reaches to infinity, and for options out of
     *     range; TOO_LARGE where it takes more than maxPieces
     */
    convexPieces(world: World, options?: ConvexOptions): ConvexPiece[];
    /** The same of a chunk, in its frame. @throws {FirmaError} OUT_OF_RANGE for one that is not there */
    convexPiecesOfChunk(chunks: Chunks, chunk: number, options?: ConvexOptions): ConvexPiece[];

    /**
     * Which faces hold things: a crate on a bridge, a lamp at a ceiling. Costs the faces near each.
     * @throws {FirmaError} INVALID, with the thing's number, for one that is not finite or out of range
     */
    findSupports(world: World, things: readonly SupportedThing[]): Supports;
}

export interface GameFacts {
    /** Ticks a second. */
    rate: number;
    /** Ticks behind it. */
    tick: number;
    /** So far. */
    explosions: number;
    weapons: number;
    parts: number;
    players: number;
    projectiles: number;
    bodies: number;
    /** It is being recorded. */
    recorded: boolean;
    /** It is a replay. */
    replay: boolean;
}

/** How much debris a game keeps. */
export interface DebrisRules {
    /** 256 unless given. */
    maxBodies?: number;
    /** Of all debris together; 4,096 unless given. */
    maxSpheres?: number;
    /** Seconds: what is older goes, asleep or not; Infinity unless given. */
    maxAge?: number;
    /** Seconds: what sleeps longer goes, or becomes ground; 20 unless given. */
    maxAsleep?: number;
    /** Sleepers become part of the world instead of going. */
    toGround?: boolean;
    /** A tick: each is an edit of the world; 1 unless given. */
    maxToGround?: number;
    /** Cubic metres: what is less goes; 0.01 unless given. */
    minToGround?: number;
    /** Metres: so deep another body may be in what becomes ground; 0.02 unless given. */
    maxOverlap?: number;
}

export interface GameRules {
    /** What carvings leave loose becomes debris; true unless given. */
    chunks?: boolean;
    /** Cubic metres: loose pieces of less are lost; 0.001 unless given. */
    minChunkVolume?: number;
    /** Kilograms a cubic metre; 0, or not given: of each matter. */
    chunkDensity?: number;
    /** Metres a second: a blast gives no body and no player more; 30 unless given. */
    maxBlastSpeed?: number;
    /** Of craters and cracks; 1 unless given. */
    seed?: number | bigint;
    bodies?: StepOptions;
    debris?: DebrisRules;
}

/** What explodes. */
export interface Charge {
    /** Metres, at most 8,192: its crater's mean radius; 0: it leaves none; 1.2 unless given. */
    crater?: number;
    /** Of the crater; 'rocky' unless given. */
    shape?: Shape;
    /** Of the faces that the crater leaves. */
    material?: string;
    /** Metres, above 0: nothing is felt from there on; 6 unless given. */
    radius?: number;
    /** Newton seconds a square metre that faces it; 3,000 unless given. */
    impulse?: number;
    /** Metres: debris in it that it sees breaks; 3 unless given. */
    breakRadius?: number;
    /** That a body breaks into at most, 1 to 4,096; 12 unless given. */
    maxPieces?: number;
}

/** A kind of projectile, and what becomes of it. */
export interface Weapon {
    name?: string;
    /** Kilograms, of a projectile; 0.01 unless given. */
    mass?: number;
    /** 0, 0, -9.81 m/s2 unless given. */
    gravity?: Vector;
    /** Of all matters, and of parts. */
    terms?: ShotTerms;
    bodies?: ShotTerms;
    /** Joules that it takes to go through a pane; none does unless given. */
    paneEnergy?: number;
    /** Metres a second: what an impact leaves slower stops there; 1 unless given. */
    stopSpeed?: number;
    /** Seconds from when it was fired, 0 to 3,600; 10 unless given: then it goes. */
    fuse?: number;
    /** One that stops lies there until its fuse ends; else it goes at once. */
    lies?: boolean;
    /** It goes with this; null or not given: without. */
    charge?: Charge | null;
}

export interface GamePart {
    /** The solid in the part's frame, of one room; shared, so it may be released. */
    world: World;
    /** It stands at the origin unless given. */
    path?: PartPath;
    /** For messages. */
    name?: string;
    /** Met by what shares a bit with it, and with the face; all unless given. */
    mask?: number;
    /** Of the level. */
    entity?: number;
    /** Set off by setOff(), and time 0 of its path is then; else it is tick 0. */
    waits?: boolean;
    /** Where a player or body would be crushed between it and something else it waits, goes back, or goes on ('crushes', unless given). */
    whenBlocked?: WhenBlocked;
    /** Portals that its solid covers at its first stop are closed while it stands there, if it waits; true unless given. */
    findPortals?: boolean;
    /** Besides: portals that are closed while it stands at its first stop. */
    portals?: ArrayLike<number>;
}

export interface GamePartState {
    name: string;
    mask: number;
    entity: number | null;
    waits: boolean;
    /** It stands there: a door that is shut. */
    atFirstStop: boolean;
    whenBlocked: WhenBlocked;
    /** The tick when it was set off; null: never, or it does not wait. */
    started: number | null;
    /** Of the last tick. */
    motion: Required<Motion>;
}

/** A player who comes in. */
export interface GamePlayer {
    /** Kept: it may be released. */
    shape: PlayerShape;
    /** Kilograms: what blasts push; 80 unless given. */
    mass?: number;
    player?: PlayerLike;
    /** From tick to tick, but for `jump`, which is of one tick. */
    wish?: PlayerWish;
    rules?: PlayerRules;
}

/** What a blast did. */
export interface GameBlast {
    /** Where, metres. */
    at: Vector3;
    /** Of its crater. */
    status: 'done' | 'nothing' | 'refused';
    /** Bodies of what came loose, and of its pieces. */
    loose: BodyId[];
    /** Bodies of debris that broke. */
    pieces: BodyId[];
    /** Bodies that broke, of both. */
    broken: number;
    /** Loose pieces that could not be bodies: lost. */
    unfit: number;
    /** Pieces too small to be bodies, and their kilograms. */
    dust: number;
    dustMass: number;
    /** Bodies with a sphere within the radius; of these, those that were pushed. */
    reached: number;
    pushed: number;
}

/** What happened to a projectile of a game. */
export interface GameShotEvent extends Omit<SceneShotEvent, 'lengths'> {
    weapon: number;
}

/** What happened in a tick, and by what happened before it since the tick before. */
export interface GameReport {
    /** Of each player; none before the tick. */
    moves: PlayerMove[];
    /** In order. */
    blasts: GameBlast[];
    /** Of all weapons one after the other; what they went through is not told. */
    shotEvents: GameShotEvent[];
    /** Of the world that were done: they are in the log. */
    edits: number;
    /** That came to nothing. */
    nothing: number;
    refused: number;
    /** Why, of the first that was refused; '' without any. */
    refusal: string;
    /** Bodies of what came loose. */
    loose: number;
    /** Bodies that broke. */
    broken: number;
    /** Bodies that were too old or too many. */
    removed: number;
    /** Bodies that became ground. */
    grounded: number;
    bodies: StepReport;
}

export interface ReplayState {
    /** It is over: after its last tick, or after the first that is not as it was recorded. */
    finished: boolean;
    /** And is another game than was recorded. */
    differs: boolean;
    /** All ticks are as recorded, and the game that the recording ended with is another. */
    atEnd: boolean;
    /** That are as they were recorded, of ticksInAll. */
    ticks: number;
    ticksInAll: number;
    /** Where it differs: so many ticks were behind. */
    tick: number;
    /** Of the replay then, and as recorded. */
    hash: bigint;
    recorded: bigint;
    /** 'tick 37: the hash is ..., recorded is ...; not as recorded: player 0, body 5'; '' where nothing differs. */
    text: string;
}

/**
 * A whole game as one value: a world and the log of what was done to it, parts, players, weapons, projectiles, bodies, debris,
 * rules, and the tick. What happens from outside happens between two ticks; step() goes one tick on. docs/recordings.md.
 *
 * It is as it was made, read or copied; or recorded, from record() on: then setRules(), setWeapon(), addWeapon() and addPart()
 * throw BAD_CALL, as no recording keeps them; or a replay, in which nothing may be done but step().
 */
export interface Game extends Handle {
    /** Another that goes the same way from here, neither recorded nor a replay. Costs its arrays; worlds are shared. */
    copy(): Game;
    facts(): GameFacts;

    rules(): Required<GameRules>;
    /** What is not given is as by default. @throws {FirmaError} OUT_OF_RANGE, INVALID */
    setRules(rules: GameRules): void;
    /** @throws {FirmaError} OUT_OF_RANGE for one that is not there, here and below */
    weapon(index: number): Required<Weapon>;
    /** Another in place of one; what is not given is as by default. @throws {FirmaError} INVALID, naming it, for what is out of range */
    setWeapon(index: number, weapon: Weapon): void;
    /** @returns its number */
    addWeapon(weapon: Weapon): number;
    /** Adds a part at its place at this tick. @returns its number @throws {FirmaError} INVALID for a world of several rooms, or a motion that cannot be used */
    addPart(part: GamePart): number;

    /**
     * An edit of the world, whose numbers are not used: the log's next ones are given. What carvings leave loose becomes debris.
     * Of one that is refused report().refusal tells why, if it is the first.
     */
    edit(command: Command): 'done' | 'nothing' | 'refused';
    /** @throws {FirmaError} OUT_OF_RANGE for a number that is not finite; INVALID for a charge out of range, and below for what is not there */
    explode(at: Vector, charge?: Charge): void;
    /** A projectile starts, in the air. */
    fire(weapon: number, position: Vector, velocity: Vector): void;
    /** A body is put in, the frame of its shape at a pose. @param body how it moves and what it is like */
    addBody(shape: BodyShape, pose: Pose, body?: Omit<BodyState, 'position' | 'rotation'>): BodyId;
    /** @returns its number */
    addPlayer(player: GamePlayer): number;
    /** A player wishes something else from now on. */
    wish(player: number, wish: PlayerWish): void;
    /** A part that waits sets off, if it stands at its first stop; else this is in vain. */
    setOff(part: number): void;
    /** One tick on. Of a replay what was recorded for it, and compares: replayState(). @throws {FirmaError} BAD_CALL for a replay that is over */
    step(): void;

    /** Shared: costs a handle. */
    world(): World;
    /** Snapshots: changing them changes nothing in the game. Each costs a copy of its arrays. */
    log(): EditLog;
    parts(): Parts;
    bodies(): Bodies;
    /** Of the bodies that bodies() gives. */
    debris(): Debris;
    /** Of a body, shared; its spheres, four numbers each, in the frame of its pose. Cost a copy of the bodies, as bodySolid(). @throws {FirmaError} INVALID for one that is not there */
    bodyShape(id: BodyId): BodyShape;
    bodySpheres(id: BodyId): Float64Array;
    /** What a body of debris is made of, as a world in the frame of its pose: to draw. Costs a copy of bodies and debris, and its faces. @throws {FirmaError} INVALID for one that is no debris */
    bodySolid(id: BodyId): World;
    part(index: number): GamePartState;
    player(index: number): { mass: number; player: Player; wish: Required<PlayerWish>; rules: Required<PlayerRules> };
    playerShape(index: number): PlayerShape;
    /** Of spheres how far they reach. */
    playerSize(index: number): Required<PlayerSize>;
    /** Those of a weapon that fly or lie. */
    projectiles(weapon: number): Projectiles;
    /** Of the last tick; where something has happened since, of that alone. */
    report(): GameReport;

    /** Of all that the next ticks depend on. Costs all bodies and players, and World.hash(). */
    hash(): bigint;
    /** 32 bits of each thing of a kind, for comparing two games. */
    hashItems(item: 'world' | 'part' | 'player' | 'projectile' | 'body' | 'debris' | 'rest'): Uint32Array;
    /** The bytes of a .firma file: the same on every machine. Whoever reads worlds reads this one's. */
    pack(): Uint8Array;
    /** From now on all that happens is recorded. @param level what it was read from, for people */
    record(level?: string): void;
    /** What was recorded so far. @throws {FirmaError} BAD_CALL where something has happened since the last tick: step it first */
    recording(): Recording;
    /** @throws {FirmaError} BAD_CALL for a game that is no replay */
    replayState(): ReplayState;
}

export interface RecordingFacts {
    /** Ticks a second. */
    rate: number;
    /** Of the game that it starts with. */
    firstTick: number;
    ticks: number;
    events: number;
    /** World.hash() of the level. */
    levelHash: bigint;
    level: string;
}

/** Something that happened. */
export interface GameEvent {
    kind: 'edit' | 'blast' | 'fire' | 'body' | 'player' | 'wish' | 'part';
    /** So many were behind. */
    tick: number;
    /** Of the weapon, of the player that wishes, of the part; else 0. */
    index: number;
    /** Zero of doors, groups, wishes and parts. */
    position: Vector3;
    /** Of what was fired, of a body or a player that comes in, or wished; else zero. */
    velocity: Vector3;
}

/** Where a game began, what happened to it, its hashes tick by tick, where it ended. */
export interface Recording extends Handle {
    facts(): RecordingFacts;
    /** By tick, in order. @throws {FirmaError} OUT_OF_RANGE for one that is not there */
    event(index: number): GameEvent;
    /** The games that it starts and ended with, to be played on. */
    start(): Game;
    end(): Game;
    /** A game at the start that goes through what was recorded, and compares itself. The recording may be released. */
    replay(): Game;
    /** The bytes of a .firmarec file: the same on every machine. */
    pack(): Uint8Array;
}

// ---- debris

/** What pieces look like. */
export interface FracturePattern {
    /** 'lumps': concrete, rock, splinters; 'bricks': rows along z; 'shards': away from the impact, and across: glass. 'lumps' unless given. */
    style?: 'lumps' | 'bricks' | 'shards';
    /** Metres, above 0, along the pattern's axes; of shards x is how far apart cracks around the impact are, y how wide a shard is. */
    sizeOfPiece: Vector;
    /** By how much of itself a piece is larger a metre from the impact, >= 0; 0 unless given. */
    growth?: number;
    /** 0..1: how crooked cracks are; 0 unless given. */
    crooked?: number;
    /** x, y, z, w: the pattern's axes in the solid's frame; null or not given: found from its flat sides. */
    axes?: ArrayLike<number> | null;
    /** A corner of a brick of an even row, metres; null or not given: the low corner of the solid. */
    brickCorner?: Vector | null;
}

export interface FractureOptions {
    /** 1 to 4,096: cracks end when there are so many; 32 unless given. */
    maxPieces?: number;
    /** Number of the material of the faces along cracks; 0 unless given. */
    material?: number;
    /** Metres: where pieces are smallest; of a world in its frame, of a body in the world. */
    impact?: Vector;
    /** Cubic metres: a piece of less is not divided, and of a body it becomes dust; 0.001 unless given, or 0. */
    minVolume?: number;
    /** Kilograms a cubic metre; 2,400 unless given, or 0. */
    density?: number;
    /** Of crooked cracks; 1 unless given, or 0. */
    seed?: number | bigint;
}

/** A body's own density counts. */
export interface ShatterOptions extends Omit<FractureOptions, 'density'> {
    /** Of a piece, 1 to 4,096; 12 unless given. */
    maxSpheres?: number;
    /**
     * The world that it lies in, of the level that it came from: each piece is of the matter of its place there, and its
     * spheres keep clear of what is solid. Not given: all are of the body's matter.
     */
    world?: World;
}

export interface Shattered {
    /** The bodies in place of the one that broke; that one itself where nothing divided it. */
    pieces: BodyId[];
    /** Pieces too small to be bodies, without room for a sphere, or buried. */
    dust: number;
    /** Planes that divided something; that could not be cut. */
    cracks: number;
    refused: number;
    /** Kilograms, newton seconds, newton metre seconds about where the body's centre of mass was. */
    dustMass: number;
    dustMomentum: Vector3;
    dustAngularMomentum: Vector3;
}

export interface DebrisPiece {
    /** What it is most of: its number in the world that it came from. */
    matter: number;
    /** Where its frame's origin lay there, metres. */
    origin: Vector3;
    /** Seconds, since it is a body of its own; asleep. */
    age: number;
    asleepFor: number;
    /** Of its solid. */
    faceCount: number;
    /** How often what it was part of broke since it left the world. */
    broken: number;
    /** It was to become ground, and could not. */
    neverGround: boolean;
    /** It came off a part of the level. */
    ofPart: boolean;
}

export interface TendRules extends DebrisRules {
    /** Spheres that stay clear of what becomes ground, players say: four numbers each, centre and radius, metres. */
    keepClear?: Numbers;
}

export interface DebrisReport {
    /** Bodies that were removed; that became ground, in the order of fill(). */
    removed: BodyId[];
    toGround: BodyId[];
    /** That could not become ground. */
    refused: number;
    /** That wait, as a body or a player is in the way, or for another call. */
    waiting: number;
}

/**
 * What bodies are made of, kept beside a list of them: every call is given the same list. A copy of both is a snapshot.
 * Calls throw INVALID for a body that is not there, or is no debris.
 */
export interface Debris extends Handle {
    /** Others that go the same way from here, with a copy of the bodies. Costs their array; solids are shared. */
    copy(): Debris;
    /** Of all that the next calls depend on. Costs all of it. */
    hash(): bigint;
    /** A chunk as a body at rest where it came loose, that knows its solid. @throws {FirmaError} as Bodies.addChunk() */
    addChunk(bodies: Bodies, chunks: Chunks, chunk: number, fit?: FitOptions): BodyId;
    get(bodies: Bodies, id: BodyId): DebrisPiece;
    /**
     * Its solid as a world of one room, in the frame of the body's shape: to draw at Bodies.pose(). Materials have no names
     * there: their numbers are those of the world that it came from. Costs its faces.
     */
    world(bodies: Bodies, id: BodyId): World;
    /** Takes the body out, too. */
    remove(bodies: Bodies, id: BodyId): void;
    /**
     * Breaks a body: its pieces take its place, and keep its momentum and angular momentum, dust included.
     * @throws {FirmaError} as fracture(): then all is as it was
     */
    shatter(bodies: Bodies, id: BodyId, pattern: FracturePattern, options?: ShatterOptions): Shattered;
    /**
     * Lets debris age, and keeps it within rules: once a frame, after Bodies.step(). `world`: after all that became ground, a
     * handle of its own.
     * @throws {FirmaError} OUT_OF_RANGE for seconds that are not finite, or negative, and for rules that are not a number, or negative
     */
    tend(bodies: Bodies, world: World, seconds: number, rules?: TendRules): { world: World; report: DebrisReport };
    /**
     * One of the edits of the last tend(): World.carve() with `fill` and these makes it again, for a log. Release the cutter.
     * @throws {FirmaError} OUT_OF_RANGE for one that is not there
     */
    fill(index: number): { cutter: Cutter; pose: FullPose; material: string };
    /**
     * A blast in one call: the crater; what comes loose becomes debris and breaks as its matter does; debris near it that it
     * sees breaks; then all bodies near it are pushed. Where the crater is refused all else happens. `world` is a handle of its own.
     * @param crater null: none, and the world stays the same
     * @param pose of the crater; without one it does not count
     * @throws {FirmaError} OUT_OF_RANGE for a blast or options out of range; INVALID for `carve` that fills
     */
    explode(bodies: Bodies, scene: Scene, blast: Blast, crater: Cutter | null, pose?: Pose, options?: ExplodeOptions): { world: World; report: Explosion };
    /**
     * Breaks a part: its pieces become debris where it stands. The part keeps its number, without a face; portals that it
     * closed are open in `world`, a handle of its own. One without solid breaks into nothing.
     * @throws {FirmaError} OUT_OF_RANGE for a part that is not there, and for options or a breakable out of range; INVALID for
     *     a matter that the part's world does not have
     */
    breakPart(bodies: Bodies, parts: Parts, part: number, level: World, options?: BreakOptions & { breakable?: Breakable }): { world: World; breakable: Breakable | null; report: BreakReport };
    /**
     * Carves a part where it stands. Pieces that nothing holds become bodies; where more than maxTaken was taken, or nothing
     * holds any of it, the rest goes as by breakPart(). `world` is the level after it, a handle of its own.
     * @param pose of the cutter, in the world @throws {FirmaError} as breakPart() and World.carve()
     */
    carvePart(bodies: Bodies, parts: Parts, part: number, level: World, cutter: Cutter, pose: Pose, options?: PartCutOptions): { world: World; breakable: Breakable | null; report: PartCut };
}

// ---- blasts

export interface Blast {
    /** Metres; the origin unless given. */
    at?: Vector;
    /** Metres, above 0: nothing is felt from there on; 6 unless given. */
    radius?: number;
    /** Newton seconds a square metre that faces it, at `at`; 3,000 unless given. */
    impulse?: number;
}

export interface PushOptions {
    /** Faces that stop a blast; all unless given. */
    mask?: number;
    /** Metres a second: a push gives no body more; Infinity is no limit; 30 unless given. */
    maxSpeed?: number;
}

export interface PushReport {
    /** Bodies with a sphere within the radius; of these, those that were not wholly covered. */
    reached: number;
    pushed: number;
}

export interface ExplodeOptions extends PushOptions {
    /** What broke so often does not break again; 3 unless given. */
    maxBroken?: number;
    /** That a body breaks into at most, 1 to 4,096; 12 unless given. */
    maxPieces?: number;
    /** Of a piece, and of what comes loose, 1 to 4,096; 12 unless given. */
    maxSpheres?: number;
    /** Metres around the blast: what is seen in it breaks; 0: nothing does; 3 unless given. */
    breakRadius?: number;
    /** Cubic metres: pieces of less become dust; 0.001 unless given. */
    minVolume?: number;
    /** Of cracks; 1 unless given. */
    seed?: number | bigint;
    /** Of the crater; `chunks` is true unless given. */
    carve?: Omit<CarveOptions, 'fill'>;
}

export interface Explosion extends PushReport {
    /** Of the crater; its `loose` is null. */
    carve: CarveReport;
    /** Bodies of what came loose, and of its pieces. */
    loose: BodyId[];
    /** Bodies of debris that broke. */
    pieces: BodyId[];
    /** Bodies that broke, of both. */
    broken: number;
    /** Chunks that could not be bodies: lost. */
    unfit: number;
    /** Pieces too small to be bodies, and their kilograms. */
    dust: number;
    dustMass: number;
}

// ---- casts at bodies, sets of spheres

/** The first touch with a body. A miss has fraction 1, 'invalid' 0; the rest means something where `hit` is true. */
export interface BodyHit {
    status: Status;
    /** Whether anything was met. */
    hit: boolean;
    /** Of the way. */
    fraction: number;
    /** The contact offset before it, by the speed along the normal; at least 0. */
    safeFraction: number;
    /** Of the sphere that was cast, at the touch, metres. */
    centre: Vector3;
    point: Vector3;
    /** Unit, from the body toward what was cast. */
    normal: Vector3;
    /** Of the body there, metres a second. */
    surfaceVelocity: Vector3;
    /** Of several at one fraction the one that is first in list(). */
    body: BodyId | null;
    /** Its number in the body's shape. */
    bodySphere: number | null;
    /** Its number in the set that was cast; 0 of a single one. */
    sphere: number | null;
}

export interface BodyCastOptions {
    /** Bodies that share a bit are met; all unless given. */
    mask?: number;
    /** Is not met: who casts. */
    except?: BodyId | null;
    /** Metres for safeFraction; below 0 counts as 0; 0.001 unless given. */
    contactOffset?: number;
}

export interface BodyIndex extends Handle {
    /**
     * A sphere, or a ray, of radius 0. It meets the spheres of bodies, not the solids that these stand for; what begins in one
     * meets it at once where it comes nearer to its middle, else not at all. Against bodies that turn a touch is
     * never late, and at most 0.06 mm early. Costs the logarithm of the bodies, and the spheres of those near the way.
     */
    cast(input: { centre: Vector; radius: number; path: Vector }, options?: BodyCastOptions): BodyHit;
    /** The same of a set, as of castSet(). */
    castSet(spheres: Numbers, motion: Motion, options?: BodyCastOptions): BodyHit;
}

/** A hit, and which sphere of the set it was: `centre` is that sphere's. */
export interface SetHit extends Hit {
    /** Null when nothing was touched. */
    sphere: number | null;
}

export interface SetPartHit extends SetHit, OfPart {}

export interface SetPairHit {
    status: Status;
    hit: boolean;
    /** 1 of a miss, 0 of 'invalid'. */
    fraction: number;
    /** Where they touch, metres. */
    point: Vector3;
    /** Unit, from b's sphere toward a's. */
    normal: Vector3;
    sphereA: number | null;
    sphereB: number | null;
}

export interface SceneNear extends Near, OfPart {}

export interface SceneClosestOptions {
    /** Metres; anywhere unless given. */
    reach?: number;
    /** Where the parts are: of the scene's stretch, 0..1; 0 unless given. */
    fraction?: number;
    mask?: number;
    room?: number;
}

// ---- rules of projectiles

/** What a projectile meets. */
export interface ShotImpact {
    /** Metres. */
    point: Vector3;
    /** Unit, toward where it came from. */
    normal: Vector3;
    /** Metres a second, before. */
    velocity: Vector3;
    /** Of the part there, metres a second; zero of no part. */
    surface: Vector3;
    /** Kilograms. */
    mass: number;
    /** Its index. */
    projectile: number;
    /** Null of portals and bodies; of a part of its world. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    portal: number | null;
    body: BodyId | null;
    /** Of the face or portal. */
    material: number;
    /** A face that bounds no solid, or a closed portal. */
    pane: boolean;
    /** That is met; null: none. */
    part: number | null;
}

export interface SceneFlyOptions extends FlyOptions {
    /**
     * In place of `matters`: what a matter (of a body: 0) does in an impact, asked once for the face, and for each matter on
     * the way through. `usual` is `ofBodies` for a body, else `other`; what the rule gives is taken over it, where it gives
     * anything; out of range it stops the projectile. What it throws is thrown once all have flown, and the projectiles stay
     * as they were; bodies do not. It must not call what it was given to.
     */
    rule?: (impact: ShotImpact, matter: number, usual: Required<ShotTerms>) => ShotTerms | undefined | void;
}

// ---- parts that break

export interface BreakOptions {
    /** Of each connected piece, at most, 1 to 4,096; 12 unless given. */
    maxPieces?: number;
    /** Of a piece, 1 to 4,096; 12 unless given. */
    maxSpheres?: number;
    /** It falls as it is. */
    unbroken?: boolean;
    /** In the world, metres: pieces are smallest there. */
    impact?: Vector;
    /** Of the part's motion, 0..1, where it breaks; 0 unless given. */
    fraction?: number;
    /** That its motion takes: pieces go on as it went; 0, or not given: they begin at rest. */
    seconds?: number;
    /** Cubic metres: pieces of less become dust; 0.001 unless given. */
    minVolume?: number;
    /** 1 unless given. */
    seed?: number | bigint;
    /** Portals that are opened as well as those that it covers: that it closed when it was whole. */
    portals?: Words;
}

export interface BreakReport {
    pieces: BodyId[];
    /** Pieces of its solid that could be no bodies: lost. */
    unfit: number;
    /** Pieces too small to be bodies, and their kilograms. */
    dust: number;
    dustMass: number;
    /** Portals that it closed, and that are open now. */
    opened: number;
}

export interface PartCutOptions {
    /** None: nothing breaks, but pieces fall. */
    breakable?: Breakable;
    /** The largest piece is held, by what moves it; else the level's faces hold what touches them. */
    holdLargest?: boolean;
    /** Metres within which a face holds; 1/32 unless given. */
    touch?: number;
    carve?: Omit<CarveOptions, 'fill'>;
    pieces?: BreakOptions;
}

export interface PartCut {
    status: 'done' | 'nothing' | 'refused';
    /** Why it was refused; '' when it was not. */
    reason: string;
    /** Bodies of what the cut left that nothing holds, unbroken. */
    loose: BodyId[];
    /** Such pieces that could be no bodies: lost. */
    unfit: number;
    /** Cubic metres that the cutter took. */
    volume: number;
    /** Portals that it closed before, and that are open now: it has a hole there, or it broke. */
    opened: number;
    /** What was left broke or fell; null where it did not. */
    rest: BreakReport | null;
}

// ---- what a path goes through

/** What happened to a projectile among parts. */
export interface SceneShotEvent extends ShotEvent {
    /** That was met: face, material and matter are then of its world. */
    part: number | null;
    /** `point` in the part's frame, metres; zero of no part. */
    inPart: Vector3;
}
export interface SceneFlyReport extends Omit<FlyReport, 'events'> {
    events: SceneShotEvent[];
}

export interface PierceOptions {
    /** Panes that share a bit are told, and stretches whose face where the path goes in does; all unless given. */
    mask?: number;
    /** Panes are met from behind, too. */
    bothSides?: boolean;
    /** Whether panes are told; true unless given. */
    panes?: boolean;
    /** Whether it is asked what stretches are of; true unless given. */
    matters?: boolean;
}

/** Where a path goes into solid, or comes out. */
export interface PierceEnd {
    /** Of the path, 0..1. */
    fraction: number;
    /** On the path, metres. */
    point: Vector3;
    /** Unit, of the face, out of the solid; zero where there is none. */
    normal: Vector3;
    /** Null where the path starts or ends in the solid, and of a closed portal. */
    face: number | null;
    /** The face's first corner, in steps of 1/262144 m. */
    corner: Vector3;
    material: number;
}

/** A stretch of solid that a path goes through, or a pane, which has no thickness. */
export interface PierceSpan {
    /** Of a pane the same. */
    in: PierceEnd;
    out: PierceEnd;
    /** Metres along the path. */
    thickness: number;
    /** What is of one matter, by fractions of the path; none of panes, and where matters were not asked for. */
    lengths: { from: number; to: number; matter: number }[];
    /** A closed one. */
    portal: number | null;
    /** A face that bounds no solid, or a closed portal. */
    pane: boolean;
    /** The path starts in this solid; ends in it. */
    startsInside: boolean;
    endsInside: boolean;
}

export interface Piercing {
    /** As Hit.status: of an initial overlap where the path starts in solid that is told. */
    status: Hit['status'];
    /** Metres of solid in all that is told. */
    thickness: number;
    /** By the fraction at which they begin. */
    spans: PierceSpan[];
}

// ---- convex pieces

export interface ConvexOptions {
    /** 1 to 16,384; 256 unless given, or 0. */
    maxPieces?: number;
    /** Metres. 0, or not given: each piece is convex. Above: what is convex but for less is one piece, of which its hull is given. */
    maxConcavity?: number;
    /** Kilograms a cubic metre; 2,400 unless given, or 0. */
    density?: number;
}

export interface ConvexFace {
    /** Unit, outward. */
    normal: Vector3;
    /** Metres: normal . p = offset on it. */
    offset: number;
    /** Numbers of its corners, three or more, counter-clockwise seen from outside. */
    corners: number[];
}

/** Mass and volume are of the piece, not of its hull: they add up to the whole's. */
export interface ConvexPiece extends Mass {
    /** The piece is convex, exactly; else corners and faces are those of its hull. */
    exact: boolean;
    /** Cubic metres: of the hull of the corners. */
    hullVolume: number;
    /** Metres: no point of the hull is farther from the piece; 0 of an exact one. */
    overhang: number;
    /** Three numbers each, metres: rounded by at most 3.3 um. */
    corners: Float64Array;
    faces: ConvexFace[];
}

// ---- what faces hold

/** Something that faces may hold: docs/support.md. */
export interface SupportedThing {
    /** The program's number for it; its place in the list unless given. */
    entity?: number;
    /** 'touches': whatever faces its sides touch; 'stands': it is put down first, then what is below; 'hangs': faces as near as the nearest. 'touches' unless given. */
    kind?: 'touches' | 'stands' | 'hangs';
    /** A box, metres. */
    low: Vector;
    high: Vector;
    /** Metres: from a side to what holds it; how far down; how far around; 0 unless given. */
    reach?: number;
    /** Faces that share a bit hold; those that stop walkers unless given, or 0. */
    mask?: number;
}

export interface Support {
    entity: number;
    kind: 'touches' | 'stands' | 'hangs';
    /** That hold it: faces(). */
    faceCount: number;
    /** Square metres that hold it; 0: nothing does. */
    area: number;
    /** Metres that it stands below where it was given. */
    lowered: number;
}

export interface SupportChange {
    /** Its number in the supports. */
    thing: number;
    entity: number;
    /** 'kept': as much holds it as before, or more; 'less'; 'lost': nothing holds it any more. */
    loss: 'kept' | 'less' | 'lost';
    /** Its middle is in solid now: it was filled in. */
    buried: boolean;
    /** How many of the faces that held it went. */
    lost: number;
    /** Square metres that hold it. */
    before: number;
    after: number;
}

/** What holds things in a world; it never changes. */
export interface Supports extends Handle {
    /** How many things. */
    count(): number;
    /** @throws {FirmaError} OUT_OF_RANGE for one that is not there, here and below */
    get(thing: number): Support;
    /** The faces that hold it, by id, and the square metres of each. */
    faces(thing: number): { face: number; area: number }[];
    /**
     * The things whose supporting faces were removed or added between the world that these supports are of and another, by
     * thing; `after`: the supports in that world, a handle of its own.
     * @param was the world that these are of: with it only what is near the difference is searched
     * @throws {FirmaError} INVALID where `was` is another world
     */
    diff(world: World, was?: World): { changes: SupportChange[]; after: Supports };
}
