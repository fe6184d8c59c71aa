// SPDX-License-Identifier: MIT
// What is drawn, but for the faces: camera, light, fog, a cast that is shown; and what blasts add to it.
import * as THREE from 'three';
import { BlastLight } from './blast_light.js';
import { ParticleView } from './particle_view.js';
import { Particles } from './particles.js';
import { Sun } from './sun.js';

const kFog = 0x8f9aa6;
const kUpright = 78; // degrees from the lower edge to the upper one
const kLeastAcross = 62; // degrees from side to side: on an upright phone as well
const kMostUpright = 102;
const kDust = 320;
const kGlow = 420;

/** Degrees from the lower edge to the upper one for a picture so many times as wide as high. */
export function uprightAngle(aspect) {
    const half = (degrees) => Math.tan((degrees * Math.PI) / 360);
    const asked = (360 / Math.PI) * Math.atan(half(kLeastAcross) / aspect);
    return Math.min(kMostUpright, Math.max(kUpright, asked));
}

export class Stage {
    constructor(canvas, antialias = true) {
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias });
        this.renderer.toneMapping = THREE.ACESFilmicToneMapping;
        this.renderer.toneMappingExposure = 1.15;
        this.scene = new THREE.Scene();
        this.scene.background = new THREE.Color(kFog);
        this.scene.fog = new THREE.FogExp2(kFog, 0.009);
        this.camera = new THREE.PerspectiveCamera(kUpright, 1, 0.05, 400);
        this.camera.up.set(0, 0, 1);
        this.sun = new Sun(this.scene, this.renderer);
        this.lamp = new THREE.PointLight(0xffe8c8, 9, 22, 1.5); // on the helmet: what is near stands out
        this.blast = new BlastLight();
        this.dust = new Particles(kDust);
        this.glow = new Particles(kGlow);
        this.views = [new ParticleView(this.dust, false), new ParticleView(this.glow, true)];
        this.cast = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x40ff80, fog: false }));
        this.cast.visible = false;
        this.scene.add(this.lamp, this.blast.light, this.cast, ...this.views.map((view) => view.points));
    }

    resize(width, height, ratio) {
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.fov = uprightAngle(this.camera.aspect);
        this.camera.updateProjectionMatrix();
    }

    /** Somebody's eye, where it looks, and how it shakes: radians to the left, up and about the view. */
    view(eye, direction, [yaw, pitch, roll] = [0, 0, 0]) {
        this.camera.position.set(...eye);
        this.camera.lookAt(eye[0] + direction[0], eye[1] + direction[1], eye[2] + direction[2]);
        this.camera.rotateY(yaw);
        this.camera.rotateX(pitch);
        this.camera.rotateZ(roll);
        this.lamp.position.set(eye[0], eye[1], eye[2] + 0.25);
    }

    /** Where something leaves that is held at the right, beside the eye. */
    muzzle() {
        return new THREE.Vector3(0.2, -0.18, -0.35).applyQuaternion(this.camera.quaternion).toArray();
    }

    /** Shows where a cast went, from now on; null: no longer. */
    showCast(from, to) {
        this.cast.visible = from !== null;
        if (!from) return;
        this.cast.geometry.dispose();
        this.cast.geometry = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(...from), new THREE.Vector3(...to)]);
    }

    /** Compiles what materials need before they are first drawn, so that no frame waits for it. */
    warmUp(materials) {
        const group = new THREE.Group();
        for (const material of Object.values(materials)) {
            const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
            mesh.receiveShadow = true;
            group.add(mesh);
        }
        for (const { points } of this.views) group.add(new THREE.Points(points.geometry, points.material));
        this.renderer.compile(group, this.camera, this.scene);
    }

    render(dt) {
        this.blast.step(dt);
        this.dust.step(dt);
        this.glow.step(dt);
        const height = this.renderer.domElement.height;
        for (const view of this.views) view.update(height, this.camera);
        this.renderer.render(this.scene, this.camera);
    }
}
