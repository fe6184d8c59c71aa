// SPDX-License-Identifier: MIT
// Games as one value: what they go by, what happens in them, what is in them.
import { bytes, flag, longWord, mask, number, object, text, vector, word, words } from './arguments.js';
import { Bodies, BODY_KINDS, BodyShape, COUNTS, STEP_KINDS } from './bodies.js';
import { putPose } from './carving.js';
import { Debris } from './debris.js';
import { getDebrisRules, putDebrisRules } from './debris_rules.js';
import { badCall } from './errors.js';
import { getPartEvent } from './fly_scene.js';
import { CORE, Handle, ID, idOf, makeHandle, takeBytes } from './handle.js';
import * as layout from './layout.js';
import { EditLog } from './logs.js';
import { MOTION_KINDS, putPath, WHEN_BLOCKED_NAMES } from './part_paths.js';
import { getMove, getPlayer, PlayerShape, putPlayerAt, RULE_KINDS, SIZE_KINDS, WISH_KINDS } from './players.js';
import { getProjectiles, TERM_KINDS } from './projectiles.js';
import { Parts } from './scenes.js';
import { getMembers, orNull, putMembers, structTable } from './structs.js';
import { World } from './world.js';

const { fresh, toFill } = structTable({
    body: [layout.BODY, 'firma_body_defaults'],
    charge: [layout.CHARGE, 'firma_charge_defaults'],
    explosion: [layout.EXPLOSION],
    facts: [layout.GAME_FACTS],
    part: [layout.GAME_PART, 'firma_game_part_defaults'],
    partState: [layout.GAME_PART_STATE],
    player: [layout.GAME_PLAYER, 'firma_game_player_defaults'],
    playerMove: [layout.PLAYER_MOVE],
    playerSize: [layout.PLAYER_SIZE],
    replay: [layout.GAME_REPLAY],
    report: [layout.GAME_REPORT],
    rules: [layout.GAME_RULES, 'firma_game_rules_defaults'],
    weapon: [layout.WEAPON, 'firma_weapon_defaults'],
    wish: [layout.PLAYER_WISH],
});

const {
    CHARGE,
    EXPLOSION,
    GAME_FACTS,
    GAME_PART,
    GAME_PART_STATE,
    GAME_PLAYER,
    GAME_REPLAY,
    GAME_REPORT,
    GAME_RULES,
    MOTION,
    WEAPON,
} = layout;

const CHARGE_KINDS = { crater: 'number', radius: 'number', impulse: 'number', breakRadius: 'number', maxPieces: 'word' };
const CHARGE_NAMES = [...Object.keys(CHARGE_KINDS), 'shape', 'material'];
const WEAPON_KINDS = {
    lies: 'flag',
    mass: 'number',
    gravity: 'vector',
    paneEnergy: 'number',
    stopSpeed: 'number',
    fuse: 'number',
};
const WEAPON_NAMES = [...Object.keys(WEAPON_KINDS), 'name', 'terms', 'bodies', 'charge'];
const RULES_KINDS = { minChunkVolume: 'number', chunkDensity: 'number', maxBlastSpeed: 'number' };
const RULES_NAMES = [...Object.keys(RULES_KINDS), 'chunks', 'seed', 'bodies', 'debris'];
const PART_NAMES = ['world', 'mask', 'path', 'name', 'entity', 'waits', 'whenBlocked', 'findPortals', 'portals'];
const PLAYER_NAMES = ['shape', 'mass', 'player', 'wish', 'rules'];
const MOVED_NAMES = Object.keys(BODY_KINDS).filter((name) => name !== 'position' && name !== 'rotation');
const MOVED_KINDS = Object.fromEntries(MOVED_NAMES.map((name) => [name, BODY_KINDS[name]]));
const FACT_COUNTS = ['tick', 'explosions', 'weapons', 'parts', 'players', 'projectiles', 'bodies'];
const REPORT_COUNTS = ['edits', 'nothing', 'refused', 'loose', 'broken', 'removed', 'grounded'];
const EXPLOSION_COUNTS = ['broken', 'unfit', 'dust', 'reached', 'pushed'];
const NO_TICK = 0xffffffffffffffffn;

