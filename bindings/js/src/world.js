// SPDX-License-Identifier: MIT
// Worlds: what they are, what they meet, and edits of them.
import { CORE, Handle, ID, idOf, makeHandle, takeBytes } from './handle.js';
import { badCall, FirmaError } from './errors.js';
import { CASTS_AT_ONCE } from './core.js';
import { CAST_INPUT, HIT, NEAR, REGION_HASH, WORLD_FACTS } from './layout.js';
import { doubles, flag, number, object, vector, word } from './arguments.js';
import {
    addCounts,
    clearCounts,
    getHit,
    getHitInfo,
    getHits,
    getNear,
    getOverlap,
    HitBatch,
    putCastOptions,
    putHit,
    putInput,
    putNearOptions,
    reserve,
    withPassed,
} from './hits.js';
import { carve, Edit, Job } from './carving.js';
import { getMass, getPieces, putAnchors } from './chunks.js';
import { applyCommand } from './commands.js';
import { getShownFace, onlyFace, putFaceFilter, putFaceRef, takeDiff, takeFaces } from './faces.js';
import { countMatters, matterAt, matterOf, mattersOf } from './matters.js';
import { takeRegionMeshes } from './regions.js';
import { castMany, castManyAny, contactPoints, isOther, putMover, putMoving } from './movers.js';
import { applyPatch, listFaces, makePatch } from './patches.js';
import { findByName, getNeighbours, getPath, getPortal, getRoom, locate, NO_ROOM } from './rooms.js';
import { putRules } from './rules.js';
import { takeTexture, takeTriangles } from './triangles.js';

/** All of a list whose length is not known before: asks again when there is no room for all. */
function getList(core, ask, bytes, get) {
    let room = Math.floor((CASTS_AT_ONCE * (CAST_INPUT.sizeof + HIT.sizeof)) / bytes);
    let found = ask(core.batch(), room);
    const read = (at) => Array.from({ length: found }, (_, k) => get(core, at + k * bytes));
    if (found <= room) return read(core.batch());
    return core.borrow((lent) => {
        room = found;
        const at = lent.take(room * bytes);
        found = ask(at, room);
        return read(at);
    });
}

/** Throws why nothing could be asked: the room, or else the numbers. */
function notAsked(core, id, options, place) {
    const room = options?.room;
    if (typeof room === 'number' && room < NO_ROOM && core.call('firma_world_room', id, room, core.at.room) !== 0)
        throw new FirmaError('INVALID', `${place}: the world has no room ${room}`);
    throw new FirmaError('OUT_OF_RANGE', `${place}: a number is not finite or too large, or the radius negative`);
}

function overlaps(world, shape, options, place) {
    const core = world[CORE];
    const ask = (at, room) => {
        const mover = putMover(core, shape, place);
        const chosen = putNearOptions(core, options, place);
        core.run('firma_overlap_mover', world[ID], mover, chosen, at, room, core.at.out);
        return core.getU32(core.at.out);
    };
    return getList(core, ask, NEAR.sizeof, getOverlap);
}

function eachOverlap(world, shape, visit, options, place) {
    const core = world[CORE];
    if (typeof visit !== 'function') throw badCall(place, 'visit must be a function');
    const mover = putMover(core, shape, place);
    const chosen = putNearOptions(core, options, place);
    const ask = (at) => (visit(getOverlap(core, at)) === false ? 0 : 1);
    core.runVisited(ask, 'firma_wasm_overlap_mover_each', world[ID], mover, chosen, core.at.out);
    return core.getU32(core.at.out) !== 0;
}

