// SPDX-License-Identifier: MIT
// Buttons of the page that are held like keys: data-hold says which. Others act at once: data-do.
/**
 * @param keys  gets true and false by the name of what is held
 * @param taps  gets true: what went down, however short
 */
export function listenToButtons(root, keys, taps, actions) {
    for (const button of root.querySelectorAll('[data-hold]')) {
        const name = button.dataset.hold;
        const set = (down) => (event) => {
            event.preventDefault();
            keys[name] = down;
            if (down) taps[name] = true;
            button.classList.toggle('down', down);
            if (down) button.setPointerCapture?.(event.pointerId);
        };
        button.addEventListener('pointerdown', set(true));
        for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) button.addEventListener(end, set(false));
        button.addEventListener('contextmenu', (event) => event.preventDefault());
    }
    for (const button of root.querySelectorAll('[data-do]'))
        button.addEventListener('click', () => {
            button.blur(); // the space bar is for jumping
            actions[button.dataset.do]();
        });
}
