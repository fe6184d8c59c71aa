// SPDX-License-Identifier: MIT
// Written by tools/make_layout.js from firma_c.h; change that, not this file. Bytes, by clang for wasm32.

export const VERSION = '0.1.0';

export const FACE_TWO_SIDED = 1;
export const FACE_SOLID = 2;

/** By the numbers of firma_code. */
export const CODE_NAMES = Object.freeze([
    'OK',
    'CANNOT_READ',
    'MALFORMED',
    'OUT_OF_RANGE',
    'TOO_LARGE',
    'UNSUPPORTED',
    'INVALID',
    'CANNOT_WRITE',
    'BAD_HANDLE',
    'BAD_CALL',
    'NO_MEMORY',
    'BROKEN',
    'INTERNAL',
]);

/** By the numbers of firma_texture_unit. */
export const TEXTURE_UNIT_NAMES = Object.freeze([
    'texels',
    'repeats',
    'metres',
]);

/** By the numbers of firma_where. */
export const WHERE_NAMES = Object.freeze([
    'air',
    'solid',
    'surface',
    'unknown',
]);

/** By the numbers of firma_status. */
export const STATUS_NAMES = Object.freeze([
    'miss',
    'hit',
    'touching',
    'invalid',
]);

/** By the numbers of firma_feature. */
export const FEATURE_NAMES = Object.freeze([
    'face',
    'edge',
    'vertex',
]);

/** By the numbers of firma_shape. */
export const SHAPE_NAMES = Object.freeze([
    'rocky',
    'spiky',
    'drill',
    'wedge',
    'box',
]);

/** By the numbers of firma_carve_status. */
export const CARVE_STATUS_NAMES = Object.freeze([
    'done',
    'nothing',
    'refused',
]);

/** firma_allocator */
export const ALLOCATOR = Object.freeze({
    sizeof: 16,
    size: 0,
    take: 4,
    giveBack: 8,
    user: 12,
});

/** firma_tasks */
export const TASKS = Object.freeze({
    sizeof: 12,
    size: 0,
    run: 4,
    user: 8,
});

/** firma_world_options */
export const WORLD_OPTIONS = Object.freeze({
    sizeof: 40,
    size: 0,
    surfaceArea: 4,
    maxDepth: 8,
    facesPerBin: 12,
    minBinVolume: 16,
    skin: 24,
    scale: 32,
});

/** firma_mesh */
export const MESH = Object.freeze({
    sizeof: 48,
    size: 0,
    materialCount: 4,
    positions: 8,
    vertexCount: 12,
    corners: 16,
    cornerCounts: 20,
    faceCount: 24,
    materials: 28,
    materialNames: 32,
    masks: 36,
    twoSided: 40,
    uvs: 44,
});

/** firma_entity */
export const ENTITY = Object.freeze({
    sizeof: 48,
    classname: 0,
    keys: 4,
    values: 8,
    keyCount: 12,
    origin: 16,
    hasOrigin: 40,
    line: 44,
});

/** firma_level_view */
export const LEVEL_VIEW = Object.freeze({
    sizeof: 24,
    entities: 0,
    entityCount: 4,
    notes: 8,
    noteCount: 12,
    metresAUnit: 16,
});

/** firma_world_facts */
export const WORLD_FACTS = Object.freeze({
    sizeof: 96,
    version: 0,
    faceCount: 8,
    roomCount: 16,
    portalCount: 24,
    low: 32,
    high: 56,
    skin: 80,
    materialCount: 88,
    edits: 92,
});

/** firma_zone */
export const ZONE = Object.freeze({
    sizeof: 64,
    name: 0,
    low: 8,
    high: 32,
    hardness: 56,
});

/** firma_rules */
export const RULES = Object.freeze({
    sizeof: 80,
    size: 0,
    reserved: 4,
    zones: 8,
    zoneCount: 12,
    hardness: 16,
    hardnessCount: 20,
    mostFaces: 24,
    mostFacesLookedAt: 32,
    mostNewFaces: 40,
    mostCutterTriangles: 48,
    mostPairs: 56,
    mostCorners: 64,
    largestCutter: 72,
});

/** firma_face */
export const FACE = Object.freeze({
    sizeof: 64,
    normal: 0,
    id: 24,
    source: 28,
    sourceEdit: 32,
    material: 36,
    mask: 40,
    flags: 44,
    room: 48,
    firstCorner: 52,
    cornerCount: 56,
});

/** firma_faces_view */
export const FACES_VIEW = Object.freeze({
    sizeof: 16,
    faces: 0,
    faceCount: 4,
    corners: 8,
    cornerCount: 12,
});

/** firma_texture */
export const TEXTURE = Object.freeze({
    sizeof: 72,
    uAxis: 0,
    uOffset: 24,
    vAxis: 32,
    vOffset: 56,
    unit: 64,
    reserved: 68,
});

/** firma_triangle_run */
export const TRIANGLE_RUN = Object.freeze({
    sizeof: 24,
    material: 0,
    firstTriangle: 4,
    triangleCount: 8,
    firstVertex: 12,
    vertexCount: 16,
    reserved: 20,
});

