// SPDX-License-Identifier: MIT
// Bodies that the last call with debris named.
import { DEBRIS_LIST_NAMES } from './layout.js';

/** @param list  one of DEBRIS_LIST_NAMES @returns the names of the bodies */
export function bodiesNamed(core, debris, list) {
    const number = DEBRIS_LIST_NAMES.indexOf(list);
    core.run('firma_debris_named', debris, number, 0, 0, core.at.out);
    const count = core.getU32(core.at.out);
    return core.borrow((lent) => {
        const at = lent.take(8 * count);
        core.run('firma_debris_named', debris, number, at, count, core.at.out);
        return Array.from(core.u64.subarray(at >>> 3, (at >>> 3) + count));
    });
}
