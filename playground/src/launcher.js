// SPDX-License-Identifier: MIT
// Fires: a cast along the view, a crater where it meets something, a new version of the world; and back.
import { countChunks, kDensity } from './chunk_counts.js';
import { kStopsShots, kStopsSight } from './masks.js';
import { Samples } from './samples.js';
import { dot, subtract } from './vector.js';

const kReach = 250; // metres
const kCraterScale = 1.2;
const kHistoryBytes = 256 * 1024 * 1024;
/** What is cut off leaves. The faces of a crater are of the matter that it cuts. */
export const kCarveOptions = { chunks: { density: kDensity } };

export class Launcher {
    /**
     * @param onChange  (before, after): the worlds, after each change
     * @param onBlast  (cutter, pose): a crater was tried, after that; the cutter goes when it returns
     */
    constructor(firma, world, probe, onChange, onBlast = () => {}) {
        this.firma = firma;
        this.store = firma.openStore(world, kHistoryBytes);
        this.world = world;
        this.materials = world.facts().materials;
        this.matters = world.matters().matters;
        this.probe = probe;
        this.onChange = onChange;
        this.onBlast = onBlast;
        this.scene = () => this.world; // what flies meets, with what moves in it
        this.matterOfPart = () => '';
        this.carve = (before, cutter, pose) => before.carve(cutter, pose); // what it cuts off stays where it is
        this.shots = 0;
        this.last = null; // of the last shot: { status, reason, cutMs, meshMs, report, chunks, portals }
        this.cutMs = new Samples(60);
        this.meshMs = new Samples(60);
        this.dents = new Map(); // number of an edit -> where its crater lies, for the colours of its faces
    }

    /** Craters that nobody sees, so that the first shot finds compiled code (the first one takes ten times as long). */
    warmUp(at) {
        for (let seed = 1; seed <= 3; ++seed) {
            const cutter = this.firma.crater('rocky', seed);
            const { world: after, report } = this.world.carve(cutter, { position: at, scale: kCraterScale }, kCarveOptions);
            this.world.changedRegionMeshes(after);
            report.loose?.release();
            cutter.release();
            after.release();
        }
    }

