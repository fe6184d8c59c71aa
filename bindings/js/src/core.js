// SPDX-License-Identifier: MIT
// One instance of the module: calls into it, its memory, and what happens when it stops.
import * as layout from './layout.js';
import { FirmaError } from './errors.js';

const decoder = new TextDecoder('utf-8', { ignoreBOM: true }); // which keeps it
const encoder = new TextEncoder();

/** Casts that a batch hands over at a time: their structs fit into a processor's second cache. */
export const CASTS_AT_ONCE = 1024;

/** Structs that a single call fills; the caller says how large his is. */
const FILLED = {
    hitInfo: layout.HIT_INFO,
    worldFacts: layout.WORLD_FACTS,
    room: layout.ROOM,
    portal: layout.PORTAL,
    levelView: layout.LEVEL_VIEW,
    facesView: layout.FACES_VIEW,
    texture: layout.TEXTURE,
    trianglesView: layout.TRIANGLES_VIEW,
    regionMeshView: layout.REGION_MESH_VIEW,
    diffView: layout.DIFF_VIEW,
    report: layout.CARVE_REPORT,
    chunk: layout.CHUNK,
    rest: layout.REST,
    commandView: layout.COMMAND_VIEW,
    logFacts: layout.LOG_FACTS,
    replayFacts: layout.REPLAY_FACTS,
    storeFacts: layout.STORE_FACTS,
    matterTable: layout.MATTER_TABLE,
    matterCounts: layout.MATTER_COUNTS,
};

/** Structs that a single call needs one of; they lie at fixed places, made once. */
const FIXED = {
    ...Object.fromEntries(Object.entries(FILLED).map(([name, { sizeof }]) => [name, sizeof])),
    input: layout.CAST_INPUT.sizeof,
    castOptions: layout.CAST_OPTIONS.sizeof,
    mover: layout.MOVER.sizeof,
    hit: layout.HIT.sizeof,
    counts: layout.CAST_COUNTS.sizeof,
    near: layout.NEAR.sizeof,
    faceFilter: layout.FACE_FILTER.sizeof,
    nearOptions: layout.NEAR_OPTIONS.sizeof,
    worldOptions: layout.WORLD_OPTIONS.sizeof,
    mesh: layout.MESH.sizeof,
    rules: layout.RULES.sizeof,
    pose: layout.POSE.sizeof,
    carveOptions: layout.CARVE_OPTIONS.sizeof,
    anchors: layout.ANCHORS.sizeof,
    mass: layout.MASS.sizeof,
    /** Answers that are no struct: a handle, two pointers, two doubles, a count. */
    out: 32,
};

export class Core {
    /** Of all that the module exports. Once it has stopped, each of them throws. */
    exports;
    memory;
    /** Views of the memory; made anew by refresh() once it has grown. */
    u8 = new Uint8Array(0);
    u32;
    i32;
    f64;
    u64;
    /** Where the fixed structs are. */
    at = {};
    /** Why the module stopped; null while it runs. */
    stopped = null;
    /** Of the questions under way that go one by one: what is called for each answer, the innermost last. */
    #visitors = [];
    #batch = 0;
    #stoppedMessage;

    /** @param stoppedMessage of why the module stopped: what every call says then */
    constructor(exports, stoppedMessage) {
        this.exports = exports;
        this.#stoppedMessage = stoppedMessage;
        this.memory = exports.memory;
        this.refresh();
        this.call('_initialize');
        let total = 0;
        for (const [name, bytes] of Object.entries(FIXED)) {
            this.at[name] = total;
            total += (bytes + 15) & ~15;
        }
        const start = this.take(total);
        for (const name of Object.keys(FIXED)) this.at[name] += start;
        Object.freeze(this.at);
        for (const [name, { size, sizeof }] of Object.entries(FILLED)) this.setU32(this.at[name] + size, sizeof);
    }

    /** After every call that may take memory: when memory grows, the views of before have length 0. */
    refresh() {
        if (this.u8.length !== 0) return;
        const buffer = this.memory.buffer;
        this.u8 = new Uint8Array(buffer);
        this.u32 = new Uint32Array(buffer);
        this.i32 = new Int32Array(buffer);
        this.f64 = new Float64Array(buffer);
        this.u64 = new BigUint64Array(buffer);
    }

    /** Calls a function of the module. @throws {FirmaError} INTERNAL when it stops */
    call(name, ...args) {
        let answer;
        try {
            answer = this.exports[name](...args);
        } catch (error) {
            throw this.stop(error);
        }
        this.refresh();
        return answer;
    }

    /** Calls a function that returns a firma_code. @throws {FirmaError} for any but FIRMA_OK */
    run(name, ...args) {
        const code = this.call(name, ...args);
        if (code !== 0) throw this.failure(code);
    }

