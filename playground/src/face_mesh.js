// SPDX-License-Identifier: MIT
// All faces of a world as one mesh of triangles, in which faces come and go: what an edit did not change is not touched.
//
// Each face has a run of triangles in the buffers. A face that goes leaves its run, as triangles without area, to the
// next face of as many; only what was written is sent to the graphics card.
import * as THREE from 'three';

const kFirstCapacity = 16384; // triangles

export class FaceMesh {
    /**
     * @param painter  colours: paint(faces, k, x, y, z, out) puts red, green, blue of 0..255 and a kind into `out`
     * @param clearMaterial  draws what one sees through, over the rest, from the same buffers
     */
    constructor(material, painter, clearMaterial) {
        this.painter = painter;
        this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
        this.clearMesh = new THREE.Mesh(this.mesh.geometry, clearMaterial);
        this.mesh.frustumCulled = this.clearMesh.frustumCulled = false;
        this.runs = new Map(); // face id -> first triangle and how many
        this.free = new Map(); // how many -> first triangles
        this.used = 0; // triangles in use or free
        this.triangles = 0; // of faces that are there
        this.#reserve(kFirstCapacity);
    }

    get faceCount() {
        return this.runs.size;
    }

    /** Takes out the faces with these ids. */
    remove(ids) {
        for (const id of ids) {
            const run = this.runs.get(id);
            if (!run) throw new Error(`face ${id} is not drawn, but goes`);
            this.runs.delete(id);
            this.triangles -= run.count;
            this.position.array.fill(0, run.first * 9, (run.first + run.count) * 9);
            this.#touch(run);
            if (!this.free.has(run.count)) this.free.set(run.count, []);
            this.free.get(run.count).push(run.first);
        }
    }

    /** Puts in faces as World.faces() gives them. */
    add(faces) {
        for (let k = 0; k < faces.ids.length; ++k) {
            if (this.runs.has(faces.ids[k])) throw new Error(`face ${faces.ids[k]} is drawn already, and comes`);
            const run = this.#take(faces.cornerCounts[k] - 2);
            this.runs.set(faces.ids[k], run);
            this.triangles += run.count;
            this.#write(run, faces, k);
            this.#touch(run);
        }
        this.mesh.geometry.setDrawRange(0, this.used * 3);
    }

    #take(count) {
        const left = this.free.get(count);
        if (left && left.length) return { first: left.pop(), count };
        if (this.used + count > this.capacity) this.#reserve(Math.max(2 * this.capacity, this.used + count));
        const run = { first: this.used, count };
        this.used += count;
        return run;
    }

    /** A fan of triangles around the first corner: faces are convex. */
    #write(run, faces, k) {
        const { corners, normals } = faces;
        const first = faces.firstCorners[k];
        for (let t = 0; t < run.count; ++t) {
            for (let c = 0; c < 3; ++c) {
                const from = 3 * (c === 0 ? first : first + t + c);
                const vertex = 3 * (run.first + t) + c;
                const [x, y, z] = [corners[from], corners[from + 1], corners[from + 2]];
                this.position.array.set([x, y, z], 3 * vertex);
                for (let a = 0; a < 3; ++a) this.normal.array[4 * vertex + a] = Math.round(127 * normals[3 * k + a]);
                this.painter.paint(faces, k, x, y, z, this.colour.array.subarray(4 * vertex, 4 * vertex + 4));
            }
        }
    }

    #attributes() {
        return [this.position, this.normal, this.colour];
    }

    #touch(run) {
        for (const attribute of this.#attributes()) {
            attribute.addUpdateRange(run.first * 3 * attribute.itemSize, run.count * 3 * attribute.itemSize);
            attribute.needsUpdate = true;
        }
    }

    /** Larger buffers with what is in the old ones: seldom, and the one time that all is sent anew. */
    #reserve(capacity) {
        const old = this.position && this.#attributes().map((attribute) => attribute.array);
        const attribute = (Kind, itemSize, normalized) => {
            const made = new THREE.BufferAttribute(new Kind(capacity * 3 * itemSize), itemSize, normalized);
            made.setUsage(THREE.DynamicDrawUsage);
            return made;
        };
        this.position = attribute(Float32Array, 3, false);
        this.normal = attribute(Int8Array, 4, true); // the fourth for alignment
        this.colour = attribute(Uint8Array, 4, true); // the fourth is the kind of surface
        if (old) this.#attributes().forEach((to, k) => to.array.set(old[k]));
        this.capacity = capacity;
        this.mesh.geometry.dispose();
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', this.position);
        geometry.setAttribute('normal', this.normal);
        geometry.setAttribute('surface', this.colour);
        geometry.setDrawRange(0, this.used * 3);
        this.mesh.geometry = this.clearMesh.geometry = geometry;
    }
}
