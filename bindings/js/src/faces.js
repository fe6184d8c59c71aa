// SPDX-License-Identifier: MIT
// Faces as arrays: copies of what the module shows.
import { DIFF_VIEW, FACE, FACE_FILTER, FACES_VIEW } from './layout.js';
import { object, region, vector, word } from './arguments.js';

/** What ids of faces are where there is none. */
export const NO_FACE = 0xffffffff;

/** What faces are besides their outlines. @param faces the address of the first; @param count how many there are */
function getFaceInfos(core, faces, count) {
    const words = (offset) => {
        const all = new Uint32Array(count);
        for (let k = 0, at = (faces + offset) >>> 2; k < count; ++k, at += FACE.sizeof / 4) all[k] = core.u32[at];
        return all;
    };
    const normals = new Float64Array(3 * count);
    for (let k = 0; k < count; ++k) {
        const at = (faces + k * FACE.sizeof + FACE.normal) >>> 3;
        for (let axis = 0; axis < 3; ++axis) normals[3 * k + axis] = core.f64[at + axis];
    }
    const points = new Int32Array(3 * count);
    for (let k = 0; k < count; ++k) {
        const at = (faces + k * FACE.sizeof + FACE.corner) >>> 2;
        for (let axis = 0; axis < 3; ++axis) points[3 * k + axis] = core.i32[at + axis];
    }
    return {
        ids: words(FACE.id),
        normals,
        materials: words(FACE.material),
        sources: words(FACE.source),
        sourceEdits: words(FACE.sourceEdit),
        masks: words(FACE.mask),
        flags: words(FACE.flags),
        rooms: words(FACE.room),
        firstPoints: points,
    };
}

/** @param faces, corners addresses; @param count, cornerCount how many there are */
function getFaces(core, faces, count, corners, cornerCount) {
    const words = (offset) =>
        Uint32Array.from({ length: count }, (_, k) => core.getU32(faces + k * FACE.sizeof + offset));
    return {
        ...getFaceInfos(core, faces, count),
        firstCorners: words(FACE.firstCorner),
        cornerCounts: words(FACE.cornerCount),
        corners: core.f64.slice(corners >>> 3, (corners >>> 3) + 3 * cornerCount),
    };
}

/** { room }, { box: { low, high } } or { region } as the C API has it. @returns the address of the struct */
export function putFaceFilter(core, lent, filter = {}, place) {
    object(filter, place, 'the filter', ['room', 'box', 'region']);
    const room = filter.room === undefined ? 0xffffffff : word(filter.room, place, 'room');
    let [box, cube] = [0, 0];
    if (filter.box !== undefined) {
        const { low, high } = object(filter.box, place, 'box', ['low', 'high']);
        box = lent.doubles([...vector(low, 3, place, 'low'), ...vector(high, 3, place, 'high')]);
    }
    if (filter.region !== undefined) cube = lent.words(region(filter.region, place));
    const at = core.at.faceFilter;
    core.setU32(at + FACE_FILTER.size, FACE_FILTER.sizeof);
    core.setU32(at + FACE_FILTER.room, room);
    core.setU32(at + FACE_FILTER.box, box);
    core.setU32(at + FACE_FILTER.region, cube);
    return at;
}

/** What names a face: { face, corner } or { id, corner }. @returns its id, NO_FACE for null, and where the corner is */
export function putFaceRef(core, ref, place) {
    const { id, face = id, corner } = object(ref, place, 'the face');
    const at = core.at.out;
    core.i32.set(vector(corner, 3, place, 'its corner'), at >>> 2);
    return [face === null ? NO_FACE : word(face, place, 'its id'), at];
}

/** The first of faces as an object; null where there is none. */
export function onlyFace(found) {
    if (found.ids.length === 0) return null;
    return {
        id: found.ids[0],
        normal: Array.from(found.normals),
        material: found.materials[0],
        source: found.sources[0],
        sourceEdit: found.sourceEdits[0],
        mask: found.masks[0],
        flags: found.flags[0],
        room: found.rooms[0],
        corner: Array.from(found.firstPoints),
        corners: found.corners,
    };
}

/** A face that firma_wasm_each_face() shows, by the addresses of the face and of its corners. */
export function getShownFace(core, at) {
    const face = core.getU32(at);
    return onlyFace(getFaces(core, face, 1, core.getU32(at + 4), core.getU32(face + FACE.cornerCount)));
}

/** What a firma_faces handle shows; releases it. */
export function takeFaces(core, handle) {
    try {
        const at = core.at.facesView;
        core.run('firma_faces_get_view', handle, at);
        const [faces, count] = [core.getU32(at + FACES_VIEW.faces), core.getU32(at + FACES_VIEW.faceCount)];
        const [corners, cornerCount] = [core.getU32(at + FACES_VIEW.corners), core.getU32(at + FACES_VIEW.cornerCount)];
        return getFaces(core, faces, count, corners, cornerCount);
    } finally {
        core.call('firma_faces_release', handle);
    }
}

/** What a firma_diff handle shows; releases it. */
export function takeDiff(core, handle) {
    try {
        const at = core.at.diffView;
        core.run('firma_diff_get_view', handle, at);
        const get = (field) => core.getU32(at + DIFF_VIEW[field]);
        const words = (field) => core.u32.slice(get(field) >>> 2, (get(field) >>> 2) + get(`${field}Count`));
        const tiles = get('tiles') >>> 2;
        return {
            removed: words('removed'),
            removedFaces: getFaceInfos(core, get('removedFaces'), get('removedCount')),
            added: getFaces(core, get('added'), get('addedCount'), get('corners'), get('cornerCount')),
            rooms: core.u32.slice(get('rooms') >>> 2, (get('rooms') >>> 2) + get('roomCount')),
            opened: words('opened'),
            closed: words('closed'),
            portalsAdded: words('portalsAdded'),
            portalsRemoved: words('portalsRemoved'),
            portalsChanged: words('portalsChanged'),
            tiles: core.i32.slice(tiles, tiles + 3 * get('tileCount')),
            low: core.getVector(at + DIFF_VIEW.low),
            high: core.getVector(at + DIFF_VIEW.high),
            tooManyTiles: get('tooManyTiles') !== 0,
        };
    } finally {
        core.call('firma_diff_release', handle);
    }
}
