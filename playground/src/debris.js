// SPDX-License-Identifier: MIT
// What came loose, as bodies of the engine that know what they are made of: they fall, tumble, come to rest, and break as
// their matter does, by the next blast and, those that are heavy, by a hard fall.
import { kCarveOptions } from './launcher.js';
import { kStopsSight } from './masks.js';
import { poseWithin } from './turns.js';
import { length, subtract } from './vector.js';

const kMost = 90; // bodies: beyond that sleepers leave, small ones first
const kSpheres = 32; // of what comes loose: with 12 a bridge lies 0.7 m in the floor
const kPieces = { maxSpheres: 32, minVolume: 0.002 }; // cubic metres: what is less is dust
const kHeavy = 150; // kilograms: lighter ones do not break by a fall
const kBreaks = 5; // metres a second that a fall takes away, however many steps it takes
const kForgets = 30; // metres a second of that in a second: sliding takes less
const kByFall = { pieces: 8, most: 2 }; // pieces at most; times, of what came of one chunk
const kByBlast = { pieces: 12, most: 3 };
const kPush = { reach: 3, impulse: 8000, maxSpeed: 9 }; // radii of a blast, newton seconds a square metre, metres a second

export class Debris {
    /** @param matters  of the level @param onChange  ({ added, removed }): pieces; a piece is { id, world, names, matter, origin, size, mass, ... } */
    constructor(firma, matters, onChange = () => {}) {
        this.firma = firma;
        this.matters = matters;
        this.onChange = onChange;
        this.bodies = firma.bodies();
        this.solids = firma.debris(); // of the bodies
        this.pieces = new Map(); // by the body's name
        this.loose = []; // bodies that nobody was told of
        this.cracks = 0;
    }

    /**
     * A crater in the level; what comes loose become bodies, of which blast() tells.
     * @returns { world, report } as World.carve(); `report.largest`: kilograms of the heaviest of them
     */
    carve(level, cutter, pose) {
        const options = { breakRadius: 0, maxBroken: 0, maxSpheres: kSpheres, carve: kCarveOptions };
        const { world, report } = this.solids.explode(this.bodies, level, { at: pose.position, impulse: 0 }, cutter, pose, options);
        this.loose = report.loose;
        return { world, report: { ...report.carve, largest: Math.max(0, ...this.loose.map((id) => this.bodies.get(id).mass)) } };
    }

    /** Time goes on. @returns what was hit hard: [{ piece, point, speed }] */
    step(scene, dt) {
        if (this.pieces.size === 0) return [];
        this.bodies.step(scene, dt);
        const hits = [];
        for (const piece of [...this.pieces.values()]) {
            const before = piece.velocity;
            const body = this.bodies.get(piece.id);
            Object.assign(piece, { velocity: body.velocity, asleep: body.asleep, at: body.position });
            const lost = length(subtract(body.velocity, before)) - 9.81 * dt;
            piece.shock = Math.max(0, piece.shock - kForgets * dt) + Math.max(0, lost);
            if (lost < 1) continue;
            hits.push({ piece, point: body.position, speed: lost });
            if (piece.shock > kBreaks && piece.mass > kHeavy) this.#break(piece, scene.world, this.#hardestAt(piece), kByFall);
        }
        this.#keepFew(scene.world);
        return hits;
    }

    /** The blast of a crater: what is near breaks, all around are pushed, less behind cover. @param level  after carve() */
    blast(level, point, radius) {
        const before = [...this.pieces.values()];
        this.#welcome(level);
        for (const piece of before) {
            const { position } = poseWithin(this.bodies.pose(piece.id), { position: point });
            if (piece.world.closest(position, radius) || piece.world.locate(position).where === 'solid') this.#break(piece, level, point, kByBlast);
        }
        const { reach, impulse, maxSpeed } = kPush;
        this.firma.pushBlast(level, this.bodies, { at: point, radius: reach * radius, impulse }, { mask: kStopsSight, maxSpeed });
        this.#keepFew(level);
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
        this.solids.release();
        this.bodies.release();
    }

    get moving() {
        for (const piece of this.pieces.values()) if (!piece.asleep) return true;
        return false;
    }

    /** What carve() cut off. */
    #welcome(level) {
        if (this.loose.length === 0) return;
        const facts = level.facts();
        this.onChange({ added: this.loose.splice(0).map((id) => this.#know(id, facts)), removed: [] });
    }

    /** All that is told of a body. @param from  { version: of the level, materials: its names } */
    #know(id, { version, materials }) {
        const { matter: kind, origin, broken: breaks } = this.solids.get(this.bodies, id);
        const { name: matter, inside } = this.matters[kind];
        const { mass, position: at, velocity } = this.bodies.get(id);
        const world = this.solids.world(this.bodies, id);
        const { low, high } = world.facts();
        // The faces of its cracks have the material after the last one of the level.
        const names = [...materials, inside || 'rubble'];
        const piece = { id, world, names, kind, matter, inside, origin, breaks, mass, at, velocity, low, high, size: length(subtract(high, low)) / 2, shock: 0, asleep: false, version, materials };
        this.pieces.set(id, piece);
        return piece;
    }

    /** Breaks one as its matter does, smaller near a point, unless that broke too often. */
    #break(piece, level, impact, { pieces: maxPieces, most }) {
        if (piece.breaks >= most) return;
        const pattern = this.firma.fracturePattern(level, piece.kind);
        const options = { ...kPieces, maxPieces, world: level, impact, material: piece.materials.length, seed: ++this.cracks };
        let pieces;
        try {
            ({ pieces } = this.solids.shatter(this.bodies, piece.id, pattern, options));
        } catch (error) {
            if (error.code === undefined) throw error;
            return; // a crack that cannot be cut: all is as it was
        }
        if (pieces.includes(piece.id)) return;
        this.onChange({ added: pieces.map((id) => this.#know(id, piece)), removed: [piece] });
        this.#forget(piece);
    }

    /** Where the last step pressed most on a body. */
    #hardestAt({ id, at }) {
        const own = this.bodies.contacts().filter(({ body, other }) => body === id || other === id);
        return own.reduce((most, one) => (one.force > most.force ? one : most), { point: at, force: 0 }).point;
    }

    #keepFew(level) {
        if (this.pieces.size <= kMost) return;
        const { world, report } = this.solids.tend(this.bodies, level, 0, { maxBodies: kMost, maxSpheres: kMost * kSpheres, maxAsleep: Infinity });
        world.release();
        this.#left(report.removed.map((id) => this.pieces.get(id)));
    }

    #drop(pieces) {
        for (const { id } of pieces) this.solids.remove(this.bodies, id);
        this.#left(pieces);
    }

    /** They are no bodies any more. */
    #left(pieces) {
        if (pieces.length === 0) return;
        this.onChange({ added: [], removed: pieces });
        for (const piece of pieces) this.#forget(piece);
    }

    #forget(piece) {
        this.pieces.delete(piece.id);
        piece.world.release();
    }
}
