// SPDX-License-Identifier: MIT
// Bodies as they are drawn: the meshes of each one's own world, put where the engine says its frame is.
import * as THREE from 'three';
import { Painter } from './painter.js';
import { RegionMeshes, regionOptions } from './region_meshes.js';
import { add } from './vector.js';

/** A mesh whose places are told from its frame's origin. */
function fromFrame(mesh) {
    const positions = mesh.positions.map((x, k) => x + mesh.origin[k % 3]);
    return { ...mesh, positions, origin: [0, 0, 0] };
}

/**
 * The meshes of a world that moves, in a group to be put somewhere.
 * @param names  of its materials
 * @param depth  (edit, point of the level): how deep that lies in the crater of an edit
 * @param shift  where its frame was in the level
 */
export function meshesOf(world, names, { bodies, shadow }, depth, shift = [0, 0, 0]) {
    const meshes = new RegionMeshes(bodies, new Painter(names, (edit, point) => depth(edit, add(point, shift))), shadow);
    meshes.replace(world.regionMeshes(regionOptions(names)).map(fromFrame));
    return meshes;
}

export class DebrisView {
    /** @param materials  of makeSurfaceMaterials() */
    constructor(materials, depth) {
        this.make = (piece) => meshesOf(piece.world, piece.names, materials, depth, piece.origin);
        this.group = new THREE.Group();
        this.shown = new Map(); // piece -> meshes
    }

    change({ added, removed }) {
        for (const piece of removed) {
            const meshes = this.shown.get(piece);
            this.shown.delete(piece);
            this.group.remove(meshes.group);
            meshes.clear();
        }
        for (const piece of added) {
            const meshes = this.make(piece);
            this.shown.set(piece, meshes);
            this.group.add(meshes.group);
        }
    }

    /** @param bodies  where each is */
    update(bodies) {
        for (const [piece, { group }] of this.shown) {
            const { position, rotation } = bodies.pose(piece.id);
            group.position.set(...position);
            group.quaternion.set(...rotation);
        }
    }

    get triangles() {
        let sum = 0;
        for (const meshes of this.shown.values()) sum += meshes.triangles;
        return sum;
    }
}
