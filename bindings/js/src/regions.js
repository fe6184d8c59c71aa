// SPDX-License-Identifier: MIT
// Meshes by region: copies of what the module shows.
import { doubles, flag, mask, number, object } from './arguments.js';
import { makeHandle } from './handle.js';
import { REGION_MESH_VIEW, REGION_OPTIONS, REGION_PART, REGION_RUN, TEXTURE_UNIT_NAMES } from './layout.js';

const NAMES = ['size', 'mask', 'solidOnly', 'textures', 'textureSizes'];
const PART_WORDS = REGION_PART.sizeof >>> 2;

/** The options' address. */
function putOptions(core, lent, options, place) {
    const given = object(options, place, 'the options', NAMES);
    const at = lent.take(REGION_OPTIONS.sizeof);
    core.call('firma_region_options_defaults', at);
    if (given.mask !== undefined) core.setU32(at + REGION_OPTIONS.mask, mask(given.mask, place));
    core.setU32(at + REGION_OPTIONS.solidOnly, flag(given.solidOnly, place, 'solidOnly'));
    core.setU32(at + REGION_OPTIONS.noTextures, 1 - flag(given.textures ?? true, place, 'textures'));
    if (given.size !== undefined) core.setF64(at + REGION_OPTIONS.regionSize, number(given.size, place, 'size'));
    const sizes = given.textureSizes ?? [];
    doubles(sizes, 2, place, 'textureSizes');
    core.setU32(at + REGION_OPTIONS.textureSizes, lent.doubles(sizes));
    core.setU32(at + REGION_OPTIONS.textureSizeCount, sizes.length / 2);
    return at;
}

/** Of the parts, an array of words from one field on, `each` for each. */
function column(words, count, offset, each = 1, Kind = Uint32Array) {
    const made = new Kind(count * each);
    for (let k = 0; k < count; ++k)
        for (let c = 0; c < each; ++c) made[each * k + c] = words[PART_WORDS * k + (offset >>> 2) + c];
    return made;
}

function getRun(core, at) {
    const get = (field) => core.getU32(at + REGION_RUN[field]);
    return {
        material: get('material'),
        cut: get('cut') !== 0,
        twoSided: get('twoSided') !== 0,
        uvUnit: TEXTURE_UNIT_NAMES[get('uvUnit')],
        firstTriangle: get('firstTriangle'),
        triangleCount: get('triangleCount'),
        firstVertex: get('firstVertex'),
        vertexCount: get('vertexCount'),
    };
}

function getMesh(core, at) {
    const get = (field) => core.getU32(at + REGION_MESH_VIEW[field]);
    /** Empty where there are none. */
    const copy = (Kind, field, count) => {
        const from = get(field);
        return from === 0 ? new Kind(0) : new Kind(core.u8.buffer, from, count).slice();
    };
    const [vertices, triangles, parts] = [get('vertexCount'), get('triangleCount'), get('partCount')];
    const words = core.u32.subarray(get('parts') >>> 2, (get('parts') >>> 2) + parts * PART_WORDS);
    const [place, runs] = [(at + REGION_MESH_VIEW.place) >>> 2, get('runs')];
    const one = (field) => column(words, parts, REGION_PART[field]);
    return {
        place: Array.from(core.i32.subarray(place, place + 3)),
        origin: core.getVector(at + REGION_MESH_VIEW.origin),
        low: core.getVector(at + REGION_MESH_VIEW.low),
        high: core.getVector(at + REGION_MESH_VIEW.high),
        positions: copy(Float32Array, 'positions', 3 * vertices),
        normals: copy(Float32Array, 'normals', 3 * vertices),
        tangents: copy(Float32Array, 'tangents', 4 * vertices),
        uvs: copy(Float32Array, 'uvs', 2 * vertices),
        blends: copy(Uint8Array, 'blends', 4 * vertices),
        corners: copy(Uint32Array, 'corners', 3 * triangles),
        faces: copy(Uint32Array, 'faces', triangles),
        runs: Array.from({ length: get('runCount') }, (_, k) => getRun(core, runs + k * REGION_RUN.sizeof)),
        parts: {
            faces: one('face'),
            faceCorners: column(words, parts, REGION_PART.corner, 3, Int32Array),
            sources: one('source'),
            sourceEdits: one('sourceEdit'),
            masks: one('mask'),
            flags: one('flags'),
            firstTriangles: one('firstTriangle'),
            triangleCounts: one('triangleCount'),
            firstVertices: one('firstVertex'),
            vertexCounts: one('vertexCount'),
        },
    };
}

/**
 * @param name    of the function that makes them
 * @param worlds  the ids that it takes first
 */
export function takeRegionMeshes(core, name, worlds, options, place) {
    const handle = core.borrow((lent) => makeHandle(core, name, ...worlds, putOptions(core, lent, options, place)));
    try {
        core.run('firma_region_meshes_get_count', handle, core.at.out);
        const count = core.getU32(core.at.out);
        return Array.from({ length: count }, (_, k) => {
            core.run('firma_region_meshes_get_view', handle, k, core.at.regionMeshView);
            return getMesh(core, core.at.regionMeshView);
        });
    } finally {
        core.call('firma_region_meshes_release', handle);
    }
}
