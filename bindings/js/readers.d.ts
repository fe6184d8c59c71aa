// SPDX-License-Identifier: MIT
// The types of 'firma/readers': the module of readers, loaded ahead of the first file.
import type { Bytes, Cutter, Firma, Level, LevelOptions, WholeMatterTable, World, WorldOptions } from './index.js';

/**
 * Loads the module of readers, unless that was done already, for what loadFirma() gave; it is where the options of
 * loadFirma() say. A program that does so before it needs a level does not wait then, and can read without promises.
 *
 * @throws {FirmaError} as loadFirma(); the message says where the module was looked for. BAD_CALL for anything but a Firma
 */
export function loadReaders(firma: Firma): Promise<Readers>;

/**
 * The functions of a Firma that read files, without promises; costs and errors are the same, and what they give is that
 * Firma's. Their memory stays as large as the largest file has made it, for as long as this object is kept. When it runs
 * out they stop, and throw INTERNAL from then on; loadReaders() then gives others, and worlds are not concerned.
 */
export interface Readers {
    /** As '0.2.0'. */
    readonly version: string;
    worldFromObj(file: string | Bytes, options?: WorldOptions): World;
    worldFromBsp(file: Bytes, options?: WorldOptions): World;
    worldFromMap(file: string | Bytes, options?: WorldOptions): World;
    levelFromMap(file: string | Bytes, options?: LevelOptions): Level;
    levelFromBsp(file: Bytes, options?: LevelOptions): Level;
    cutterFromObj(file: string | Bytes, name?: string): Cutter;
    readMatters(text: string | Bytes, name?: string): WholeMatterTable;
}
