// SPDX-License-Identifier: MIT
// What `import ... from 'firma'` gives.
export { loadFirma } from './load.js';
export { FirmaError } from './errors.js';
export { HitBatch, NO_FACE } from './hits.js';
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
