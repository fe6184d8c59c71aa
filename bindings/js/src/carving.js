// SPDX-License-Identifier: MIT
// Cutters, and edits in one go, in slices, and several at once.
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { CARVE_OPTIONS, CARVE_REPORT, CARVE_STATUS_NAMES, POSE } from './layout.js';
import { flag, number, object, text, vector } from './arguments.js';
import { World } from './world.js';

export class Cutter extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_cutter_release');
    }
}

const POSE_NAMES = ['position', 'rotation', 'scale'];
const OPTION_NAMES = ['fill', 'material', 'from'];

/** The cutter's handle, the pose's and the options' addresses: what every edit begins with. */
function putOrder(core, lent, cutter, pose, options, place) {
    const id = idOf(cutter, core, place, 'cutter');
    const { position, rotation = [0, 0, 0, 1], scale = 1 } = object(pose, place, 'the pose', POSE_NAMES);
    const given = object(options, place, 'the options', OPTION_NAMES);
    vector(position, 3, place, 'position');
    vector(rotation, 4, place, 'rotation');
    number(scale, place, 'scale');
    const fill = flag(given.fill, place, 'fill');
    const material = text(given.material, place, 'material');
    if (given.from !== undefined) vector(given.from, 3, place, 'from');
    const name = material === '' ? 0 : lent.text(material);
    const { pose: at, carveOptions } = core.at;
    core.setVector(at + POSE.position, position);
    core.setVector(at + POSE.rotation, rotation);
    core.setF64(at + POSE.scale, scale);
    core.setU32(carveOptions + CARVE_OPTIONS.size, CARVE_OPTIONS.sizeof);
    core.setU32(carveOptions + CARVE_OPTIONS.fill, fill);
    core.setU32(carveOptions + CARVE_OPTIONS.material, name);
    core.setU32(carveOptions + CARVE_OPTIONS.hasFrom, given.from === undefined ? 0 : 1);
    core.setU32(carveOptions + CARVE_OPTIONS.reserved, 0);
    if (given.from !== undefined) core.setVector(carveOptions + CARVE_OPTIONS.from, given.from);
    return [id, at, carveOptions];
}

function getReport(core) {
    const at = core.at.report;
    const status = CARVE_STATUS_NAMES[core.getU32(at + CARVE_REPORT.status)];
    const times = {};
    let total = 0;
    for (const phase of ['place', 'gather', 'cut', 'label', 'trace', 'facets', 'tree']) {
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
        portals: core.getCount(at + CARVE_REPORT.portals),
        rooms: core.getCount(at + CARVE_REPORT.rooms),
        scale: core.getF64(at + CARVE_REPORT.scale),
        volume: core.getF64(at + CARVE_REPORT.volume),
        times: { ...times, total },
    };
}

/** What firma_carve() and firma_job_result() put. */
function getResult(core) {
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
