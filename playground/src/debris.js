// SPDX-License-Identifier: MIT
// What came loose, as bodies of the engine: they fall, tumble, come to rest; the next blast pushes them and cuts them to
// pieces, and so does a hard fall those that are heavy.
import { makeCrack } from './crack.js';
import { combine, poseWithin, turned } from './turns.js';
import { add, cross, length, subtract, times } from './vector.js';

const kMost = 90; // bodies: the ones that lie longest leave
const kDensity = 2400;
const kFit = { maxSpheres: 48, maxError: 0.05 }; // with fewer a bridge lies half a metre in the floor
const kHeavy = 150; // kilograms: lighter ones do not break by a fall
const kBreaks = 5; // metres a second that a fall takes away within a step
const kMostBreaks = 2; // times, of what came of one chunk
const kFirstEdit = 1 << 20; // of cuts in a body's own world: none of the level's has such a number
const kPush = { speed: 9, impulse: 6000 }; // metres a second and newton seconds at most, at the middle of a blast
const kReach = 3; // of a blast's radius

export class Debris {
    /** @param matters  of the level @param onChange  ({ added, removed }): pieces; a piece is { id, world, origin, size, mass, ... } */
    constructor(firma, matters, onChange = () => {}) {
        this.firma = firma;
        this.matters = matters; // of the level
        this.onChange = onChange;
        this.bodies = firma.bodies();
        this.pieces = new Map(); // by the body's name
        this.edits = 0;
    }

    /** Pieces that left the level. @param loose  handle of a carving, stays the caller's @param version  of the world without them */
    add(loose, version) {
        const added = [];
        loose.list().forEach((chunk, k) => {
            const piece = this.#make(loose, k, { version, origin: chunk.origin, breaks: 0, ...this.#stuffOf(chunk) });
            if (piece) added.push(piece);
        });
        this.#tell(added, []);
        this.#keepFew();
    }

    /** Time goes on. @returns what was hit hard: [{ piece, point, speed }] */
    step(scene, dt) {
        if (this.pieces.size === 0) return [];
        this.bodies.step(scene, dt);
        const hits = [];
        for (const piece of [...this.pieces.values()]) {
            piece.age += dt;
            const before = piece.velocity;
            const body = this.bodies.get(piece.id);
            Object.assign(piece, { velocity: body.velocity, asleep: body.asleep, at: body.position });
            const lost = length(subtract(body.velocity, before)) - 9.81 * dt;
            if (lost < 1) continue;
            hits.push({ piece, point: body.position, speed: lost });
            if (lost > kBreaks && piece.mass > kHeavy && piece.breaks < kMostBreaks) this.#crack(piece);
        }
        this.#keepFew();
        return hits;
    }

    /** A blast among them. @param free  (from, to) => whether nothing is between @param cutter, pose  of its crater */
    blast(point, radius, cutter, pose, free) {
        for (const piece of [...this.pieces.values()]) {
            const away = subtract(piece.at, point);
            const distance = length(away);
            if (distance > kReach * radius + piece.size) continue;
            const pieces = distance < radius + piece.size ? this.#cut(piece, cutter, pose) : [piece];
            for (const one of pieces) this.#push(one, point, radius, free);
        }
    }

    /** Those of shots after a version are part of the world again. */
    undo(version) {
        this.#drop([...this.pieces.values()].filter((piece) => piece.version > version));
    }

    clear() {
        this.#drop([...this.pieces.values()]);
    }

    /** Gives all back. */
    release() {
        this.clear();
        this.bodies.release();
    }

    get moving() {
        for (const piece of this.pieces.values()) if (!piece.asleep) return true;
        return false;
    }

