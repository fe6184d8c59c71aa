// SPDX-License-Identifier: MIT
// Contenders taking turns, and their tables.
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

export function quantile(values, share) {
    const sorted = Float64Array.from(values).sort();
    return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
export const median = (values) => quantile(values, 0.5);

/** Processor time of this process, milliseconds: other work on the machine does not count. */
export function clock() {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1e3;
}

/** Runs each once to warm up, then `rounds` times, each round beginning with another one.
 * @returns for each the milliseconds of its rounds */
export function race(runs, rounds) {
    runs.forEach((run) => run());
    const times = runs.map(() => new Float64Array(rounds));
    for (let round = 0; round < rounds; ++round)
        for (let k = 0; k < runs.length; ++k) {
            const turn = (round + k) % runs.length;
            const before = clock();
            runs[turn]();
            times[turn][round] = clock() - before;
        }
    return times;
}

/** The median of the ratios within a round. */
export const ratio = (mine, others) => median(mine.map((ms, round) => ms / others[round]));

export function settings() {
    const options = { quick: { type: 'boolean', default: false }, csv: { type: 'string', default: '' } };
    return parseArgs({ options }).values;
}

// ---- numbers for people ----

export const count = (value) => String(value).replace(/\B(?=(\d{3})+$)/g, ' ');
export function number(value) {
    const size = Math.abs(value);
    if (size === 0) return '0';
    if (size < 1e-2) return value.toExponential(1).replace(/e([+-])(\d)$/, 'e$10$2');
    if (size < 9.995) return value.toFixed(2);
    return size < 99.95 ? value.toFixed(1) : count(Math.round(value));
}
export const times = (ratio) => `${ratio < 9.995 ? ratio.toFixed(2) : ratio < 99.95 ? ratio.toFixed(1) : ratio.toFixed(0)} x`;

const cell = (text) => (text.includes(',') ? `"${text}"` : text);

/** Prints the rows, which are lists of texts, and writes FOLDER/NAME.csv unless the folder is ''. */
export async function finish(name, columns, rows, folder) {
    const line = (cells) => `| ${cells.join(' | ')} |`;
    console.log(['', name, '', line(columns), `|---|${'---:|'.repeat(columns.length - 1)}`, ...rows.map(line)].join('\n'));
    if (folder === '') return;
    await mkdir(folder, { recursive: true });
    await writeFile(join(folder, `${name}.csv`), [columns, ...rows].map((cells) => `${cells.map(cell).join(',')}\n`).join(''));
}
