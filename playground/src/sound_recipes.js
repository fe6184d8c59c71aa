// SPDX-License-Identifier: MIT
// What is heard, made of noise and oscillators: nothing is fetched. Each function puts nodes on a context, from `when` on.
import { Chance } from './chance.js';

const kNoiseSeconds = 2;

/** White noise, the same each time. */
function makeNoise(context) {
    const buffer = context.createBuffer(1, kNoiseSeconds * context.sampleRate, context.sampleRate);
    const chance = new Chance(11);
    const samples = buffer.getChannelData(0);
    for (let k = 0; k < samples.length; ++k) samples[k] = chance.between(-1, 1);
    return buffer;
}
const noises = new WeakMap();
function noiseOf(context) {
    if (!noises.has(context)) noises.set(context, makeNoise(context));
    return noises.get(context);
}

/** Up at once, then down to nothing within `seconds`. */
function fading(context, when, seconds, strength) {
    const gain = context.createGain();
    gain.gain.setValueAtTime(0, when);
    gain.gain.linearRampToValueAtTime(strength, when + 0.004);
    gain.gain.exponentialRampToValueAtTime(1e-4, when + seconds);
    return gain;
}

/** @param from, to  hertz: of a filter, as it closes or opens */
function noise(context, out, when, { kind, from, to, seconds, strength, q = 0.7, skip = 0 }) {
    const source = context.createBufferSource();
    source.buffer = noiseOf(context);
    source.loop = true;
    const filter = context.createBiquadFilter();
    filter.type = kind;
    filter.Q.value = q;
    filter.frequency.setValueAtTime(from, when);
    filter.frequency.exponentialRampToValueAtTime(to, when + seconds);
    source.connect(filter).connect(fading(context, when, seconds, strength)).connect(out);
    source.start(when, skip % kNoiseSeconds);
    source.stop(when + seconds + 0.05);
}

function tone(context, out, when, { shape = 'sine', from, to, seconds, strength }) {
    const source = context.createOscillator();
    source.type = shape;
    source.frequency.setValueAtTime(from, when);
    source.frequency.exponentialRampToValueAtTime(to, when + seconds);
    source.connect(fading(context, when, seconds, strength)).connect(out);
    source.start(when);
    source.stop(when + seconds + 0.05);
}

/** By name; `vary` in [0, 1) makes two of a kind unlike. */
export const kSounds = {
    blast(context, out, when, vary) {
        tone(context, out, when, { from: 95 + 20 * vary, to: 28, seconds: 0.9, strength: 0.55 });
        noise(context, out, when, { kind: 'lowpass', from: 2600, to: 90, seconds: 1.5, strength: 0.5, skip: vary });
        noise(context, out, when, { kind: 'highpass', from: 1800, to: 3200, seconds: 0.12, strength: 0.2, skip: vary + 0.5 });
        noise(context, out, when + 0.25, { kind: 'bandpass', from: 900, to: 300, seconds: 1.6, strength: 0.08, q: 0.4, skip: vary + 1 }); // what falls
    },
    rocket(context, out, when, vary) {
        noise(context, out, when, { kind: 'bandpass', from: 500 + 100 * vary, to: 1800, seconds: 0.55, strength: 0.4, q: 0.9, skip: vary });
        tone(context, out, when, { shape: 'triangle', from: 160, to: 70, seconds: 0.16, strength: 0.25 });
    },
    grenade(context, out, when, vary) {
        tone(context, out, when, { from: 260 + 40 * vary, to: 90, seconds: 0.14, strength: 0.4 });
        noise(context, out, when, { kind: 'lowpass', from: 900, to: 300, seconds: 0.12, strength: 0.2, skip: vary });
    },
    bounce(context, out, when, vary) {
        tone(context, out, when, { shape: 'triangle', from: 900 + 500 * vary, to: 600, seconds: 0.07, strength: 0.25 });
        noise(context, out, when, { kind: 'bandpass', from: 2200, to: 1500, seconds: 0.05, strength: 0.2, skip: vary });
    },
    thud(context, out, when, vary) {
        tone(context, out, when, { from: 70 + 20 * vary, to: 32, seconds: 0.3, strength: 0.6 });
        noise(context, out, when, { kind: 'lowpass', from: 700, to: 120, seconds: 0.45, strength: 0.35, skip: vary });
    },
    door(context, out, when, vary) {
        for (const [at, pitch] of [[0, 1], [0.16, 1.12], [0.33, 0.94]])
            tone(context, out, when + at, { shape: 'sawtooth', from: (150 + 30 * vary) * pitch, to: 110 * pitch, seconds: 0.2, strength: 0.05 });
        noise(context, out, when, { kind: 'bandpass', from: 420, to: 260, seconds: 0.6, strength: 0.12, q: 4, skip: vary });
    },
};

/** How long the longest lasts, seconds. */
export const kLongestSound = 2;
