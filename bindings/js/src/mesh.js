// SPDX-License-Identifier: MIT
// Meshes as arrays.
import { badCall } from './errors.js';
import { MESH } from './layout.js';
import { doubles, flags, masks, object, text, words } from './arguments.js';

const MESH_NAMES = ['positions', 'corners', 'cornerCounts', 'materials', 'materialNames', 'masks', 'twoSided', 'uvs'];

/** The arrays of a mesh, checked to fit each other. */
export function readMesh(mesh, place) {
    if (mesh === undefined) throw badCall(place, 'the mesh must be an object');
    object(mesh, place, 'the mesh', MESH_NAMES);
    const read = {
        positions: doubles(mesh.positions, 3, place, 'positions'),
        corners: words(mesh.corners, undefined, place, 'corners'),
        materialNames: mesh.materialNames === undefined ? [] : mesh.materialNames,
    };
    if (mesh.cornerCounts === undefined) {
        if (read.corners.length % 3 !== 0) throw badCall(place, 'corners of triangles must be a multiple of 3');
        read.faceCount = read.corners.length / 3;
    } else {
        read.cornerCounts = words(mesh.cornerCounts, undefined, place, 'cornerCounts');
        read.faceCount = read.cornerCounts.length;
        let sum = 0;
        for (const count of read.cornerCounts) sum += count;
        if (sum !== read.corners.length)
            throw badCall(place, `cornerCounts sum to ${sum}, corners are ${read.corners.length}`);
    }
    if (!Array.isArray(read.materialNames)) throw badCall(place, 'materialNames must be an array');
    read.materialNames = read.materialNames.map((name, k) => text(name, place, `materialNames[${k}]`));
    if (mesh.materials !== undefined) read.materials = words(mesh.materials, read.faceCount, place, 'materials');
    if (mesh.masks !== undefined) read.masks = masks(mesh.masks, read.faceCount, place, 'masks');
    if (mesh.uvs !== undefined) {
        read.uvs = doubles(mesh.uvs, 2, place, 'uvs');
        if (read.uvs.length !== 2 * read.corners.length)
            throw badCall(place, `uvs must be two for each corner: ${2 * read.corners.length}, not ${read.uvs.length}`);
    }
    if (mesh.twoSided !== undefined) read.twoSided = flags(mesh.twoSided, read.faceCount, place, 'twoSided');
    return read;
}

export function putMesh(core, lent, mesh) {
    const names = mesh.materialNames.map((name) => lent.text(name));
    const fields = {
        size: MESH.sizeof,
        materialCount: names.length,
        positions: lent.doubles(mesh.positions),
        vertexCount: mesh.positions.length / 3,
        corners: lent.words(mesh.corners),
        cornerCounts: mesh.cornerCounts ? lent.words(mesh.cornerCounts) : 0,
        faceCount: mesh.faceCount,
        materials: mesh.materials ? lent.words(mesh.materials) : 0,
        materialNames: lent.words(names),
        masks: mesh.masks ? lent.words(mesh.masks) : 0,
        twoSided: mesh.twoSided ? lent.bytes(mesh.twoSided) : 0,
        uvs: mesh.uvs ? lent.doubles(mesh.uvs) : 0,
    };
    for (const name in fields) core.setU32(core.at.mesh + MESH[name], fields[name]);
    return core.at.mesh;
}
