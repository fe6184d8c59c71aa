// SPDX-License-Identifier: MIT
// Door leaves as they are drawn.
import * as THREE from 'three';
import { meshesOf } from './debris_view.js';

export class DoorView {
    /** @param materials  of makeSurfaceMaterials() */
    constructor(materials) {
        this.make = (door) => meshesOf(door.world, door.world.facts().materials, materials, () => 0);
        this.group = new THREE.Group();
        this.shown = new Map(); // door -> meshes
    }

    change({ added, removed }) {
        for (const door of removed) {
            const meshes = this.shown.get(door);
            this.shown.delete(door);
            this.group.remove(meshes.group);
            meshes.clear();
        }
        for (const door of added) {
            const meshes = this.make(door);
            this.shown.set(door, meshes);
            this.group.add(meshes.group);
        }
    }

    update(doors) {
        for (const [door, { group }] of this.shown) {
            const { position, rotation } = doors.frame(door);
            group.position.set(...position);
            group.quaternion.set(...rotation);
        }
    }
}
