// SPDX-License-Identifier: MIT
// node.mjs LEVEL.obj: the line, in node.
import { readFileSync } from 'node:fs';
import { crater } from './crater.js';

console.log(await crater(readFileSync(process.argv[2])));
