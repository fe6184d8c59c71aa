// SPDX-License-Identifier: MIT
// The parts put together: a world, somebody in it, what is drawn of it. Nothing here knows of frames or keys.
import { FaceMesh } from './face_mesh.js';
import { Launcher } from './launcher.js';
import { Painter } from './painter.js';
import { Player } from './player.js';
import { Probe } from './probe.js';
import { Samples } from './samples.js';
import { findSpawn } from './spawn.js';
import { makeSurfaceMaterial } from './surface_material.js';
import { direction } from './vector.js';

const kFrames = 90;
const summary = (samples) => ({ last: samples.last, least: samples.least(), median: samples.median(), count: samples.count });

export class Game {
    constructor(firma, world, levelName, stage) {
        this.stage = stage;
        this.probe = new Probe(world);
        this.player = new Player(this.probe);
        this.launcher = new Launcher(firma, world, this.probe, (diff, after) => this.#redraw(diff, after));
        this.painter = new Painter(this.launcher.materials, (edit, point) => this.launcher.depth(edit, point));
        this.faces = new FaceMesh(makeSurfaceMaterial(), this.painter);
        this.faces.add(world.faces());
        stage.scene.add(this.faces.mesh);
        this.floor = world.facts().low[2];
        this.frameMs = new Samples(kFrames);
        this.workMs = new Samples(kFrames);
        this.moved = { counts: { bins: 0, boxes: 0, faces: 0, precise: 0 }, casts: 0 };
        this.aimed = null;
        this.spawn = findSpawn(this.player, world, levelName);
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
        this.probe.measure(() => this.player.step(dt, keys));
        this.moved = this.probe.group;
        if (this.player.feet[2] < this.floor - 20) this.respawn(); // through a hole in a level that is not closed
    }

    /** What is looked at. */
    aim() {
        const target = this.launcher.aim(this.player.eye(), this.#direction());
        this.aimed = { ...target, counts: this.probe.group.counts };
        return this.aimed;
    }

    fire() {
        const shot = this.launcher.fire(this.player.eye(), this.#direction());
        if (shot.target.met) this.stage.explode(this.player.eye(), shot.target.hit.point, shot.target.hit.normal);
        return shot;
    }

    undo() {
        return this.#freed(this.launcher.undo());
    }

    redo() {
        return this.#freed(this.launcher.redo());
    }

    render(dt) {
        this.stage.view(this.player.eye(), this.#direction());
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
            drawnFaces: this.faces.faceCount,
            drawnTriangles: this.faces.triangles,
            room: aimed && aimed.met ? aimed.hit.room : null,
            aim: aimed && { met: aimed.met, distance: aimed.distance, material: aimed.material, counts: { ...aimed.counts } },
            move: { casts: this.moved.casts, counts: { ...this.moved.counts } },
            shot: launcher.last && { ...launcher.last, target: undefined },
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

    #freed(changed) {
        if (changed && !this.player.freeYourself()) this.respawn();
        return changed;
    }

    #redraw(diff, after) {
        this.painter.learn(after.facts().materials);
        this.faces.remove(diff.gone);
        this.faces.add(diff.come);
    }
}
