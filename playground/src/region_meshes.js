// SPDX-License-Identifier: MIT
// What is drawn of a world: a mesh for each cube of it, as World.regionMeshes() gives them. After an edit the meshes of
// the cubes that it changed are replaced, and nothing else is sent to the graphics card.
import * as THREE from 'three';
import { kStopsLiquid, kStopsShots, kStopsSight } from './masks.js';
import { kFirstClear } from './painter.js';

/** Metres: how wide the picture of a surface is, where a level does not say otherwise. */
export const kPicture = 2;
const kTexels = 128; // of a picture, as levels of texels are meant

/** How World.regionMeshes() is asked. What only walkers meet is not to be seen. */
export function regionOptions(materials) {
    return { size: 16, mask: kStopsShots | kStopsSight | kStopsLiquid, textureSizes: new Float64Array(2 * materials.length).fill(kTexels) };
}

/** Parts of a mesh with the run that each is in, in order: visit(part, run). */
function eachPart({ runs, parts }, visit) {
    let r = 0;
    for (let p = 0; p < parts.faces.length; ++p) {
        while (parts.firstTriangles[p] >= runs[r].firstTriangle + runs[r].triangleCount) ++r;
        visit(p, runs[r]);
    }
}

export class RegionMeshes {
    /**
     * @param painter  colours: paint(face, x, y, z, out) puts red, green, blue of 0..255 and a kind into `out`
     * @param materials  `solid`; `clear` draws what one sees through, over the rest, from the same buffers
     * @param shadow  the material of shadows that it throws
     */
    constructor(materials, painter, shadow) {
        this.materials = materials;
        this.painter = painter;
        this.shadow = shadow;
        this.group = new THREE.Group();
        this.regions = new Map(); // place -> { geometry, group, origin, faces: their ids, ids: of the face of each triangle }
        this.faceCount = 0;
        this.triangles = 0;
        this.sent = 0; // vertices of the last replace()
    }

    /** Meshes take the place of those of the same cubes; an empty one only ends them. */
    replace(meshes) {
        this.sent = 0;
        for (const mesh of meshes) {
            const place = String(mesh.place);
            this.#remove(place);
            if (mesh.faces.length > 0) this.#add(place, mesh);
        }
    }

    /** Nothing is drawn any more. */
    clear() {
        for (const place of [...this.regions.keys()]) this.#remove(place);
    }

    #remove(place) {
        const region = this.regions.get(place);
        if (!region) return;
        this.regions.delete(place);
        this.group.remove(region.group);
        region.geometry.dispose();
        this.faceCount -= region.faces.length;
        this.triangles -= region.ids.length;
    }

    #add(place, mesh) {
        const { surfaces, clear } = this.#paint(mesh);
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(mesh.positions, 3));
        geometry.setAttribute('normal', new THREE.BufferAttribute(mesh.normals, 3));
        geometry.setAttribute('tangent', new THREE.BufferAttribute(mesh.tangents, 4));
        geometry.setAttribute('uv', new THREE.BufferAttribute(mesh.uvs, 2));
        geometry.setAttribute('blend', new THREE.BufferAttribute(mesh.blends, 4, true));
        geometry.setAttribute('surface', new THREE.BufferAttribute(surfaces, 4, true)); // the fourth is the kind of surface
        geometry.setIndex(new THREE.BufferAttribute(mesh.corners, 1));
        const corners = [mesh.low, mesh.high].map((corner) => new THREE.Vector3(...corner.map((x, axis) => x - mesh.origin[axis])));
        geometry.boundingBox = new THREE.Box3(...corners);
        geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new THREE.Sphere());
        const group = new THREE.Group();
        group.position.set(...mesh.origin);
        const solid = new THREE.Mesh(geometry, this.materials.solid);
        solid.castShadow = solid.receiveShadow = true;
        solid.customDepthMaterial = this.shadow;
        group.add(solid);
        if (clear) group.add(new THREE.Mesh(geometry, this.materials.clear));
        this.group.add(group);
        const region = { geometry, group, origin: mesh.origin, faces: mesh.parts.faces, ids: mesh.faces };
        this.regions.set(place, region);
        this.faceCount += region.faces.length;
        this.triangles += region.ids.length;
        this.sent += mesh.positions.length / 3;
    }

    /** A colour and a kind for each vertex; coordinates become repeats of the picture. */
    #paint(mesh) {
        const { parts, positions, uvs, origin } = mesh;
        const surfaces = new Uint8Array(4 * (positions.length / 3));
        const out = new Uint8Array(4);
        const face = { material: 0, source: 0, sourceEdit: 0 };
        let clear = false;
        eachPart(mesh, (p, run) => {
            face.material = run.material;
            face.source = parts.sources[p];
            face.sourceEdit = parts.sourceEdits[p];
            const end = parts.firstVertices[p] + parts.vertexCounts[p];
            for (let v = parts.firstVertices[p]; v < end; ++v) {
                this.painter.paint(face, origin[0] + positions[3 * v], origin[1] + positions[3 * v + 1], origin[2] + positions[3 * v + 2], out);
                surfaces.set(out, 4 * v);
                clear ||= out[3] >= kFirstClear;
                if (run.uvUnit !== 'metres') continue;
                uvs[2 * v] /= kPicture;
                uvs[2 * v + 1] /= kPicture;
            }
        });
        return { surfaces, clear };
    }
}
