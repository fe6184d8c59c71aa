// SPDX-License-Identifier: MIT
// The lines on the screen: where one is, what the casts tested, how long things took.
const kEvery = 150; // milliseconds between two changes of the text, as it is to be read

const number = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : '-');
const grouped = (value) => value.toString().replace(/\B(?=(\d{3})+$)/g, ',');
const counts = ({ nodes, boxes, faces, precise }) =>
    `${nodes} nodes, ${boxes} boxes, ${faces} faces${precise ? `, ${precise} in more digits` : ''}`;

/** What a shot came to, in words. */
export function describeShot(shot) {
    if (!shot) return '';
    const cut = `cut ${number(shot.cutMs, 2)} ms`;
    switch (shot.status) {
        case 'done':
            return `crater: ${shot.report.facesRemoved} faces removed, ${shot.report.facesAdded} added, ` +
                `${number(shot.report.volume, 2)} m\u00b3; ${cut}, drawn anew in ${number(shot.meshMs, 2)} ms`;
        case 'nothing': return shot.report.facesCastableOnly > 0
            ? `nothing is taken away: met only faces that are castable only (${shot.report.facesCastableOnly}); ${cut}`
            : `nothing is taken away: no closed solid there (${cut})`;
        case 'refused': return `refused: ${shot.reason} (${cut})`;
        case 'undone': case 'redone': return shot.status;
        case 'opened': case 'closed': return `portal ${shot.status}`;
        case 'sky': return 'that is the sky';
        default: return 'nothing in reach';
    }
}

export class Hud {
    constructor(root) {
        this.lines = Object.fromEntries(['place', 'aim', 'move', 'times', 'shot'].map((name) => [name, root.querySelector(`.${name}`)]));
        this.shown = -Infinity;
    }

    /** @param s  state() of the game */
    show(s, now, atOnce = false) {
        if (!atOnce && now - this.shown < kEvery) return;
        this.shown = now;
        const at = s.position.map((x) => number(x, 2)).join(', ');
        const set = (name, text) => (this.lines[name].textContent = text);
        set('place', `at ${at}   ${s.room === null ? '' : `room ${s.room.name}${s.room.name === `${s.room.id}` ? '' : ` (${s.room.id})`}   `}version ${s.version}   ` +
            `${grouped(s.faces)} faces   history ${number(s.history.bytes / 1024, 0)} KiB in ${s.history.versions} versions`);
        set('aim', s.aim ? `looking: ${s.aim.met ? `${s.aim.material || 'rock'} at ${number(s.aim.distance, 2)} m` : 'nothing'}` +
            `${s.aim.rooms.length > 1 ? `, through ${s.aim.rooms.join(', ')}` : ''}` +
            `; the cast tested ${counts(s.aim.counts)}` : '');
        set('move', `moving: ${s.move.casts} casts tested ${counts(s.move.counts)}`);
        set('times', `frame ${number(s.times.frameMs.median, 1)} ms (ours ${number(s.times.workMs.median, 2)})   ` +
            `cast ${number(s.times.castUs.median, 1)} \u00b5s (least ${number(s.times.castUs.least, 1)})   ` +
            `cut ${number(s.times.cutMs.median, 2)} ms (least ${number(s.times.cutMs.least, 2)}, last ${number(s.times.cutMs.last, 2)})`);
        set('shot', describeShot(s.shot));
    }
}
