// SPDX-License-Identifier: MIT
// What `import ... from 'firma'` gives.
export { loadFirma } from './load.js';
export * from './common.js';
