// SPDX-License-Identifier: MIT
// Cutters, and edits in one go, in slices, and several at once.
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { CARVE_OPTIONS, CARVE_REPORT, CARVE_STATUS_NAMES, POSE } from './layout.js';
import { flag, number, object, text, vector, word } from './arguments.js';
import { Chunks } from './chunks.js';
import { World } from './world.js';

export class Cutter extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_cutter_release');
    }
}

const POSE_NAMES = ['position', 'rotation', 'scale'];
const OPTION_NAMES = ['fill', 'material', 'from', 'chunks', 'edit'];
const CHUNK_NAMES = ['minVolume', 'density'];

/** Places a pose. @returns its address */
export function putPose(core, pose, place) {
    const { position, rotation = [0, 0, 0, 1], scale = 1 } = object(pose, place, 'the pose', POSE_NAMES);
    vector(position, 3, place, 'position');
    vector(rotation, 4, place, 'rotation');
    number(scale, place, 'scale');
    const at = core.at.pose;
    core.setVector(at + POSE.position, position);
    core.setVector(at + POSE.rotation, rotation);
    core.setF64(at + POSE.scale, scale);
    return at;
}

export function getPose(core, at) {
    const rotation = (at + POSE.rotation) >>> 3;
    return {
        position: core.getVector(at + POSE.position),
        rotation: Array.from(core.f64.subarray(rotation, rotation + 4)),
        scale: core.getF64(at + POSE.scale),
    };
}

/** `chunks` of options: none or false, true, or { minVolume, density }. @returns null for none */
function readChunks(chunks, place) {
    if (chunks === undefined || chunks === false) return null;
    const { minVolume = 0, density = 0 } = chunks === true ? {} : object(chunks, place, 'chunks', CHUNK_NAMES);
    number(minVolume, place, 'minVolume');
    number(density, place, 'density');
    return { minVolume, density };
}

/** @returns the address of the struct */
export function putCarveOptions(core, lent, options, place) {
    const given = object(options, place, 'the options', OPTION_NAMES);
    const fill = flag(given.fill, place, 'fill');
    const material = text(given.material, place, 'material');
    if (given.from !== undefined) vector(given.from, 3, place, 'from');
    const chunks = readChunks(given.chunks, place);
    const edit = given.edit === undefined ? 0 : word(given.edit, place, 'edit');
    const name = material === '' ? 0 : lent.text(material);
    const { carveOptions } = core.at;
    core.setU32(carveOptions + CARVE_OPTIONS.size, CARVE_OPTIONS.sizeof);
    core.setU32(carveOptions + CARVE_OPTIONS.fill, fill);
    core.setU32(carveOptions + CARVE_OPTIONS.material, name);
    core.setU32(carveOptions + CARVE_OPTIONS.hasFrom, given.from === undefined ? 0 : 1);
    core.setU32(carveOptions + CARVE_OPTIONS.reserved, 0);
    if (given.from !== undefined) core.setVector(carveOptions + CARVE_OPTIONS.from, given.from);
    core.setU32(carveOptions + CARVE_OPTIONS.chunks, chunks ? 1 : 0);
    core.setU32(carveOptions + CARVE_OPTIONS.edit, edit);
    core.setF64(carveOptions + CARVE_OPTIONS.minChunkVolume, chunks?.minVolume ?? 0);
    core.setF64(carveOptions + CARVE_OPTIONS.density, chunks?.density ?? 0);
    return carveOptions;
}

/** The cutter's handle, the pose's and the options' addresses: what every edit begins with. */
export function putOrder(core, lent, cutter, pose, options, place) {
    const id = idOf(cutter, core, place, 'cutter');
    const at = putPose(core, pose, place);
    return [id, at, putCarveOptions(core, lent, options, place)];
}

