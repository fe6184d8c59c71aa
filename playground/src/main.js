// SPDX-License-Identifier: MIT
// Loads Firma and a level, runs the frames, and offers window.firmaPlayground to whoever drives the page by program.
import { loadRecordings, Projectiles } from 'firma/recordings';
import { Game } from './game.js';
import { describeShot, Hud } from './hud.js';
import { listenToButtons } from './held_buttons.js';
import { Input } from './input.js';
import { kLevels, levelName, loadLevel } from './load_level.js';
import { kStopsWalk } from './masks.js';
import { drawsInSoftware, Picture, wantsFull } from './picture.js';
import { renderSound, Sound } from './sound.js';
import { kSounds } from './sound_recipes.js';
import { Stage } from './stage.js';
import { Touch } from './touch.js';

const kLongestFrame = 0.1; // seconds: after a pause time does not jump

/** For tests: `done` and `error` say when there is something to see; then time can be stepped by hand. */
const hooks = { done: false, error: null, frames: 0 };
window.firmaPlayground = hooks;

function offerHooks(game, loop, draw, picture, heldNow) {
    Object.assign(hooks, {
        state: () => game.state(),
        /** Stops time; from then on only step() moves anything. */
        pause: () => (loop.running = false),
        resume: () => (loop.running = true),
        step(dt, keys) {
            loop.running = false;
            game.step(dt, keys);
            return game.state();
        },
        look: (yaw, pitch) => game.player.look(yaw, pitch),
        place: (x, y, z) => game.player.place([x, y, z]),
        aim() {
            game.aim();
            return game.state().aim;
        },
        fire() {
            const { status, reason } = game.fire();
            return { status, reason: reason ?? null, text: describeShot(game.state().shot) };
        },
        undo: () => game.undo(),
        redo: () => game.redo(),
        respawn: () => game.respawn(),
        startSet: (name) => game.startSet(name),
        togglePortals: () => game.togglePortals(),
        turnPortal: () => game.turnPortal(),
        /** What a sound is like, played nowhere. */
        async renderSound(name) {
            const samples = await renderSound(name);
            return { peak: samples.reduce((most, x) => Math.max(most, Math.abs(x)), 0), energy: samples.reduce((sum, x) => sum + x * x, 0), finite: samples.every(Number.isFinite) };
        },
        sounds: () => Object.keys(kSounds),
        heldNow,
        /** Draws now, `dt` seconds later for what fades. */
        draw: (dt = 0) => draw(dt),
        hash: () => game.launcher.world.hash().toString(16),
        check: () => game.launcher.world.check(),
        picture: () => ({ share: picture.share, full: picture.full }),
        /** Of the player's spheres: the least distance of a centre to a face, and whether one is in rock. */
        clearance() {
            const { feet } = game.player;
            const centres = [0.35, 0.85, 1.35].map((z) => [feet[0], feet[1], feet[2] + z]);
            const { world } = game.launcher;
            return {
                distance: Math.min(...centres.map((centre) => world.closest(centre, 10, { mask: kStopsWalk })?.distance ?? 10)),
                inSolid: centres.some((centre) => world.locate(centre).where === 'solid'),
            };
        },
        game,
    });
}

/** Fingers rather than a mouse: other buttons, and fewer pixels. */
const isTouched = () => document.body.classList.contains('touch');
function beTouched() {
    if (!isTouched()) document.body.classList.add('touch', 'without-help');
}

/** What keys and buttons do at once. */
function actionsOf(game, sound, name) {
    const playSet = (set) => {
        if (isTouched()) document.body.classList.add('without-help'); // the menu would cover it
        game.startSet(set);
    };
    return {
        undo: () => game.undo(),
        redo: () => game.redo(),
        respawn: () => game.respawn(),
        portals: () => game.togglePortals(),
        door: () => game.turnPortal(),
        bridge: () => playSet('bridge'),
        wall: () => playSet('wall'),
        level: () => (location.search = `?level=${kLevels[(kLevels.indexOf(name) + 1) % kLevels.length]}${wantsFull(location.search) ? '&picture=full' : ''}`),
        help: () => document.body.classList.toggle('without-help'),
        figures: () => document.body.classList.toggle('figures'),
        sound: () => document.querySelector('#more [data-do=sound]').classList.toggle('on', sound.toggle()),
    };
}

/** Calls `frame` with the seconds gone by, for each frame of the browser. */
function runFrames(loop, frame) {
    let before = performance.now();
    const next = (now) => {
        const dt = Math.max(0, (now - before) / 1000);
        before = now;
        if (loop.running) frame(dt);
        requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
}

async function start() {
    const message = document.querySelector('#message');
    try {
        const name = levelName(location.search);
        const firma = await loadRecordings(new URL('firma_recordings.wasm', document.baseURI));
        const { world, start: from } = await loadLevel(firma, name);
        const canvas = document.querySelector('canvas');
        const picture = new Picture({ software: drawsInSoftware(), full: wantsFull(location.search) });
        const stage = new Stage(canvas, picture.antialias);
        const sound = new Sound();
        const game = new Game({ firma, Projectiles, world, levelName: name, stage, sound, start: from });
        const hud = new Hud(document.querySelector('#hud'), document.querySelector('#told'));
        document.querySelector('#title').textContent = `Firma ${firma.version} \u00b7 ${name}`;

        if (matchMedia('(pointer: coarse)').matches) beTouched();
        const resize = () => stage.resize(innerWidth, innerHeight, Math.min(devicePixelRatio, isTouched() ? 1.5 : 2) * picture.share);
        addEventListener('resize', resize);
        resize();
        const actions = actionsOf(game, sound, name);
        const input = new Input(canvas, game.player, actions);
        const touch = new Touch(canvas, game.player, document.querySelector('#stick'), () => {
            if (isTouched()) return;
            beTouched();
            resize();
        });
        listenToButtons(document, input.keys, input.taps, actions);
        for (const set of ['bridge', 'wall']) document.querySelector(`#${set}`).hidden = !game.sets.plans[set];

        const loop = { running: true };
        const draw = (dt) => {
            game.aim();
            game.render(dt);
            hud.show(game.state(), performance.now(), !loop.running);
            ++hooks.frames;
        };
        draw(0);
        offerHooks(game, loop, draw, picture, () => ({ ...input.keys, ...touch.keys }));
        runFrames(loop, (dt) => {
            const began = performance.now();
            input.turn(Math.min(dt, kLongestFrame));
            game.step(Math.min(dt, kLongestFrame), input.take(touch.keys));
            draw(dt);
            if (picture.frame(dt)) resize();
            game.frameMs.add(dt * 1000);
            game.workMs.add(performance.now() - began);
        });
        message.hidden = true;
        hooks.done = true;
    } catch (error) {
        hooks.error = String(error?.message ?? error);
        message.textContent = hooks.error;
        message.hidden = false;
        throw error;
    }
}

start();
