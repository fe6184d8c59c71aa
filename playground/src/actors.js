// SPDX-License-Identifier: MIT
// All that moves besides the player: rockets, grenades, rubble, doors; what each does to the others, and how they are drawn.
import * as THREE from 'three';
import { ContactShadows } from './contact_shadows.js';
import { Debris } from './debris.js';
import { DebrisView } from './debris_view.js';
import { DoorView } from './door_view.js';
import { Doors } from './doors.js';
import { FlyingView } from './flying_view.js';
import { Grenades } from './grenades.js';
import { kStopsSight } from './masks.js';
import { Obstacles } from './obstacles.js';
import { kSpeed, Rockets } from './rockets.js';
import { add, along, length, subtract, times } from './vector.js';

const kLongestStep = 1 / 30; // seconds, of bodies
const kThrow = { reach: 4.5, speed: 7.5 }; // metres from a blast, metres a second beside it: what somebody feels
const kHeard = 1.5; // metres a second that a hit takes away

export class Actors {
    /** @param game  what it is part of: its launcher, rooms, stage, player */
    constructor(game, materials) {
        this.game = game;
        const { firma, launcher, rooms, stage } = game;
        this.debrisView = new DebrisView(materials, (edit, point) => launcher.depth(edit, point));
        this.doorView = new DoorView(materials);
        this.contactShadows = new ContactShadows();
        this.debris = new Debris(firma, launcher.matters, (change) => {
            this.debrisView.change(change);
            this.contactShadows.change(change);
            this.chosen = false;
        });
        this.doors = new Doors(firma, rooms.portals, (portal) => this.#closed(portal), (door) => {
            this.doorView.change({ added: [door], removed: [door] });
            this.obstacles.changeDoor(door);
        });
        this.doorView.change({ added: this.doors.all, removed: [] });
        this.obstacles = new Obstacles(firma, this.doors, this.debris);
        this.chosen = true; // whether the obstacles are those of the moment
        launcher.scene = () => this.#scene();
        launcher.carve = (before, cutter, pose) => this.debris.carve(before, cutter, pose);
        launcher.matterOfPart = (part) => this.obstacles.of(part).piece?.matter ?? 'wood';
        this.rockets = new Rockets((from, path) => launcher.meet(from, path));
        this.grenades = new Grenades(firma, game.Projectiles);
        this.views = { rockets: FlyingView.rockets(), grenades: FlyingView.grenades() };
        this.group = new THREE.Group();
        this.group.add(this.debrisView.group, this.contactShadows.group, this.doorView.group, this.views.rockets.group, this.views.grenades.group);
        this.sun = stage.sun;
        this.broken = []; // portals whose doors are no more
    }

    launch(weapon, eye, way, velocity) {
        if (weapon === 'rocket') this.rockets.launch(eye, way, this.game.stage.muzzle());
        else this.grenades.throw(eye, way, velocity);
        this.game.show.hear(weapon, eye);
    }

    /** Time goes on. @param walk  (scene): the player goes on, while doors swing */
    step(dt, walk) {
        for (const portal of this.broken.splice(0)) if (!this.game.rooms.portals[portal].open) this.game.launcher.turnPortal(portal, true);
        this.doors.begin(dt);
        const start = performance.now();
        this.#tumble(this.doors.scene(this.game.launcher.world), dt);
        this.game.bodyMs.add(performance.now() - start);
        const scene = this.#scene();
        this.obstacles.begin();
        walk(scene);
        this.doors.arrive(this.game.player.caught);
        this.obstacles.arrive();
        this.#fly(dt);
        if (this.debris.moving || this.doors.moving) this.sun.moving(dt);
    }

    /** A crater was tried somewhere: what that does to what moves. */
    blast(cutter, pose) {
        const { world } = this.game.launcher;
        const free = (from, to) => !world.castAny({ centre: from, radius: 0, path: subtract(to, from) }, { mask: kStopsSight });
        this.debris.blast(world, pose.position, pose.scale);
        this.broken.push(...this.doors.blast(cutter, pose));
        const { player } = this.game;
        const away = subtract(add(player.feet, [0, 0, 0.9]), pose.position);
        const share = 1 - length(away) / kThrow.reach;
        if (share <= 0) return;
        const speed = kThrow.speed * share * (free(pose.position, player.eye()) ? 1 : 0.3);
        player.push(times(add(away, [0, 0, 0.3]), speed / Math.max(0.3, length(away))));
    }

    /** A version was undone. */
    undo() {
        this.debris.undo(this.game.launcher.world.facts().version);
    }

    /** Portals are as they are now. */
    follow(portals) {
        this.doors.follow(portals);
    }

    doorOf(portal) {
        return this.doors.of(portal);
    }

    /** Numbers of the portals that have a door. */
    doorPortals() {
        return new Set(this.doors.all.filter((door) => !door.broken).map((door) => door.portal));
    }

    /** The door that a ray meets before anything else and that can be used, or null. */
    doorAlong(from, path) {
        const { firma, launcher } = this.game;
        const hit = firma.castScene(launcher.scene(), { centre: from, radius: 0, path }, { mask: kStopsSight });
        const door = hit.hit && hit.part !== null ? this.obstacles.of(hit.part).door : null;
        return door && !door.broken ? door : null;
    }

    useDoor(door) {
        this.game.show.hear('door', this.doors.middle(door));
        if (this.game.rooms.portals[door.portal].open && !door.shutting) {
            this.doors.shut(door);
            return true;
        }
        this.doors.open(door);
        if (!this.game.rooms.portals[door.portal].open) this.game.launcher.turnPortal(door.portal);
        return true;
    }

    show() {
        this.debrisView.update(this.debris.bodies);
        this.contactShadows.update(this.debris.bodies, this.game.launcher.world);
        this.doorView.update(this.doors);
        const rockets = this.rockets.flying.map((rocket) => ({ at: Rockets.seenAt(rocket), direction: rocket.direction }));
        this.views.rockets.show(rockets);
        this.views.grenades.show(this.grenades.seen());
        this.game.stage.blast.follow(rockets.at(-1)?.at ?? null);
    }

    /** In numbers, for the lines and the tests. */
    state() {
        const pieces = [...this.debris.pieces.values()];
        return {
            rockets: this.rockets.flying.length,
            grenades: this.grenades.count,
            debris: { bodies: pieces.length, awake: pieces.filter(({ asleep }) => !asleep).length, triangles: this.debrisView.triangles, mass: pieces.reduce((sum, { mass }) => sum + mass, 0) },
            doors: { all: this.doors.all.length, moving: this.doors.moving, broken: this.doors.all.filter(({ broken }) => broken).length },
        };
    }

    /** The level with all that players and shots meet. */
    #scene() {
        if (!this.chosen) this.obstacles.choose();
        this.chosen = true;
        return { world: this.game.launcher.world, parts: this.obstacles.parts };
    }

    #closed(portal) {
        this.game.launcher.turnPortal(portal);
        this.game.show.hear('thud', this.doors.middle(this.doors.of(portal)), 0.4);
    }

    /** Bodies fall; what comes down hard is seen and heard. */
    #tumble(scene, dt) {
        const count = Math.max(1, Math.ceil(dt / kLongestStep - 1e-9));
        for (let k = 0; k < count; ++k) {
            for (const { piece, point, speed } of this.debris.step({ ...scene, from: k / count, to: (k + 1) / count }, dt / count)) {
                if (speed < kHeard) continue;
                this.game.show.hear('thud', point, Math.min(1, 0.1 + speed * Math.cbrt(piece.mass) * 0.01));
                if (piece.size > 0.25) this.game.show.puff(along(point, [0, 0, -1], piece.size * 0.4), this.game.painter.dustOf(piece.inside || 'rubble'), piece.size);
            }
        }
    }

    #fly(dt) {
        const { launcher, show } = this.game;
        for (const { target } of this.rockets.step(dt)) {
            const shot = launcher.strike(target);
            if (shot.status !== 'sky') this.game.showBlast(target.hit.point, target.hit.normal, shot);
        }
        for (const rocket of this.rockets.flying) show.trail(Rockets.seenAt(rocket), rocket.direction, kSpeed, dt);
        const { blasts, bounces } = this.grenades.step(launcher.world, this.debris.bodies, dt);
        for (const { point, speed } of bounces) if (speed > 1) show.hear('bounce', point, Math.min(1, speed / 12));
        for (const point of blasts) {
            const shot = launcher.burst(point);
            this.game.showBlast(point, shot.normal, shot);
        }
    }
}