/** @param at  where it is; right after the call that filled it, as the module still says then why it refused */
export function getReport(core, at = core.at.report) {
    const loose = core.u64[(at + CARVE_REPORT.loose) >>> 3];
    const status = CARVE_STATUS_NAMES[core.getU32(at + CARVE_REPORT.status)];
    const times = {};
    let total = 0;
    for (const phase of ['place', 'gather', 'cut', 'label', 'trace', 'facets', 'chunks', 'tree']) {
        times[phase] = core.getF64(at + CARVE_REPORT[`${phase}Us`]);
        total += times[phase];
    }
    return {
        status,
        reason: status === 'refused' ? core.message() : '',
        retries: core.getU32(at + CARVE_REPORT.retries),
        candidateFaces: core.getCount(at + CARVE_REPORT.candidateFaces),
        facesCut: core.getCount(at + CARVE_REPORT.facesCut),
        facesRemoved: core.getCount(at + CARVE_REPORT.facesRemoved),
        facesAdded: core.getCount(at + CARVE_REPORT.facesAdded),
        facesCastableOnly: core.getCount(at + CARVE_REPORT.facesCastableOnly),
        openTrimmed: core.getCount(at + CARVE_REPORT.openTrimmed),
        openRemoved: core.getCount(at + CARVE_REPORT.openRemoved),
        panes: core.getCount(at + CARVE_REPORT.panes),
        clips: core.getCount(at + CARVE_REPORT.clips),
        portals: core.getCount(at + CARVE_REPORT.portals),
        rooms: core.getCount(at + CARVE_REPORT.rooms),
        scale: core.getF64(at + CARVE_REPORT.scale),
        cutShort: core.getCount(at + CARVE_REPORT.cutShort),
        volume: core.getF64(at + CARVE_REPORT.volume),
        chunks: core.getCount(at + CARVE_REPORT.chunks),
        chunkVolume: core.getF64(at + CARVE_REPORT.chunkVolume),
        crumbs: core.getCount(at + CARVE_REPORT.crumbs),
        crumbVolume: core.getF64(at + CARVE_REPORT.crumbVolume),
        facesSearched: core.getCount(at + CARVE_REPORT.facesSearched),
        loose: loose === 0n ? null : new Chunks(core, loose),
        times: { ...times, total },
    };
}

/** What firma_carve(), firma_job_result() and firma_command_apply() put. */
export function getResult(core) {
    const world = new World(core, core.u64[core.at.out >>> 3]);
    return { world, report: getReport(core) };
}

export function carve(world, cutter, pose, options) {
    const core = world[CORE];
    return core.borrow((lent) => {
        const order = putOrder(core, lent, cutter, pose, options, 'carve');
        core.run('firma_carve', world[ID], ...order, core.at.out, core.at.report);
        return getResult(core);
    });
}

export class Job extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_job_release');
    }

    static start(world, cutter, pose, options) {
        const core = world[CORE];
        return core.borrow((lent) => {
            const order = putOrder(core, lent, cutter, pose, options, 'startCarve');
            return new Job(core, makeHandle(core, 'firma_job_start', world[ID], ...order));
        });
    }

    static apply(world, command) {
        const core = world[CORE];
        const id = idOf(command, core, 'startApply', 'command');
        return new Job(core, makeHandle(core, 'firma_command_start', world[ID], id));
    }

    run(microseconds) {
        const core = this[CORE];
        number(microseconds, 'run', 'microseconds');
        core.run('firma_job_run', this[ID], microseconds, core.at.out);
        return core.getU32(core.at.out) !== 0;
    }

    result() {
        const core = this[CORE];
        core.run('firma_job_result', this[ID], core.at.out, core.at.report);
        return getResult(core);
    }
}

export class Edit extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_edit_release');
    }

    static begin(world) {
        const core = world[CORE];
        return new Edit(core, makeHandle(core, 'firma_edit_begin', world[ID]));
    }

    carve(cutter, pose, options) {
        const core = this[CORE];
        return core.borrow((lent) => {
            const order = putOrder(core, lent, cutter, pose, options, 'carve');
            core.run('firma_edit_carve', this[ID], ...order, core.at.report);
            return getReport(core);
        });
    }

    finish() {
        const core = this[CORE];
        return new World(core, makeHandle(core, 'firma_edit_finish', this[ID]));
    }
}
