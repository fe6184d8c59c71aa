// SPDX-License-Identifier: MIT
// What every failure throws.

/** `code` is a name of the C API's firma_code without FIRMA_ERROR_, as 'MALFORMED'; `message` says where and why. */
export class FirmaError extends Error {
    constructor(code, message, options) {
        super(message, options);
        this.name = 'FirmaError';
        this.code = code;
    }
}

/** For arguments of a wrong kind, which never reach the module. */
export function badCall(place, reason) {
    return new FirmaError('BAD_CALL', `${place}: ${reason}`);
}
