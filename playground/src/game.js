// SPDX-License-Identifier: MIT
// The parts put together: a world, somebody in it, what flies, what is drawn of it. Nothing here knows of frames or keys.
import { BlastShow } from './blast_show.js';
import { FlyingView } from './flying_view.js';
import { Launcher } from './launcher.js';
import { LooseChunks } from './loose_chunks.js';
import { Painter } from './painter.js';
import { PortalPanes } from './portal_panes.js';
import { Player } from './player.js';
import { Probe } from './probe.js';
import { RegionMeshes, regionOptions } from './region_meshes.js';
import { kSpeed, Rockets } from './rockets.js';
import { areaOf, Rooms } from './rooms.js';
import { Samples } from './samples.js';
import { SetShots } from './set_shots.js';
import { findSpawn } from './spawn.js';
import { makeSurfaceMaterials } from './surface_material.js';
import { direction } from './vector.js';
import { Weapons } from './weapons.js';

const kFrames = 90;
const kArm = 5; // metres: how far a door may be that one opens
const summary = (samples) => ({ last: samples.last, least: samples.least(), median: samples.median(), count: samples.count });

export class Game {
    /**
     * @param sound  plays what is heard
     * @param start  where the level's author has players start, or null: see startOf()
     */
    constructor(firma, world, levelName, stage, sound, start = null) {
        this.stage = stage;
        this.show = new BlastShow(stage, sound, (from, path) => this.probe.world.cast({ centre: from, radius: 0, path }).fraction,
            globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches);
        this.probe = new Probe(world);
        this.player = new Player(this.probe);
        this.launcher = new Launcher(firma, world, this.probe, (before, after) => this.#redraw(before, after), (loose) => this.loose.add(loose));
        this.painter = new Painter(this.launcher.materials, (edit, point) => this.launcher.depth(edit, point));
        const materials = makeSurfaceMaterials();
        this.meshes = new RegionMeshes(materials.level, this.painter, materials.shadow);
        this.meshes.replace(world.regionMeshes(regionOptions(this.launcher.materials)));
        this.rooms = new Rooms(world);
        this.panes = new PortalPanes();
        this.loose = new LooseChunks(materials.makeFading, this.painter, materials.shadow);
        this.sets = new SetShots(this.launcher, this.rooms, levelName);
        this.weapons = new Weapons();
        this.rockets = new Rockets((from, path) => this.launcher.meet(from, path));
        this.rocketView = FlyingView.rockets();
        stage.scene.add(this.meshes.group, this.loose.group, this.panes.group, this.rocketView.group);
        this.neverDrawn = materials.makeFading(); // keeps their program compiled
        stage.warmUp(this.neverDrawn);
        const { low, high } = world.facts();
        stage.sun.cover(low, high);
        this.floor = low[2];
        this.frameMs = new Samples(kFrames);
        this.workMs = new Samples(kFrames);
        this.moved = { counts: { nodes: 0, boxes: 0, faces: 0, precise: 0 }, casts: 0 };
        this.aimed = null;
        this.spawn = findSpawn(this.player, world, levelName, start);
        this.respawn();
        this.launcher.warmUp(this.spawn.feet);
        for (let k = 0; k < 500; ++k) this.player.sweep([0.07, 0, 0]); // casts likewise: 1,500, some milliseconds
    }

    respawn() {
        this.player.place(this.spawn.feet);
        this.player.look(this.spawn.yaw, this.spawn.pitch);
    }

    /** Time goes on by dt seconds, with these keys held. */
    step(dt, keys = {}) {
        for (const weapon of this.weapons.step(dt, keys)) this.#launch(weapon);
        this.probe.measure(() => this.player.step(dt, keys));
        this.moved = this.probe.group;
        this.rooms.locate(this.player.eye());
        if (this.player.feet[2] < this.floor - 20) this.respawn(); // through a hole in a level that is not closed
        this.#fly(dt);
        this.#playSet(dt);
    }

    #launch() {
        const [eye, way] = [this.player.eye(), this.#direction()];
        this.#endSet();
        this.rockets.launch(eye, way, this.stage.muzzle());
        this.show.launched('rocket', eye);
    }

    #fly(dt) {
        for (const { target } of this.rockets.step(dt)) {
            const shot = this.launcher.strike(target);
            if (shot.status !== 'sky') this.#blastAt(target.hit.point, target.hit.normal, shot);
        }
        for (const rocket of this.rockets.flying) this.show.trail(Rockets.seenAt(rocket), rocket.direction, kSpeed, dt);
    }

    #playSet(dt) {
        const shot = this.sets.step(dt);
        if (!shot) return;
        this.#blastAt(shot.position, [0, 0, 1], shot);
        const { told } = this.sets;
        if (told.after) this.stage.showCast(this.sets.cast.from, told.after.point);
    }

    /** What is seen and heard of a blast. */
    #blastAt(point, normal, { matter = '' }) {
        const inside = this.launcher.matters.find(({ name }) => name === matter)?.inside || 'rubble';
        this.show.blast(this.player.eye(), this.#direction(), { point, normal, colour: this.painter.dustOf(inside), metal: matter === 'steel' });
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
        if (shot.target.met) this.#blastAt(shot.target.hit.point, shot.target.hit.normal, shot);
        return shot;
    }

    /** Shows the portals, or no longer. */
    togglePortals() {
        this.panes.show(this.rooms.portals, !this.panes.all);
    }

    /** Opens or closes the portal that is looked at, when it is near; says whether there was one. */
    turnPortal() {
        const found = this.rooms.portalAlong(this.player.eye(), this.#direction(), kArm);
        if (!found || (this.aimed?.met && this.aimed.distance < found.distance - 1e-6)) return false;
        this.launcher.turnPortal(found.portal);
        return this.#freed(true);
    }

    undo() {
        this.#endSet();
        this.loose.clear();
        return this.#freed(this.launcher.undo());
    }

    redo() {
        this.#endSet();
        return this.#freed(this.launcher.redo());
    }

    render(dt) {
        this.loose.step(dt);
        this.show.step(dt);
        this.stage.view(this.player.eye(), this.#direction(), this.show.shake.turn());
        const seen = this.rockets.flying.map((rocket) => ({ at: Rockets.seenAt(rocket), direction: rocket.direction }));
        this.rocketView.show(seen);
        this.stage.blast.follow(seen.at(-1)?.at ?? null);
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
            move: { casts: this.moved.casts, counts: { ...this.moved.counts } },
            shot: launcher.last && { ...launcher.last, target: undefined, portals: launcher.last.portals?.map((portal) => this.#portalState(portal)) },
            fading: this.loose.triangles,
            rockets: this.rockets.flying.length,
            specks: this.stage.dust.count + this.stage.glow.count,
            set: this.sets.told && { ...this.sets.told, portals: this.sets.told.portals.map((portal) => this.#portalState(portal)) },
            history: (({ bytes, versions }) => ({ bytes: Number(bytes), versions: Number(versions) }))(launcher.store.facts()),
            times: {
                frameMs: summary(this.frameMs), workMs: summary(this.workMs), castUs: summary(this.probe.microseconds),
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
        this.panes.show(this.rooms.portals);
        this.meshes.replace(before.changedRegionMeshes(after, regionOptions(materials)));
        this.stage.sun.changed();
    }
}
