// SPDX-License-Identifier: MIT
// Gets a module from wherever it is, and starts it.
import { bytes } from './arguments.js';
import { Core } from './core.js';
import { FirmaError } from './errors.js';
import { VERSION } from './layout.js';
import { readBytes } from './read_file.js';

const inNode = typeof process !== 'undefined' && Boolean(process.versions?.node);

function cannotRead(place, what, cause) {
    return new FirmaError('CANNOT_READ', `${place}: ${what}: ${cause.message ?? cause}`, { cause });
}

async function readFile(url, place) {
    try {
        return await readBytes(url);
    } catch (error) {
        throw cannotRead(place, url, error);
    }
}

async function fetchUrl(url, place) {
    try {
        return await fetch(url);
    } catch (error) {
        throw cannotRead(place, url, error);
    }
}

/** A URL as a string may have no scheme: then it is relative to the page, in node to the working directory. */
async function readUrl(source, place) {
    if (!inNode) return fetchUrl(source, place);
    const scheme = /^([a-z][a-z0-9+.-]+):/i.exec(String(source))?.[1];
    if (scheme === undefined) return readFile(source, place);
    return scheme === 'file' ? readFile(new URL(source), place) : fetchUrl(source, place);
}

/** Compiled while it arrives, where the server says what it is. */
async function compileResponse(response, place) {
    if (!response.ok) throw cannotRead(place, response.url, `status ${response.status}`);
    const type = response.headers.get('content-type') ?? '';
    if (/^application\/wasm *(;|$)/.test(type)) return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(
        await response.arrayBuffer().catch((error) => {
            throw cannotRead(place, response.url, error);
        }),
    );
}

/** A WebAssembly.Module of whatever was given. @param place for messages */
export async function moduleOf(source, place) {
    if (source instanceof WebAssembly.Module) return source;
    if (typeof source === 'string' || source instanceof URL) source = await readUrl(source, place);
    const compile =
        typeof Response === 'function' && source instanceof Response ? compileResponse : WebAssembly.compile;
    if (compile !== compileResponse) source = bytes(source, place, 'what is not a URL, Response or WebAssembly.Module');
    try {
        return await compile(source, place);
    } catch (error) {
        if (error instanceof FirmaError) throw error;
        throw new FirmaError('MALFORMED', `${place}: ${error.message}`, { cause: error });
    }
}

/**
 * An instance of a module.
 * @param kind what it is for messages, the name of a function that it has, and what to do when it has stopped
 */
export async function startCore(module, place, kind) {
    let core = null;
    const imports = { firma: { now: () => performance.now() * 1000, visit: (at) => core.visited(at) } };
    let exports;
    try {
        ({ exports } = await WebAssembly.instantiate(module, imports));
    } catch (error) {
        if (error instanceof RangeError)
            throw new FirmaError('NO_MEMORY', `${place}: ${error.message}`, { cause: error });
        throw new FirmaError('UNSUPPORTED', `${place}: not ${kind.name}: ${error.message}`, { cause: error });
    }
    if (typeof exports.firma_version !== 'function' || typeof exports[kind.has] !== 'function')
        throw new FirmaError('UNSUPPORTED', `${place}: not ${kind.name}`);
    const version = exports.firma_version();
    const [major, minor] = VERSION.split('.').map(Number);
    if (version >>> 8 !== (major << 8) + minor)
        throw new FirmaError('UNSUPPORTED', `${place}: ${kind.name} is not of version ${major}.${minor}`);
    core = new Core(exports, kind.stopped);
    return core;
}