/** Over what is there. @returns the address */
function putCharge(core, lent, at, charge, place) {
    const given = object(charge, place, 'the charge', CHARGE_NAMES);
    putMembers(core, at, CHARGE, CHARGE_KINDS, given, place);
    if (given.shape !== undefined) {
        const shape = layout.SHAPE_NAMES.indexOf(given.shape);
        if (shape < 0) throw badCall(place, `shape must be one of ${layout.SHAPE_NAMES.join(', ')}`);
        core.setU32(at + CHARGE.shape, shape);
    }
    if (given.material !== undefined)
        core.setU32(at + CHARGE.material, lent.text(text(given.material, place, 'material')));
    return at;
}

function getCharge(core, at) {
    return {
        ...getMembers(core, at, CHARGE, CHARGE_KINDS),
        shape: layout.SHAPE_NAMES[core.getU32(at + CHARGE.shape)],
        material: core.text(core.getU32(at + CHARGE.material)),
    };
}

/** @returns the address of the struct */
function putWeapon(core, lent, weapon, place) {
    const given = object(weapon, place, 'the weapon', WEAPON_NAMES);
    const at = fresh(core, 'weapon');
    putMembers(core, at, WEAPON, WEAPON_KINDS, given, place);
    for (const name of ['terms', 'bodies'])
        putMembers(core, at + WEAPON[name], layout.SHOT_TERMS, TERM_KINDS, object(given[name], place, name, Object.keys(TERM_KINDS)), place);
    if (given.name !== undefined) core.setU32(at + WEAPON.name, lent.text(text(given.name, place, 'name')));
    if (given.charge !== undefined && given.charge !== null) {
        core.setU32(at + WEAPON.hasCharge, 1);
        putCharge(core, lent, at + WEAPON.charge, given.charge, place);
    }
    return at;
}

/** @returns the address of the struct */
function putRules(core, rules, place) {
    const given = object(rules, place, 'the rules', RULES_NAMES);
    const at = fresh(core, 'rules');
    putMembers(core, at, GAME_RULES, RULES_KINDS, given, place);
    if (given.chunks !== undefined) core.setU32(at + GAME_RULES.noChunks, 1 - flag(given.chunks, place, 'chunks'));
    if (given.seed !== undefined) core.setU64(at + GAME_RULES.seed, longWord(given.seed, place, 'seed'));
    const bodies = object(given.bodies, place, 'bodies', Object.keys(STEP_KINDS));
    putMembers(core, at + GAME_RULES.bodies, layout.STEP_OPTIONS, STEP_KINDS, bodies, place);
    putDebrisRules(core, at + GAME_RULES.debris, given.debris, place, 'debris');
    return at;
}

function getRules(core, at) {
    return {
        ...getMembers(core, at, GAME_RULES, RULES_KINDS),
        chunks: core.getU32(at + GAME_RULES.noChunks) === 0,
        seed: core.u64[(at + GAME_RULES.seed) >>> 3],
        bodies: getMembers(core, at + GAME_RULES.bodies, layout.STEP_OPTIONS, STEP_KINDS),
        debris: getDebrisRules(core, at + GAME_RULES.debris),
    };
}

/** @returns the address of the struct */
function putPart(core, lent, part, place) {
    if (part === undefined) throw badCall(place, 'the part must be an object');
    const given = object(part, place, 'the part', PART_NAMES);
    const at = fresh(core, 'part');
    core.setU64(at + GAME_PART.world, idOf(given.world, core, place, 'world'));
    if (given.mask !== undefined) core.setU32(at + GAME_PART.mask, mask(given.mask, place));
    if (given.entity !== undefined) core.setU32(at + GAME_PART.entity, word(given.entity, place, 'entity'));
    if (given.name !== undefined) core.setU32(at + GAME_PART.name, lent.text(text(given.name, place, 'name')));
    core.setU32(at + GAME_PART.waits, flag(given.waits, place, 'waits'));
    if (given.whenBlocked !== undefined) {
        const kind = WHEN_BLOCKED_NAMES.indexOf(given.whenBlocked);
        if (kind < 0) throw badCall(place, `whenBlocked must be one of ${WHEN_BLOCKED_NAMES.join(', ')}`);
        core.setU32(at + GAME_PART.whenBlocked, kind);
    }
    if (given.findPortals !== undefined)
        core.setU32(at + GAME_PART.noPortals, 1 - flag(given.findPortals, place, 'findPortals'));
    if (given.portals !== undefined) {
        words(given.portals, undefined, place, 'the portals');
        core.setU32(at + GAME_PART.portals, lent.words(given.portals));
        core.setU32(at + GAME_PART.portalCount, given.portals.length);
    }
    if (given.path !== undefined) core.setU32(at + GAME_PART.path, putPath(core, lent, given.path, place));
    return at;
}

