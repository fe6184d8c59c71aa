// SPDX-License-Identifier: MIT
// Turns as quaternions x, y, z, w: the few operations that what moves needs.
import { cross } from './vector.js';

/** A vector turned. */
export function turned([x, y, z, w], v) {
    const t = cross([x, y, z], v).map((c) => 2 * c);
    const u = cross([x, y, z], t);
    return v.map((c, k) => c + w * t[k] + u[k]);
}

export const back = ([x, y, z, w]) => [-x, -y, -z, w];

/** First b, then a. */
export const combine = ([ax, ay, az, aw], [bx, by, bz, bw]) => [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
];

/** About z, radians. */
export const aboutUp = (angle) => [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];

/** A pose of the world, as it is in a frame that is at `position`, turned by `rotation`. */
export function poseWithin({ position, rotation }, pose) {
    const from = pose.position.map((x, k) => x - position[k]);
    return { ...pose, position: turned(back(rotation), from), rotation: combine(back(rotation), pose.rotation ?? [0, 0, 0, 1]) };
}
