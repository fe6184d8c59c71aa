// SPDX-License-Identifier: MIT
// What stands or moves in somebody's way besides the level: doors, and the heaviest pieces of rubble as parts of the scene.
// Players walk on them and are pushed by them, shots meet them.
import { boxMesh } from './box_mesh.js';
import { back, combine } from './turns.js';
import { subtract } from './vector.js';

const kMost = 16; // pieces
const kHeavy = 40; // kilograms: lighter ones stop nobody
const kNowhere = { position: [0, 0, -4000], rotation: [0, 0, 0, 1] };
const kMostTurn = 7; // radians in a step: more is as if it did not turn

const standing = ({ position, rotation }) => ({ position, rotation, path: [0, 0, 0], turn: [0, 0, 0] });

/** Axis times angle from one turn to another. */
export function turnBetween(from, to) {
    const [x, y, z, w] = combine(to, back(from));
    const sign = w < 0 ? -1 : 1;
    const size = Math.hypot(x, y, z);
    if (size < 1e-9) return [0, 0, 0];
    const angle = 2 * Math.atan2(size, Math.abs(w));
    return [x, y, z].map((c) => (sign * c * angle) / size);
}

/** From one pose to another, as a motion of a part. */
function between(from, to) {
    const turn = turnBetween(from.rotation, to.rotation);
    const path = subtract(to.position, from.position);
    return Math.hypot(...turn) > kMostTurn ? standing(to) : { ...standing(from), path, turn };
}

export class Obstacles {
    constructor(firma, doors, debris) {
        this.doors = doors;
        this.debris = debris;
        const { positions, corners } = boxMesh([0.01, 0.01, 0.01]);
        this.nothing = firma.worldFromMesh({ positions, corners });
        this.parts = firma.parts();
        for (const door of doors.all) this.parts.add({ world: door.world, motion: standing(doors.frame(door)) });
        this.slots = Array(kMost).fill(null); // { piece, from, to: its poses in this step }
        for (let k = 0; k < kMost; ++k) this.parts.add({ world: this.nothing, motion: standing(kNowhere) });
    }

    /** What the number of a part stands for: { door } or { piece }. */
    of(part) {
        const count = this.doors.all.length;
        return part < count ? { door: this.doors.all[part] } : { piece: this.slots[part - count].piece };
    }

    /** A leaf is another one. */
    changeDoor(door) {
        this.parts.set(this.doors.all.indexOf(door), { world: door.world, motion: standing(this.doors.frame(door)) });
    }

    /** Pieces came or went: the heaviest keep or get a place. */
    choose() {
        const heavy = [...this.debris.pieces.values()].filter(({ mass }) => mass > kHeavy).sort((a, b) => b.mass - a.mass).slice(0, kMost);
        const chosen = new Set(heavy);
        this.slots.forEach((slot, k) => {
            if (slot && !chosen.delete(slot.piece)) this.#put(k, null);
        });
        for (const piece of chosen) this.#put(this.slots.indexOf(null), piece);
    }

    /** Bodies have moved, doors are about to: how all go within this step. */
    begin() {
        for (const slot of this.slots) if (slot) Object.assign(slot, { from: slot.to, to: this.debris.bodies.pose(slot.piece.id) });
        this.#move((slot) => between(slot.from, slot.to), this.doors.motions());
    }

    /** All are where they went. */
    arrive() {
        this.#move((slot) => standing(slot.to), this.doors.motions());
    }

    release() {
        this.parts.release();
        this.nothing.release();
    }

    #move(of, doors) {
        this.parts.setMotions([...doors, ...this.slots.map((slot) => (slot ? of(slot) : standing(kNowhere)))]);
    }

    #put(k, piece) {
        const at = piece ? this.debris.bodies.pose(piece.id) : kNowhere;
        this.slots[k] = piece && { piece, from: at, to: at };
        this.parts.set(this.doors.all.length + k, { world: piece?.world ?? this.nothing, motion: standing(at) });
    }
}
