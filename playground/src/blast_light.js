// SPDX-License-Identifier: MIT
// The flash of a blast, and the glow of a rocket that flies: one light, as each costs every pixel.
import * as THREE from 'three';

const kSeconds = 0.4;
const kBlast = 60; // candela at first
const kRocket = 7;

export class BlastLight {
    constructor() {
        this.light = new THREE.PointLight(0xffa050, 0, 20, 1.3);
        this.age = Infinity;
        this.rocket = null;
    }

    /** A blast went off there. */
    flash(point, normal) {
        this.light.position.set(...point.map((x, k) => x + 0.5 * normal[k]));
        this.age = 0;
    }

    /** Where a rocket is that flies, or null. */
    follow(position) {
        this.rocket = position;
    }

    step(dt) {
        this.age += dt;
        const left = 1 - this.age / kSeconds;
        if (left > 0) {
            this.light.intensity = kBlast * left * left;
        } else if (this.rocket) {
            this.light.position.set(...this.rocket);
            this.light.intensity = kRocket;
        } else {
            this.light.intensity = 0;
        }
    }
}
