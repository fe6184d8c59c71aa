// SPDX-License-Identifier: MIT
// Written by tools/make_layout.js from firma_c.h; change that, not this file. Bytes, by clang for wasm32.

export const VERSION = '0.2.0';

export const STOPS_WALK = 1;
export const STOPS_SHOTS = 2;
export const STOPS_SIGHT = 4;
export const STOPS_LIQUID = 8;
export const IS_SKY = 16;
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

/** By the numbers of firma_fracture. */
export const FRACTURE_NAMES = Object.freeze([
    'chunks',
    'splinters',
    'bends',
    'pane',
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

/** By the numbers of firma_mover_kind. */
export const MOVER_KIND_NAMES = Object.freeze([
    'sphere',
    'capsule',
    'hull',
]);

/** By the numbers of firma_contact_kind. */
export const CONTACT_KIND_NAMES = Object.freeze([
    'ground',
    'wall',
    'ceiling',
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

/** By the numbers of firma_projectile_state. */
export const PROJECTILE_STATE_NAMES = Object.freeze([
    'flying',
    'stopped',
    'expired',
]);

/** By the numbers of firma_shot_event_kind. */
export const SHOT_EVENT_KIND_NAMES = Object.freeze([
    'ricochet',
    'entered',
    'left',
    'passed',
    'stopped',
    'expired',
]);

/** By the numbers of firma_crack_style. */
export const CRACK_STYLE_NAMES = Object.freeze([
    'lumps',
    'bricks',
    'shards',
]);

/** By the numbers of firma_debris_list. */
export const DEBRIS_LIST_NAMES = Object.freeze([
    'loose',
    'pieces',
    'removed',
    'to_ground',
]);

/** By the numbers of firma_when_blocked. */
export const WHEN_BLOCKED_NAMES = Object.freeze([
    'blocked_stops',
    'blocked_returns',
    'blocked_crushes',
]);

/** By the numbers of firma_support_kind. */
export const SUPPORT_KIND_NAMES = Object.freeze([
    'touches',
    'stands',
    'hangs',
]);

/** By the numbers of firma_support_loss. */
export const SUPPORT_LOSS_NAMES = Object.freeze([
    'kept',
    'less',
    'lost',
]);

/** By the numbers of firma_edit_kind. */
export const EDIT_KIND_NAMES = Object.freeze([
    'carve',
    'fill',
    'door',
    'group',
]);

/** By the numbers of firma_game_item. */
export const GAME_ITEM_NAMES = Object.freeze([
    'world',
    'part',
    'player',
    'projectile',
    'body',
    'debris',
    'rest',
]);

/** By the numbers of firma_bytes_kind. */
export const BYTES_KIND_NAMES = Object.freeze([
    'other',
    'game',
    'recording',
]);

/** By the numbers of firma_game_event_kind. */
export const GAME_EVENT_KIND_NAMES = Object.freeze([
    'edit',
    'blast',
    'fire',
    'body',
    'player',
    'wish',
    'part',
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

/** firma_matter */
export const MATTER = Object.freeze({
    sizeof: 40,
    name: 0,
    inside: 4,
    density: 8,
    strength: 16,
    hardness: 24,
    fracture: 32,
    reserved: 36,
});

/** firma_matter_pattern */
export const MATTER_PATTERN = Object.freeze({
    sizeof: 12,
    pattern: 0,
    matter: 4,
    reserved: 8,
});

/** firma_matter_table */
export const MATTER_TABLE = Object.freeze({
    sizeof: 24,
    size: 0,
    reserved: 4,
    matters: 8,
    matterCount: 12,
    patterns: 16,
    patternCount: 20,
});

/** firma_matter_counts */
export const MATTER_COUNTS = Object.freeze({
    sizeof: 32,
    size: 0,
    rest: 4,
    pieces: 8,
    protectedPieces: 16,
    matterCount: 24,
});

/** firma_world_options */
export const WORLD_OPTIONS = Object.freeze({
    sizeof: 56,
    size: 0,
    surfaceArea: 4,
    maxDepth: 8,
    facesPerLeaf: 12,
    minNodeVolume: 16,
    contactOffset: 24,
    scale: 32,
    noTextures: 40,
    reserved: 44,
    matters: 48,
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

/** firma_omission */
export const OMISSION = Object.freeze({
    sizeof: 16,
    what: 0,
    first: 4,
    count: 8,
});

/** firma_box */
export const BOX = Object.freeze({
    sizeof: 48,
    low: 0,
    high: 24,
});

/** firma_level_view */
export const LEVEL_VIEW = Object.freeze({
    sizeof: 48,
    size: 0,
    entities: 4,
    entityCount: 8,
    notes: 12,
    noteCount: 16,
    omissions: 20,
    omissionCount: 24,
    metresAUnit: 32,
    anchors: 40,
    anchorCount: 44,
});

/** firma_world_facts */
export const WORLD_FACTS = Object.freeze({
    sizeof: 104,
    size: 0,
    edits: 4,
    version: 8,
    faceCount: 16,
    roomCount: 24,
    portalCount: 32,
    low: 40,
    high: 64,
    contactOffset: 88,
    materialCount: 96,
    reserved: 100,
});

/** firma_region_hash */
export const REGION_HASH = Object.freeze({
    sizeof: 32,
    region: 0,
    reserved: 12,
    faces: 16,
    points: 24,
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
    sizeof: 96,
    size: 0,
    reserved: 4,
    zones: 8,
    zoneCount: 12,
    hardness: 16,
    hardnessCount: 20,
    maxFaces: 24,
    maxCandidateFaces: 32,
    maxNewFaces: 40,
    maxCutterTriangles: 48,
    maxPairs: 56,
    maxCorners: 64,
    maxCutterSize: 72,
    mergeShare: 80,
    noOpenFaces: 88,
    reserved2: 92,
});

/** firma_face */
export const FACE = Object.freeze({
    sizeof: 72,
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
    corner: 60,
});

/** firma_faces_view */
export const FACES_VIEW = Object.freeze({
    sizeof: 20,
    size: 0,
    faces: 4,
    faceCount: 8,
    corners: 12,
    cornerCount: 16,
});

/** firma_face_filter */
export const FACE_FILTER = Object.freeze({
    sizeof: 16,
    size: 0,
    room: 4,
    box: 8,
    region: 12,
});

/** firma_texture */
export const TEXTURE = Object.freeze({
    sizeof: 72,
    size: 0,
    unit: 4,
    uAxis: 8,
    uOffset: 32,
    vAxis: 40,
    vOffset: 64,
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
    sizeof: 48,
    size: 0,
    positions: 4,
    normals: 8,
    vertexCount: 12,
    corners: 16,
    faces: 20,
    triangleCount: 24,
    runs: 28,
    runCount: 32,
    sources: 36,
    sourceCount: 40,
    uvs: 44,
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

/** firma_region_run */
export const REGION_RUN = Object.freeze({
    sizeof: 32,
    material: 0,
    cut: 4,
    twoSided: 8,
    uvUnit: 12,
    firstTriangle: 16,
    triangleCount: 20,
    firstVertex: 24,
    vertexCount: 28,
});

/** firma_region_part */
export const REGION_PART = Object.freeze({
    sizeof: 48,
    face: 0,
    corner: 4,
    source: 16,
    sourceEdit: 20,
    mask: 24,
    flags: 28,
    firstTriangle: 32,
    triangleCount: 36,
    firstVertex: 40,
    vertexCount: 44,
});

/** firma_region_mesh_view */
export const REGION_MESH_VIEW = Object.freeze({
    sizeof: 144,
    size: 0,
    place: 4,
    origin: 16,
    low: 40,
    high: 64,
    positions: 88,
    normals: 92,
    tangents: 96,
    uvs: 100,
    blends: 104,
    vertexCount: 108,
    corners: 112,
    faces: 116,
    triangleCount: 120,
    runs: 124,
    runCount: 128,
    parts: 132,
    partCount: 136,
});

/** firma_region_options */
export const REGION_OPTIONS = Object.freeze({
    sizeof: 32,
    size: 0,
    mask: 4,
    solidOnly: 8,
    noTextures: 12,
    regionSize: 16,
    textureSizes: 24,
    textureSizeCount: 28,
});

/** firma_room */
export const ROOM = Object.freeze({
    sizeof: 88,
    size: 0,
    exterior: 4,
    low: 8,
    high: 32,
    faceCount: 56,
    name: 64,
    portals: 68,
    portalCount: 72,
    mergedInto: 76,
    reserved: 80,
});

/** firma_portal */
export const PORTAL = Object.freeze({
    sizeof: 88,
    size: 0,
    material: 4,
    low: 8,
    high: 32,
    name: 56,
    rooms: 60,
    mask: 68,
    open: 72,
    polygonCount: 76,
    reserved: 80,
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
    contactOffset: 16,
    passed: 24,
    passedCapacity: 28,
    passedCount: 32,
    passedPortals: 36,
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
    nodes: 0,
    boxes: 8,
    faces: 16,
    precise: 24,
});

/** firma_mover */
export const MOVER = Object.freeze({
    sizeof: 72,
    size: 0,
    kind: 4,
    at: 8,
    to: 32,
    radius: 56,
    hull: 64,
});

/** firma_casts */
export const CASTS = Object.freeze({
    sizeof: 68,
    size: 0,
    kind: 4,
    count: 8,
    stride: 12,
    x: 16,
    y: 20,
    z: 24,
    pathX: 28,
    pathY: 32,
    pathZ: 36,
    toX: 40,
    toY: 44,
    toZ: 48,
    radius: 52,
    hulls: 56,
    hullCount: 60,
    hullOf: 64,
});

/** firma_answers */
export const ANSWERS = Object.freeze({
    sizeof: 48,
    size: 0,
    reserved: 4,
    hits: 8,
    status: 12,
    fraction: 16,
    safeFraction: 20,
    normalX: 24,
    normalY: 28,
    normalZ: 32,
    face: 36,
    portal: 40,
    material: 44,
});

/** firma_many_options */
export const MANY_OPTIONS = Object.freeze({
    sizeof: 16,
    size: 0,
    any: 4,
    progress: 8,
    user: 12,
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

/** firma_motion */
export const MOTION = Object.freeze({
    sizeof: 104,
    position: 0,
    rotation: 24,
    path: 56,
    turn: 80,
});

/** firma_part */
export const PART = Object.freeze({
    sizeof: 120,
    size: 0,
    mask: 4,
    world: 8,
    motion: 16,
});

/** firma_scene */
export const SCENE = Object.freeze({
    sizeof: 40,
    size: 0,
    reserved: 4,
    world: 8,
    parts: 16,
    from: 24,
    to: 32,
});

/** firma_part_hit */
export const PART_HIT = Object.freeze({
    sizeof: 184,
    hit: 0,
    surfaceVelocity: 152,
    part: 176,
    reserved: 180,
});

/** firma_part_near */
export const PART_NEAR = Object.freeze({
    sizeof: 128,
    near: 0,
    surfaceVelocity: 96,
    part: 120,
    reserved: 124,
});

/** firma_set_hit */
export const SET_HIT = Object.freeze({
    sizeof: 160,
    hit: 0,
    sphere: 152,
    reserved: 156,
});

/** firma_set_part_hit */
export const SET_PART_HIT = Object.freeze({
    sizeof: 192,
    hit: 0,
    sphere: 184,
    reserved: 188,
});

/** firma_set_pair_hit */
export const SET_PAIR_HIT = Object.freeze({
    sizeof: 72,
    fraction: 0,
    point: 8,
    normal: 32,
    status: 56,
    sphereA: 60,
    sphereB: 64,
    reserved: 68,
});

/** firma_player_size */
export const PLAYER_SIZE = Object.freeze({
    sizeof: 56,
    size: 0,
    reserved: 4,
    radius: 8,
    height: 16,
    crouchedHeight: 24,
    up: 32,
});

/** firma_player */
export const PLAYER = Object.freeze({
    sizeof: 128,
    position: 0,
    velocity: 24,
    groundNormal: 48,
    groundVelocity: 72,
    worldHash: 96,
    mask: 104,
    room: 108,
    groundPart: 112,
    onGround: 116,
    crouched: 120,
    stuck: 124,
});

/** firma_player_wish */
export const PLAYER_WISH = Object.freeze({
    sizeof: 40,
    size: 0,
    jump: 4,
    crouch: 8,
    careful: 12,
    velocity: 16,
});

/** firma_player_rules */
export const PLAYER_RULES = Object.freeze({
    sizeof: 96,
    size: 0,
    reserved: 4,
    gravity: 8,
    maxSlope: 16,
    stepHeight: 24,
    maxDrop: 32,
    overhang: 40,
    jumpSpeed: 48,
    groundAcceleration: 56,
    airAcceleration: 64,
    crouchedSpeed: 72,
    maxPush: 80,
    contactOffset: 88,
});

/** firma_player_contact */
export const PLAYER_CONTACT = Object.freeze({
    sizeof: 104,
    point: 0,
    normal: 24,
    faceNormal: 48,
    kind: 72,
    face: 76,
    corner: 80,
    portal: 92,
    part: 96,
    material: 100,
});

/** firma_player_move */
export const PLAYER_MOVE = Object.freeze({
    sizeof: 1040,
    size: 0,
    contactCount: 4,
    player: 8,
    pushed: 136,
    carried: 160,
    landedSpeed: 184,
    pushedBy: 192,
    crushedBy: 196,
    jumped: 200,
    stepped: 204,
    contacts: 208,
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
    sizeof: 72,
    size: 0,
    fill: 4,
    material: 8,
    hasFrom: 12,
    reserved: 16,
    from: 24,
    chunks: 48,
    edit: 52,
    minChunkVolume: 56,
    density: 64,
});

/** firma_carve_report */
export const CARVE_REPORT = Object.freeze({
    sizeof: 240,
    size: 0,
    status: 4,
    retries: 8,
    reserved: 12,
    candidateFaces: 16,
    facesCut: 24,
    facesRemoved: 32,
    facesAdded: 40,
    scale: 48,
    volume: 56,
    placeUs: 64,
    gatherUs: 72,
    cutUs: 80,
    labelUs: 88,
    traceUs: 96,
    facetsUs: 104,
    treeUs: 112,
    facesCastableOnly: 120,
    portals: 128,
    rooms: 136,
    chunks: 144,
    crumbs: 152,
    chunkVolume: 160,
    crumbVolume: 168,
    facesSearched: 176,
    chunksUs: 184,
    loose: 192,
    cutShort: 200,
    openTrimmed: 208,
    openRemoved: 216,
    panes: 224,
    clips: 232,
});

/** firma_anchors */
export const ANCHORS = Object.freeze({
    sizeof: 32,
    size: 0,
    noHanging: 4,
    materials: 8,
    materialCount: 12,
    sources: 16,
    sourceCount: 20,
    volumes: 24,
    volumeCount: 28,
});

/** firma_mass */
export const MASS = Object.freeze({
    sizeof: 112,
    volume: 0,
    mass: 8,
    centre: 16,
    inertia: 40,
});

/** firma_matter_volume */
export const MATTER_VOLUME = Object.freeze({
    sizeof: 16,
    matter: 0,
    reserved: 4,
    volume: 8,
});

/** firma_chunk */
export const CHUNK = Object.freeze({
    sizeof: 208,
    size: 0,
    reserved: 4,
    origin: 8,
    mass: 32,
    faceCount: 144,
    low: 152,
    high: 176,
    matters: 200,
    matterCount: 204,
});

/** firma_rest */
export const REST = Object.freeze({
    sizeof: 80,
    size: 0,
    mended: 4,
    pose: 8,
    volumeChange: 72,
});

/** firma_convex_options */
export const CONVEX_OPTIONS = Object.freeze({
    sizeof: 24,
    size: 0,
    maxPieces: 4,
    maxConcavity: 8,
    density: 16,
});

/** firma_convex_face */
export const CONVEX_FACE = Object.freeze({
    sizeof: 40,
    normal: 0,
    offset: 24,
    first: 32,
    count: 36,
});

/** firma_convex_piece */
export const CONVEX_PIECE = Object.freeze({
    sizeof: 160,
    size: 0,
    exact: 4,
    mass: 8,
    hullVolume: 120,
    overhang: 128,
    corners: 136,
    cornerCount: 140,
    faces: 144,
    faceCount: 148,
    loops: 152,
    loopCount: 156,
});

/** firma_fit_options */
export const FIT_OPTIONS = Object.freeze({
    sizeof: 24,
    size: 0,
    maxSpheres: 4,
    maxError: 8,
    margin: 16,
});

/** firma_body_id */
export const BODY_ID = Object.freeze({
    sizeof: 8,
    slot: 0,
    use: 4,
});

/** firma_body */
export const BODY = Object.freeze({
    sizeof: 208,
    size: 0,
    mask: 4,
    position: 8,
    rotation: 32,
    velocity: 64,
    spin: 88,
    force: 112,
    torque: 136,
    friction: 160,
    restitution: 168,
    rolling: 176,
    mass: 184,
    asleep: 192,
    stuck: 196,
    crushed: 200,
    reserved: 204,
});

/** firma_step_options */
export const STEP_OPTIONS = Object.freeze({
    sizeof: 72,
    size: 0,
    substepsASecond: 4,
    maxBounces: 8,
    reserved: 12,
    gravity: 16,
    contactFriction: 40,
    contactOffset: 48,
    sleepSpeed: 56,
    sleepAfter: 64,
});

/** firma_step_report */
export const STEP_REPORT = Object.freeze({
    sizeof: 64,
    size: 0,
    reserved: 4,
    awake: 8,
    contacts: 16,
    swept: 24,
    bounces: 32,
    woken: 40,
    stuck: 48,
    crushed: 56,
});

/** firma_body_contact */
export const BODY_CONTACT = Object.freeze({
    sizeof: 96,
    body: 0,
    other: 8,
    point: 16,
    normal: 40,
    force: 64,
    face: 72,
    corner: 76,
    portal: 88,
    part: 92,
});

/** firma_body_hit */
export const BODY_HIT = Object.freeze({
    sizeof: 136,
    fraction: 0,
    safeFraction: 8,
    centre: 16,
    point: 40,
    normal: 64,
    surfaceVelocity: 88,
    body: 112,
    bodySphere: 120,
    sphere: 124,
    status: 128,
    reserved: 132,
});

/** firma_body_cast_options */
export const BODY_CAST_OPTIONS = Object.freeze({
    sizeof: 24,
    size: 0,
    mask: 4,
    except: 8,
    contactOffset: 16,
});

/** firma_projectile */
export const PROJECTILE = Object.freeze({
    sizeof: 88,
    position: 0,
    velocity: 24,
    mass: 48,
    age: 56,
    worldHash: 64,
    mask: 72,
    user: 76,
    state: 80,
    reserved: 84,
});

/** firma_shot_terms */
export const SHOT_TERMS = Object.freeze({
    sizeof: 32,
    ricochetBelow: 0,
    restitution: 8,
    friction: 16,
    resistance: 24,
});

/** firma_shot_impact */
export const SHOT_IMPACT = Object.freeze({
    sizeof: 152,
    point: 0,
    normal: 24,
    velocity: 48,
    surface: 72,
    mass: 96,
    projectile: 104,
    face: 108,
    corner: 112,
    portal: 124,
    body: 128,
    material: 136,
    pane: 140,
    part: 144,
    reserved: 148,
});

/** firma_fly_options */
export const FLY_OPTIONS = Object.freeze({
    sizeof: 152,
    size: 0,
    maxImpacts: 4,
    gravity: 8,
    maxBow: 32,
    maxAge: 40,
    stopSpeed: 48,
    maxThickness: 56,
    paneEnergy: 64,
    other: 72,
    bodies: 104,
    matters: 136,
    matterCount: 140,
    rule: 144,
    user: 148,
});

/** firma_shot_event */
export const SHOT_EVENT = Object.freeze({
    sizeof: 208,
    time: 0,
    point: 8,
    normal: 32,
    velocity: 56,
    impulse: 80,
    energy: 104,
    thickness: 112,
    inPart: 120,
    kind: 144,
    projectile: 148,
    number: 152,
    face: 156,
    corner: 160,
    portal: 172,
    body: 176,
    material: 184,
    matter: 188,
    firstLength: 192,
    lengthCount: 196,
    part: 200,
    reserved: 204,
});

/** firma_shot_length */
export const SHOT_LENGTH = Object.freeze({
    sizeof: 24,
    from: 0,
    to: 8,
    matter: 16,
    reserved: 20,
});

/** firma_shot_view */
export const SHOT_VIEW = Object.freeze({
    sizeof: 24,
    size: 0,
    reserved: 4,
    events: 8,
    eventCount: 12,
    lengths: 16,
    lengthCount: 20,
});

/** firma_fly_report */
export const FLY_REPORT = Object.freeze({
    sizeof: 32,
    size: 0,
    reserved: 4,
    flying: 8,
    chords: 16,
    impacts: 24,
});

/** firma_pierce_end */
export const PIERCE_END = Object.freeze({
    sizeof: 80,
    fraction: 0,
    point: 8,
    normal: 32,
    face: 56,
    corner: 60,
    material: 72,
    reserved: 76,
});

/** firma_pierce_span */
export const PIERCE_SPAN = Object.freeze({
    sizeof: 192,
    in: 0,
    out: 80,
    thickness: 160,
    firstLength: 168,
    lengthCount: 172,
    portal: 176,
    pane: 180,
    startsInside: 184,
    endsInside: 188,
});

/** firma_piercing_view */
export const PIERCING_VIEW = Object.freeze({
    sizeof: 32,
    size: 0,
    reserved: 4,
    spans: 8,
    spanCount: 12,
    lengths: 16,
    lengthCount: 20,
    thickness: 24,
});

/** firma_pierce_options */
export const PIERCE_OPTIONS = Object.freeze({
    sizeof: 24,
    size: 0,
    mask: 4,
    bothSides: 8,
    noPanes: 12,
    noMatters: 16,
    reserved: 20,
});

/** firma_fracture_pattern */
export const FRACTURE_PATTERN = Object.freeze({
    sizeof: 112,
    size: 0,
    style: 4,
    sizeOfPiece: 8,
    growth: 32,
    crooked: 40,
    hasAxes: 48,
    hasBrickCorner: 52,
    axes: 56,
    brickCorner: 88,
});

/** firma_fracture_options */
export const FRACTURE_OPTIONS = Object.freeze({
    sizeof: 64,
    size: 0,
    maxPieces: 4,
    material: 8,
    hasImpact: 12,
    impact: 16,
    minVolume: 40,
    density: 48,
    seed: 56,
});

/** firma_debris_piece */
export const DEBRIS_PIECE = Object.freeze({
    sizeof: 72,
    size: 0,
    matter: 4,
    origin: 8,
    age: 32,
    asleepFor: 40,
    faceCount: 48,
    broken: 56,
    neverGround: 60,
    ofPart: 64,
    reserved: 68,
});

/** firma_shatter_options */
export const SHATTER_OPTIONS = Object.freeze({
    sizeof: 16,
    size: 0,
    maxSpheres: 4,
    world: 8,
});

/** firma_shattered */
export const SHATTERED = Object.freeze({
    sizeof: 96,
    size: 0,
    reserved: 4,
    pieces: 8,
    dust: 16,
    cracks: 24,
    refused: 32,
    dustMass: 40,
    dustMomentum: 48,
    dustAngularMomentum: 72,
});

/** firma_debris_rules */
export const DEBRIS_RULES = Object.freeze({
    sizeof: 72,
    size: 0,
    toGround: 4,
    maxBodies: 8,
    maxSpheres: 16,
    maxAge: 24,
    maxAsleep: 32,
    maxToGround: 40,
    minToGround: 48,
    maxOverlap: 56,
    keepClear: 64,
    keepClearCount: 68,
});

/** firma_debris_report */
export const DEBRIS_REPORT = Object.freeze({
    sizeof: 40,
    size: 0,
    reserved: 4,
    removed: 8,
    toGround: 16,
    refused: 24,
    waiting: 32,
});

/** firma_blast */
export const BLAST = Object.freeze({
    sizeof: 48,
    size: 0,
    reserved: 4,
    at: 8,
    radius: 32,
    impulse: 40,
});

/** firma_push_options */
export const PUSH_OPTIONS = Object.freeze({
    sizeof: 16,
    size: 0,
    mask: 4,
    maxSpeed: 8,
});

/** firma_push_report */
export const PUSH_REPORT = Object.freeze({
    sizeof: 24,
    size: 0,
    reserved: 4,
    reached: 8,
    pushed: 16,
});

/** firma_explode_options */
export const EXPLODE_OPTIONS = Object.freeze({
    sizeof: 64,
    size: 0,
    maxBroken: 4,
    maxPieces: 8,
    maxSpheres: 12,
    breakRadius: 16,
    minVolume: 24,
    seed: 32,
    carve: 40,
    push: 48,
});

/** firma_explosion */
export const EXPLOSION = Object.freeze({
    sizeof: 312,
    size: 0,
    status: 4,
    loose: 8,
    pieces: 16,
    broken: 24,
    unfit: 32,
    dust: 40,
    dustMass: 48,
    reached: 56,
    pushed: 64,
    carve: 72,
});

/** firma_part_stop */
export const PART_STOP = Object.freeze({
    sizeof: 48,
    position: 0,
    angle: 24,
    wait: 32,
    seconds: 40,
});

/** firma_part_path */
export const PART_PATH = Object.freeze({
    sizeof: 128,
    size: 0,
    repeats: 4,
    stops: 8,
    stopCount: 12,
    rotation: 16,
    axis: 48,
    spin: 72,
    swingReach: 80,
    swingAngle: 104,
    swingPeriod: 112,
    swingPhase: 120,
});

/** firma_part_info */
export const PART_INFO = Object.freeze({
    sizeof: 184,
    size: 0,
    entity: 4,
    whenBlocked: 8,
    waitsForTrigger: 12,
    breaks: 16,
    mask: 20,
    low: 24,
    high: 48,
    faceCount: 72,
    motion: 80,
});

/** firma_breakable */
export const BREAKABLE = Object.freeze({
    sizeof: 48,
    size: 0,
    matter: 4,
    health: 8,
    whole: 16,
    maxTaken: 24,
    damage: 32,
    broken: 40,
    reserved: 44,
});

/** firma_break_options */
export const BREAK_OPTIONS = Object.freeze({
    sizeof: 88,
    size: 0,
    maxPieces: 4,
    maxSpheres: 8,
    unbroken: 12,
    hasImpact: 16,
    reserved: 20,
    impact: 24,
    fraction: 48,
    seconds: 56,
    minVolume: 64,
    seed: 72,
    portals: 80,
    portalCount: 84,
});

/** firma_break_report */
export const BREAK_REPORT = Object.freeze({
    sizeof: 48,
    size: 0,
    reserved: 4,
    pieces: 8,
    unfit: 16,
    dust: 24,
    dustMass: 32,
    opened: 40,
});

/** firma_part_cut_options */
export const PART_CUT_OPTIONS = Object.freeze({
    sizeof: 112,
    size: 0,
    holdLargest: 4,
    touch: 8,
    carve: 16,
    pieces: 24,
});

/** firma_part_cut */
export const PART_CUT = Object.freeze({
    sizeof: 96,
    size: 0,
    status: 4,
    loose: 8,
    unfit: 16,
    broke: 24,
    reserved: 28,
    volume: 32,
    opened: 40,
    rest: 48,
});

/** firma_supported */
export const SUPPORTED = Object.freeze({
    sizeof: 72,
    entity: 0,
    kind: 4,
    low: 8,
    high: 32,
    reach: 56,
    mask: 64,
    reserved: 68,
});

/** firma_support */
export const SUPPORT = Object.freeze({
    sizeof: 40,
    size: 0,
    entity: 4,
    kind: 8,
    reserved: 12,
    faceCount: 16,
    area: 24,
    lowered: 32,
});

/** firma_support_change */
export const SUPPORT_CHANGE = Object.freeze({
    sizeof: 40,
    thing: 0,
    entity: 4,
    loss: 8,
    buried: 12,
    lost: 16,
    before: 24,
    after: 32,
});

/** firma_diff_view */
export const DIFF_VIEW = Object.freeze({
    sizeof: 144,
    size: 0,
    tooManyTiles: 4,
    removed: 8,
    removedCount: 12,
    added: 16,
    addedCount: 20,
    corners: 24,
    cornerCount: 28,
    tiles: 32,
    tileCount: 36,
    rooms: 40,
    roomCount: 44,
    opened: 48,
    closed: 52,
    openedCount: 56,
    closedCount: 60,
    portalsAdded: 64,
    portalsRemoved: 68,
    portalsAddedCount: 72,
    portalsRemovedCount: 76,
    portalsChanged: 80,
    portalsChangedCount: 84,
    low: 88,
    high: 112,
    removedFaces: 136,
});

/** firma_store_facts */
export const STORE_FACTS = Object.freeze({
    sizeof: 56,
    size: 0,
    reserved: 4,
    oldest: 8,
    current: 16,
    newest: 24,
    versions: 32,
    bytes: 40,
    waiting: 48,
});

/** firma_command_view */
export const COMMAND_VIEW = Object.freeze({
    sizeof: 160,
    size: 0,
    kind: 4,
    number: 8,
    lastNumber: 12,
    partCount: 16,
    portal: 20,
    open: 24,
    shape: 28,
    seed: 32,
    pose: 40,
    material: 104,
    chunks: 108,
    hasFrom: 112,
    from: 120,
    minChunkVolume: 144,
    density: 152,
});

/** firma_log_facts */
export const LOG_FACTS = Object.freeze({
    sizeof: 56,
    size: 0,
    levelEdits: 4,
    levelHash: 8,
    rulesHash: 16,
    commandCount: 24,
    checkpointCount: 32,
    patchBytes: 40,
    lastNumber: 48,
    patchedNumber: 52,
});

/** firma_replay_facts */
export const REPLAY_FACTS = Object.freeze({
    sizeof: 72,
    size: 0,
    finished: 4,
    commandsBehind: 8,
    commandsInAll: 16,
    applied: 24,
    done: 32,
    nothing: 40,
    refused: 48,
    checkpoints: 56,
    error: 64,
});

/** firma_game_facts */
export const GAME_FACTS = Object.freeze({
    sizeof: 72,
    size: 0,
    rate: 4,
    tick: 8,
    explosions: 16,
    weapons: 24,
    parts: 32,
    players: 40,
    projectiles: 48,
    bodies: 56,
    recorded: 64,
    replay: 68,
});

/** firma_game_rules */
export const GAME_RULES = Object.freeze({
    sizeof: 184,
    size: 0,
    noChunks: 4,
    minChunkVolume: 8,
    chunkDensity: 16,
    maxBlastSpeed: 24,
    seed: 32,
    bodies: 40,
    debris: 112,
});

/** firma_charge */
export const CHARGE = Object.freeze({
    sizeof: 56,
    size: 0,
    shape: 4,
    crater: 8,
    radius: 16,
    impulse: 24,
    breakRadius: 32,
    maxPieces: 40,
    reserved: 44,
    material: 48,
});

/** firma_weapon */
export const WEAPON = Object.freeze({
    sizeof: 200,
    size: 0,
    lies: 4,
    name: 8,
    mass: 16,
    gravity: 24,
    paneEnergy: 48,
    stopSpeed: 56,
    fuse: 64,
    terms: 72,
    bodies: 104,
    hasCharge: 136,
    reserved: 140,
    charge: 144,
});

/** firma_game_part */
export const GAME_PART = Object.freeze({
    sizeof: 48,
    size: 0,
    mask: 4,
    world: 8,
    path: 16,
    name: 20,
    entity: 24,
    waits: 28,
    noPortals: 32,
    whenBlocked: 36,
    portals: 40,
    portalCount: 44,
});

/** firma_game_player */
export const GAME_PLAYER = Object.freeze({
    sizeof: 288,
    size: 0,
    reserved: 4,
    shape: 8,
    mass: 16,
    player: 24,
    wish: 152,
    rules: 192,
});

/** firma_game_part_state */
export const GAME_PART_STATE = Object.freeze({
    sizeof: 144,
    size: 0,
    mask: 4,
    entity: 8,
    waits: 12,
    atFirstStop: 16,
    whenBlocked: 20,
    started: 24,
    motion: 32,
    name: 136,
});

/** firma_game_report */
export const GAME_REPORT = Object.freeze({
    sizeof: 160,
    size: 0,
    reserved: 4,
    moves: 8,
    blasts: 16,
    shotEvents: 24,
    edits: 32,
    nothing: 40,
    refused: 48,
    refusal: 56,
    loose: 64,
    broken: 72,
    removed: 80,
    grounded: 88,
    bodies: 96,
});

/** firma_game_replay */
export const GAME_REPLAY = Object.freeze({
    sizeof: 64,
    size: 0,
    finished: 4,
    differs: 8,
    atEnd: 12,
    ticks: 16,
    ticksInAll: 24,
    tick: 32,
    hash: 40,
    recorded: 48,
    text: 56,
});

/** firma_recording_facts */
export const RECORDING_FACTS = Object.freeze({
    sizeof: 48,
    size: 0,
    rate: 4,
    firstTick: 8,
    ticks: 16,
    events: 24,
    levelHash: 32,
    level: 40,
});

/** firma_game_event */
export const GAME_EVENT = Object.freeze({
    sizeof: 72,
    size: 0,
    kind: 4,
    tick: 8,
    index: 16,
    reserved: 20,
    position: 24,
    velocity: 48,
});
