// SPDX-License-Identifier: MIT
// How bodies darken the ground that they lie on or fall toward: a soft oval below each, as wide as the body is, seen from
// above; the less the higher it is. The sun throws shadows of its own, but does not come into halls.
import * as THREE from 'three';
import { kStopsSight } from './masks.js';
import { turned } from './turns.js';

const kReach = 2.5; // metres below the lowest point: farther away it darkens nothing
const kDark = 0.62; // at most
const kWider = 1.3; // than the body
const kLift = 0.02; // metres above the ground
const kTexels = 64;

/** Half axes and direction of the oval that a box covers, seen from above. @param half  metres @returns { long, short, angle, high: half its height } */
export function ovalOf(half, rotation) {
    let [xx, xy, yy, high] = [0, 0, 0, 0];
    half.forEach((size, axis) => {
        const [x, y, z] = turned(rotation, [0, 1, 2].map((k) => (k === axis ? size : 0)));
        xx += x * x;
        xy += x * y;
        yy += y * y;
        high += Math.abs(z);
    });
    const [mean, apart] = [(xx + yy) / 2, Math.hypot((xx - yy) / 2, xy)];
    return { long: Math.sqrt(mean + apart), short: Math.sqrt(Math.max(0, mean - apart)), angle: Math.atan2(2 * xy, xx - yy) / 2, high };
}

/** Dark in the middle, nothing at the rim. */
function makeSpot() {
    const pixels = new Uint8Array(4 * kTexels * kTexels);
    for (let k = 0; k < kTexels * kTexels; ++k) {
        const [x, y] = [(2 * ((k % kTexels) + 0.5)) / kTexels - 1, (2 * (Math.floor(k / kTexels) + 0.5)) / kTexels - 1];
        const inside = Math.max(0, 1 - Math.hypot(x, y));
        pixels[4 * k + 3] = 255 * Math.min(1, inside * inside * (3 - 2 * inside) * 1.35);
    }
    const texture = new THREE.DataTexture(pixels, kTexels, kTexels);
    texture.magFilter = texture.minFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

export class ContactShadows {
    constructor() {
        this.level = null; // that those of sleepers lie on
        this.spot = makeSpot();
        this.group = new THREE.Group();
        this.shown = new Map(); // piece -> mesh
        this.flat = new THREE.PlaneGeometry(2, 2);
    }

    material() {
        return new THREE.MeshBasicMaterial({ map: this.spot, color: 0x000000, transparent: true, depthWrite: false, fog: false, polygonOffset: true, polygonOffsetFactor: -1 });
    }

    /** Pieces came or went. */
    change({ added, removed }) {
        for (const piece of removed) {
            const mesh = this.shown.get(piece);
            if (!mesh) continue;
            this.shown.delete(piece);
            this.group.remove(mesh);
            mesh.material.dispose();
        }
        for (const piece of added) {
            const mesh = new THREE.Mesh(this.flat, this.material());
            mesh.visible = false;
            this.shown.set(piece, mesh);
            this.group.add(mesh);
        }
    }

    /** Where they are now: a cast for each that is awake, and for all when the level is another one. @param bodies  of the pieces */
    update(bodies, level) {
        const changed = level !== this.level;
        this.level = level;
        for (const [piece, mesh] of this.shown) {
            const { userData } = mesh;
            if (!piece.asleep || !userData.asleep || changed) this.#lay(piece, mesh, bodies.pose(piece.id));
            userData.asleep = piece.asleep;
        }
    }

    #lay({ low, high }, mesh, { position, rotation }) {
        const [half, middle] = [low.map((x, axis) => (high[axis] - x) / 2), low.map((x, axis) => (high[axis] + x) / 2)];
        const at = turned(rotation, middle).map((x, axis) => x + position[axis]);
        const oval = ovalOf(half, rotation);
        const hit = this.level.cast({ centre: at, radius: 0, path: [0, 0, -oval.high - kReach] }, { mask: kStopsSight });
        const free = hit.hit ? Math.max(0, hit.fraction * (oval.high + kReach) - oval.high) : kReach;
        mesh.visible = free < kReach;
        if (!mesh.visible) return;
        mesh.material.opacity = kDark * (1 - free / kReach) ** 2;
        const normal = new THREE.Vector3(...hit.normal);
        mesh.position.set(...hit.point).addScaledVector(normal, kLift);
        mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), normal).multiply(new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0, 1), oval.angle));
        const wider = kWider + 0.3 * free;
        mesh.scale.set(oval.long * wider, Math.max(0.3 * oval.long, oval.short) * wider, 1);
    }
}
