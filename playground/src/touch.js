// SPDX-License-Identifier: MIT
// Fingers on the picture: one that goes down on the left walks like a stick from where it went down, any other one turns
// the view. Two at once do both. Buttons are in index.html.
const kStick = 55; // CSS pixels from the middle to full speed
const kDead = 0.15; // of that
const kRun = 1.25; // pushed so far beyond: run
const kLeft = 0.42; // of the width: where a stick begins
const kRadiansPerPixel = 0.0055;

/** Which keys a stick stands for. @param x, y  pixels from its middle, to the right and down */
export function stickKeys(x, y) {
    const size = Math.hypot(x, y) / kStick;
    if (size < kDead) return {};
    // By eighths of a turn, so that straight ahead is easy to hold.
    const eighth = Math.round(Math.atan2(-y, x) / (Math.PI / 4));
    const [right, ahead] = [Math.cos((eighth * Math.PI) / 4), Math.sin((eighth * Math.PI) / 4)];
    return { forward: ahead > 0.1, back: ahead < -0.1, right: right > 0.1, left: right < -0.1, run: size > kRun };
}

export class Touch {
    /** @param knob  the element that shows the stick */
    constructor(canvas, player, knob, onFirst = () => {}) {
        this.keys = {};
        this.stick = null; // { id, x, y }
        this.looks = new Map(); // id -> [x, y]
        this.knob = knob;
        canvas.addEventListener('pointerdown', (event) => {
            if (event.pointerType !== 'touch') return;
            event.preventDefault();
            onFirst();
            if (!this.stick && event.clientX < kLeft * innerWidth) {
                this.stick = { id: event.pointerId, x: event.clientX, y: event.clientY };
                this.#show(0, 0);
            } else {
                this.looks.set(event.pointerId, [event.clientX, event.clientY]);
            }
            canvas.setPointerCapture?.(event.pointerId);
        });
        canvas.addEventListener('pointermove', (event) => {
            if (event.pointerType !== 'touch') return;
            if (this.stick?.id === event.pointerId) {
                const [x, y] = [event.clientX - this.stick.x, event.clientY - this.stick.y];
                this.keys = stickKeys(x, y);
                this.#show(x, y);
            } else if (this.looks.has(event.pointerId)) {
                const [x, y] = this.looks.get(event.pointerId);
                player.look(player.yaw - (event.clientX - x) * kRadiansPerPixel, player.pitch - (event.clientY - y) * kRadiansPerPixel);
                this.looks.set(event.pointerId, [event.clientX, event.clientY]);
            }
        });
        for (const name of ['pointerup', 'pointercancel'])
            canvas.addEventListener(name, (event) => {
                this.looks.delete(event.pointerId);
                if (this.stick?.id !== event.pointerId) return;
                this.stick = null;
                this.keys = {};
                this.knob.hidden = true;
            });
    }

    #show(x, y) {
        const size = Math.max(1, Math.hypot(x, y) / kStick);
        this.knob.hidden = false;
        this.knob.style.left = `${this.stick.x}px`;
        this.knob.style.top = `${this.stick.y}px`;
        this.knob.firstElementChild.style.transform = `translate(${x / size}px, ${y / size}px)`;
    }
}
