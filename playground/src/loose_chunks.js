// SPDX-License-Identifier: MIT
// Pieces that came loose: they have left the world, and are drawn where they were until they have faded. No bodies yet.
import * as THREE from 'three';
import { RegionMeshes, regionOptions } from './region_meshes.js';

const kSeconds = 3; // until nothing is left

/** What there is of pieces, in numbers: cubic metres and kilograms. @param report  of a carving */
export function countChunks({ loose, crumbs }) {
    const list = loose?.list() ?? [];
    const sum = (of) => list.reduce((total, chunk) => total + of(chunk), 0);
    const largest = list.reduce((best, { volume, mass }) => (mass > best.mass ? { volume, mass } : best), { volume: 0, mass: 0 });
    return { count: list.length, volume: sum((chunk) => chunk.volume), mass: sum((chunk) => chunk.mass), largest, crumbs };
}

export class LooseChunks {
    /** @param makeMaterials  () => { solid, clear }, with an opacity of their own */
    constructor(makeMaterials, painter, shadow) {
        this.makeMaterials = makeMaterials;
        this.shadow = shadow;
        this.painter = painter;
        this.group = new THREE.Group();
        this.fading = []; // { meshes, materials, age }: one for each shot
    }

    /** Draws pieces from now on. @param loose  handle of a carving, which stays the caller's */
    add(loose) {
        const materials = this.makeMaterials();
        const meshes = new RegionMeshes(materials, this.painter, this.shadow);
        loose.list().forEach(({ origin }, k) => {
            const body = loose.world(k);
            const own = body.regionMeshes(regionOptions(body.facts().materials));
            body.release();
            const moved = (point) => point.map((x, axis) => x + origin[axis]);
            // The frame of a piece lies in the world as it did there; cubes of several may have one place.
            meshes.replace(own.map((mesh) => ({ ...mesh, place: [...mesh.place, k], origin: moved(mesh.origin), low: moved(mesh.low), high: moved(mesh.high) })));
        });
        this.group.add(meshes.group);
        this.fading.push({ meshes, materials, age: 0 });
    }

    /** Time goes on; those that have faded are dropped. */
    step(dt) {
        for (const one of this.fading) {
            one.age += dt;
            const left = Math.max(0, 1 - one.age / kSeconds);
            for (const material of Object.values(one.materials)) material.opacity = left * (2 - left); // slow at first
        }
        const gone = this.fading.filter(({ age }) => age >= kSeconds);
        this.fading = this.fading.filter(({ age }) => age < kSeconds);
        gone.forEach((one) => this.#drop(one));
    }

    /** None is drawn any more: they are part of the world again, or of another one. */
    clear() {
        for (const one of this.fading) this.#drop(one);
        this.fading = [];
    }

    get triangles() {
        return this.fading.reduce((sum, { meshes }) => sum + meshes.triangles, 0);
    }

    #drop({ meshes, materials }) {
        this.group.remove(meshes.group);
        meshes.clear();
        for (const material of Object.values(materials)) material.dispose();
    }
}