const putWishAt = (core, at, wish, place) =>
    putMembers(core, at, layout.PLAYER_WISH, WISH_KINDS, object(wish, place, 'the wish', Object.keys(WISH_KINDS)), place);

/** @returns the address of the struct */
function putGamePlayer(core, player, place) {
    if (player === undefined) throw badCall(place, 'the player must be an object');
    const given = object(player, place, 'the player', PLAYER_NAMES);
    const at = fresh(core, 'player');
    core.setU64(at + GAME_PLAYER.shape, idOf(given.shape, core, place, 'player shape'));
    if (given.mass !== undefined) core.setF64(at + GAME_PLAYER.mass, number(given.mass, place, 'mass'));
    putPlayerAt(core, at + GAME_PLAYER.player, given.player, place);
    putWishAt(core, at + GAME_PLAYER.wish, given.wish, place);
    const rules = object(given.rules, place, 'the rules', Object.keys(RULE_KINDS));
    putMembers(core, at + GAME_PLAYER.rules, layout.PLAYER_RULES, RULE_KINDS, rules, place);
    return at;
}

/** What fn(at, capacity, core.at.out) writes: asked for how many there are first. @returns get(address) of each */
function listOf(core, sizeof, fn, get) {
    fn(0, 0);
    const count = core.getU32(core.at.out);
    return core.borrow((lent) => {
        const at = lent.take(count * sizeof);
        fn(at, count);
        return Array.from({ length: count }, (_, k) => get(at + k * sizeof));
    });
}

