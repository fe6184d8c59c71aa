// SPDX-License-Identifier: MIT
// Keyboard and mouse: what is held down, and what happens at once.
const kHeld = {
    KeyW: 'forward', ArrowUp: 'forward', KeyS: 'back', ArrowDown: 'back', KeyA: 'left', KeyD: 'right',
    ArrowLeft: 'turnLeft', ArrowRight: 'turnRight', PageUp: 'lookUp', PageDown: 'lookDown',
    Space: 'jump', ShiftLeft: 'run', ShiftRight: 'run',
};
const kRadiansPerPixel = 0.0022;
const kTurn = 2.4; // radians a second, by keys

export class Input {
    /** @param actions  fire, undo, redo, respawn, help, portals, door, level, bridge, wall: called when a key or the button goes down */
    constructor(canvas, player, actions) {
        this.keys = {};
        this.player = player;
        const atKey = { KeyF: 'fire', Enter: 'fire', KeyZ: 'undo', KeyY: 'redo', KeyR: 'respawn', KeyH: 'help',
            KeyP: 'portals', KeyE: 'door', KeyL: 'level', KeyB: 'bridge', KeyT: 'wall' };
        addEventListener('keydown', (event) => {
            if (event.altKey || event.metaKey) return;
            const held = kHeld[event.code];
            // Z and Y by what is printed on the key: layouts swap them.
            const letter = /^[a-z]$/i.test(event.key) ? `Key${event.key.toUpperCase()}` : event.code;
            const action = atKey[letter] ?? null;
            if (event.ctrlKey && action !== 'undo' && action !== 'redo') return;
            if (!held && !action) return;
            event.preventDefault();
            if (held && !event.ctrlKey) this.keys[held] = true;
            if (action && !event.repeat) actions[action]();
        });
        addEventListener('keyup', (event) => {
            if (kHeld[event.code]) this.keys[kHeld[event.code]] = false;
        });
        addEventListener('blur', () => (this.keys = {}));
        canvas.addEventListener('mousedown', (event) => {
            if (document.pointerLockElement === canvas) {
                if (event.button === 0) actions.fire();
            } else {
                canvas.requestPointerLock()?.catch?.(() => {}); // refused just after Escape: the next click works
            }
        });
        addEventListener('mousemove', (event) => {
            if (document.pointerLockElement !== canvas) return;
            player.look(player.yaw - event.movementX * kRadiansPerPixel, player.pitch - event.movementY * kRadiansPerPixel);
        });
        document.addEventListener('pointerlockchange', () => {
            document.body.classList.toggle('locked', document.pointerLockElement === canvas);
        });
    }

    /** Turns by the keys that are held. */
    turn(dt) {
        const { turnLeft, turnRight, lookUp, lookDown } = this.keys;
        const yaw = (turnLeft ? 1 : 0) - (turnRight ? 1 : 0);
        const pitch = (lookUp ? 1 : 0) - (lookDown ? 1 : 0);
        if (yaw || pitch) this.player.look(this.player.yaw + yaw * kTurn * dt, this.player.pitch + pitch * kTurn * dt);
    }
}
