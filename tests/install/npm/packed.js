// SPDX-License-Identifier: MIT
// page.js for a packer that makes files of the modules and URLs of the imports.
import module from 'firma/firma.wasm';
import readers from 'firma/firma_readers.wasm';
import { crater } from './crater.js';

fetch('first.obj')
    .then((response) => response.text())
    .then((level) => crater(level, module, { readers }))
    .then((line) => (document.title = line))
    .catch((error) => (document.title = `failed: ${error.message}`));