/** firma_triangle_source */
export const TRIANGLE_SOURCE = Object.freeze({
    sizeof: 48,
    face: 0,
    room: 4,
    source: 8,
    sourceEdit: 12,
    material: 16,
    mask: 20,
    flags: 24,
    firstTriangle: 28,
    triangleCount: 32,
    firstVertex: 36,
    vertexCount: 40,
    uvUnit: 44,
});

/** firma_triangles_view */
export const TRIANGLES_VIEW = Object.freeze({
    sizeof: 44,
    positions: 0,
    normals: 4,
    vertexCount: 8,
    corners: 12,
    faces: 16,
    triangleCount: 20,
    runs: 24,
    runCount: 28,
    sources: 32,
    sourceCount: 36,
    uvs: 40,
});

/** firma_triangle_options */
export const TRIANGLE_OPTIONS = Object.freeze({
    sizeof: 64,
    size: 0,
    mask: 4,
    solidOnly: 8,
    room: 12,
    origin: 16,
    region: 40,
    textureSizes: 44,
    textureSizeCount: 48,
    uvs: 52,
    reserved: 56,
});

/** firma_room */
export const ROOM = Object.freeze({
    sizeof: 80,
    low: 0,
    high: 24,
    faceCount: 48,
    name: 56,
    portals: 60,
    portalCount: 64,
    exterior: 68,
    mergedInto: 72,
});

/** firma_portal */
export const PORTAL = Object.freeze({
    sizeof: 80,
    low: 0,
    high: 24,
    name: 48,
    rooms: 52,
    material: 60,
    mask: 64,
    open: 68,
    polygonCount: 72,
});

/** firma_cast_input */
export const CAST_INPUT = Object.freeze({
    sizeof: 56,
    centre: 0,
    radius: 24,
    path: 32,
});

/** firma_cast_options */
export const CAST_OPTIONS = Object.freeze({
    sizeof: 40,
    size: 0,
    mask: 4,
    sides: 8,
    room: 12,
    skin: 16,
    passed: 24,
    passedCapacity: 28,
    passedCount: 32,
});

/** firma_hit */
export const HIT = Object.freeze({
    sizeof: 152,
    fraction: 0,
    safeFraction: 8,
    centre: 16,
    point: 40,
    normal: 64,
    faceNormal: 88,
    status: 112,
    feature: 116,
    featureIndex: 120,
    face: 124,
    corner: 128,
    portal: 140,
    material: 144,
    reserved: 148,
});

/** firma_hit_info */
export const HIT_INFO = Object.freeze({
    sizeof: 32,
    size: 0,
    room: 4,
    source: 8,
    sourceEdit: 12,
    mask: 16,
    flags: 20,
    otherFace: 24,
    reserved: 28,
});

/** firma_cast_counts */
export const CAST_COUNTS = Object.freeze({
    sizeof: 32,
    bins: 0,
    boxes: 8,
    faces: 16,
    precise: 24,
});

/** firma_near */
export const NEAR = Object.freeze({
    sizeof: 96,
    point: 0,
    distance: 24,
    direction: 32,
    depth: 56,
    face: 64,
    corner: 68,
    feature: 80,
    featureIndex: 84,
    portal: 88,
    material: 92,
});

/** firma_near_options */
export const NEAR_OPTIONS = Object.freeze({
    sizeof: 16,
    size: 0,
    mask: 4,
    room: 8,
    reserved: 12,
});

/** firma_pose */
export const POSE = Object.freeze({
    sizeof: 64,
    position: 0,
    rotation: 24,
    scale: 56,
});

/** firma_carve_options */
export const CARVE_OPTIONS = Object.freeze({
    sizeof: 12,
    size: 0,
    fill: 4,
    material: 8,
});

/** firma_carve_report */
export const CARVE_REPORT = Object.freeze({
    sizeof: 120,
    status: 0,
    retries: 4,
    facesLookedAt: 8,
    facesCut: 16,
    facesGone: 24,
    facesNew: 32,
    scale: 40,
    volume: 48,
    placeUs: 56,
    gatherUs: 64,
    cutUs: 72,
    labelUs: 80,
    traceUs: 88,
    facetsUs: 96,
    treeUs: 104,
    facesCastableOnly: 112,
});

/** firma_diff_view */
export const DIFF_VIEW = Object.freeze({
    sizeof: 136,
    removed: 0,
    removedCount: 4,
    added: 8,
    addedCount: 12,
    corners: 16,
    cornerCount: 20,
    tiles: 24,
    tileCount: 28,
    rooms: 32,
    roomCount: 36,
    opened: 40,
    closed: 44,
    openedCount: 48,
    closedCount: 52,
    portalsAdded: 56,
    portalsRemoved: 60,
    portalsAddedCount: 64,
    portalsRemovedCount: 68,
    portalsChanged: 72,
    portalsChangedCount: 76,
    low: 80,
    high: 104,
    tooManyTiles: 128,
    reserved: 132,
});

/** firma_store_facts */
export const STORE_FACTS = Object.freeze({
    sizeof: 48,
    oldest: 0,
    current: 8,
    newest: 16,
    versions: 24,
    bytes: 32,
    waiting: 40,
});
