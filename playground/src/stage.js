// SPDX-License-Identifier: MIT
// What is drawn, but for the faces: camera, lights, fog, the flash of a shot, a cast that is shown.
import * as THREE from 'three';

const kFog = 0x8f9aa6;
const kFlashSeconds = 0.35;

export class Stage {
    constructor(canvas) {
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
        this.renderer.toneMapping = THREE.ACESFilmicToneMapping;
        this.renderer.toneMappingExposure = 1.0;
        this.scene = new THREE.Scene();
        this.scene.background = new THREE.Color(kFog);
        this.scene.fog = new THREE.FogExp2(kFog, 0.009);
        this.camera = new THREE.PerspectiveCamera(78, 1, 0.05, 400);
        this.camera.up.set(0, 0, 1);

        this.scene.add(new THREE.HemisphereLight(0xe6edf8, 0xa39a90, 1.7));
        const sun = new THREE.DirectionalLight(0xfff3e0, 1.3);
        sun.position.set(0.55, -0.35, 0.75);
        this.scene.add(sun);
        this.lamp = new THREE.PointLight(0xffe8c8, 9, 22, 1.5); // on the helmet: what is near stands out
        this.flash = new THREE.PointLight(0xffa040, 0, 14, 1.2);
        this.ball = new THREE.Mesh(new THREE.SphereGeometry(1, 16, 12),
            new THREE.MeshBasicMaterial({ color: 0xffc060, transparent: true, depthWrite: false }));
        this.ball.visible = false;
        this.trace = new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3()]),
            new THREE.LineBasicMaterial({ color: 0xffe0a0, transparent: true, depthWrite: false }));
        this.trace.frustumCulled = false;
        this.trace.visible = false;
        this.cast = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x40ff80, fog: false }));
        this.cast.visible = false;
        this.scene.add(this.lamp, this.flash, this.ball, this.trace, this.cast);
        this.sinceShot = Infinity;
    }

    resize(width, height, ratio) {
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
    }

    /** Somebody's eye, and where it looks. */
    view(eye, direction) {
        this.camera.position.set(...eye);
        this.camera.lookAt(eye[0] + direction[0], eye[1] + direction[1], eye[2] + direction[2]);
        this.lamp.position.set(eye[0], eye[1], eye[2] + 0.25);
    }

    /** A shot from an eye went off there. */
    explode(eye, point, normal) {
        const muzzle = new THREE.Vector3(0.18, -0.16, -0.3).applyQuaternion(this.camera.quaternion);
        this.trace.geometry.setFromPoints([muzzle.add(new THREE.Vector3(...eye)), new THREE.Vector3(...point)]);
        this.ball.position.set(...point);
        this.flash.position.set(...point.map((x, k) => x + 0.4 * normal[k]));
        this.sinceShot = 0;
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
        for (const material of Object.values(materials)) group.add(new THREE.Mesh(new THREE.BufferGeometry(), material));
        this.renderer.compile(group, this.camera, this.scene);
    }

    render(dt) {
        this.sinceShot += dt;
        const left = 1 - this.sinceShot / kFlashSeconds;
        this.ball.visible = left > 0;
        this.trace.visible = left > 0.5;
        this.trace.material.opacity = 2 * left - 1;
        this.flash.intensity = left > 0 ? 18 * left * left : 0;
        if (left > 0) {
            this.ball.scale.setScalar(0.15 + 0.9 * (1 - left));
            this.ball.material.opacity = 0.75 * left * left;
        }
        this.renderer.render(this.scene, this.camera);
    }
}
