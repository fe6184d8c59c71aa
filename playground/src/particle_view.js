// SPDX-License-Identifier: MIT
// Particles as points of the graphics card: soft round specks, as large as they are near, up to a bound that keeps drawing
// them in software cheap.
import * as THREE from 'three';

const kMostPixels = 180;

const kVertex = `
attribute vec4 place;
attribute vec4 tint;
varying vec4 vTint;
uniform float pixels; // that a metre takes at a distance of one
void main() {
    vec4 seen = viewMatrix * vec4(place.xyz, 1.0);
    gl_Position = projectionMatrix * seen;
    gl_PointSize = clamp(pixels * place.w / max(0.05, -seen.z), 1.5, ${kMostPixels}.0);
    vTint = vec4(tint.rgb * tint.rgb, tint.a * smoothstep(0.15, 0.7, -seen.z)); // not in one's eyes
}`;
const kFragment = `
varying vec4 vTint;
void main() {
    float r = length(gl_PointCoord - 0.5) * 2.0;
    float a = vTint.a * (1.0 - smoothstep(0.25, 1.0, r));
    if (a < 0.004) discard;
    gl_FragColor = vec4(vTint.rgb, a);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
}`;

export class ParticleView {
    /** @param shines  it adds its light to what is behind it, and hides nothing */
    constructor(particles, shines) {
        this.particles = particles;
        this.geometry = new THREE.BufferGeometry();
        this.attributes = ['place', 'tint'].map((name) => {
            const attribute = new THREE.BufferAttribute(new Float32Array(4 * particles.most), 4).setUsage(THREE.DynamicDrawUsage);
            this.geometry.setAttribute(name, attribute);
            return attribute;
        });
        this.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * particles.most), 3)); // three draws as many as it has
        this.material = new THREE.ShaderMaterial({ vertexShader: kVertex, fragmentShader: kFragment, uniforms: { pixels: { value: 1 } }, transparent: true, depthWrite: false,
            blending: shines ? THREE.AdditiveBlending : THREE.NormalBlending });
        this.points = new THREE.Points(this.geometry, this.material);
        this.points.frustumCulled = false;
        this.points.renderOrder = shines ? 2 : 1;
    }

    /** @param height  of the picture, pixels @param camera  a PerspectiveCamera */
    update(height, camera) {
        const [places, tints] = this.attributes;
        const count = this.particles.pack(places.array, tints.array);
        this.geometry.setDrawRange(0, count);
        this.points.visible = count > 0;
        this.material.uniforms.pixels.value = 0.5 * height * camera.projectionMatrix.elements[5];
        for (const attribute of this.attributes) {
            attribute.clearUpdateRanges();
            attribute.addUpdateRange(0, 4 * count);
            attribute.needsUpdate = count > 0;
        }
    }
}
