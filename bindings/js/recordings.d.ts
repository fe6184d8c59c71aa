// SPDX-License-Identifier: MIT
// The types of 'firma/recordings': all of 'firma/games', and games as one value: made, stepped, saved, recorded, replayed.
//
// Units, errors and costs as index.d.ts says at its top. The same game given the same events goes through the same bits on
// every machine and in every engine. Memory that runs out within a call stops the module, as everywhere.
import type {
    Bodies,
    BodyId,
    BodyShape,
    BodyState,
    Command,
    EditLog,
    Games,
    Handle,
    LoadOptions,
    Motion,
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
    Shape,
    ShotEvent,
    ShotTerms,
    Source,
    StepOptions,
    StepReport,
    Vector,
    Vector3,
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
export interface GameShotEvent extends Omit<ShotEvent, 'lengths'> {
    weapon: number;
    /** That was met: face, material and matter are then of its world. */
    part: number | null;
    /** `point` in the part's frame, metres; zero of no part. */
    inPart: Vector3;
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