export class Game extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_game_release');
    }

    static begin(core, level, rate) {
        const world = idOf(level, core, 'game', 'world');
        return new Game(core, makeHandle(core, 'firma_game_begin', world, word(rate, 'game', 'the rate')));
    }

    #make(name, ...args) {
        return makeHandle(this[CORE], name, this[ID], ...args);
    }

    copy() {
        return new Game(this[CORE], this.#make('firma_game_copy'));
    }

    facts() {
        const core = this[CORE];
        const at = toFill(core, 'facts');
        core.run('firma_game_get_facts', this[ID], at);
        const facts = { rate: core.getU32(at + GAME_FACTS.rate) };
        for (const name of FACT_COUNTS) facts[name] = core.getCount(at + GAME_FACTS[name]);
        for (const name of ['recorded', 'replay']) facts[name] = core.getU32(at + GAME_FACTS[name]) !== 0;
        return facts;
    }

    // ---- what it goes by

    rules() {
        const core = this[CORE];
        const at = fresh(core, 'rules');
        core.run('firma_game_get_rules', this[ID], at);
        return getRules(core, at);
    }

    setRules(rules) {
        this[CORE].run('firma_game_set_rules', this[ID], putRules(this[CORE], rules, 'setRules'));
    }

    weapon(index) {
        const core = this[CORE];
        const at = fresh(core, 'weapon');
        core.run('firma_game_get_weapon', this[ID], word(index, 'weapon', 'the index'), at);
        return {
            name: core.text(core.getU32(at + WEAPON.name)),
            ...getMembers(core, at, WEAPON, WEAPON_KINDS),
            terms: getMembers(core, at + WEAPON.terms, layout.SHOT_TERMS, TERM_KINDS),
            bodies: getMembers(core, at + WEAPON.bodies, layout.SHOT_TERMS, TERM_KINDS),
            charge: core.getU32(at + WEAPON.hasCharge) === 0 ? null : getCharge(core, at + WEAPON.charge),
        };
    }

    setWeapon(index, weapon) {
        const core = this[CORE];
        word(index, 'setWeapon', 'the index');
        core.borrow((lent) =>
            core.run('firma_game_set_weapon', this[ID], index, putWeapon(core, lent, weapon, 'setWeapon')),
        );
    }

    addWeapon(weapon) {
        const core = this[CORE];
        return core.borrow((lent) => {
            core.run('firma_game_add_weapon', this[ID], putWeapon(core, lent, weapon, 'addWeapon'), core.at.out);
            return core.getU32(core.at.out);
        });
    }

    addPart(part) {
        const core = this[CORE];
        return core.borrow((lent) => {
            core.run('firma_game_add_part', this[ID], putPart(core, lent, part, 'addPart'), core.at.out);
            return core.getU32(core.at.out);
        });
    }

    // ---- what happens

    edit(command) {
        const core = this[CORE];
        core.run('firma_game_edit', this[ID], idOf(command, core, 'edit', 'command'), core.at.out);
        return layout.CARVE_STATUS_NAMES[core.getU32(core.at.out)];
    }

    explode(at, charge) {
        const core = this[CORE];
        vector(at, 3, 'explode', 'the place');
        core.borrow((lent) => {
            const given = putCharge(core, lent, fresh(core, 'charge'), charge, 'explode');
            core.setVector(core.at.input, at);
            core.run('firma_game_explode', this[ID], core.at.input, given);
        });
    }

    fire(weapon, position, velocity) {
        const core = this[CORE];
        word(weapon, 'fire', 'the weapon');
        core.setVector(core.at.input, vector(position, 3, 'fire', 'position'));
        core.setVector(core.at.input + 24, vector(velocity, 3, 'fire', 'velocity'));
        core.run('firma_game_fire', this[ID], weapon, core.at.input, core.at.input + 24);
    }

    addBody(shape, pose, body) {
        const core = this[CORE];
        const id = idOf(shape, core, 'addBody', 'body shape');
        const at = fresh(core, 'body');
        const given = object(body, 'addBody', 'the body', MOVED_NAMES);
        putMembers(core, at, layout.BODY, MOVED_KINDS, given, 'addBody');
        return this.#make('firma_game_add_body', id, putPose(core, pose, 'addBody'), at);
    }

    addPlayer(player) {
        const core = this[CORE];
        core.run('firma_game_add_player', this[ID], putGamePlayer(core, player, 'addPlayer'), core.at.out);
        return core.getU32(core.at.out);
    }

    wish(player, wish) {
        const core = this[CORE];
        word(player, 'wish', 'the player');
        const at = fresh(core, 'wish');
        putWishAt(core, at, wish, 'wish');
        core.run('firma_game_wish', this[ID], player, at);
    }

    setOff(part) {
        this[CORE].run('firma_game_set_off', this[ID], word(part, 'setOff', 'the part'));
    }

    step() {
        this[CORE].run('firma_game_step', this[ID]);
    }

    // ---- what is in it

    world() {
        return new World(this[CORE], this.#make('firma_game_world'));
    }

    log() {
        return new EditLog(this[CORE], this.#make('firma_game_log'));
    }

    parts() {
        return new Parts(this[CORE], this.#make('firma_game_parts'));
    }

    bodies() {
        return new Bodies(this[CORE], this.#make('firma_game_bodies'));
    }

    debris() {
        return new Debris(this[CORE], this.#make('firma_game_debris'));
    }

    /** work(address of the body's name, handle of a snapshot of the bodies). */
    #ofBody(id, place, work) {
        if (typeof id !== 'bigint' || BigInt.asUintN(64, id) !== id)
            throw badCall(place, 'the body must be what addBody() or list() gave, a BigInt');
        const core = this[CORE];
        const bodies = this.#make('firma_game_bodies');
        try {
            core.setU64(core.at.out + 8, id);
            return work(core.at.out + 8, bodies);
        } finally {
            if (!core.stopped) core.run('firma_bodies_release', bodies);
        }
    }

    bodyShape(id) {
        const core = this[CORE];
        return this.#ofBody(
            id,
            'bodyShape',
            (at, bodies) => new BodyShape(core, makeHandle(core, 'firma_bodies_shape', bodies, at)),
        );
    }

    bodySpheres(id) {
        const core = this[CORE];
        const shape = this.bodyShape(id);
        try {
            core.run('firma_body_shape_get_spheres', shape[ID], 0, 0, core.at.out);
            const count = core.getU32(core.at.out);
            return core.borrow((lent) => {
                const at = lent.take(32 * count);
                core.run('firma_body_shape_get_spheres', shape[ID], at, count, core.at.out);
                return core.f64.slice(at >>> 3, (at >>> 3) + 4 * count);
            });
        } finally {
            shape.release();
        }
    }

    bodySolid(id) {
        const core = this[CORE];
        return this.#ofBody(id, 'bodySolid', (at, bodies) => {
            const debris = this.debris();
            try {
                return new World(core, makeHandle(core, 'firma_debris_world', debris[ID], bodies, at));
            } finally {
                debris.release();
            }
        });
    }

    part(index) {
        const core = this[CORE];
        const at = toFill(core, 'partState');
        core.run('firma_game_get_part', this[ID], word(index, 'part', 'the index'), at);
        const started = core.u64[(at + GAME_PART_STATE.started) >>> 3];
        return {
            name: core.text(core.getU32(at + GAME_PART_STATE.name)),
            mask: core.getU32(at + GAME_PART_STATE.mask),
            entity: orNull(core.getU32(at + GAME_PART_STATE.entity)),
            waits: core.getU32(at + GAME_PART_STATE.waits) !== 0,
            atFirstStop: core.getU32(at + GAME_PART_STATE.atFirstStop) !== 0,
            whenBlocked: WHEN_BLOCKED_NAMES[core.getU32(at + GAME_PART_STATE.whenBlocked)],
            started: started === NO_TICK ? null : Number(started),
            motion: getMembers(core, at + GAME_PART_STATE.motion, MOTION, MOTION_KINDS),
        };
    }

    player(index) {
        const core = this[CORE];
        const at = fresh(core, 'player');
        core.run('firma_game_get_player', this[ID], word(index, 'player', 'the index'), at);
        return {
            mass: core.getF64(at + GAME_PLAYER.mass),
            player: getPlayer(core, at + GAME_PLAYER.player),
            wish: getMembers(core, at + GAME_PLAYER.wish, layout.PLAYER_WISH, WISH_KINDS),
            rules: getMembers(core, at + GAME_PLAYER.rules, layout.PLAYER_RULES, RULE_KINDS),
        };
    }

    playerShape(index) {
        const core = this[CORE];
        return new PlayerShape(core, this.#make('firma_game_player_shape', word(index, 'playerShape', 'the index')));
    }

    playerSize(index) {
        const core = this[CORE];
        const shape = this.playerShape(index);
        try {
            const at = toFill(core, 'playerSize');
            core.run('firma_player_shape_get_size', shape[ID], at);
            return getMembers(core, at, layout.PLAYER_SIZE, SIZE_KINDS);
        } finally {
            shape.release();
        }
    }

    projectiles(weapon) {
        const core = this[CORE];
        word(weapon, 'projectiles', 'the weapon');
        core.run('firma_game_projectiles', this[ID], weapon, 0, 0, core.at.out);
        const count = core.getU32(core.at.out);
        return core.borrow((lent) => {
            const at = lent.take(count * layout.PROJECTILE.sizeof);
            core.run('firma_game_projectiles', this[ID], weapon, at, count, core.at.out);
            return getProjectiles(core, at, count);
        });
    }

    // ---- what happened

    report() {
        const core = this[CORE];
        const at = toFill(core, 'report');
        core.run('firma_game_get_report', this[ID], at);
        const report = {};
        for (const name of REPORT_COUNTS) report[name] = core.getCount(at + GAME_REPORT[name]);
        report.refusal = core.text(core.getU32(at + GAME_REPORT.refusal));
        report.bodies = {};
        for (const name of COUNTS)
            report.bodies[name] = core.getCount(at + GAME_REPORT.bodies + layout.STEP_REPORT[name]);
        const [moves, blasts] = ['moves', 'blasts'].map((name) => core.getCount(at + GAME_REPORT[name]));
        report.moves = Array.from({ length: moves }, (_, k) => this.#move(k));
        report.blasts = Array.from({ length: blasts }, (_, k) => this.#blast(k));
        report.shotEvents = this.#shotEvents();
        return report;
    }

    #move(player) {
        const core = this[CORE];
        const at = toFill(core, 'playerMove');
        core.run('firma_game_move', this[ID], player, at);
        return getMove(core, at);
    }

    #blast(index) {
        const core = this[CORE];
        const at = toFill(core, 'explosion');
        core.run('firma_game_blast', this[ID], index, core.at.input, at);
        const place = core.getVector(core.at.input);
        const blast = { at: place, status: layout.CARVE_STATUS_NAMES[core.getU32(at + EXPLOSION.status)] };
        for (const name of EXPLOSION_COUNTS) blast[name] = core.getCount(at + EXPLOSION[name]);
        blast.dustMass = core.getF64(at + EXPLOSION.dustMass);
        ['loose', 'pieces'].forEach((name, list) => {
            blast[name] = listOf(
                core,
                8,
                (ids, capacity) => core.run('firma_game_blast_bodies', this[ID], index, list, ids, capacity, core.at.out),
                (one) => core.u64[one >>> 3],
            );
        });
        return blast;
    }

    #shotEvents() {
        const core = this[CORE];
        core.run('firma_game_shot_events', this[ID], 0, 0, 0, core.at.out);
        const count = core.getU32(core.at.out);
        return core.borrow((lent) => {
            const at = lent.take(count * layout.SHOT_EVENT.sizeof);
            const weapons = lent.take(4 * count);
            core.run('firma_game_shot_events', this[ID], at, weapons, count, core.at.out);
            return Array.from({ length: count }, (_, k) => {
                const one = at + k * layout.SHOT_EVENT.sizeof;
                const { lengths, ...event } = getPartEvent(core, one, []);
                return { weapon: core.getU32(weapons + 4 * k), ...event };
            });
        });
    }

    // ---- hashes, bytes, recordings

    hash() {
        const core = this[CORE];
        core.run('firma_game_hash', this[ID], core.at.out);
        return core.u64[core.at.out >>> 3];
    }

    hashItems(item) {
        const core = this[CORE];
        const kind = layout.GAME_ITEM_NAMES.indexOf(item);
        if (kind < 0) throw badCall('hashItems', `the item must be one of ${layout.GAME_ITEM_NAMES.join(', ')}`);
        core.run('firma_game_hash_items', this[ID], kind, 0, 0, core.at.out);
        const count = core.getU32(core.at.out);
        return core.borrow((lent) => {
            const at = lent.take(4 * count);
            core.run('firma_game_hash_items', this[ID], kind, at, count, core.at.out);
            return core.u32.slice(at >>> 2, (at >>> 2) + count);
        });
    }

    pack() {
        return takeBytes(this[CORE], this.#make('firma_game_pack'));
    }

    record(level) {
        const core = this[CORE];
        const name = text(level, 'record', 'the level');
        core.borrow((lent) => core.run('firma_game_record', this[ID], lent.text(name)));
    }

    recording() {
        return new Recording(this[CORE], this.#make('firma_game_recording'));
    }

    replayState() {
        const core = this[CORE];
        const at = toFill(core, 'replay');
        core.run('firma_game_get_replay', this[ID], at);
        const replay = {};
        for (const name of ['finished', 'differs', 'atEnd']) replay[name] = core.getU32(at + GAME_REPLAY[name]) !== 0;
        for (const name of ['ticks', 'ticksInAll', 'tick']) replay[name] = core.getCount(at + GAME_REPLAY[name]);
        for (const name of ['hash', 'recorded']) replay[name] = core.u64[(at + GAME_REPLAY[name]) >>> 3];
        replay.text = core.text(core.getU32(at + GAME_REPLAY.text));
        return replay;
    }
}

const { GAME_EVENT, RECORDING_FACTS } = layout;
const own = structTable({ event: [GAME_EVENT], facts: [RECORDING_FACTS] });

/** What was recorded of a game. Beside it, as each makes the other. */
export class Recording extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_recording_release');
    }

    facts() {
        const core = this[CORE];
        const at = own.toFill(core, 'facts');
        core.run('firma_recording_get_facts', this[ID], at);
        const facts = { rate: core.getU32(at + RECORDING_FACTS.rate) };
        for (const name of ['firstTick', 'ticks', 'events']) facts[name] = core.getCount(at + RECORDING_FACTS[name]);
        facts.levelHash = core.u64[(at + RECORDING_FACTS.levelHash) >>> 3];
        facts.level = core.text(core.getU32(at + RECORDING_FACTS.level));
        return facts;
    }

    event(index) {
        const core = this[CORE];
        const at = own.toFill(core, 'event');
        core.run('firma_recording_event', this[ID], word(index, 'event', 'the index'), at);
        return {
            kind: layout.GAME_EVENT_KIND_NAMES[core.getU32(at + GAME_EVENT.kind)],
            tick: core.getCount(at + GAME_EVENT.tick),
            index: core.getU32(at + GAME_EVENT.index),
            position: core.getVector(at + GAME_EVENT.position),
            velocity: core.getVector(at + GAME_EVENT.velocity),
        };
    }

    #game(name, ...args) {
        return new Game(this[CORE], makeHandle(this[CORE], name, this[ID], ...args));
    }

    start() {
        return this.#game('firma_recording_game', 0);
    }

    end() {
        return this.#game('firma_recording_game', 1);
    }

    replay() {
        return this.#game('firma_recording_replay');
    }

    pack() {
        return takeBytes(this[CORE], makeHandle(this[CORE], 'firma_recording_pack', this[ID]));
    }
}

/** What bytes begin as: 'game', 'recording' or 'other'. */
export function kindOfBytes(core, data) {
    const given = bytes(data, 'kindOfBytes', 'the data');
    return core.borrow((lent) => {
        core.run('firma_game_bytes_kind', lent.bytes(given), given.length, core.at.out);
        return layout.BYTES_KIND_NAMES[core.getU32(core.at.out)];
    });
}
