// SPDX-License-Identifier: MIT
// Keyboard and mouse: what is held down, and what happens at once.
const kHeld = {
    KeyW: 'forward', ArrowUp: 'forward', KeyS: 'back', ArrowDown: 'back', KeyA: 'left', KeyD: 'right',
    ArrowLeft: 'turnLeft', ArrowRight: 'turnRight', PageUp: 'lookUp', PageDown: 'lookDown',
    Space: 'jump', ShiftLeft: 'run', ShiftRight: 'run', KeyF: 'rocket', Enter: 'rocket', KeyG: 'grenade', KeyC: 'crouch',
};
const kAtOnce = {
    KeyZ: 'undo', KeyY: 'redo', KeyR: 'respawn', KeyH: 'help', KeyP: 'portals', KeyE: 'door', KeyL: 'level', KeyB: 'bridge', KeyT: 'wall',
    KeyI: 'figures', KeyM: 'sound',
};
const kButtons = { 0: 'rocket', 2: 'grenade' }; // of a mouse
const kRadiansPerPixel = 0.0022;
const kTurn = 2.4; // radians a second, by keys

export class Input {
    /** @param actions  by the names in kAtOnce: called when a key goes down */
    constructor(canvas, player, actions) {
        this.keys = {};
        this.taps = {}; // went down since the last frame: a press shorter than a frame counts
        this.player = player;
        addEventListener('keydown', (event) => {
            if (event.altKey || event.metaKey) return;
            const held = kHeld[event.code];
            // Z and Y by what is printed on the key: layouts swap them.
            const letter = /^[a-z]$/i.test(event.key) ? `Key${event.key.toUpperCase()}` : event.code;
            const action = kAtOnce[letter] ?? null;
            if (event.ctrlKey && action !== 'undo' && action !== 'redo') return;
            if (!held && !action) return;
            event.preventDefault();
            if (held && !event.ctrlKey) this.#press(held, event.repeat);
            if (action && !event.repeat) actions[action]();
        });
        addEventListener('keyup', (event) => {
            if (kHeld[event.code]) this.keys[kHeld[event.code]] = false;
        });
        addEventListener('blur', () => this.#letGo());
        canvas.addEventListener('mousedown', (event) => {
            if (document.pointerLockElement === canvas) {
                if (kButtons[event.button]) this.#press(kButtons[event.button]);
            } else if (event.button === 0) {
                canvas.requestPointerLock()?.catch?.(() => {}); // refused just after Escape: the next click works
            }
        });
        addEventListener('mouseup', (event) => {
            if (kButtons[event.button]) this.keys[kButtons[event.button]] = false;
        });
        addEventListener('contextmenu', (event) => event.preventDefault());
        addEventListener('mousemove', (event) => {
            if (document.pointerLockElement !== canvas) return;
            player.look(player.yaw - event.movementX * kRadiansPerPixel, player.pitch - event.movementY * kRadiansPerPixel);
        });
        document.addEventListener('pointerlockchange', () => {
            const locked = document.pointerLockElement === canvas;
            document.body.classList.toggle('locked', locked);
            if (!locked) this.#letGo();
        });
    }

    /** What is held, and what was pressed since this was asked last. @param more  keys of something else: a stick */
    take(more = {}) {
        const all = { ...this.keys };
        for (const name in more) all[name] ||= more[name];
        Object.assign(all, this.taps);
        for (const name in this.taps) delete this.taps[name];
        return all;
    }

    /** Turns by the keys that are held. */
    turn(dt) {
        const { turnLeft, turnRight, lookUp, lookDown } = this.keys;
        const yaw = (turnLeft ? 1 : 0) - (turnRight ? 1 : 0);
        const pitch = (lookUp ? 1 : 0) - (lookDown ? 1 : 0);
        if (yaw || pitch) this.player.look(this.player.yaw + yaw * kTurn * dt, this.player.pitch + pitch * kTurn * dt);
    }

    #press(name, repeated = false) {
        this.keys[name] = true;
        if (!repeated) this.taps[name] = true;
    }

    #letGo() {
        for (const name in this.keys) this.keys[name] = false;
    }
}
