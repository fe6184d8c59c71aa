// SPDX-License-Identifier: MIT
// Contenders of cuts: a level each, and one mesh that is taken away from it again and again.
import { clock } from './race.mjs';

export class FirmaCutter {
    taken = 0;
    retries = 0;
    refused = 0;
    constructor(firma, mesh, tool) {
        this.world = firma.worldFromMesh(mesh);
        this.cutter = firma.cutterFromMesh(tool.positions, tool.corners);
    }
    cut(pose) {
        const { world, report } = this.world.carve(this.cutter, pose);
        this.world.release();
        this.world = world;
        this.taken += report.volume;
        this.retries += report.retries;
        this.refused += report.status === 'refused';
    }
    release() {
        this.world.release();
        this.cutter.release();
    }
}

/** Manifold evaluates lazily: numTri() makes it cut. */
export class ManifoldCutter {
    failed = 0;
    constructor(library, mesh, tool) {
        this.library = library;
        this.tool = tool;
        this.level = this.solid(mesh);
        this.before = this.level.volume();
    }
    solid({ positions, corners }) {
        const mesh = new this.library.Mesh({ numProp: 3, vertProperties: Float32Array.from(positions), triVerts: corners });
        const solid = new this.library.Manifold(mesh);
        if (solid.status() !== 'NoError') throw new Error(`manifold-3d: ${solid.status()}`);
        return solid;
    }
    /** @param solid the tool where Firma puts it */
    cut(solid) {
        const after = this.level.subtract(solid);
        if (after.numTri() === 0) ++this.failed;
        this.level.delete();
        solid.delete();
        this.level = after;
    }
    get taken() {
        return this.before - this.level.volume();
    }
    release() {
        this.level.delete();
    }
}

export function timed(list, run) {
    const before = clock();
    const made = run();
    list.push(clock() - before);
    return made;
}
