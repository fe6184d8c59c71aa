// SPDX-License-Identifier: MIT
// Gets the module from wherever it is, and starts it.
import { bytes } from './arguments.js';
import { Core } from './core.js';
import { Firma } from './firma.js';
import { FirmaError } from './errors.js';
import { VERSION } from './layout.js';
import { readBytes } from './read_file.js';

const PLACE = 'loadFirma';
const inNode = typeof process !== 'undefined' && Boolean(process.versions?.node);

function cannotRead(what, cause) {
    return new FirmaError('CANNOT_READ', `${PLACE}: ${what}: ${cause.message ?? cause}`, { cause });
}

async function readFile(url) {
    try {
        return await readBytes(url);
    } catch (error) {
        throw cannotRead(url, error);
    }
}

async function fetchUrl(url) {
    try {
        return await fetch(url);
    } catch (error) {
        throw cannotRead(url, error);
    }
}

/** A URL as a string may have no scheme: then it is relative to the page, in node to the working directory. */
async function readUrl(source) {
    if (!inNode) return fetchUrl(source);
    const scheme = /^([a-z][a-z0-9+.-]+):/i.exec(String(source))?.[1];
    if (scheme === undefined) return readFile(source);
    return scheme === 'file' ? readFile(new URL(source)) : fetchUrl(source);
}

/** Compiled while it arrives, where the server says what it is. */
async function compileResponse(response) {
    if (!response.ok) throw cannotRead(response.url, `status ${response.status}`);
    const type = response.headers.get('content-type') ?? '';
    if (/^application\/wasm *(;|$)/.test(type)) return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(
        await response.arrayBuffer().catch((error) => {
            throw cannotRead(response.url, error);
        }),
    );
}

/** A WebAssembly.Module of whatever was given. */
async function moduleOf(source) {
    if (source instanceof WebAssembly.Module) return source;
    if (typeof source === 'string' || source instanceof URL) source = await readUrl(source);
    const compile =
        typeof Response === 'function' && source instanceof Response ? compileResponse : WebAssembly.compile;
    if (compile !== compileResponse) source = bytes(source, PLACE, 'what is not a URL, Response or WebAssembly.Module');
    try {
        return await compile(source);
    } catch (error) {
        if (error instanceof FirmaError) throw error;
        throw new FirmaError('MALFORMED', `${PLACE}: ${error.message}`, { cause: error });
    }
}

async function start(module) {
    let core = null;
    const imports = { firma: { now: () => performance.now() * 1000, visit: (at) => core.visited(at) } };
    let exports;
    try {
        ({ exports } = await WebAssembly.instantiate(module, imports));
    } catch (error) {
        if (error instanceof RangeError)
            throw new FirmaError('NO_MEMORY', `${PLACE}: ${error.message}`, { cause: error });
        throw new FirmaError('UNSUPPORTED', `${PLACE}: not Firma's module: ${error.message}`, { cause: error });
    }
    if (typeof exports.firma_version !== 'function')
        throw new FirmaError('UNSUPPORTED', `${PLACE}: not Firma's module`);
    const version = exports.firma_version();
    const [major, minor] = VERSION.split('.').map(Number);
    if (version >>> 8 !== (major << 8) + minor)
        throw new FirmaError('UNSUPPORTED', `${PLACE}: the module is not of version ${major}.${minor}`);
    core = new Core(exports);
    return new Firma(core);
}

export async function loadFirma(source = new URL('./firma.wasm', import.meta.url)) {
    return start(await moduleOf(await source));
}
