// SPDX-License-Identifier: MIT
// Who walks: the engine's player, what keys wish of it, and where one stood, for when undo puts rock around somebody.
import { kStopsWalk } from './masks.js';
import { add } from './vector.js';

export const kRadius = 0.35; // metres
const kHeight = 1.7;
const kCrouched = 1.05;
/** Of spheres within it, above the feet: for tests of what it is clear of. */
export const kCentres = [0.35, 0.85, 1.35];
export const kEye = 1.56;
const kCrouchedEye = 0.92;
const kWalk = 4.5; // metres a second
const kRun = 8;
const kRules = { gravity: 16, jumpSpeed: 5.6, stepHeight: 0.42, maxSlope: Math.acos(0.6), groundAcceleration: 55, airAcceleration: 12 };
const kLongestStep = 1 / 60; // seconds
const kEyeSpeed = 5; // metres a second, when it crouches

export class Player {
    /** @param firma  of loadGames() @param probe  knows the world of the moment */
    constructor(firma, probe) {
        this.firma = firma;
        this.probe = probe;
        this.shape = firma.playerCapsule({ radius: kRadius, height: kHeight, crouchedHeight: kCrouched });
        this.body = { position: [0, 0, 0], velocity: [0, 0, 0], mask: kStopsWalk };
        this.yaw = 0;
        this.pitch = 0;
        this.height = kEye; // of the eye
        this.moves = 0; // within the last step
        this.caught = null; // the part that it is pressed by
        this.landed = 0; // metres a second, within the last step
        this.trail = [];
    }

    get feet() {
        return this.body.position;
    }

    get velocity() {
        return this.body.velocity;
    }

    get grounded() {
        return Boolean(this.body.onGround);
    }

    eye() {
        return add(this.feet, [0, 0, this.height]);
    }

    place(feet) {
        this.body = { position: [...feet], velocity: [0, 0, 0], mask: kStopsWalk };
        this.trail = [];
    }

    look(yaw, pitch) {
        this.yaw = yaw;
        this.pitch = Math.max(-1.55, Math.min(1.55, pitch));
    }

    /** Something throws it. @param change  of its velocity, metres a second */
    push(change) {
        this.body = { ...this.body, velocity: add(this.velocity, change), onGround: this.grounded && change[2] <= 0.5 };
    }

    /** Whether somebody may stand there. */
    isFree(feet, world = this.probe.world) {
        return this.firma.playerFits(world, this.shape, feet, { mask: kStopsWalk });
    }

    /** What keys wish: forward, back, left, right, jump, run, crouch as booleans. */
    wish(keys) {
        const ahead = (keys.forward ? 1 : 0) - (keys.back ? 1 : 0);
        const aside = (keys.right ? 1 : 0) - (keys.left ? 1 : 0);
        const speed = (keys.run ? kRun : kWalk) / (Math.hypot(ahead, aside) || 1);
        const [c, s] = [Math.cos(this.yaw), Math.sin(this.yaw)];
        return { velocity: [(ahead * c + aside * s) * speed, (ahead * s - aside * c) * speed, 0], jump: Boolean(keys.jump), crouch: Boolean(keys.crouch) };
    }

    /** Time goes on by dt seconds. @param scene  { world, parts }: parts go along all of their motions meanwhile */
    step(dt, keys, scene = { world: this.probe.world }) {
        const count = Math.max(1, Math.ceil(dt / kLongestStep - 1e-9));
        this.moves = count;
        this.caught = null;
        this.landed = 0;
        for (let k = 0; k < count; ++k) {
            const there = { ...scene, from: k / count, to: (k + 1) / count };
            const move = this.firma.movePlayer(there, this.shape, this.body, this.wish(keys), dt / count, kRules);
            this.body = move.player;
            this.caught ??= move.crushedBy;
            this.landed = Math.max(this.landed, move.landedSpeed);
        }
        const eye = this.body.crouched ? kCrouchedEye : kEye;
        this.height += Math.max(-kEyeSpeed * dt, Math.min(kEyeSpeed * dt, eye - this.height));
        this.#remember();
    }

    /** Moves that lead nowhere, so that the first ones find compiled code. */
    warmUp(count) {
        for (let k = 0; k < count; ++k) this.firma.movePlayer(this.probe.world, this.shape, this.body, this.wish({ forward: true }), 1 / 60, kRules);
    }

    /** After rock came back: where one was last that is free now; null when there is no such place. */
    freeYourself() {
        if (this.isFree(this.feet)) return this.feet;
        for (let k = this.trail.length - 1; k >= 0; --k) {
            if (!this.isFree(this.trail[k])) continue;
            const feet = this.trail[k];
            const trail = this.trail.slice(0, k);
            this.place(feet);
            this.trail = trail;
            return feet;
        }
        return null;
    }

    release() {
        this.shape.release();
    }

    #remember() {
        const last = this.trail[this.trail.length - 1];
        if (!this.grounded || (last && Math.hypot(...last.map((x, k) => x - this.feet[k])) <= 0.3)) return;
        this.trail.push([...this.feet]);
        if (this.trail.length > 400) this.trail.shift();
    }
}
