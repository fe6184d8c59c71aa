// SPDX-License-Identifier: MIT
// The parts put together: a world, somebody in it, what flies, what is drawn of it. Nothing here knows of frames or keys.
import { Actors } from './actors.js';
import { BlastShow } from './blast_show.js';
import { Launcher } from './launcher.js';
import { Painter } from './painter.js';
import { PortalPanes } from './portal_panes.js';
import { Player } from './player.js';
import { Probe } from './probe.js';
import { RegionMeshes, regionOptions } from './region_meshes.js';
import { areaOf, Rooms } from './rooms.js';
import { Samples } from './samples.js';
import { SetShots } from './set_shots.js';
import { findSpawn } from './spawn.js';
import { makeSurfaceMaterials } from './surface_material.js';
import { direction } from './vector.js';
import { Weapons } from './weapons.js';

const kFrames = 90;
const kHardLanding = 5; // metres a second
const kArm = 5; // metres: how far a door may be that one opens
const summary = (samples) => ({ last: samples.last, least: samples.least(), median: samples.median(), count: samples.count });

export class Game {
    /**
     * @param firma  of loadRecordings() @param Projectiles  the class of the same package
     * @param sound  plays what is heard
     * @param start  where the level's author has players start, or null: see startOf()
     */
    constructor({ firma, Projectiles, world, levelName, stage, sound, start = null }) {
        Object.assign(this, { firma, Projectiles });
        this.stage = stage;
        this.show = new BlastShow(stage, sound, (from, path) => this.launcher.world.cast({ centre: from, radius: 0, path }).fraction,
            globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches);
        this.probe = new Probe(world);
        this.player = new Player(firma, this.probe);
        this.launcher = new Launcher(firma, world, this.probe, (before, after) => this.#redraw(before, after),
            (cutter, pose) => this.actors.blast(cutter, pose));
        this.painter = new Painter(this.launcher.materials, (edit, point) => this.launcher.depth(edit, point));
        const materials = makeSurfaceMaterials();
        this.meshes = new RegionMeshes(materials.level, this.painter, materials.shadow);
        this.meshes.replace(world.regionMeshes(regionOptions(this.launcher.materials)));
        this.rooms = new Rooms(world);
        this.panes = new PortalPanes();
        this.sets = new SetShots(this.launcher, this.rooms, levelName);
        this.weapons = new Weapons();
        this.actors = new Actors(this, materials);
        this.panes.show(this.rooms.portals, false, this.actors.doorPortals());
        stage.scene.add(this.meshes.group, this.actors.group, this.panes.group);
        stage.warmUp({ ...materials.bodies, contact: this.actors.contactShadows.material() });
        const { low, high } = world.facts();
        stage.sun.cover(low, high);
        this.floor = low[2];
        for (const name of ['frameMs', 'workMs', 'bodyMs']) this[name] = new Samples(kFrames);
        this.moveUs = new Samples(240); // a move of the player, mean of a step
        this.aimed = null;
        this.spawn = findSpawn(this.player, world, levelName, start);
        this.respawn();
        this.launcher.warmUp(this.spawn.feet);
        this.player.warmUp(300);
    }

    respawn() {
        this.player.place(this.spawn.feet);
        this.player.look(this.spawn.yaw, this.spawn.pitch);
    }

