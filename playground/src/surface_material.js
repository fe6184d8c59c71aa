// SPDX-License-Identifier: MIT
// The material of all faces: lit by three's Lambert shader, with a grain worked out from the place, as faces have no
// coordinates for pictures. What each kind is: painter.js, kKinds.
import * as THREE from 'three';
import { kFirstClear, kKinds } from './painter.js';

const kVertexHead = `
attribute vec4 surface;
varying vec3 vPlace;
varying vec3 vFlat;
varying vec4 vSurface;
`;

const kVertexBody = `
vPlace = position;
vFlat = normal;
vSurface = surface;
`;

// Faces of the other pass are drawn as points outside of the picture.
const kVertexEnd = (keeps) => `
if (!(${keeps})) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
`;
const kKind = 'floor(surface.a * 255.0 + 0.5)';


const kFragmentHead = `
varying vec3 vPlace;
varying vec3 vFlat;
varying vec4 vSurface;

float hashAt(vec3 p) {
    p = fract(p * 0.3183099 + vec3(0.71, 0.113, 0.419));
    p *= 17.0;
    return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}

float noiseAt(vec3 p) {
    vec3 cell = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(mix(hashAt(cell), hashAt(cell + vec3(1, 0, 0)), f.x),
                   mix(hashAt(cell + vec3(0, 1, 0)), hashAt(cell + vec3(1, 1, 0)), f.x), f.y),
               mix(mix(hashAt(cell + vec3(0, 0, 1)), hashAt(cell + vec3(1, 0, 1)), f.x),
                   mix(hashAt(cell + vec3(0, 1, 1)), hashAt(cell + vec3(1, 1, 1)), f.x), f.y), f.z);
}

// Dark joints each two metres across the two axes that a wall runs along, as wide as a pixel where they are far.
float joints(vec3 place, vec3 flatNormal) {
    vec3 a = abs(flatNormal);
    vec2 uv = a.z > a.x && a.z > a.y ? place.xy : a.x > a.y ? place.yz : place.xz;
    vec2 wide = fwidth(uv) * 0.6 + 0.008;
    vec2 from = abs(fract(uv * 0.5 + 0.5) - 0.5) * 2.0;
    vec2 line = 1.0 - smoothstep(wide, wide * 1.8, from);
    float strength = clamp(0.2 / max(wide.x, wide.y), 0.0, 1.0);
    return 1.0 - 0.2 * strength * max(line.x, line.y);
}

float grain(vec3 place, vec3 flatNormal, float kind) {
    float fine = noiseAt(place * 7.0), broad = noiseAt(place * 1.3);
    if (kind < 0.5) return 0.93 + 0.07 * fine + 0.05 * broad;
    if (kind < 1.5) return (0.92 + 0.07 * fine + 0.06 * broad) * joints(place, flatNormal);
    if (kind < 2.5) return 0.7 + 0.16 * fine + 0.2 * broad + 0.2 * noiseAt(place * 19.0);
    if (kind < 3.5) return 0.74 + 0.22 * fine + 0.24 * noiseAt(place * 0.35);
    if (kind > 5.5) return 0.9 + 0.2 * broad;
    return 1.0;
}
`;

const kFragmentColour = `
float kind = floor(vSurface.a * 255.0 + 0.5);
vec3 paint = vSurface.rgb;
diffuseColor.rgb *= paint * paint * (0.305306 * paint + 0.682171) + 0.012523 * paint; // sRGB to linear, nearly
diffuseColor.rgb *= grain(vPlace, vFlat, kind);
`;

// The sky shines by itself; glass lets through more than water.
const kFragmentSky = `
if (kind > 4.5) diffuseColor.a = kind > 5.5 ? 0.72 : 0.22;
if (kind > 3.5 && kind < 4.5) outgoingLight = diffuseColor.rgb * (0.75 + 0.25 * smoothstep(0.0, 9.0, vPlace.z));
#include <opaque_fragment>
`;

/** @param keeps  of the kinds, which are drawn: a condition of the shading language */
function makeMaterial(keeps, options) {
    const material = new THREE.MeshLambertMaterial(options);
    material.customProgramCacheKey = () => keeps;
    material.onBeforeCompile = (shader) => {
        shader.vertexShader = (kVertexHead + shader.vertexShader).replace('#include <begin_vertex>',
            '#include <begin_vertex>\n' + kVertexBody).replace('#include <project_vertex>', '#include <project_vertex>\n' + kVertexEnd(keeps));
        shader.fragmentShader = (kFragmentHead + shader.fragmentShader)
            .replace('#include <color_fragment>', '#include <color_fragment>\n' + kFragmentColour)
            .replace('#include <opaque_fragment>', kFragmentSky);
    };
    return material;
}

/** `solid` for what hides all behind it, `clear` for glass and water, which are seen from both sides. */
export function makeSurfaceMaterials() {
    return {
        solid: makeMaterial(`${kKind} < ${kFirstClear}.0`, {}),
        clear: makeMaterial(`${kKind} >= ${kFirstClear}.0 && ${kKind} < ${kKinds.hidden}.0`,
            { transparent: true, depthWrite: false, side: THREE.DoubleSide }),
    };
}
