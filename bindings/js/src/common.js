// SPDX-License-Identifier: MIT
// What every entry of the package gives besides what loads its module.
export { FirmaError } from './errors.js';
export { NO_FACE } from './faces.js';
export { HitBatch } from './hits.js';
export { NO_PORTAL } from './rooms.js';
export {
    FACE_SOLID,
    FACE_TWO_SIDED,
    IS_SKY,
    STOPS_LIQUID,
    STOPS_SHOTS,
    STOPS_SIGHT,
    STOPS_WALK,
} from './layout.js';
