// SPDX-License-Identifier: MIT
// How fine the picture is: fewer pixels where frames take long. ?picture=full in the address keeps it whole.

/** Of the pixels that a full picture has along a side. */
export const kShares = [1, 0.7, 0.5, 0.35];
const kSlow = 1 / 24; // seconds a frame
const kVerySlow = 1 / 8;
const kQuick = 1 / 55;
const kFrames = 8; // frames that are looked at together
const kGood = 300; // quick ones in a row before it is made finer

/** The share of pixels, by the frames' pace. */
export class Picture {
    /** @param software  whether the page draws without a graphics card: it begins with fewer pixels then @param full  never changes */
    constructor({ software = false, full = false } = {}) {
        this.full = full;
        this.antialias = full || !software; // a picture with fewer pixels is drawn larger, and soft anyway
        this.step = software && !full ? 2 : 0;
        this.finest = 0; // a step that was too slow once is not tried again
        this.frames = [];
        this.good = 0;
    }

    get share() {
        return kShares[this.step];
    }

    /** A frame took so many seconds. @returns whether the share is another now */
    frame(dt) {
        if (this.full) return false;
        this.good = dt < kQuick ? this.good + 1 : 0;
        if (this.good >= kGood && this.step > this.finest) return this.#change(this.step - 1);
        this.frames.push(dt);
        if (this.frames.length < kFrames) return false;
        const median = this.frames.sort((a, b) => a - b)[kFrames >> 1];
        this.frames = [];
        if (median < kSlow || this.step === kShares.length - 1) return false;
        this.finest = this.step + 1;
        return this.#change(Math.min(kShares.length - 1, this.step + (median < kVerySlow ? 1 : 2)));
    }

    #change(step) {
        this.step = step;
        this.frames = [];
        this.good = 0;
        return true;
    }
}

/** Whether the browser draws without a graphics card. */
export function drawsInSoftware() {
    const gl = document.createElement('canvas').getContext('webgl2', { failIfMajorPerformanceCaveat: true });
    if (!gl) return true;
    const named = gl.getExtension('WEBGL_debug_renderer_info');
    const name = String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** What the address says. */
export const wantsFull = (search) => new URLSearchParams(search).get('picture') === 'full';
