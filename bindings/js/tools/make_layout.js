// SPDX-License-Identifier: MIT
// Writes src/layout.js: where clang puts the fields of the C API's structs for wasm32, and the header's constants.
//
//   node tools/make_layout.js           writes the file
//   node tools/make_layout.js --check   ends with 1 when the file is not what would be written
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const include = join(here, '../../../include');
const target = join(here, '../src/layout.js');

const camel = (name) => name.replace(/_+([a-z0-9])/g, (_, letter) => letter.toUpperCase());
// Words of 0.1 that programs compare with.
const STATUS_WORDS = { INITIAL_OVERLAP: 'touching' };
const constant = (name) => name.toUpperCase();

/** What clang says of every complete struct: name -> { size, fields: [[name, offset]] }. */
function dumpLayouts() {
    const clang = process.env.CLANG ?? 'clang-19';
    const options = ['--target=wasm32-wasi', '-ffreestanding', '-fsyntax-only', '-I', include, '-x', 'c', '-'];
    const result = spawnSync(clang, ['-Xclang', '-fdump-record-layouts-complete', ...options], {
        input: '#include "firma/firma_c.h"\n',
        encoding: 'utf8',
    });
    if (result.error || result.status !== 0) throw new Error(`${clang}: ${result.error ?? result.stderr}`);
    const structs = new Map();
    for (const dump of result.stdout.split('*** Dumping AST Record Layout').slice(1)) {
        const name = /struct (firma_\w+)\n/.exec(dump)?.[1];
        if (!name) continue;
        // Three blanks: a field of this struct, deeper ones belong to structs in it.
        const fields = [...dump.matchAll(/^ *(\d+) \|   (?! ).*?(\w+)$/gm)].map((m) => [m[2], Number(m[1])]);
        structs.set(name, { size: Number(/\[sizeof=(\d+)/.exec(dump)[1]), fields });
    }
    return structs;
}

/** The header's enumerations: name -> [[name, value]]. */
function readEnumerations(header) {
    const found = new Map();
    for (const [, name, body] of header.matchAll(/typedef enum (firma_\w+) \{([^}]*)\}/g))
        found.set(
            name,
            [...body.matchAll(/(FIRMA_\w+) = (\d+)/g)].map((m) => [m[1], Number(m[2])]),
        );
    return found;
}

function write() {
    const header = readFileSync(join(include, 'firma/firma_c.h'), 'utf8');
    const lines = [
        '// SPDX-License-Identifier: MIT',
        '// Written by tools/make_layout.js from firma_c.h; change that, not this file. Bytes, by clang for wasm32.',
        '',
    ];
    const version = ['MAJOR', 'MINOR', 'PATCH'].map(
        (part) => new RegExp(`FIRMA_VERSION_${part} (\\d+)`).exec(header)[1],
    );
    lines.push(`export const VERSION = '${version.join('.')}';`, '');
    for (const [, name, value] of header.matchAll(/#define FIRMA_(FACE_\w+|STOPS_\w+|IS_\w+) (\d+)u/g))
        lines.push(`export const ${name} = ${value};`);
    lines.push('');
    for (const [name, entries] of readEnumerations(header)) {
        const short = constant(name.slice('firma_'.length));
        const start = { firma_code: 'FIRMA_ERROR_', firma_carve_status: 'FIRMA_CARVE_', firma_edit_kind: 'FIRMA_EDIT_', firma_fracture: 'FIRMA_FRACTURE_', firma_mover_kind: 'FIRMA_MOVER_', firma_cast_order: 'FIRMA_ORDER_', firma_contact_kind: 'FIRMA_CONTACT_', firma_projectile_state: 'FIRMA_PROJECTILE_', firma_shot_event_kind: 'FIRMA_SHOT_', firma_crack_style: 'FIRMA_CRACK_', firma_debris_list: 'FIRMA_DEBRIS_', firma_support_kind: 'FIRMA_SUPPORT_', firma_support_loss: 'FIRMA_SUPPORT_', firma_game_item: 'FIRMA_ITEM_', firma_bytes_kind: 'FIRMA_BYTES_', firma_game_event_kind: 'FIRMA_EVENT_' }[name] ?? 'FIRMA_';
        lines.push(`/** By the numbers of ${name}. */`, `export const ${short}_NAMES = Object.freeze([`);
        entries.forEach(([entry, value], k) => {
            if (value !== k) throw new Error(`${name}: ${entry} is not ${k}`);
            const text = entry.startsWith(start) ? entry.slice(start.length) : entry.slice('FIRMA_'.length);
            lines.push(`    '${name === 'firma_code' ? text : STATUS_WORDS[text] ?? text.toLowerCase()}',`);
        });
        lines.push(']);', '');
    }
    for (const [name, { size, fields }] of dumpLayouts()) {
        if (fields.length === 1 && fields[0][0] === 'id') continue; // a handle
        lines.push(`/** ${name} */`, `export const ${constant(name.slice('firma_'.length))} = Object.freeze({`);
        lines.push(`    sizeof: ${size},`, ...fields.map(([field, offset]) => `    ${camel(field)}: ${offset},`));
        lines.push('});', '');
    }
    return lines.join('\n').trimEnd() + '\n';
}

const text = write();
if (process.argv.includes('--check')) {
    if (readFileSync(target, 'utf8') !== text) {
        console.error('bindings/js/src/layout.js is out of date: run node bindings/js/tools/make_layout.js');
        process.exit(1);
    }
} else {
    writeFileSync(target, text);
}
