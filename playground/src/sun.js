// SPDX-License-Identifier: MIT
// The light: the sun, whose shadows are drawn into a map when something has changed, the sky, and a little from the
// other side so that walls in the shade are not all alike.
import * as THREE from 'three';

const kToSun = new THREE.Vector3(0.5, -0.42, 0.76).normalize();
const kTexels = 2048;
const kMovingEvery = 4; // frames of the pace of the moment: how often the map follows what moves

export class Sun {
    constructor(scene, renderer) {
        this.renderer = renderer;
        renderer.shadowMap.enabled = true;
        renderer.shadowMap.type = THREE.PCFShadowMap;
        renderer.shadowMap.autoUpdate = false;
        scene.add(new THREE.HemisphereLight(0xdfe8f6, 0xa89c8e, 2.0));
        const fill = new THREE.DirectionalLight(0xbfd0e8, 0.45);
        fill.position.set(-0.6, 0.7, 0.25);
        this.light = new THREE.DirectionalLight(0xfff0d8, 2.1);
        this.light.castShadow = true;
        this.light.shadow.mapSize.set(kTexels, kTexels);
        this.light.shadow.bias = -0.0006;
        this.light.shadow.normalBias = 0.05;
        this.light.shadow.radius = 1.5;
        scene.add(fill, this.light, this.light.target);
        this.since = 0; // seconds
    }

    /** The map covers this box. @param low, high  of the level, metres */
    cover(low, high) {
        const middle = new THREE.Vector3(...low.map((x, axis) => (x + high[axis]) / 2));
        const radius = Math.hypot(...low.map((x, axis) => high[axis] - x)) / 2;
        this.light.target.position.copy(middle);
        this.light.position.copy(middle).addScaledVector(kToSun, radius + 1);
        this.light.target.updateMatrixWorld();
        this.light.updateMatrixWorld();
        // As narrow as the box is, seen from the sun.
        const { camera } = this.light.shadow;
        const view = new THREE.Matrix4().lookAt(this.light.position, middle, camera.up).setPosition(this.light.position).invert();
        const box = new THREE.Box3();
        for (let k = 0; k < 8; ++k) box.expandByPoint(new THREE.Vector3(...low.map((x, axis) => ((k >> axis) & 1 ? high[axis] : x))).applyMatrix4(view));
        Object.assign(camera, { left: box.min.x, right: box.max.x, bottom: box.min.y, top: box.max.y, near: 0.5, far: -box.min.z + 1 });
        camera.updateProjectionMatrix();
        this.changed();
    }

    /** The level is another one: the map is drawn anew with the next frame. */
    changed() {
        this.renderer.shadowMap.needsUpdate = true;
    }

    /** Something moves, and dt seconds have gone by: the map follows now and then. */
    moving(dt) {
        this.since += dt;
        if (this.since < kMovingEvery * dt) return;
        this.since = 0;
        this.changed();
    }
}
