// SPDX-License-Identifier: MIT
// page.js for a packer that makes a file of the module and a URL of the import.
import module from 'firma/firma.wasm';
import { crater } from './crater.js';

fetch('first.obj')
    .then((response) => response.text())
    .then((level) => crater(level, module))
    .then((line) => (document.title = line))
    .catch((error) => (document.title = `failed: ${error.message}`));
