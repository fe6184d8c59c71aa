// SPDX-License-Identifier: MIT
// Doors: parts of the scene that swing about their hinges. A door follows its portal: open it stands aside, and once it
// has shut the portal is closed, so that undo takes doors along.
import { leafMesh, planDoor } from './door_plans.js';
import { aboutUp, poseWithin, turned } from './turns.js';

const kOpen = Math.PI / 2; // radians from shut: walls are thicker than leaves
const kSpeed = 2.2; // radians a second
const kEdit = 1 << 20; // cuts of leaves are numbered from here

export class Doors {
    /**
     * @param portals  of the level @param close  (portal): it has shut
     * @param onChange  (door): its leaf is another one
     */
    constructor(firma, portals, close, onChange = () => {}) {
        this.firma = firma;
        this.close = close;
        this.onChange = onChange;
        this.parts = firma.parts();
        this.all = [];
        portals.forEach((portal, k) => {
            const plan = planDoor(portal);
            if (!plan) return;
            const world = firma.worldFromMesh(leafMesh(plan), { name: `door ${portal.name}` });
            const shut = plan.along === 0 ? 0 : Math.PI / 2;
            const door = { portal: k, ...plan, world, shut, angle: portal.open ? kOpen : 0, target: portal.open ? kOpen : 0, turn: 0, shutting: false, broken: false };
            this.all.push(door);
            this.parts.add({ world, motion: this.#motion(door) });
        });
        this.edits = 0;
    }

    /** The level with its doors, as bodies meet it. */
    scene(world) {
        return this.all.length > 0 ? { world, parts: this.parts } : { world };
    }

    /** Whether a portal has a door that is whole enough to be used. */
    of(portal) {
        return this.all.find((door) => door.portal === portal && !door.broken) ?? null;
    }

    /** The portals are as they are now: doors of open ones open, those of closed ones shut. */
    follow(portals) {
        for (const door of this.all) if (!door.shutting) door.target = portals[door.portal].open ? kOpen : 0;
    }

    /** Begins to shut; the portal is closed once it has. */
    shut(door) {
        door.target = 0;
        door.shutting = true;
    }

    open(door) {
        door.target = kOpen;
        door.shutting = false;
    }

    /** How each goes within the next dt seconds; then arrive() puts them there. */
    begin(dt) {
        if (this.all.length === 0) return;
        for (const door of this.all) {
            const left = door.target - door.angle;
            door.turn = Math.sign(left) * Math.min(Math.abs(left), kSpeed * dt);
        }
        this.parts.setMotions(this.motions());
    }

    /** Of all leaves, in this step. */
    motions() {
        return this.all.map((door) => this.#motion(door));
    }

    /** @param blocked  the number of a door that somebody is caught in, or null: it goes back */
    arrive(blocked = null) {
        for (const [k, door] of this.all.entries()) {
            door.angle += door.turn;
            door.turn = 0;
            if (k === blocked && door.shutting) this.open(door);
            if (!door.shutting || door.angle !== door.target) continue;
            door.shutting = false;
            this.close(door.portal);
        }
        if (this.all.length > 0) this.parts.setMotions(this.motions());
    }

    /** A blast takes of the leaves that it reaches. @returns the portals of those of which nothing is left */
    blast(cutter, pose) {
        const broken = [];
        this.all.forEach((door, k) => {
            if (door.broken) return;
            const { world: after, report } = door.world.carve(cutter, poseWithin(this.frame(door), pose), { edit: kEdit + ++this.edits, material: 'matter/wood' });
            if (report.status !== 'done') return after.release();
            const before = door.world;
            door.world = after;
            door.broken = after.facts().faceCount === 0 || report.volume > 0.5 * before.measure().volume;
            this.parts.set(k, { world: after, motion: this.#motion(door) });
            this.onChange(door);
            before.release();
            if (!door.broken) return;
            door.shutting = false;
            broken.push(door.portal);
        });
        return broken;
    }

    get moving() {
        return this.all.some((door) => door.angle !== door.target);
    }

    /** Where a leaf's frame is. */
    frame({ hinge, shut, angle }) {
        return { position: hinge, rotation: aboutUp(shut + angle) };
    }

    /** The middle of a leaf, for what is heard of it. */
    middle(door) {
        const { position, rotation } = this.frame(door);
        return turned(rotation, [door.width / 2, 0, door.height / 2]).map((x, k) => x + position[k]);
    }

    release() {
        for (const door of this.all) door.world.release();
        this.parts.release();
    }

    #motion(door) {
        return { ...this.frame(door), path: [0, 0, 0], turn: [0, 0, door.turn] };
    }
}
