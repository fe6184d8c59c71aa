// SPDX-License-Identifier: MIT
// Who walks: three spheres, one above the other, moved by sphere casts that slide along what they meet.
import { kStopsWalk } from './masks.js';
import { add, along, cross, dot, flatten, length, times } from './vector.js';

export const kRadius = 0.35; // metres
export const kCentres = [0.35, 0.85, 1.35]; // of the spheres above the feet: nearer than two radii, so no gap between
export const kEye = 1.56;
const kWalk = 4.5; // metres a second
const kRun = 8;
const kJump = 5.6;
const kGravity = 16;
const kStep = 0.42; // what one walks up without jumping
const kWalkable = 0.6; // least z of the normal of what one stands on
const kSteepest = 0.25; // the same on an edge whose upper face is walkable: the edge of a step
const kLongestStep = 1 / 60; // seconds
const kMostSlides = 4;

/** What is left of a motion after the contacts met so far: along one plane, along the crease of two, or nothing. */
function clip(motion, normals) {
    for (let a = normals.length - 1; a >= 0; --a) {
        const flat = flatten(motion, normals[a]);
        if (normals.every((n) => dot(flat, n) > -1e-9)) return flat;
    }
    for (let a = 0; a < normals.length; ++a) {
        for (let b = a + 1; b < normals.length; ++b) {
            const crease = cross(normals[a], normals[b]);
            const size = length(crease);
            if (size < 1e-6) continue;
            const unit = times(crease, 1 / size);
            const slid = times(unit, dot(motion, unit));
            if (normals.every((n) => dot(slid, n) > -1e-9)) return slid;
        }
    }
    return [0, 0, 0];
}

export class Player {
    constructor(probe) {
        this.probe = probe;
        this.feet = [0, 0, 0];
        this.velocity = [0, 0, 0];
        this.yaw = 0;
        this.pitch = 0;
        this.grounded = false;
        this.trail = []; // where one stood, for when undo puts rock around somebody
    }

    eye() {
        return [this.feet[0], this.feet[1], this.feet[2] + kEye];
    }

    place(feet) {
        this.feet = [...feet];
        this.velocity = [0, 0, 0];
        this.grounded = false;
        this.trail = [];
    }

    look(yaw, pitch) {
        this.yaw = yaw;
        this.pitch = Math.max(-1.55, Math.min(1.55, pitch));
    }

    /** Whether somebody may stand there: in the air, and no sphere reaches a face. */
    isFree(feet, world = this.probe.world) {
        return kCentres.every((height) => {
            const centre = [feet[0], feet[1], feet[2] + height];
            return world.locate(centre).where !== 'solid' && world.overlap(centre, kRadius, { mask: kStopsWalk }).length === 0;
        });
    }

    /** The first contact of the three spheres along a motion. */
    sweep(path) {
        let first = null;
        for (const height of kCentres) {
            const hit = this.probe.cast([this.feet[0], this.feet[1], this.feet[2] + height], kRadius, path, kStopsWalk);
            if (hit.status === 'miss' || hit.status === 'invalid') continue;
            if (!first || hit.safeFraction < first.safeFraction) first = hit;
        }
        return first;
    }

    /** Moves as far as it goes along a motion, then along what was met. Returns the normals met. */
    slide(motion) {
        const normals = [];
        let rest = motion;
        for (let k = 0; k < kMostSlides && dot(rest, rest) > 1e-12; ++k) {
            const hit = this.sweep(rest);
            if (!hit) {
                this.feet = add(this.feet, rest);
                break;
            }
            this.feet = along(this.feet, rest, hit.safeFraction);
            normals.push(hit.normal);
            rest = clip(times(rest, 1 - hit.safeFraction), normals);
        }
        return normals;
    }

    /** Whether a contact below holds somebody: not too steep, or an edge or corner with a floor just beyond it. */
    holds(hit) {
        const [x, y, z] = hit.normal;
        if (z >= kWalkable) return true;
        if (z < kSteepest || hit.feature === 'face') return false;
        const size = Math.hypot(x, y);
        const above = [hit.point[0] - (0.02 * x) / size, hit.point[1] - (0.02 * y) / size, hit.point[2] + 0.05];
        const floor = this.probe.cast(above, 0, [0, 0, -0.1], kStopsWalk);
        return floor.status === 'hit' && floor.normal[2] >= kWalkable;
    }

