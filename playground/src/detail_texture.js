// SPDX-License-Identifier: MIT
// One picture for all surfaces, worked out here: bumps like those of rough stone, which go on where the picture ends.
import * as THREE from 'three';

const kSize = 256; // pixels each way, a power of two
const kOctaves = 6;
const kFirstCells = 4; // of the widest bumps, across the picture

/** A number in [0, 1) that a lattice point gives. */
function chance(x, y, octave) {
    let h = Math.imul(x + 0x1f123bb5, 0x85ebca6b) ^ Math.imul(y + 0x5f356495, 0xc2b2ae35) ^ Math.imul(octave + 1, 0x27d4eb2f);
    h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
    h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
    return ((h ^ (h >>> 15)) >>> 0) / 4294967296;
}

const smooth = (t) => t * t * t * (t * (6 * t - 15) + 10);

/** Heights of 0..1, row by row; the last row goes on in the first. */
export function makeHeights(size = kSize) {
    const heights = new Float32Array(size * size);
    for (let octave = 0, cells = kFirstCells, strength = 0.5; octave < kOctaves; ++octave, cells *= 2, strength *= 0.55) {
        for (let y = 0; y < size; ++y) {
            for (let x = 0; x < size; ++x) {
                const [u, v] = [(x * cells) / size, (y * cells) / size];
                const [i, j] = [Math.floor(u), Math.floor(v)];
                const [s, t] = [smooth(u - i), smooth(v - j)];
                const at = (di, dj) => chance((i + di) % cells, (j + dj) % cells, octave);
                const value = (at(0, 0) * (1 - s) + at(1, 0) * s) * (1 - t) + (at(0, 1) * (1 - s) + at(1, 1) * s) * t;
                heights[size * y + x] += strength * (octave < 2 ? 1 - Math.abs(2 * value - 1) : value); // ridges, then grain
            }
        }
    }
    const [low, high] = heights.reduce(([a, b], h) => [Math.min(a, h), Math.max(b, h)], [Infinity, -Infinity]);
    return heights.map((h) => (h - low) / (high - low));
}

/** Red, green: how far the surface leans to the right and up, 128 for level; blue: how bright; alpha: 255. */
export function makePixels(heights, size = kSize) {
    const pixels = new Uint8Array(4 * size * size);
    const at = (x, y) => heights[size * ((y + size) % size) + ((x + size) % size)];
    for (let y = 0; y < size; ++y) {
        for (let x = 0; x < size; ++x) {
            const k = 4 * (size * y + x);
            const [right, down] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
            const lean = (slope) => Math.max(0, Math.min(255, Math.round(128 + 900 * slope)));
            pixels.set([lean(-right), lean(down), Math.round(255 * at(x, y)), 255], k);
        }
    }
    return pixels;
}

export function makeDetailTexture() {
    const texture = new THREE.DataTexture(makePixels(makeHeights()), kSize, kSize);
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.magFilter = THREE.LinearFilter;
    texture.minFilter = THREE.LinearMipmapLinearFilter;
    texture.generateMipmaps = true;
    texture.needsUpdate = true;
    return texture;
}
