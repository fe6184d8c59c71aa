// SPDX-License-Identifier: MIT
// Edits as bytes: commands.
import { bytes, text, word } from './arguments.js';
import { getPose, getResult, putOrder } from './carving.js';
import { badCall } from './errors.js';
import { CORE, Handle, ID, idOf, makeHandle, takeBytes } from './handle.js';
import { COMMAND_VIEW, EDIT_KIND_NAMES, SHAPE_NAMES } from './layout.js';
import { putName } from './world_options.js';

/** What carve() takes as options, as a command has it; `edit` is its number. */
function getOptions(core, at, kind) {
    const options = { fill: kind === 'fill', material: core.text(core.getU32(at + COMMAND_VIEW.material)) };
    options.edit = core.getU32(at + COMMAND_VIEW.number);
    if (core.getU32(at + COMMAND_VIEW.hasFrom)) options.from = core.getVector(at + COMMAND_VIEW.from);
    if (core.getU32(at + COMMAND_VIEW.chunks))
        options.chunks = {
            minVolume: core.getF64(at + COMMAND_VIEW.minChunkVolume),
            density: core.getF64(at + COMMAND_VIEW.density),
        };
    return options;
}

export class Command extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_command_release');
    }

    static edit(core, number, cutter, pose, options) {
        const place = 'editCommand';
        word(number, place, 'the number');
        return core.borrow((lent) => {
            const order = putOrder(core, lent, cutter, pose, options, place);
            return new Command(core, makeHandle(core, 'firma_command_edit', number, ...order));
        });
    }

    static door(core, number, portal, open) {
        const place = 'doorCommand';
        word(number, place, 'the number');
        word(portal, place, 'the portal');
        if (typeof open !== 'boolean') throw badCall(place, 'open must be true or false');
        return new Command(core, makeHandle(core, 'firma_command_door', number, portal, open ? 1 : 0));
    }

    static group(core, parts) {
        const place = 'groupCommand';
        if (!Array.isArray(parts)) throw badCall(place, 'the parts must be an array');
        return core.borrow((lent) => {
            const ids = parts.map((part) => idOf(part, core, place, 'command'));
            const at = lent.take(8 * ids.length);
            core.u64.set(ids, at >>> 3);
            return new Command(core, makeHandle(core, 'firma_command_group', at, ids.length));
        });
    }

    static unpack(core, data, name) {
        return new Command(core, unpackHandle(core, 'firma_command_unpack', data, name, 'unpackCommand'));
    }

    facts() {
        const core = this[CORE];
        const at = core.at.commandView;
        core.run('firma_command_get_view', this[ID], at);
        const kind = EDIT_KIND_NAMES[core.getU32(at + COMMAND_VIEW.kind)];
        const cuts = kind === 'carve' || kind === 'fill';
        const shape = SHAPE_NAMES[core.getU32(at + COMMAND_VIEW.shape)] ?? null;
        return {
            kind,
            number: core.getU32(at + COMMAND_VIEW.number),
            lastNumber: core.getU32(at + COMMAND_VIEW.lastNumber),
            partCount: core.getU32(at + COMMAND_VIEW.partCount),
            portal: kind === 'door' ? core.getU32(at + COMMAND_VIEW.portal) : null,
            open: kind === 'door' ? core.getU32(at + COMMAND_VIEW.open) !== 0 : null,
            shape,
            seed: shape === null ? null : core.u64[(at + COMMAND_VIEW.seed) >>> 3],
            pose: cuts ? getPose(core, at + COMMAND_VIEW.pose) : null,
            options: cuts ? getOptions(core, at, kind) : null,
        };
    }

    part(part) {
        const core = this[CORE];
        word(part, 'part', 'the part');
        return new Command(core, makeHandle(core, 'firma_command_part', this[ID], part));
    }

    quantised() {
        const core = this[CORE];
        return new Command(core, makeHandle(core, 'firma_command_quantise', this[ID]));
    }

    pack() {
        const core = this[CORE];
        return takeBytes(core, makeHandle(core, 'firma_command_pack', this[ID]));
    }
}

export function applyCommand(world, command) {
    const core = world[CORE];
    const id = idOf(command, core, 'apply', 'command');
    core.run('firma_command_apply', world[ID], id, core.at.out, core.at.report);
    return getResult(core);
}

/** A handle of bytes, by a function that takes them, their length and a name. */
export function unpackHandle(core, unpack, data, name, place) {
    const given = bytes(data, place, 'the data');
    return core.borrow((lent) => {
        const at = lent.bytes(given);
        return makeHandle(core, unpack, at, given.length, putName(lent, text(name, place, 'name')));
    });
}
