// SPDX-License-Identifier: MIT
// Cuts and casts whose answers must be the same in every engine: run by node and in a browser.

/** xorshift32: integers only, so equal everywhere. @returns numbers from 0 to below 1 */
export function random(seed) {
    let state = seed >>> 0 || 1;
    return () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state = (state ^ (state << 5)) >>> 0;
        return state / 2 ** 32;
    };
}

/** Casts within bounds, seven numbers each. */
export function randomCasts(count, { low, high }, seed, length = 12) {
    const next = random(seed);
    const inputs = new Float64Array(7 * count);
    for (let k = 0; k < count; ++k) {
        for (let axis = 0; axis < 3; ++axis) inputs[7 * k + axis] = low[axis] + (high[axis] - low[axis]) * next();
        inputs[7 * k + 3] = k % 3 === 0 ? 0 : next();
        for (let axis = 0; axis < 3; ++axis) inputs[7 * k + 4 + axis] = (next() - 0.5) * length;
    }
    return inputs;
}

/** FNV-1a of 64 bits over the bytes of typed arrays. */
export function hashOf(...arrays) {
    let hash = 0xcbf29ce484222325n;
    for (const array of arrays)
        for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength))
            hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & 0xffffffffffffffffn;
    return hash.toString(16);
}

/** Places on surfaces, where cuts meet something. */
export function surfacePoints(world, count, seed) {
    const points = [];
    const batch = world.castBatch(randomCasts(20 * count, world.facts(), seed, 60));
    for (let k = 0; k < batch.count && points.length < count; ++k) {
        const hit = batch.hit(k);
        if (hit.status === 'hit') points.push(hit.point);
    }
    return points;
}

/** @param cuts of any shape, every fifth filled; @param casts of the world as it is then */
export async function scenario(firma, level, cuts, casts) {
    const shapes = ['rocky', 'spiky', 'drill', 'wedge', 'box'];
    let world = await firma.worldFromObj(level, { name: 'first.obj' });
    const counts = { done: 0, nothing: 0, refused: 0 };
    surfacePoints(world, cuts, 7).forEach((position, k) => {
        const cutter = firma.crater(shapes[k % 3 === 0 ? k % 5 : 0], k);
        const pose = { position, rotation: firma.randomTurn(k), scale: 0.5 + (k % 8) / 8 };
        const { world: after, report } = world.carve(cutter, pose, { fill: k % 5 === 4, material: 'crater' });
        ++counts[report.status];
        cutter.release();
        world.release();
        world = after;
    });
    const hits = world.castBatch(randomCasts(casts, world.facts(), 11));
    const { fraction, safeFraction, centre, point, normal, faceNormal, status, feature, face, corner } = hits;
    const answers = hashOf(fraction, safeFraction, centre, point, normal, faceNormal, status, feature, face, corner);
    const faces = world.faces();
    const result = {
        ...counts,
        hash: world.hash().toString(16),
        answers,
        faces: hashOf(faces.ids, faces.corners, faces.normals, faces.materials, faces.sources),
        hitCount: status.reduce((sum, one) => sum + (one === 1), 0),
        faceCount: faces.ids.length,
    };
    world.release();
    return { ...result, left: firma.liveHandles() };
}
