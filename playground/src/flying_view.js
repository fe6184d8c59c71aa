// SPDX-License-Identifier: MIT
// Rockets and grenades as they are drawn: a few meshes that are used again.
import * as THREE from 'three';

export class FlyingView {
    /** @param geometry, colour  of one of them */
    constructor(geometry, colour) {
        this.geometry = geometry;
        this.material = new THREE.MeshLambertMaterial({ color: colour });
        this.group = new THREE.Group();
        this.meshes = [];
    }

    static rockets() {
        return new FlyingView(new THREE.CylinderGeometry(0.025, 0.045, 0.42, 8).rotateX(Math.PI / 2), 0x4a5058);
    }

    static grenades() {
        return new FlyingView(new THREE.IcosahedronGeometry(0.07, 1), 0x4d5a36);
    }

    /** @param places  [{ at, direction }] of all that fly */
    show(places) {
        while (this.meshes.length < places.length) {
            const mesh = new THREE.Mesh(this.geometry, this.material);
            this.meshes.push(mesh);
            this.group.add(mesh);
        }
        this.meshes.forEach((mesh, k) => {
            mesh.visible = k < places.length;
            if (!mesh.visible) return;
            const { at, direction } = places[k];
            mesh.position.set(...at);
            mesh.up.set(0, 0, 1);
            mesh.lookAt(at[0] + direction[0], at[1] + direction[1], at[2] + direction[2]);
        });
    }
}