    /** Straight down as far as `depth`; says whether there was something to stand on, else stays. */
    drop(depth) {
        const hit = this.sweep([0, 0, -depth]);
        if (!hit || !this.holds(hit)) return false;
        this.feet[2] -= depth * hit.safeFraction;
        return true;
    }

    /** Over the ground: sliding; where that is stopped, by stepping up, forward and down again, if it leads further. */
    walk(motion) {
        const before = this.feet;
        const normals = this.slide(motion);
        if (normals.length === 0 || !this.grounded) return normals;
        const slid = this.feet;
        const gone = (feet) => Math.hypot(feet[0] - before[0], feet[1] - before[1]);
        this.feet = [...before];
        const roof = this.sweep([0, 0, kStep]);
        const rise = kStep * (roof ? roof.safeFraction : 1);
        this.feet[2] += rise;
        const stepped = this.slide(motion);
        if (this.drop(rise + 0.02) && gone(this.feet) > gone(slid) + 1e-4) return stepped;
        this.feet = slid;
        return normals;
    }

    /** One step of at most kLongestStep. `keys`: forward, back, left, right, jump, run as booleans. */
    stepOnce(dt, keys) {
        const ahead = (keys.forward ? 1 : 0) - (keys.back ? 1 : 0);
        const aside = (keys.right ? 1 : 0) - (keys.left ? 1 : 0);
        const size = Math.hypot(ahead, aside) || 1;
        const speed = (keys.run ? kRun : kWalk) / size;
        const [c, s] = [Math.cos(this.yaw), Math.sin(this.yaw)];
        const wish = [(ahead * c + aside * s) * speed, (ahead * s - aside * c) * speed];

        const footing = this.velocity[2] <= 0 && this.sweep([0, 0, -0.02]);
        this.grounded = Boolean(footing) && this.holds(footing);
        const share = 1 - Math.exp(-(this.grounded ? 14 : 2.5) * dt);
        for (const k of [0, 1]) this.velocity[k] += (wish[k] - this.velocity[k]) * share;
        const jumps = this.grounded && keys.jump;
        if (jumps) this.velocity[2] = kJump;
        else if (this.grounded) this.velocity[2] = 0;
        else this.velocity[2] = Math.max(this.velocity[2] - kGravity * dt, -40);

        const met = this.walk([this.velocity[0] * dt, this.velocity[1] * dt, 0]);
        if (this.velocity[2] !== 0) met.push(...this.slide([0, 0, this.velocity[2] * dt]));
        else if (this.grounded) this.drop(kStep); // down stairs without flying
        if (met.length) {
            const vertical = this.velocity[2];
            this.velocity = clip(this.velocity, met);
            if (!jumps) this.velocity[2] = Math.min(this.velocity[2], Math.max(vertical, 0)); // no launch off a slope
        }
    }

    step(dt, keys) {
        const count = Math.max(1, Math.ceil(dt / kLongestStep - 1e-9));
        for (let k = 0; k < count; ++k) this.stepOnce(dt / count, keys);
        const last = this.trail[this.trail.length - 1];
        if (this.grounded && (!last || Math.hypot(...last.map((x, k) => x - this.feet[k])) > 0.3)) {
            this.trail.push([...this.feet]);
            if (this.trail.length > 400) this.trail.shift();
        }
    }

    /** After rock came back: where one was last that is free now; null when there is no such place. */
    freeYourself() {
        if (this.isFree(this.feet)) return this.feet;
        for (let k = this.trail.length - 1; k >= 0; --k) {
            if (!this.isFree(this.trail[k])) continue;
            const feet = this.trail[k];
            this.trail.length = k;
            this.feet = [...feet];
            this.velocity = [0, 0, 0];
            return feet;
        }
        return null;
    }
}
