// SPDX-License-Identifier: MIT
// Arguments as they are given, checked for their kind. What a number may be is the C API's to say.
import { badCall } from './errors.js';

const encoder = new TextEncoder();

export function number(value, place, what) {
    if (typeof value !== 'number') throw badCall(place, `${what} must be a number`);
    return value;
}

/** An integer of 32 bits without sign. */
export function word(value, place, what) {
    if (!Number.isInteger(value) || value < 0 || value > 0xffffffff)
        throw badCall(place, `${what} must be an integer within 0 and 2^32 - 1`);
    return value;
}

/** Bits of 32: as JavaScript's operators make them, ~0 is -1, and as the module takes them, which is the same bits. */
export function mask(value, place, what = 'mask') {
    if (!Number.isInteger(value) || value < -0x80000000 || value > 0xffffffff)
        throw badCall(place, `${what} must be an integer of 32 bits`);
    return value;
}

/** 64 bits without sign, as a BigInt. */
export function longWord(value, place, what) {
    const big = typeof value === 'bigint' ? value : Number.isSafeInteger(value) ? BigInt(value) : -1n;
    if (big < 0n || big >> 64n !== 0n)
        throw badCall(place, `${what} must be an integer from 0, below 2^53 as a number or below 2^64 as a BigInt`);
    return big;
}

export function flag(value, place, what) {
    if (value === undefined || typeof value === 'boolean') return value ? 1 : 0;
    throw badCall(place, `${what} must be true or false`);
}

/** A string that C can hold, '' for none. */
export function text(value, place, what) {
    if (value === undefined) return '';
    if (typeof value !== 'string') throw badCall(place, `${what} must be a string`);
    if (value.includes('\0')) throw badCall(place, `${what} has a character of code 0`);
    return value;
}

/**
 * An object; {} where none is given.
 * @param names  what members it may have, where some are optional: a misspelt one would do nothing. None: any
 */
export function object(value, place, what, names) {
    if (value === undefined) return {};
    if (typeof value !== 'object' || value === null || Array.isArray(value))
        throw badCall(place, `${what} must be an object`);
    if (names === undefined) return value;
    for (const name in value)
        if (!names.includes(name)) throw badCall(place, `${what}: there is no ${name}, only ${names.join(', ')}`);
    return value;
}

function list(value, place, what) {
    if (Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView))) return value;
    throw badCall(place, `${what} must be an array or a typed array`);
}

/** As many numbers in an array or typed array. */
export function vector(value, count, place, what) {
    if (list(value, place, what).length !== count) throw badCall(place, `${what} must have ${count} numbers`);
    for (let k = 0; k < count; ++k)
        if (typeof value[k] !== 'number') throw badCall(place, `${what} must have ${count} numbers`);
    return value;
}

/** Numbers in any array, a multiple of `each`. */
export function doubles(value, each, place, what) {
    if (list(value, place, what).length % each !== 0)
        throw badCall(place, `${what} must have ${each} numbers for each`);
    if (!(value instanceof Float64Array || value instanceof Float32Array))
        for (const one of value) number(one, place, `each of ${what}`);
    return value;
}

/** As many flags in any array, true and false or 1 and 0. */
export function flags(value, count, place, what) {
    if (list(value, place, what).length !== count) throw badCall(place, `${what} must have ${count} entries`);
    for (const one of value)
        if (typeof one !== 'boolean' && one !== 0 && one !== 1)
            throw badCall(place, `each of ${what} must be true, false, 1 or 0`);
    return Uint8Array.from(value, Number);
}

/** Integers of 32 bits in any array; as many as `count`, when that is given. */
export function words(value, count, place, what, check = word) {
    if (count !== undefined && list(value, place, what).length !== count)
        throw badCall(place, `${what} must have ${count} entries`);
    if (!(list(value, place, what) instanceof Uint32Array))
        for (const one of value) check(one, place, `each of ${what}`);
    return value;
}

/** The same of masks; a Uint32Array takes what is below 0 as the same bits. */
export function masks(value, count, place, what) {
    return words(value, count, place, what, mask);
}

/** Also one of another window or context, whose class is not ours. */
export function isArrayBuffer(value) {
    return Object.prototype.toString.call(value) === '[object ArrayBuffer]';
}

/** Bytes of whatever holds them; strings are encoded. */
export function bytes(value, place, what, strings = false) {
    if (strings && typeof value === 'string') return encoder.encode(value);
    try {
        if (isArrayBuffer(value)) return new Uint8Array(value);
        if (ArrayBuffer.isView(value)) return new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
    } catch (error) {
        throw badCall(place, `${what} cannot be read: ${error.message}`); // its memory was transferred
    }
    throw badCall(place, `${what} must be ${strings ? 'a string, ' : ''}a Uint8Array or an ArrayBuffer`);
}

/** A cube of 32 m: three integers. */
export function region(value, place) {
    const three = Array.from(vector(value, 3, place, 'region'));
    if (!three.every((k) => Number.isInteger(k) && Math.abs(k) < 2 ** 31))
        throw badCall(place, 'region must be three integers');
    return three;
}
