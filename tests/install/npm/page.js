// SPDX-License-Identifier: MIT
// What a page runs: the line becomes its title.
import { crater } from './crater.js';

fetch('first.obj')
    .then((response) => response.text())
    .then((level) => crater(level))
    .then((line) => (document.title = line))
    .catch((error) => (document.title = `failed: ${error.message}`));
