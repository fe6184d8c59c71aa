// SPDX-License-Identifier: MIT
// Faces as triangles, and how textures lie on them: copies of what the module shows.
import { doubles, flag, mask, object, region as regionOf, vector, word } from './arguments.js';
import { badCall } from './errors.js';
import { makeHandle } from './handle.js';
import { putFaceRef } from './faces.js';
import { TEXTURE, TEXTURE_UNIT_NAMES, TRIANGLE_OPTIONS, TRIANGLE_RUN, TRIANGLE_SOURCE, TRIANGLES_VIEW } from './layout.js';

const NAMES = ['mask', 'solidOnly', 'room', 'region', 'origin', 'uvs', 'textureSizes'];

/** The options' address. */
function putOptions(core, lent, options) {
    const given = object(options, 'triangles', 'the options', NAMES);
    const { origin = [0, 0, 0], room, region } = given;
    const at = lent.take(TRIANGLE_OPTIONS.sizeof);
    core.setU32(at + TRIANGLE_OPTIONS.size, TRIANGLE_OPTIONS.sizeof);
    core.setU32(at + TRIANGLE_OPTIONS.mask, given.mask === undefined ? 0xffffffff : mask(given.mask, 'triangles'));
    core.setU32(at + TRIANGLE_OPTIONS.solidOnly, flag(given.solidOnly, 'triangles', 'solidOnly'));
    core.setU32(at + TRIANGLE_OPTIONS.room, room === undefined ? 0xffffffff : word(room, 'triangles', 'room'));
    core.setVector(at + TRIANGLE_OPTIONS.origin, vector(origin, 3, 'triangles', 'origin'));
    core.setU32(at + TRIANGLE_OPTIONS.region, region === undefined ? 0 : lent.words(regionOf(region, 'triangles')));
    core.setU32(at + TRIANGLE_OPTIONS.uvs, flag(given.uvs, 'triangles', 'uvs'));
    core.setU32(at + TRIANGLE_OPTIONS.reserved, 0);
    const sizes = given.textureSizes ?? [];
    doubles(sizes, 2, 'triangles', 'textureSizes');
    core.setU32(at + TRIANGLE_OPTIONS.textureSizes, lent.doubles(sizes));
    core.setU32(at + TRIANGLE_OPTIONS.textureSizeCount, sizes.length / 2);
    return at;
}

/** An array of objects with the fields of a struct, all of them words. */
function getStructs(core, at, count, layout) {
    const fields = Object.keys(layout).filter((name) => name !== 'sizeof' && name !== 'reserved');
    return Array.from({ length: count }, (_, k) =>
        Object.fromEntries(fields.map((name) => [name, core.getU32(at + k * layout.sizeof + layout[name])])),
    );
}

export function takeTriangles(core, id, options) {
    const handle = core.borrow((lent) => makeHandle(core, 'firma_world_triangles', id, putOptions(core, lent, options)));
    try {
        const at = core.at.trianglesView;
        core.run('firma_triangles_get_view', handle, at);
        const get = (field) => core.getU32(at + TRIANGLES_VIEW[field]);
        const f32 = new Float32Array(core.u8.buffer);
        const floats = (field, count) => f32.slice(get(field) >>> 2, (get(field) >>> 2) + count);
        const words = (field, count) => core.u32.slice(get(field) >>> 2, (get(field) >>> 2) + count);
        const triangles = get('triangleCount');
        const sources = getStructs(core, get('sources'), get('sourceCount'), TRIANGLE_SOURCE);
        for (const source of sources) source.uvUnit = TEXTURE_UNIT_NAMES[source.uvUnit];
        return {
            positions: floats('positions', 3 * get('vertexCount')),
            normals: floats('normals', 3 * get('vertexCount')),
            uvs: floats('uvs', get('uvs') === 0 ? 0 : 2 * get('vertexCount')),
            corners: words('corners', 3 * triangles),
            faces: words('faces', triangles),
            runs: getStructs(core, get('runs'), get('runCount'), TRIANGLE_RUN),
            sources,
        };
    } finally {
        core.call('firma_triangles_release', handle);
    }
}

/** @param face  an id, or what names a face and its place: then nothing is searched */
export function takeTexture(core, id, face) {
    const named = typeof face === 'object' && face !== null;
    const [number, corner] = named ? putFaceRef(core, face, 'texture') : [word(face, 'texture', 'the face'), 0];
    const at = core.at.texture;
    core.run('firma_world_texture', id, number, corner, at);
    return {
        uAxis: core.getVector(at + TEXTURE.uAxis),
        uOffset: core.getF64(at + TEXTURE.uOffset),
        vAxis: core.getVector(at + TEXTURE.vAxis),
        vOffset: core.getF64(at + TEXTURE.vOffset),
        unit: TEXTURE_UNIT_NAMES[core.getU32(at + TEXTURE.unit)],
    };
}