export class World extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_world_release');
    }

    copy() {
        const core = this[CORE];
        return new World(core, makeHandle(core, 'firma_world_copy', this[ID]));
    }

    facts() {
        const core = this[CORE];
        const at = core.at.worldFacts;
        core.run('firma_world_get_facts', this[ID], at);
        const facts = {
            version: core.getCount(at + WORLD_FACTS.version),
            faceCount: core.getCount(at + WORLD_FACTS.faceCount),
            roomCount: core.getCount(at + WORLD_FACTS.roomCount),
            portalCount: core.getCount(at + WORLD_FACTS.portalCount),
            low: core.getVector(at + WORLD_FACTS.low),
            high: core.getVector(at + WORLD_FACTS.high),
            contactOffset: core.getF64(at + WORLD_FACTS.contactOffset),
            materials: [],
            edits: core.getU32(at + WORLD_FACTS.edits),
        };
        const count = core.getU32(at + WORLD_FACTS.materialCount);
        for (let material = 0; material < count; ++material) {
            core.run('firma_world_material', this[ID], material, core.at.out);
            facts.materials.push(core.text(core.getU32(core.at.out)));
        }
        return facts;
    }

    material(material) {
        const core = this[CORE];
        core.run('firma_world_material', this[ID], word(material, 'material', 'the material'), core.at.out);
        return core.text(core.getU32(core.at.out));
    }

    matters() {
        return mattersOf(this);
    }

    matterAt(point) {
        return matterAt(this, point);
    }

    matterOf(face) {
        return matterOf(this, face);
    }

    countMatters() {
        return countMatters(this);
    }

    findRoom(name) {
        return findByName(this[CORE], this[ID], 'room', name);
    }

    findPortal(name) {
        return findByName(this[CORE], this[ID], 'portal', name);
    }

    hash() {
        const core = this[CORE];
        core.run('firma_world_hash', this[ID], core.at.out);
        return core.u64[core.at.out >>> 3];
    }

    hashSolid() {
        const core = this[CORE];
        core.run('firma_world_hash_solid', this[ID], core.at.out);
        return core.u64[core.at.out >>> 3];
    }

    sameSolid(other) {
        const core = this[CORE];
        core.run('firma_world_same_solid', this[ID], idOf(other, core, 'sameSolid', 'world'), core.at.out);
        return core.getU32(core.at.out) !== 0;
    }

    hashRegions() {
        const core = this[CORE];
        const ask = (at, room) => {
            core.run('firma_world_hash_regions', this[ID], at, room, core.at.out);
            return core.getU32(core.at.out);
        };
        return getList(core, ask, REGION_HASH.sizeof, (_, at) => ({
            region: Array.from(core.i32.subarray(at >>> 2, (at >>> 2) + 3)),
            faces: core.u64[(at + REGION_HASH.faces) >>> 3],
            points: core.u64[(at + REGION_HASH.points) >>> 3],
        }));
    }

    check() {
        this[CORE].run('firma_world_check', this[ID]);
    }

    measure() {
        const core = this[CORE];
        const at = core.at.out;
        core.run('firma_world_measure', this[ID], at, at + 8);
        return { volume: core.getF64(at), area: core.getF64(at + 8) };
    }

    memory() {
        return memoryOf(this[CORE], [this]);
    }

    faces(filter) {
        const core = this[CORE];
        if (filter === undefined) return takeFaces(core, makeHandle(core, 'firma_world_faces', this[ID]));
        return core.borrow((lent) => {
            const at = putFaceFilter(core, lent, filter, 'faces');
            return takeFaces(core, makeHandle(core, 'firma_world_faces_in', this[ID], at));
        });
    }

    eachFace(filter, visit) {
        const core = this[CORE];
        if (typeof visit !== 'function') throw badCall('eachFace', 'visit must be a function');
        const ask = (at) => (visit(getShownFace(core, at)) === false ? 0 : 1);
        core.borrow((lent) => {
            const at = putFaceFilter(core, lent, filter, 'eachFace');
            core.runVisited(ask, 'firma_wasm_each_face', this[ID], at, core.at.out);
        });
        return core.getU32(core.at.out) !== 0;
    }

    triangles(options) {
        return takeTriangles(this[CORE], this[ID], options);
    }

    regionMeshes(options) {
        return takeRegionMeshes(this[CORE], 'firma_world_region_meshes', [this[ID]], options, 'regionMeshes');
    }

    changedRegionMeshes(after, options) {
        const core = this[CORE];
        const worlds = [this[ID], idOf(after, core, 'changedRegionMeshes', 'world')];
        return takeRegionMeshes(core, 'firma_world_changed_region_meshes', worlds, options, 'changedRegionMeshes');
    }

    texture(face) {
        return takeTexture(this[CORE], this[ID], face);
    }

    findFace(id) {
        const core = this[CORE];
        word(id, 'findFace', 'the id');
        return onlyFace(takeFaces(core, makeHandle(core, 'firma_world_find_face', this[ID], id)));
    }

    face(ref) {
        const core = this[CORE];
        if (ref === undefined || ref === null) throw badCall('face', 'the face must be one of a hit, or of faces');
        const [face, corner] = putFaceRef(core, ref, 'face');
        return onlyFace(takeFaces(core, makeHandle(core, 'firma_world_face', this[ID], face, corner)));
    }

    cast(input, options) {
        const core = this[CORE];
        const at = core.at.hit;
        const other = isOther(input);
        const given = other ? putMoving(core, input, 'cast')[0] : putInput(core, input, 'cast');
        const chosen = putCastOptions(core, options, 'cast', ['counts', 'passed', 'passedPortals']);
        const counts = clearCounts(core, options, 'cast');
        const code = withPassed(core, options, chosen, (asked) => {
            try {
                if (other) return core.exports.firma_cast_mover(this[ID], given, core.at.input, asked, at, counts);
                return core.exports.firma_cast(this[ID], given, asked, at, counts);
            } catch (error) {
                throw core.stop(error);
            }
        });
        core.refresh();
        if (code !== 0) throw core.failure(code);
        addCounts(core, counts, options);
        return getHit(core, at);
    }

    hitInfo(hit) {
        const core = this[CORE];
        const at = core.at.hitInfo;
        core.run('firma_world_hit_info', this[ID], putHit(core, hit, 'hitInfo'), at);
        return getHitInfo(core, at);
    }

    castAny(input, options) {
        const core = this[CORE];
        const other = isOther(input);
        const given = other ? putMoving(core, input, 'castAny')[0] : putInput(core, input, 'castAny');
        const chosen = putCastOptions(core, options, 'castAny');
        let code;
        try {
            if (other) code = core.exports.firma_cast_mover_any(this[ID], given, core.at.input, chosen, core.at.out);
            else code = core.exports.firma_cast_any(this[ID], given, chosen, core.at.out);
        } catch (error) {
            throw core.stop(error);
        }
        core.refresh();
        if (code !== 0) throw core.failure(code);
        const status = core.getU32(core.at.out);
        if (status === 3) notAsked(core, this[ID], options, 'castAny');
        return status !== 0;
    }

    castAll(input, options) {
        const core = this[CORE];
        const ask = (at, room) => {
            const [mover, path] = putMoving(core, input, 'castAll');
            const chosen = putCastOptions(core, options, 'castAll');
            core.run('firma_cast_mover_all', this[ID], mover, path, chosen, at, room, core.at.out);
            return core.getU32(core.at.out);
        };
        return getList(core, ask, HIT.sizeof, getHit);
    }

    castEach(input, visit, options) {
        const core = this[CORE];
        if (typeof visit !== 'function') throw badCall('castEach', 'visit must be a function');
        const [mover, path] = putMoving(core, input, 'castEach');
        const chosen = putCastOptions(core, options, 'castEach');
        const ask = (at) => {
            const answer = visit(getHit(core, at));
            if (answer === undefined || answer === true) return 1;
            if (answer === false) return 0;
            return number(answer, 'castEach', 'what visit returns');
        };
        const id = this[ID]; // the visitor may release the world
        core.runVisited(ask, 'firma_wasm_cast_mover_each', id, mover, path, chosen, core.at.out);
        const status = core.getU32(core.at.out);
        if (status === 3) notAsked(core, id, options, 'castEach');
        return status !== 0;
    }

    castBatch(inputs, options, out = new HitBatch()) {
        const core = this[CORE];
        doubles(inputs, 7, 'castBatch', 'the inputs');
        if (!(out instanceof HitBatch)) throw badCall('castBatch', 'out must be a HitBatch, as castBatch() returns');
        const numbers = inputs instanceof Float64Array ? inputs : Float64Array.from(inputs);
        const count = numbers.length / 7;
        const chosen = putCastOptions(core, options, 'castBatch', ['counts']);
        const counts = clearCounts(core, options, 'castBatch');
        const given = core.batch();
        const hits = given + CASTS_AT_ONCE * CAST_INPUT.sizeof;
        let begin = 0;
        do {
            const some = Math.min(CASTS_AT_ONCE, count - begin);
            if (some > 0) core.f64.set(numbers.subarray(7 * begin, 7 * (begin + some)), given >>> 3);
            core.run('firma_cast_batch', this[ID], given, some, chosen, hits, counts);
            if (begin === 0) reserve(out, count); // not before: a call that fails leaves `out` as it was
            getHits(core, hits, some, out, begin);
            begin += some;
        } while (begin < count);
        addCounts(core, counts, options);
        out.count = count;
        return out;
    }

    castMany(casts, options, out = new HitBatch()) {
        return castMany(this, casts, options, out);
    }

    castManyAny(casts, options) {
        return castManyAny(this, casts, options);
    }

    contactPoints(hull, hit) {
        return contactPoints(this, hull, hit);
    }

    overlap(centre, radius, options) {
        return overlaps(this, { centre, radius }, options, 'overlap');
    }

    overlapEach(centre, radius, visit, options) {
        return eachOverlap(this, { centre, radius }, visit, options, 'overlapEach');
    }

    overlapShape(shape, options) {
        return overlaps(this, shape, options, 'overlapShape');
    }

    overlapShapeEach(shape, visit, options) {
        return eachOverlap(this, shape, visit, options, 'overlapShapeEach');
    }

    closest(point, reach = Infinity, options = undefined) {
        const core = this[CORE];
        vector(point, 3, 'closest', 'point');
        number(reach, 'closest', 'reach');
        const chosen = putNearOptions(core, options, 'closest');
        core.setVector(core.at.input, point);
        core.run('firma_closest', this[ID], core.at.input, reach, chosen, core.at.near, core.at.out);
        return core.getU32(core.at.out) === 0 ? null : getNear(core, core.at.near);
    }

    locate(point) {
        return locate(this[CORE], this[ID], point);
    }

    room(room) {
        return getRoom(this[CORE], this[ID], room);
    }

    portal(portal) {
        return getPortal(this[CORE], this[ID], portal);
    }

    setPortalOpen(portal, open) {
        const core = this[CORE];
        word(portal, 'setPortalOpen', 'the portal');
        if (typeof open !== 'boolean') throw badCall('setPortalOpen', 'open must be true or false');
        return new World(core, makeHandle(core, 'firma_world_set_portal_open', this[ID], portal, open ? 1 : 0));
    }

    neighbours(room) {
        return getNeighbours(this[CORE], this[ID], room);
    }

    path(from, to, options) {
        return getPath(this[CORE], this[ID], from, to, options);
    }

    carve(cutter, pose, options) {
        return carve(this, cutter, pose, options);
    }

    startCarve(cutter, pose, options) {
        return Job.start(this, cutter, pose, options);
    }

    edit() {
        return Edit.begin(this);
    }

    apply(command) {
        return applyCommand(this, command);
    }

    startApply(command) {
        return Job.apply(this, command);
    }

    withAnchors(anchors) {
        const core = this[CORE];
        return core.borrow((lent) => {
            const at = putAnchors(core, lent, anchors);
            return new World(core, makeHandle(core, 'firma_world_with_anchors', this[ID], at));
        });
    }

    mass(density) {
        return getMass(this, density);
    }

    pieces(density) {
        return getPieces(this, density);
    }

    listFaces(regions) {
        return listFaces(this, regions);
    }

    makePatch(list, name) {
        return makePatch(this, list, name);
    }

    patchFrom(from) {
        const core = this[CORE];
        const before = idOf(from, core, 'patchFrom', 'world');
        return takeBytes(core, makeHandle(core, 'firma_world_patch_from', this[ID], before));
    }

    applyPatch(patch, name) {
        return applyPatch(this, patch, name);
    }

    diff(after, tileSize = 0) {
        const core = this[CORE];
        const to = idOf(after, core, 'diff', 'world');
        number(tileSize, 'diff', 'tileSize');
        return takeDiff(core, makeHandle(core, 'firma_world_diff', this[ID], to, tileSize));
    }

    withRules(rules) {
        const core = this[CORE];
        return core.borrow((lent) => {
            const at = putRules(core, lent, rules);
            return new World(core, makeHandle(core, 'firma_world_with_rules', this[ID], at));
        });
    }

    pack(options) {
        const core = this[CORE];
        const { exact = true } = object(options, 'pack', 'the options', ['exact']);
        flag(exact, 'pack', 'exact');
        return takeBytes(core, makeHandle(core, 'firma_world_pack', this[ID], exact ? 1 : 0));
    }
}

/** Bytes that worlds hold together. */
export function memoryOf(core, worlds) {
    return core.borrow((lent) => {
        const ids = worlds.map((world) => idOf(world, core, 'memory', 'world'));
        const at = lent.take(8 * ids.length);
        core.u64.set(ids, at >>> 3);
        core.run('firma_world_memory', at, ids.length, core.at.out);
        return core.getCount(core.at.out);
    });
}