    /** The matter that it is mostly made of, and the material of its inside. */
    #stuffOf({ matters }) {
        const most = matters.reduce((best, one) => (one.volume > best.volume ? one : best), { matter: 0, volume: 0 });
        const { name, inside } = this.matters[most.matter];
        return { matter: name, inside };
    }

    /** A body of a chunk; null where no sphere has room in it. */
    #make(chunks, k, rest) {
        const { low, high, mass } = chunks.list()[k];
        let id;
        try {
            id = this.bodies.addChunk(chunks, k, kFit);
        } catch (error) {
            if (error.code === 'INVALID') return null;
            throw error;
        }
        const size = length(subtract(high, low)) / 2;
        const piece = { id, world: chunks.world(k), mass, size, age: 0, velocity: [0, 0, 0], asleep: false, at: this.bodies.get(id).position, ...rest };
        this.pieces.set(id, piece);
        return piece;
    }

    /** Takes a shape out of a body. @returns what is left of it, as it flew */
    #cut(piece, cutter, pose) {
        const frame = this.bodies.pose(piece.id);
        const { world: after, report } = piece.world.carve(cutter, poseWithin(frame, pose), { edit: kFirstEdit + ++this.edits, material: piece.inside });
        if (report.status !== 'done') {
            after.release();
            return [piece];
        }
        const was = this.bodies.get(piece.id);
        const pieces = after.pieces(kDensity);
        after.release();
        const added = [];
        for (let k = 0; k < pieces.list().length; ++k) {
            const one = this.#make(pieces, k, { version: piece.version, origin: piece.origin, matter: piece.matter, inside: piece.inside, breaks: piece.breaks + 1, age: piece.age });
            if (!one) continue;
            this.#place(one, frame, was);
            added.push(one);
        }
        pieces.release();
        this.#tell(added, [piece]);
        return added;
    }

    /** Puts a new piece where it was in the old one, going as that part of it went. */
    #place(piece, frame, was) {
        const position = add(frame.position, turned(frame.rotation, this.bodies.get(piece.id).position));
        const velocity = add(was.velocity, cross(was.spin, subtract(position, was.position)));
        this.bodies.set(piece.id, { position, rotation: frame.rotation, velocity, spin: was.spin });
        Object.assign(piece, { at: position, velocity });
    }

    /** Breaks one across its longest side. */
    #crack(piece) {
        const { low, high } = piece.world.facts();
        const { cutter, pose } = makeCrack(this.firma, low, high, this.edits);
        const frame = this.bodies.pose(piece.id);
        const turn = combine(frame.rotation, pose.rotation);
        this.#cut(piece, cutter, { position: add(frame.position, turned(frame.rotation, pose.position)), rotation: turn, scale: pose.scale });
        cutter.release();
    }

    #push(piece, point, radius, free) {
        const away = subtract(piece.at, point);
        const distance = Math.max(0.3, length(away));
        const share = Math.max(0, 1 - distance / (kReach * radius + piece.size)) * (free(point, piece.at) ? 1 : 0.3);
        const impulse = share * Math.min(kPush.speed * piece.mass, kPush.impulse);
        if (impulse <= 0) return;
        const direction = times(add(away, [0, 0, 0.4 * distance]), 1 / distance);
        const arm = times(cross(away, [0.3, -0.5, 0.8]), (0.25 * piece.size) / distance); // not through the middle: it spins
        this.bodies.push(piece.id, times(direction, impulse), add(piece.at, arm));
    }

    #keepFew() {
        const over = this.pieces.size - kMost;
        if (over <= 0) return;
        const by = (piece) => (piece.asleep ? 0 : 1e6) + piece.mass - 10 * piece.age;
        this.#drop([...this.pieces.values()].sort((a, b) => by(a) - by(b)).slice(0, over));
    }

    #tell(added, removed) {
        this.onChange({ added, removed });
        for (const piece of removed) this.#release(piece);
    }

    #drop(pieces) {
        if (pieces.length > 0) this.#tell([], pieces);
    }

    #release(piece) {
        this.pieces.delete(piece.id);
        this.bodies.remove(piece.id);
        piece.world.release();
    }
}
