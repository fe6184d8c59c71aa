// SPDX-License-Identifier: MIT
// The figures of the engine, behind a key: where one is, what the casts tested, how long things took.
const kEvery = 150; // milliseconds between two changes of the text, as it is to be read

const number = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits) : '-');
const grouped = (value) => value.toString().replace(/\B(?=(\d{3})+$)/g, ',');
const counts = ({ nodes, boxes, faces, precise }) =>
    `${nodes} nodes, ${boxes} boxes, ${faces} faces${precise ? `, ${precise} in more digits` : ''}`;

const cubic = (volume) => `${number(volume, volume < 0.1 ? 4 : 2)} m\u00b3`;
const counted = (count, what) => `${grouped(count)} ${what}${count === 1 ? '' : 's'}`;
const portalText = ({ id, rooms, area }) => `portal ${id} between ${rooms[0]} and ${rooms[1]}, ${number(area, 2)} m\u00b2`;

/** What a shot cut off and opened, in words; '' for nothing. */
function describeFound({ chunks, portals }) {
    const parts = [];
    if (chunks?.count > 0) parts.push(`${counted(chunks.count, 'chunk')} of ${cubic(chunks.volume)}, ${grouped(Math.round(chunks.mass))} kg came loose`);
    if (chunks?.crumbs > 0) parts.push(counted(chunks.crumbs, 'crumb'));
    if (portals?.length > 0) parts.push(`new: ${portals.map(portalText).join('; ')}`);
    return parts.map((part) => `; ${part}`).join('');
}

/** What a shot came to, in words. @param shot  as in state() of the game */
export function describeShot(shot) {
    if (!shot) return '';
    switch (shot.status) {
        case 'done':
            return `crater: ${shot.report.facesRemoved} faces removed, ${shot.report.facesAdded} added, ` +
                `${number(shot.report.volume, 2)} m\u00b3${describeFound(shot)}`;
        case 'nothing': return shot.report.facesCastableOnly > 0
            ? `nothing is taken away: met only faces that are castable only (${shot.report.facesCastableOnly})`
            : 'nothing is taken away: no closed solid there';
        case 'refused': return `refused: ${shot.reason}`;
        case 'undone': case 'redone': return shot.status;
        case 'opened': case 'closed': return `portal ${shot.status}`;
        case 'sky': return 'that is the sky';
        default: return 'nothing in reach';
    }
}

const sightText = (sight) => (sight ? `${sight.material} in room ${sight.room} after ${number(sight.distance, 2)} m` : 'nothing');

/** What came of a scene so far, in words. @param set  as in state() of the game */
export function describeSet(set) {
    if (!set) return '';
    const what = set.name === 'bridge' ? `the bridge: ${set.shots} of ${set.all} shots` : 'the thin wall';
    if (set.shots < set.all) return `${what}: shooting`;
    const parts = [];
    if (set.done === 0) parts.push('nothing is left there to shoot at');
    if (set.chunks > 0)
        parts.push(`${counted(set.chunks, 'chunk')} of ${cubic(set.volume)}, ${grouped(Math.round(set.mass))} kg left the level, ` +
            `the largest ${cubic(set.largest.volume)}, ${grouped(Math.round(set.largest.mass))} kg`);
    else if (set.name === 'bridge' && set.done > 0) parts.push('nothing came loose');
    if (set.portals.length > 0) parts.push(`new: ${set.portals.map(portalText).join('; ')}`);
    else if (set.name === 'wall' && set.done > 0) parts.push('one room on both sides, so no portal');
    if (set.name === 'wall') parts.push(`a cast met ${sightText(set.before)} before, meets ${sightText(set.after)} now`);
    return `${what}: ${parts.join('; ')}`;
}

export class Hud {
    /** @param root  of the figures @param told  where it stands what came of a scene, for those without them */
    constructor(root, told) {
        this.lines = Object.fromEntries(['place', 'aim', 'moves', 'times', 'shot', 'set'].map((name) => [name, root.querySelector(`.${name}`)]));
        this.told = told;
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
        set('moves', `moving: ${counted(s.debris.bodies, 'body').replace('bodys', 'bodies')}, ${s.debris.awake} awake, a step ${number(s.times.bodyMs.median, 2)} ms   ` +
            `${s.rockets} rockets, ${s.grenades} grenades   ${s.doors.all} doors`);
        set('times', `frame ${number(s.times.frameMs.median, 1)} ms (ours ${number(s.times.workMs.median, 2)})   ` +
            `a move of the player ${number(s.times.moveUs.median, 1)} \u00b5s (least ${number(s.times.moveUs.least, 1)})   ` +
            `cut ${number(s.times.cutMs.median, 2)} ms (least ${number(s.times.cutMs.least, 2)}, last ${number(s.times.cutMs.last, 2)})   drawn anew in ${number(s.times.meshMs.median, 2)} ms (last ${number(s.times.meshMs.last, 2)})`);
        set('shot', s.set ? '' : describeShot(s.shot)); // of a scene all shots together
        set('set', describeSet(s.set));
        this.told.textContent = describeSet(s.set);
    }
}
