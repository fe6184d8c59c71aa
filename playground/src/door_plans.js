// SPDX-License-Identifier: MIT
// Which portals get a door: upright rectangles along an axis, as wide as people make them; where the hinge is and how it opens.
const kWide = [0.8, 2.2]; // metres, least and most
const kHigh = [1.8, 3];
export const kThick = 0.06;
const kGap = 0.012; // around the leaf: it does not scrape

/**
 * @param portal  as World.portal() gives it
 * @returns { hinge: the foot of its axis, along: 0 or 1: the axis that the shut leaf runs along, width, height }, or null
 */
export function planDoor({ low, high, polygons, name }) {
    if (polygons.length === 0 || !name) return null; // those that craters make have no name
    const size = low.map((x, axis) => high[axis] - x);
    const across = [0, 1].find((axis) => size[axis] < 1e-6);
    if (across === undefined) return null;
    const along = 1 - across;
    const within = (x, [least, most]) => x >= least && x <= most;
    if (!within(size[along], kWide) || !within(size[2], kHigh)) return null;
    if (Math.abs(area(polygons) - size[along] * size[2]) > 1e-6) return null;
    const hinge = [low[0], low[1], low[2] + kGap];
    hinge[along] += kGap + kThick / 2; // open it stands along the jamb, not in it
    return { hinge, along, width: size[along] - 2 * kGap - kThick / 2, height: size[2] - 2 * kGap };
}

/** Of polygons in an upright plane along an axis. */
function area(polygons) {
    let sum = 0;
    for (const corners of polygons) {
        for (let k = 3; k + 3 < corners.length; k += 3) {
            const [u, v] = [k, k + 3].map((at) => [0, 1, 2].map((axis) => corners[at + axis] - corners[axis]));
            sum += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
        }
    }
    return sum;
}

/** The leaf as a mesh for Firma.worldFromMesh(), its hinge along z at the origin, running along +x from half its thickness before that. */
export function leafMesh({ width, height }) {
    const positions = Array.from({ length: 8 }, (_, k) => [k & 1 ? width : -kThick / 2, k & 2 ? kThick / 2 : -kThick / 2, k & 4 ? height : 0]).flat();
    const corners = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
    return { positions, corners, cornerCounts: [4, 4, 4, 4, 4, 4], materialNames: ['door_wood'] };
}