    /**
     * Calls a function of the module that asks visit(address) for each answer, by way of visited(). What visit() throws
     * ends the question and is thrown here.
     */
    runVisited(visit, name, ...args) {
        const visitor = { visit, thrown: null };
        this.#visitors.push(visitor);
        try {
            this.run(name, ...args);
        } finally {
            this.#visitors.pop();
        }
        if (visitor.thrown) throw visitor.thrown.error;
    }

    /** For the module: what the innermost visitor answers, 0 once it has thrown. */
    visited(at) {
        const visitor = this.#visitors.at(-1);
        if (visitor.thrown) return 0;
        this.refresh();
        try {
            return visitor.visit(at);
        } catch (error) {
            visitor.thrown = { error };
            return 0;
        }
    }

    /** What the C API says about the call that just returned `code`. */
    failure(code) {
        return new FirmaError(layout.CODE_NAMES[code] ?? 'INTERNAL', this.message());
    }

    message() {
        return this.text(this.call('firma_error_message'));
    }

    /** Whatever a call throws is a trap: memory may be in any state, nothing of the module can be used any more. */
    stop(error) {
        if (this.stopped) return this.#stoppedError();
        this.stopped = error;
        const refuse = () => {
            throw this.#stoppedError();
        };
        this.exports = new Proxy({}, { get: () => refuse });
        return this.#stoppedError();
    }

    #stoppedError() {
        const why = this.stopped?.message ?? this.stopped;
        return new FirmaError('INTERNAL', this.#stoppedMessage(why), { cause: this.stopped });
    }

    /** Of the module, as '0.2.0'. */
    version() {
        const version = this.call('firma_version');
        return `${version >>> 16}.${(version >>> 8) & 255}.${version & 255}`;
    }

    /** Memory of the module, 16-byte aligned. @throws {FirmaError} NO_MEMORY */
    take(bytes) {
        const pointer = bytes < 2 ** 32 ? this.call('firma_wasm_take', bytes) >>> 0 : 0;
        if (pointer === 0) throw new FirmaError('NO_MEMORY', `no ${bytes} bytes for the arguments of a call`);
        return pointer;
    }

    giveBack(pointer) {
        if (!this.stopped) this.call('firma_wasm_give_back', pointer);
    }

    /** Runs work(lent), where lent's methods place arguments into memory, which is given back afterwards. */
    borrow(work) {
        const lent = new Lent(this);
        try {
            return work(lent);
        } finally {
            lent.giveBack();
        }
    }

    /** Room for CASTS_AT_ONCE inputs, then as many hits; kept. */
    batch() {
        if (this.#batch === 0) this.#batch = this.take(CASTS_AT_ONCE * (layout.CAST_INPUT.sizeof + layout.HIT.sizeof));
        return this.#batch;
    }

    /** A string that ends with 0. */
    text(pointer) {
        return decoder.decode(this.u8.subarray(pointer, this.u8.indexOf(0, pointer)));
    }

    // What a struct holds, by its address and offset.
    getU32(at) {
        return this.u32[at >>> 2];
    }
    getF64(at) {
        return this.f64[at >>> 3];
    }
    /** A count, or a version: below 2^53. */
    getCount(at) {
        return Number(this.u64[at >>> 3]);
    }
    getVector(at) {
        const k = at >>> 3;
        return [this.f64[k], this.f64[k + 1], this.f64[k + 2]];
    }
    setU32(at, value) {
        this.u32[at >>> 2] = value;
    }
    setF64(at, value) {
        this.f64[at >>> 3] = value;
    }
    setU64(at, value) {
        this.u64[at >>> 3] = value;
    }
    setVector(at, vector) {
        this.f64.set(vector, at >>> 3);
    }
}

/** Pieces of memory that hold the arguments of one call. */
class Lent {
    #core;
    #pieces = [];

    constructor(core) {
        this.#core = core;
    }

    take(bytes) {
        const pointer = this.#core.take(bytes);
        this.#pieces.push(pointer);
        return pointer;
    }

    bytes(bytes) {
        const pointer = this.take(bytes.length);
        this.#core.u8.set(bytes, pointer);
        return pointer;
    }

    /** UTF-8 with a 0 at its end. */
    text(string) {
        return this.bytes(encoder.encode(`${string}\0`));
    }

    words(words) {
        const pointer = this.take(words.length * 4);
        this.#core.u32.set(words, pointer >>> 2);
        return pointer;
    }

    doubles(numbers) {
        const pointer = this.take(numbers.length * 8);
        this.#core.f64.set(numbers, pointer >>> 3);
        return pointer;
    }

    giveBack() {
        for (const pointer of this.#pieces) this.#core.giveBack(pointer);
    }
}
