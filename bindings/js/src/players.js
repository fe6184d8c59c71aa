// SPDX-License-Identifier: MIT
// Players: their shapes, and one tick of one of them.
import { badCall } from './errors.js';
import { Handle, idOf, makeHandle } from './handle.js';
import { noFace } from './hits.js';
import {
    CONTACT_KIND_NAMES,
    PLAYER,
    PLAYER_CONTACT,
    PLAYER_MOVE,
    PLAYER_RULES,
    PLAYER_SIZE,
    PLAYER_WISH,
} from './layout.js';
import { doubles, flag, longWord, mask, number, object, vector } from './arguments.js';
import { fresh, getMembers, orNone, orNull, putMembers, toFill } from './structs.js';
import { putScene } from './scenes.js';

export const SIZE_KINDS = { radius: 'number', height: 'number', crouchedHeight: 'number', up: 'vector' };
const SIZE_NAMES = Object.keys(SIZE_KINDS);
export const WISH_KINDS = { jump: 'flag', crouch: 'flag', careful: 'flag', velocity: 'vector' };
const WISH_NAMES = Object.keys(WISH_KINDS);
const RULE_NAMES = Object.keys(PLAYER_RULES).filter((name) => !['sizeof', 'size', 'reserved'].includes(name));
export const RULE_KINDS = Object.fromEntries(RULE_NAMES.map((name) => [name, 'number']));
const PLAYER_KINDS = {
    position: 'vector',
    velocity: 'vector',
    groundNormal: 'vector',
    groundVelocity: 'vector',
    mask: 'mask',
    onGround: 'flag',
    crouched: 'flag',
    stuck: 'flag',
};
const PLAYER_NAMES = [...Object.keys(PLAYER_KINDS), 'worldHash', 'room', 'groundPart'];

export class PlayerShape extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_player_shape_release');
    }
}

function sizedShape(core, size, name, place) {
    const at = fresh(core, 'playerSize');
    putMembers(core, at, PLAYER_SIZE, SIZE_KINDS, object(size, place, 'the size', SIZE_NAMES), place);
    return new PlayerShape(core, makeHandle(core, name, at));
}

export const playerCapsule = (core, size) => sizedShape(core, size, 'firma_player_shape_capsule', 'playerCapsule');
export const playerBox = (core, size) => sizedShape(core, size, 'firma_player_shape_box', 'playerBox');

export function playerSpheres(core, standing, crouched = [], up = undefined) {
    const place = 'playerSpheres';
    doubles(standing, 4, place, 'the spheres');
    doubles(crouched, 4, place, 'the spheres of the crouched');
    if (up !== undefined) vector(up, 3, place, 'up');
    return core.borrow((lent) => {
        const lists = [standing, crouched].flatMap((list) => [lent.doubles(list), list.length / 4]);
        const upward = up === undefined ? 0 : lent.doubles(up);
        return new PlayerShape(core, makeHandle(core, 'firma_player_shape_spheres', ...lists, upward));
    });
}

export function getPlayer(core, at) {
    return {
        ...getMembers(core, at, PLAYER, PLAYER_KINDS),
        worldHash: core.u64[(at + PLAYER.worldHash) >>> 3],
        room: orNull(core.getU32(at + PLAYER.room)),
        groundPart: orNull(core.getU32(at + PLAYER.groundPart)),
    };
}

/** Over the defaults. @returns the address of the struct */
const putPlayer = (core, player, place) => putPlayerAt(core, fresh(core, 'player'), player, place);

/** Over what is there. @returns the address */
export function putPlayerAt(core, at, player, place) {
    const given = object(player, place, 'the player', PLAYER_NAMES);
    putMembers(core, at, PLAYER, PLAYER_KINDS, given, place);
    const { worldHash, room, groundPart } = given;
    if (worldHash !== undefined) core.setU64(at + PLAYER.worldHash, longWord(worldHash, place, 'worldHash'));
    if (room !== undefined) core.setU32(at + PLAYER.room, orNone(room, place, 'room'));
    if (groundPart !== undefined) core.setU32(at + PLAYER.groundPart, orNone(groundPart, place, 'groundPart'));
    return at;
}

function putWish(core, wish, place) {
    const at = fresh(core, 'playerWish');
    putMembers(core, at, PLAYER_WISH, WISH_KINDS, object(wish, place, 'the wish', WISH_NAMES), place);
    return at;
}

function putRules(core, rules, place) {
    if (rules === undefined) return 0;
    const at = fresh(core, 'playerRules');
    putMembers(core, at, PLAYER_RULES, RULE_KINDS, object(rules, place, 'the rules', RULE_NAMES), place);
    return at;
}

function getContact(core, at) {
    const corner = (at + PLAYER_CONTACT.corner) >>> 2;
    return {
        kind: CONTACT_KIND_NAMES[core.getU32(at + PLAYER_CONTACT.kind)],
        point: core.getVector(at + PLAYER_CONTACT.point),
        normal: core.getVector(at + PLAYER_CONTACT.normal),
        faceNormal: core.getVector(at + PLAYER_CONTACT.faceNormal),
        face: noFace(core.getU32(at + PLAYER_CONTACT.face)),
        corner: Array.from(core.i32.subarray(corner, corner + 3)),
        portal: orNull(core.getU32(at + PLAYER_CONTACT.portal)),
        part: orNull(core.getU32(at + PLAYER_CONTACT.part)),
        material: core.getU32(at + PLAYER_CONTACT.material),
    };
}

export function getMove(core, at) {
    const contacts = [];
    for (let k = 0; k < core.getU32(at + PLAYER_MOVE.contactCount); ++k)
        contacts.push(getContact(core, at + PLAYER_MOVE.contacts + k * PLAYER_CONTACT.sizeof));
    return {
        player: getPlayer(core, at + PLAYER_MOVE.player),
        contacts,
        pushed: core.getVector(at + PLAYER_MOVE.pushed),
        carried: core.getVector(at + PLAYER_MOVE.carried),
        landedSpeed: core.getF64(at + PLAYER_MOVE.landedSpeed),
        pushedBy: orNull(core.getU32(at + PLAYER_MOVE.pushedBy)),
        crushedBy: orNull(core.getU32(at + PLAYER_MOVE.crushedBy)),
        jumped: core.getU32(at + PLAYER_MOVE.jumped) !== 0,
        stepped: core.getU32(at + PLAYER_MOVE.stepped) !== 0,
    };
}

export function movePlayer(core, scene, shape, player, wish, seconds, rules) {
    const place = 'movePlayer';
    if (player === undefined) throw badCall(place, 'the player must be an object');
    const there = putScene(core, scene, place);
    const id = idOf(shape, core, place, 'player shape');
    const from = putPlayer(core, player, place);
    const wished = putWish(core, wish, place);
    number(seconds, place, 'seconds');
    const by = putRules(core, rules, place);
    const at = toFill(core, 'playerMove');
    core.run('firma_move_player', there, id, from, wished, seconds, by, at);
    return getMove(core, at);
}

export function playerFits(core, scene, shape, position, options) {
    const place = 'playerFits';
    const there = putScene(core, scene, place);
    const id = idOf(shape, core, place, 'player shape');
    core.setVector(core.at.input, vector(position, 3, place, 'position'));
    const given = object(options, place, 'the options', ['crouched', 'mask']);
    const crouched = flag(given.crouched, place, 'crouched');
    const bits = given.mask === undefined ? 0xffffffff : mask(given.mask, place);
    core.run('firma_player_fits', there, id, core.at.input, crouched, bits, core.at.out);
    return core.getU32(core.at.out) !== 0;
}
