// SPDX-License-Identifier: MIT
// What a straight path goes through.
import { flag, object, vector } from './arguments.js';
import { badCall } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { noFace } from './hits.js';
import { PIERCE_END, PIERCE_OPTIONS, PIERCE_SPAN, PIERCING_VIEW, SHOT_LENGTH, STATUS_NAMES } from './layout.js';
import { orNull, putMembers, structTable } from './structs.js';

const { fresh, toFill } = structTable({
    options: [PIERCE_OPTIONS, 'firma_pierce_options_defaults'],
    view: [PIERCING_VIEW],
});

const KINDS = { mask: 'mask', bothSides: 'flag' };
/** What the module is told to leave out, by the names of what is told unless it is false. */
const TOLD = { panes: 'noPanes', matters: 'noMatters' };
const NAMES = [...Object.keys(KINDS), ...Object.keys(TOLD)];

/** @returns the address of the struct */
function putOptions(core, options, place) {
    const given = object(options, place, 'the options', NAMES);
    const at = fresh(core, 'options');
    putMembers(core, at, PIERCE_OPTIONS, KINDS, given, place);
    for (const name in TOLD)
        if (given[name] !== undefined) core.setU32(at + PIERCE_OPTIONS[TOLD[name]], 1 - flag(given[name], place, name));
    return at;
}

function getEnd(core, at) {
    const corner = (at + PIERCE_END.corner) >>> 2;
    return {
        fraction: core.getF64(at + PIERCE_END.fraction),
        point: core.getVector(at + PIERCE_END.point),
        normal: core.getVector(at + PIERCE_END.normal),
        face: noFace(core.getU32(at + PIERCE_END.face)),
        corner: Array.from(core.i32.subarray(corner, corner + 3)),
        material: core.getU32(at + PIERCE_END.material),
    };
}

function getLength(core, at) {
    return {
        from: core.getF64(at + SHOT_LENGTH.from),
        to: core.getF64(at + SHOT_LENGTH.to),
        matter: core.getU32(at + SHOT_LENGTH.matter),
    };
}

function getSpan(core, at, lengths) {
    const first = lengths + core.getU32(at + PIERCE_SPAN.firstLength) * SHOT_LENGTH.sizeof;
    const count = core.getU32(at + PIERCE_SPAN.lengthCount);
    return {
        in: getEnd(core, at + PIERCE_SPAN.in),
        out: getEnd(core, at + PIERCE_SPAN.out),
        thickness: core.getF64(at + PIERCE_SPAN.thickness),
        lengths: Array.from({ length: count }, (_, k) => getLength(core, first + k * SHOT_LENGTH.sizeof)),
        portal: orNull(core.getU32(at + PIERCE_SPAN.portal)),
        pane: core.getU32(at + PIERCE_SPAN.pane) !== 0,
        startsInside: core.getU32(at + PIERCE_SPAN.startsInside) !== 0,
        endsInside: core.getU32(at + PIERCE_SPAN.endsInside) !== 0,
    };
}

export function pierce(core, world, input, options) {
    const place = 'pierce';
    const id = idOf(world, core, place, 'world');
    if (input === undefined) throw badCall(place, 'the way must be { start, path }');
    const { start, path } = object(input, place, 'the way', ['start', 'path']);
    core.setVector(core.at.input, vector(start, 3, place, 'start'));
    core.setVector(core.at.input + 24, vector(path, 3, place, 'path'));
    const chosen = putOptions(core, options, place);
    const piercing = makeHandle(core, 'firma_piercing_create');
    try {
        core.run('firma_pierce', id, core.at.input, core.at.input + 24, chosen, piercing, core.at.out);
        const status = STATUS_NAMES[core.getU32(core.at.out)];
        const view = toFill(core, 'view');
        core.run('firma_piercing_get_view', piercing, view);
        const [spans, lengths] = ['spans', 'lengths'].map((name) => core.getU32(view + PIERCING_VIEW[name]));
        return {
            status,
            thickness: core.getF64(view + PIERCING_VIEW.thickness),
            spans: Array.from({ length: core.getU32(view + PIERCING_VIEW.spanCount) }, (_, k) =>
                getSpan(core, spans + k * PIERCE_SPAN.sizeof, lengths),
            ),
        };
    } finally {
        if (!core.stopped) core.run('firma_piercing_release', piercing);
    }
}