    /** Time goes on by dt seconds, with these keys held. */
    step(dt, keys = {}) {
        const eye = this.player.eye();
        this.show.listen(eye, this.#direction());
        for (const weapon of this.weapons.step(dt, keys)) {
            this.#endSet();
            this.actors.launch(weapon, eye, this.#direction(), this.player.velocity);
        }
        this.actors.step(dt, (scene) => this.#walk(dt, keys, scene));
        this.rooms.locate(this.player.eye());
        if (this.player.feet[2] < this.floor - 20) this.respawn(); // through a hole in a level that is not closed
        this.#playSet(dt);
    }

    #walk(dt, keys, scene) {
        const start = performance.now();
        this.player.step(dt, keys, scene);
        this.moveUs.add(((performance.now() - start) * 1000) / this.player.moves);
        if (this.player.landed > kHardLanding) this.show.hear('thud', this.player.feet, 0.3);
    }

    #playSet(dt) {
        const shot = this.sets.step(dt);
        if (!shot) return;
        this.showBlast(shot.position, [0, 0, 1], shot);
        const { told } = this.sets;
        if (told.after) this.stage.showCast(this.sets.cast.from, told.after.point);
    }

    /** What is seen and heard of a blast. */
    showBlast(point, normal, { matter = '' }) {
        const inside = this.launcher.matters.find(({ name }) => name === matter)?.inside || 'rubble';
        this.show.blast({ point, normal, colour: this.painter.dustOf(inside), metal: matter === 'steel' });
    }

    /** Plays a scene of the level, 'bridge' or 'wall'; says whether it has that. Whoever watches is put where it is seen. */
    startSet(name) {
        const stand = this.sets.start(name);
        if (!stand) return false;
        this.player.place(stand.feet);
        this.player.look(stand.yaw, stand.pitch);
        this.stage.showCast(null);
        return this.#freed(true);
    }

    /** What is looked at. */
    aim() {
        const eye = this.player.eye();
        const target = this.launcher.aim(eye, this.#direction(), this.rooms.locate(eye) ?? 'any');
        this.aimed = { ...target, counts: this.probe.group.counts };
        return this.aimed;
    }

    /** A blast at once where the cross is, without a rocket. */
    fire() {
        const eye = this.player.eye();
        this.#endSet();
        const shot = this.launcher.fire(eye, this.#direction(), this.rooms.locate(eye) ?? 'any');
        if (shot.target.met) this.showBlast(shot.target.hit.point, shot.target.hit.normal, shot);
        return shot;
    }

    /** Shows the portals, or no longer. */
    togglePortals() {
        this.panes.show(this.rooms.portals, !this.panes.all);
    }

    /** Opens or shuts the door, or the portal, that is looked at, when it is near; says whether there was one. */
    turnPortal() {
        const [eye, way] = [this.player.eye(), this.#direction()];
        const leaf = this.actors.doorAlong(eye, way.map((x) => x * kArm));
        if (leaf) return this.actors.useDoor(leaf);
        const found = this.rooms.portalAlong(eye, way, kArm);
        if (!found || (this.aimed?.met && this.aimed.distance < found.distance - 1e-6)) return false;
        const door = this.actors.doorOf(found.portal);
        if (door) return this.actors.useDoor(door);
        this.launcher.turnPortal(found.portal);
        return this.#freed(true);
    }

    undo() {
        this.#endSet();
        const undone = this.launcher.undo();
        this.actors.undo();
        return this.#freed(undone);
    }

    redo() {
        this.#endSet();
        return this.#freed(this.launcher.redo());
    }

    render(dt) {
        this.show.step(dt);
        this.stage.view(this.player.eye(), this.#direction(), this.show.shake.turn());
        this.actors.show();
        this.stage.render(dt);
    }

    /** All that the lines on the screen and the tests want to know; plain numbers and texts. */
    state() {
        const { launcher, player } = this;
        const facts = launcher.world.facts();
        const { aimed } = this;
        return {
            position: [...player.feet],
            eye: player.eye(),
            velocity: [...player.velocity],
            yaw: player.yaw,
            pitch: player.pitch,
            grounded: player.grounded,
            version: Number(facts.version),
            edits: Number(facts.edits),
            faces: facts.faceCount,
            drawnFaces: this.meshes.faceCount,
            drawnTriangles: this.meshes.triangles,
            regions: this.meshes.regions.size,
            room: this.rooms.here === null ? null : { id: this.rooms.here, name: this.rooms.name(this.rooms.here) },
            rooms: this.rooms.rooms.length,
            portals: { all: this.rooms.portals.length, open: this.rooms.portals.filter((portal) => portal.open).length, shown: this.panes.all },
            aim: aimed && { met: aimed.met, distance: aimed.distance, material: aimed.material, rooms: aimed.passed.map((room) => this.rooms.name(room)), counts: { ...aimed.counts } },
            move: { moves: this.player.moves, us: this.moveUs.last },
            shot: launcher.last && { ...launcher.last, target: undefined, portals: launcher.last.portals?.map((portal) => this.#portalState(portal)) },
            ...this.actors.state(),
            specks: this.stage.dust.count + this.stage.glow.count,
            set: this.sets.told && { ...this.sets.told, portals: this.sets.told.portals.map((portal) => this.#portalState(portal)) },
            history: (({ bytes, versions }) => ({ bytes: Number(bytes), versions: Number(versions) }))(launcher.store.facts()),
            times: {
                frameMs: summary(this.frameMs), workMs: summary(this.workMs), moveUs: summary(this.moveUs), bodyMs: summary(this.bodyMs),
                cutMs: summary(launcher.cutMs), meshMs: summary(launcher.meshMs),
            },
        };
    }

    #direction() {
        return direction(this.player.yaw, this.player.pitch);
    }

    #portalState(portal) {
        const { rooms, polygons } = this.rooms.portals[portal];
        return { id: portal, rooms: rooms.map((room) => this.rooms.name(room)), area: areaOf(polygons) };
    }

    /** Somebody does something else. */
    #endSet() {
        this.sets.stop();
        this.stage.showCast(null);
    }

    #freed(changed) {
        if (changed && !this.player.freeYourself()) this.respawn();
        return changed;
    }

    #redraw(before, after) {
        const { materials } = after.facts();
        this.painter.learn(materials);
        this.rooms.learn(after);
        this.actors.follow(this.rooms.portals);
        this.panes.show(this.rooms.portals, this.panes.all, this.actors.doorPortals());
        this.meshes.replace(before.changedRegionMeshes(after, regionOptions(materials)));
        this.stage.sun.changed();
    }
}
