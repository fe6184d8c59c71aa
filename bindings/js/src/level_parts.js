// SPDX-License-Identifier: MIT
// Parts of a level of brushes: made by the readers, told as plain data with a World each.
import { getBreakable } from './breakable.js';
import { makeHandle } from './handle.js';
import { BREAKABLE, PART_INFO, PART_PATH } from './layout.js';
import { getPath, WHEN_BLOCKED_NAMES } from './part_paths.js';
import { structTable } from './structs.js';

const { fresh } = structTable({ breakable: [BREAKABLE], info: [PART_INFO], path: [PART_PATH] });

function getPart(readers, parts, index, move) {
    const info = fresh(readers, 'info');
    readers.run('firma_parts_get', parts, index, info);
    const path = fresh(readers, 'path');
    readers.run('firma_parts_path', parts, index, path);
    const bears = fresh(readers, 'breakable');
    readers.run('firma_parts_breakable', parts, index, bears);
    const flag = (name) => readers.getU32(info + PART_INFO[name]) !== 0;
    return {
        entity: readers.getU32(info + PART_INFO.entity),
        mask: readers.getU32(info + PART_INFO.mask),
        waits: flag('waitsForTrigger'),
        whenBlocked: WHEN_BLOCKED_NAMES[readers.getU32(info + PART_INFO.whenBlocked)],
        path: getPath(readers, path),
        breakable: flag('breaks') ? getBreakable(readers, bears) : null,
        world: move(makeHandle(readers, 'firma_parts_world', parts, index)),
    };
}

function getNotes(readers, parts) {
    readers.run('firma_parts_notes', parts, 0, 0, 0, readers.at.out);
    const count = readers.getU32(readers.at.out);
    return readers.borrow((lent) => {
        const [entities, texts] = [lent.take(4 * count), lent.take(4 * count)];
        readers.run('firma_parts_notes', parts, entities, texts, count, readers.at.out);
        return Array.from({ length: count }, (_, k) => ({
            entity: readers.getU32(entities + 4 * k),
            note: readers.text(readers.getU32(texts + 4 * k)),
        }));
    });
}

/**
 * @param parts  a handle of the readers, which is released
 * @param move  makes a World of the program's module of a world of the readers, which it releases
 */
export function takeLevelParts(readers, parts, move) {
    const made = [];
    try {
        readers.run('firma_parts_get_count', parts, readers.at.out);
        const count = readers.getU32(readers.at.out);
        for (let k = 0; k < count; ++k) made.push(getPart(readers, parts, k, move));
        return { parts: made, notes: getNotes(readers, parts) };
    } catch (error) {
        for (const { world } of made) world.release();
        throw error;
    } finally {
        if (!readers.stopped) readers.run('firma_parts_release', parts);
    }
}
