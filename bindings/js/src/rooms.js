// SPDX-License-Identifier: MIT
// Rooms and portals as JavaScript has them.
import { takeFaces } from './faces.js';
import { makeHandle } from './handle.js';
import { PORTAL, ROOM, WHERE_NAMES } from './layout.js';
import { flag, object, text, vector, word } from './arguments.js';

/** What `portal` of a batch is where there is none. */
export const NO_PORTAL = 0xffffffff;
/** From here on numbers are no rooms: FIRMA_LOCATE_ROOM and FIRMA_ANY_ROOM. */
export const NO_ROOM = 0xfffffffe;

/** { where, room } of a point. */
export function locate(core, id, point) {
    const { input, out } = core.at;
    core.setVector(input, vector(point, 3, 'locate', 'point'));
    core.run('firma_world_locate', id, input, out, out + 4);
    const where = WHERE_NAMES[core.getU32(out)];
    return { where, room: where === 'air' ? core.getU32(out + 4) : null };
}

export function getRoom(core, id, room) {
    const at = core.at.room;
    core.run('firma_world_room', id, word(room, 'room', 'the room'), at);
    const portals = core.getU32(at + ROOM.portals) >>> 2;
    return {
        name: core.text(core.getU32(at + ROOM.name)),
        low: core.getVector(at + ROOM.low),
        high: core.getVector(at + ROOM.high),
        faceCount: core.getCount(at + ROOM.faceCount),
        exterior: core.getU32(at + ROOM.exterior) !== 0,
        mergedInto: core.getU32(at + ROOM.mergedInto),
        portals: Array.from(core.u32.subarray(portals, portals + core.getU32(at + ROOM.portalCount))),
    };
}

export function getPortal(core, id, portal) {
    const at = core.at.portal;
    core.run('firma_world_portal', id, word(portal, 'portal', 'the portal'), at);
    const info = {
        name: core.text(core.getU32(at + PORTAL.name)),
        low: core.getVector(at + PORTAL.low),
        high: core.getVector(at + PORTAL.high),
        rooms: [core.getU32(at + PORTAL.rooms), core.getU32(at + PORTAL.rooms + 4)],
        material: core.getU32(at + PORTAL.material),
        mask: core.getU32(at + PORTAL.mask),
        open: core.getU32(at + PORTAL.open) !== 0,
    };
    const faces = takeFaces(core, makeHandle(core, 'firma_world_portal_polygons', id, portal));
    info.polygons = Array.from(faces.firstCorners, (first, k) =>
        faces.corners.slice(3 * first, 3 * (first + faces.cornerCounts[k])),
    );
    return info;
}

/** The number of a room or portal ('room', 'portal') of a name; null where there is none. */
export function findByName(core, id, kind, name) {
    const place = kind === 'room' ? 'findRoom' : 'findPortal';
    return core.borrow((lent) => {
        core.run(`firma_world_find_${kind}`, id, lent.text(text(name, place, 'the name')), core.at.out);
        const found = core.getU32(core.at.out);
        return found === NO_PORTAL ? null : found;
    });
}

/** Numbers that a call writes, as many as it says there are: ask(at, capacity, count). */
function getWords(core, ask) {
    return core.borrow((lent) => {
        for (let capacity = 64; ; capacity = core.getU32(core.at.out)) {
            const at = lent.take(4 * capacity);
            ask(at, capacity, core.at.out);
            const count = core.getU32(core.at.out);
            if (count <= capacity) return Array.from(core.u32.subarray(at >>> 2, (at >>> 2) + count));
        }
    });
}

export function getNeighbours(core, id, room) {
    word(room, 'neighbours', 'the room');
    return getWords(core, (at, capacity, count) => {
        core.run('firma_world_neighbours', id, room, at, capacity, count);
    });
}

export function getPath(core, id, from, to, options) {
    word(from, 'path', 'the first room');
    word(to, 'path', 'the last room');
    const allOpen = flag(object(options, 'path', 'the options', ['allOpen']).allOpen, 'path', 'allOpen');
    const found = core.at.out + 8;
    const portals = getWords(core, (at, capacity, count) => {
        core.run('firma_world_path', id, from, to, allOpen, at, capacity, count, found);
    });
    return core.getU32(found) === 0 ? null : portals;
}