    /**
     * What lies along a view: the hit, with its distance, the name of its material and the rooms on the way. Through glass, which no shot breaks.
     * @param room  the one the eye is in; 'any' where that is not known
     */
    aim(eye, direction, room = 'any') {
        const passed = [];
        const path = direction.map((x) => x * kReach);
        const hit = this.probe.measure(() => this.probe.cast(eye, 0, path, kStopsSight, room, passed));
        const met = hit.hit;
        return { hit, met, passed, distance: met ? hit.fraction * kReach : Infinity, material: met ? this.#nameOf(hit) : '' };
    }

    /** What something that flies meets along a path, for strike(); null for nothing. */
    meet(from, path) {
        const hit = this.firma.castScene(this.scene(), { centre: from, radius: 0, path }, { mask: kStopsSight });
        if (!hit.hit) return null;
        if (hit.part !== null) return { hit, met: true, material: 'part', edit: 0, matter: this.matterOfPart(hit.part) };
        return { hit, met: true, material: this.#nameOf(hit), edit: this.world.hitInfo(hit).sourceEdit, matter: this.#matterOf(hit) };
    }

    /** A crater at once, where somebody looks. */
    fire(eye, direction, room) {
        const target = this.aim(eye, direction, room);
        if (!target.met) return (this.last = { status: 'missed', target });
        if (/sky/.test(target.material)) return (this.last = { status: 'sky', target });
        return this.strike({ ...target, edit: this.world.hitInfo(target.hit).sourceEdit, matter: this.#matterOf(target.hit) });
    }

    /** A crater where something was met. @param target  of aim() or meet() */
    strike(target) {
        if (/sky/.test(target.material)) return (this.last = { status: 'sky', target });
        const seed = ++this.shots;
        const pose = { position: target.hit.point, rotation: this.firma.randomTurn(seed), scale: kCraterScale };
        // A crater in a crater goes on from the wall that the first one hit, so that colours by depth go on too.
        const wall = this.dents.get(target.edit) ?? { point: target.hit.point, normal: target.hit.faceNormal };
        return Object.assign(this.#carve(seed, pose, { ...wall, scale: kCraterScale }), { target, matter: target.matter });
    }

    /** A crater around a point in the air, as grenades leave: of what is near. */
    burst(point) {
        const seed = ++this.shots;
        const near = this.world.closest(point, kCraterScale, { mask: kStopsShots });
        const away = near ? subtract(point, near.point) : [0, 0, 1];
        const size = Math.hypot(...away);
        const normal = size > 1e-6 ? away.map((x) => x / size) : [0, 0, 1];
        const pose = { position: point, rotation: this.firma.randomTurn(seed), scale: kCraterScale };
        const matter = near ? this.#matterOf(near) : '';
        return Object.assign(this.#carve(seed, pose, { point: near?.point ?? point, normal, scale: kCraterScale }), { normal, matter });
    }

    /** A rocky crater wherever one likes, not turned. */
    shootAt({ position, scale, seed }) {
        const matter = this.matters[this.world.matterAt(position)].name;
        // Somewhat dark all over: no wall is known that it begins at.
        return Object.assign(this.#carve(seed, { position, scale }, { point: [position[0], position[1], position[2] + 0.3 * scale], normal: [0, 0, 1], scale }), { matter });
    }

    undo() {
        return this.#travel('undone', (facts) => facts.current > facts.oldest, () => this.store.undo());
    }

    redo() {
        return this.#travel('redone', (facts) => facts.current < facts.newest, () => this.store.redo());
    }

    /** Opens or closes a portal: an edit like others. @param quiet  what was told of the last shot stays */
    turnPortal(portal, quiet = false) {
        const { open } = this.world.portal(portal);
        const after = this.world.setPortalOpen(portal, !open);
        this.store.publish(this.world, after);
        if (!quiet) this.last = { status: open ? 'closed' : 'opened' };
        this.#change(after);
    }

    /** How deep a point lies in the crater of an edit: 0 at the surface that was hit, 1 at a crater's radius. */
    depth(edit, point) {
        const dent = this.dents.get(edit);
        return dent ? -dot(subtract(point, dent.point), dent.normal) / dent.scale : 0;
    }

    #nameOf(hit) {
        return hit.portal !== null ? 'closed portal' : this.materials[hit.material];
    }

    /** The name of the matter that was met; '' for a closed portal, too. */
    #matterOf(hit) {
        return hit.face === null ? '' : this.matters[this.world.matterOf(hit)].name;
    }

    /** @param dent  for colours: where the crater lies */
    #carve(seed, pose, dent) {
        const cutter = this.firma.crater('rocky', seed);
        const before = this.world;
        const start = performance.now();
        const { world: after, report } = this.carve(before, cutter, pose);
        const cutMs = performance.now() - start;
        this.last = { status: report.status, reason: report.reason, cutMs, report };
        if (report.status === 'done') this.#take(before, after, dent);
        else after.release();
        this.onBlast(cutter, pose);
        cutter.release();
        return this.last;
    }

    /** A crater's world becomes that of the moment. */
    #take(before, after, dent) {
        const { report, cutMs } = this.last;
        this.cutMs.add(cutMs);
        const [portals, facts] = [before.facts().portalCount, after.facts()];
        this.last.portals = Array.from({ length: facts.portalCount - portals }, (_, k) => portals + k);
        this.last.chunks = countChunks({ largest: 0, ...report });
        this.dents.set(facts.edits, dent);
        this.store.publish(before, after);
        this.last.meshMs = this.#change(after);
    }

    #travel(name, isThere, move) {
        if (!isThere(this.store.facts())) return false;
        this.last = { status: name };
        this.#change(move());
        return true;
    }

    /** Everything from the world before to the one after: what is drawn, what casts meet. */
    #change(after) {
        const start = performance.now();
        const before = this.world;
        this.world = after;
        this.probe.world = after;
        this.materials = after.facts().materials;
        this.onChange(before, after);
        before.release(); // the store has its own
        const spent = performance.now() - start;
        this.meshMs.add(spent);
        return spent;
    }
}
