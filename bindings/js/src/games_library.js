// SPDX-License-Identifier: MIT
// All that moves, over a module that has it: of 'firma/games' and 'firma/recordings'.
import { Bodies, BodyShape, massOfBall, massOfBox } from './bodies.js';
import { Firma } from './firma.js';
import { pathAtFirstStop, pathMotion, pathPose } from './part_paths.js';
import { movePlayer, playerBox, playerCapsule, playerFits, playerSpheres } from './players.js';
import { fly, hashProjectiles } from './projectiles.js';
import { castScene, castSceneAny, overlapScene, Parts } from './scenes.js';

export class Games extends Firma {
    #core;

    constructor(core, readers) {
        super(core, readers);
        this.#core = core;
    }

    massOfBall(radius, density) {
        return massOfBall(this.#core, radius, density);
    }

    massOfBox(half, density) {
        return massOfBox(this.#core, half, density);
    }

    bodyShape(spheres, mass) {
        return BodyShape.make(this.#core, spheres, mass);
    }

    bodies() {
        return Bodies.create(this.#core);
    }

    parts() {
        return Parts.create(this.#core);
    }

    pathPose(path, seconds) {
        return pathPose(this.#core, path, seconds);
    }

    pathMotion(path, from, to) {
        return pathMotion(this.#core, path, from, to);
    }

    pathAtFirstStop(path, seconds) {
        return pathAtFirstStop(this.#core, path, seconds);
    }

    castScene(scene, input, options) {
        return castScene(this.#core, scene, input, options);
    }

    castSceneAny(scene, input, options) {
        return castSceneAny(this.#core, scene, input, options);
    }

    overlapScene(scene, shape, options) {
        return overlapScene(this.#core, scene, shape, options);
    }

    playerCapsule(size) {
        return playerCapsule(this.#core, size);
    }

    playerBox(size) {
        return playerBox(this.#core, size);
    }

    playerSpheres(standing, crouched, up) {
        return playerSpheres(this.#core, standing, crouched, up);
    }

    movePlayer(scene, shape, player, wish, seconds, rules) {
        return movePlayer(this.#core, scene, shape, player, wish, seconds, rules);
    }

    playerFits(scene, shape, position, options) {
        return playerFits(this.#core, scene, shape, position, options);
    }

    fly(projectiles, world, seconds, options) {
        return fly(this.#core, projectiles, world, seconds, options);
    }

    hashProjectiles(projectiles) {
        return hashProjectiles(this.#core, projectiles);
    }
}
