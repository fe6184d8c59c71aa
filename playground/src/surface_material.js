// SPDX-License-Identifier: MIT
// The material of all faces: lit by three's Lambert shader, roughened by one picture (detail_texture.js) that is laid as
// the meshes say: by coordinates on faces of the level, mixed of three along the axes on those that craters made, so
// that no seam shows between them. What each kind is: painter.js, kKinds.
import * as THREE from 'three';
import { makeDetailTexture } from './detail_texture.js';
import { kFirstClear, kKinds } from './painter.js';
import { kInsides } from './inside_patterns.js';
import { kPicture } from './region_meshes.js';

const kVertexHead = `
attribute vec4 surface;
attribute vec4 blend;
attribute vec4 tangent;
varying vec3 vPlace;
varying vec3 vFlat;
varying vec4 vSurface;
varying vec4 vBlend;
varying vec4 vTangent;
varying vec2 vLaid;
`;

const kVertexBody = `
#ifdef OF_BODY
vPlace = position; // in its own frame: what is seen on it goes with it
#else
vPlace = (modelMatrix * vec4(position, 1.0)).xyz; // regions are moved, not turned
#endif
vFlat = normal;
vSurface = surface;
vBlend = blend;
vTangent = tangent;
vLaid = uv;
`;

// Faces of the other pass are drawn as points outside of the picture.
const kVertexEnd = (keeps) => `
if (!(${keeps})) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
`;
const kKind = 'floor(surface.a * 255.0 + 0.5)';

/** A number between this kind and the next one, as the shader compares it. */
const above = (kind) => `${kKinds[kind]}.5`;

const kFragmentHead = `
varying vec3 vPlace;
varying vec3 vFlat;
varying vec4 vSurface;
varying vec4 vBlend;
varying vec4 vTangent;
varying vec2 vLaid;
uniform sampler2D detail;
uniform mat3 normalMatrix;

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

// What the picture says at a place: how the surface leans, metres a metre, and how bright it is. All of a triangle has
// one kind of blend, so all pixels of a square of four go the same way, and know how far apart they are.
struct Detail { vec3 lean; float bright; };

void lay(inout Detail d, float part, vec2 laid, vec3 along, vec3 up) {
    vec3 s = texture2D(detail, laid).rgb;
    d.lean += part * ((s.r * 2.0 - 1.0) * along + (s.g * 2.0 - 1.0) * up);
    d.bright += part * s.b;
}

Detail detailAt(vec3 place, vec3 flatNormal) {
    Detail d = Detail(vec3(0), 0.0);
    if (vBlend.w > 0.5) {
        lay(d, 1.0, vLaid, vTangent.xyz, vTangent.w * cross(flatNormal, vTangent.xyz));
    } else {
        vec3 at = place / ${kPicture.toFixed(1)};
        lay(d, vBlend.x, vec2(at.y, -at.z), vec3(0, 1, 0), vec3(0, 0, 1));
        lay(d, vBlend.y, vec2(at.x, -at.z), vec3(1, 0, 0), vec3(0, 0, 1));
        lay(d, vBlend.z, vec2(at.x, -at.y), vec3(1, 0, 0), vec3(0, 1, 0));
    }
    return d;
}

float grain(vec3 place, vec3 flatNormal, float kind, float fine) {
    float broad = noiseAt(place * 1.3);
    if (kind < 0.5) return 0.93 + 0.07 * fine + 0.05 * broad;
    if (kind < 1.5) return (0.92 + 0.07 * fine + 0.06 * broad) * mix(1.0, joints(place, flatNormal), vBlend.w);
    if (kind < 2.5) return 0.66 + 0.4 * fine + 0.2 * broad;
    if (kind < 3.5) return 0.74 + 0.22 * fine + 0.24 * noiseAt(place * 0.35);
    if (kind > ${above('glass')}) return 0.9 + 0.2 * broad;
    return 1.0;
}

float roughness(float kind) {
    return kind < 0.5 ? 0.1 : kind < 1.5 ? 0.15 : kind < 2.5 ? 0.8 : kind < 3.5 ? 0.4 : kind < 4.5 ? 0.0 :
        kind < ${above('brick')} ? 0.55 : kind < ${above('concrete')} ? 0.6 : kind < ${above('wood')} ? 0.4 : kind < ${above('steel')} ? 0.25 : 0.0;
}
` + kInsides;

