// SPDX-License-Identifier: MIT
// Portals as panes with a rim: closed ones always, open ones when they are asked for.
import * as THREE from 'three';

const kOpen = 0x1fd6b0;
const kClosed = 0xe2453c;

/** Corners as a fan of triangles. */
function fan(corners, out) {
    for (let k = 3; k + 3 < corners.length; k += 3)
        out.push(corners[0], corners[1], corners[2], ...corners.subarray(k, k + 6));
}

/** The edges of polygons, but for those along which two of them meet. */
export function rimOf(polygons) {
    const edges = new Map();
    for (const corners of polygons) {
        for (let k = 0; k < corners.length; k += 3) {
            const from = [...corners.subarray(k, k + 3)];
            const next = (k + 3) % corners.length;
            const to = [...corners.subarray(next, next + 3)];
            if (!edges.delete(`${to};${from}`)) edges.set(`${from};${to}`, [...from, ...to]);
        }
    }
    return [...edges.values()].flat();
}

export class PortalPanes {
    constructor() {
        this.group = new THREE.Group();
        this.all = false; // open ones, too
        this.portals = [];
        this.doors = new Set();
    }

    /** @param portals  as World.portal() gives them @param doors  numbers of those that a door shuts: their panes are not drawn */
    show(portals, all = this.all, doors = this.doors) {
        this.portals = portals;
        this.all = all;
        this.doors = doors;
        for (const child of this.group.children) child.geometry.dispose();
        this.group.clear();
        for (const [open, colour, opacity] of [[true, kOpen, 0.25], [false, kClosed, 0.55]]) {
            const shown = portals.filter((portal, k) => portal.open === open && (all || (!open && !doors.has(k))) && portal.polygons.length > 0);
            if (shown.length === 0) continue;
            const triangles = [];
            for (const portal of shown) for (const corners of portal.polygons) fan(corners, triangles);
            const geometry = (numbers) => new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(numbers, 3));
            const look = { color: colour, transparent: true, depthWrite: false, fog: false };
            this.group.add(new THREE.Mesh(geometry(triangles), new THREE.MeshBasicMaterial({ ...look, opacity, side: THREE.DoubleSide })));
            this.group.add(new THREE.LineSegments(geometry(shown.flatMap((portal) => rimOf(portal.polygons))), new THREE.LineBasicMaterial(look)));
        }
    }
}
