// SPDX-License-Identifier: MIT
// Sound, off until it is asked for: browsers start none before somebody has pressed something, and nobody is startled.
import { Chance } from './chance.js';
import { kLongestSound, kSounds } from './sound_recipes.js';
import { cross, dot, subtract } from './vector.js';

const kAtOnce = 14; // sounds; more are left out
const kLoudness = 0.5;

/** How loud something is, 0..1, and from which side, -1 left to 1, for an ear that looks along a direction. */
export function heard(ear, direction, place) {
    const to = subtract(place, ear);
    const distance = Math.hypot(...to);
    const right = cross(direction, [0, 0, 1]);
    const size = Math.hypot(...right) || 1;
    return { loud: 1 / (1 + (distance / 6) ** 1.5), side: distance > 0.5 ? (0.8 * dot(to, right)) / (distance * size) : 0 };
}

export class Sound {
    constructor(makeContext = () => new AudioContext()) {
        this.makeContext = makeContext;
        this.context = null;
        this.on = false;
        this.ends = []; // when the sounds that play end
        this.chance = new Chance(3);
        this.played = 0;
    }

    /** On or off; call it from a key or a button. Says which it is now. */
    toggle() {
        this.on = !this.on;
        if (this.on && !this.context) {
            this.context = this.makeContext();
            this.master = this.context.createDynamicsCompressor(); // several blasts at once do not clip
            const gain = this.context.createGain();
            gain.gain.value = kLoudness;
            this.master.connect(gain).connect(this.context.destination);
        }
        if (this.on) this.context.resume();
        else this.context.suspend();
        return this.on;
    }

    /** @param name  of kSounds @param loud  0..1 @param side  -1 left to 1 right */
    play(name, { loud = 1, side = 0 } = {}) {
        if (!this.on || loud < 0.02) return;
        const now = this.context.currentTime;
        this.ends = this.ends.filter((end) => end > now);
        if (this.ends.length >= kAtOnce) return;
        this.ends.push(now + kLongestSound);
        const gain = this.context.createGain();
        gain.gain.value = loud;
        const pan = this.context.createStereoPanner();
        pan.pan.value = Math.max(-1, Math.min(1, side));
        gain.connect(pan).connect(this.master);
        kSounds[name](this.context, gain, now, this.chance.next());
        setTimeout(() => pan.disconnect(), 1000 * (kLongestSound + 0.5));
        ++this.played;
    }
}

/** One sound by itself, worked out without playing it: its samples. For tests. */
export async function renderSound(name, rate = 22050) {
    const context = new OfflineAudioContext(1, Math.ceil(kLongestSound * rate), rate);
    kSounds[name](context, context.destination, 0, 0.5);
    return (await context.startRendering()).getChannelData(0);
}