const kFragmentColour = `
float kind = floor(vSurface.a * 255.0 + 0.5);
vec3 paint = vSurface.rgb;
diffuseColor.rgb *= paint * paint * (0.305306 * paint + 0.682171) + 0.012523 * paint; // sRGB to linear, nearly
Detail detailHere = detailAt(vPlace, vFlat);
diffuseColor.rgb *= kind > ${above('sky')} && kind < ${above('steel')} ? inside(vPlace, kind, detailHere.bright) :
    vec3(grain(vPlace, vFlat, kind, detailHere.bright));
`;

const kFragmentNormal = `
#include <normal_fragment_maps>
normal = normalize(normal + roughness(kind) * (normalMatrix * detailHere.lean));
`;

// The sky shines by itself; glass lets through more than water.
const kFragmentSky = `
if (kind > ${above('steel')}) diffuseColor.a *= kind > ${above('glass')} ? 0.72 : 0.22;
if (kind > 3.5 && kind < 4.5) outgoingLight = diffuseColor.rgb * (0.75 + 0.25 * smoothstep(0.0, 9.0, vPlace.z));
#include <opaque_fragment>
`;

/** @param keeps  of the kinds, which are drawn: a condition of the shading language */
function makeMaterial(keeps, detail, { ofBody, ...options }) {
    const material = new THREE.MeshLambertMaterial(options);
    if (ofBody) material.defines = { OF_BODY: 1 };
    material.customProgramCacheKey = () => `${keeps} ${Boolean(ofBody)}`;
    material.onBeforeCompile = (shader) => {
        shader.uniforms.detail = { value: detail };
        shader.vertexShader = (kVertexHead + shader.vertexShader).replace('#include <begin_vertex>',
            '#include <begin_vertex>\n' + kVertexBody).replace('#include <project_vertex>', '#include <project_vertex>\n' + kVertexEnd(keeps));
        shader.fragmentShader = (kFragmentHead + shader.fragmentShader)
            .replace('#include <color_fragment>', '#include <color_fragment>\n' + kFragmentColour)
            .replace('#include <normal_fragment_maps>', kFragmentNormal)
            .replace('#include <opaque_fragment>', kFragmentSky);
    };
    return material;
}

/**
 * `solid` for what hides all behind it, `clear` for glass and water, which are seen from both sides.
 * @param options  `ofBody`: of what moves and turns
 */
function makePair(detail, options) {
    return {
        solid: makeMaterial(`${kKind} < ${kFirstClear}.0`, detail, options),
        clear: makeMaterial(`${kKind} >= ${kFirstClear}.0`, detail, { ...options, transparent: true, depthWrite: false, side: THREE.DoubleSide }),
    };
}

/** Of shadows: what the sky, glass and water throw is none. */
function makeShadowMaterial() {
    const material = new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking });
    material.onBeforeCompile = (shader) => {
        shader.vertexShader = ('attribute vec4 surface;\n' + shader.vertexShader).replace('#include <project_vertex>',
            '#include <project_vertex>\n' + kVertexEnd(`${kKind} < ${kFirstClear}.0 && ${kKind} != ${kKinds.sky}.0`));
    };
    return material;
}

/** The materials of the level, those of what moves, and that of their shadows. */
export function makeSurfaceMaterials() {
    const detail = makeDetailTexture();
    return { level: makePair(detail, {}), bodies: makePair(detail, { ofBody: true }), shadow: makeShadowMaterial() };
}
