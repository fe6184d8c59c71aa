// SPDX-License-Identifier: MIT
// What the inside of matters looks like, by the place in space alone: bricks in mortar, stones in concrete, fibres of
// wood, torn steel. GLSL, for surface_material.js, which has hashAt() and noiseAt().
import { kKinds } from './painter.js';

/** Metres, with the mortar: along x, along y, in height. */
const kBrick = [0.26, 0.13, 0.085];

export const kInsides = `
// Whole bricks and half ones, each course half a brick on; joints as wide as a pixel where they are far.
vec3 insideBrick(vec3 place, float fine) {
    vec3 size = vec3(${kBrick.map((x) => x.toFixed(4)).join(', ')});
    vec3 at = place / size;
    at.x += 0.5 * mod(floor(at.z), 2.0);
    vec3 wide = fwidth(place) * 0.7 + 0.005;
    vec3 from = (0.5 - abs(fract(at) - 0.5)) * size;
    vec3 line = 1.0 - smoothstep(wide * 0.6, wide * 1.4, from);
    float far = clamp(0.05 / max(wide.x, max(wide.y, wide.z)), 0.0, 1.0);
    float mortar = max(line.x, max(line.y, line.z)) * far;
    vec3 brick = vec3(0.72 + 0.4 * fine) * mix(1.0, 0.78 + 0.44 * hashAt(floor(at)), far);
    return mix(brick, vec3(0.92, 1.45, 1.65) * (0.8 + 0.2 * fine), mortar);
}

// Stones of a thumb's size in grey mortar.
vec3 insideConcrete(vec3 place, float fine) {
    float far = clamp(0.04 / max(0.001, length(fwidth(place))), 0.0, 1.0);
    float stones = smoothstep(0.56, 0.66, noiseAt(place * 26.0));
    float pits = smoothstep(0.68, 0.8, noiseAt(place * 11.0 + 7.0));
    vec3 mortar = vec3(0.7 + 0.4 * fine + 0.1 * noiseAt(place * 1.7));
    return mortar * mix(vec3(1.0), mix(vec3(1.0), vec3(1.22, 1.16, 1.05), stones) * (1.0 - 0.35 * pits), far);
}

vec3 insideWood(vec3 place, float fine) {
    float fibres = noiseAt(place * vec3(3.0, 34.0, 34.0));
    float rings = noiseAt(place * vec3(0.8, 9.0, 9.0));
    return vec3(0.62 + 0.35 * fibres + 0.3 * rings + 0.15 * fine) * mix(vec3(1.0), vec3(1.1, 1.0, 0.8), rings);
}

vec3 insideSteel(vec3 place, float fine) {
    float streaks = noiseAt(place * vec3(5.0, 5.0, 60.0));
    return vec3(0.65 + 0.3 * streaks + 0.25 * fine) * mix(vec3(1.0), vec3(1.15, 0.95, 0.78), 0.3 * smoothstep(0.6, 0.85, noiseAt(place * 2.0)));
}

vec3 inside(vec3 place, float kind, float fine) {
    if (kind < ${kKinds.brick}.5) return insideBrick(place, fine);
    if (kind < ${kKinds.concrete}.5) return insideConcrete(place, fine);
    if (kind < ${kKinds.wood}.5) return insideWood(place, fine);
    return insideSteel(place, fine);
}
`;
