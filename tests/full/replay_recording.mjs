// SPDX-License-Identifier: MIT
// Replays a recording through the JavaScript API, as `same_games replay` does: in node, or by replay_recording_browser.mjs
// in Chromium.
//
//   node replay_recording.mjs FIRMA_RECORDINGS.wasm RECORDING.firmarec
import { loadRecordings } from '../../bindings/js/src/recordings.js';

/** @param module  URL, path or answer of fetch() of firma_recordings.wasm @param bytes  of the recording */
export async function replayRecording(module, bytes, print) {
    const firma = await loadRecordings(module);
    const recording = firma.unpackRecording(bytes, 'the recording');
    const game = recording.replay();
    while (!game.replayState().finished) game.step();
    const { ticks, differs, text } = game.replayState();
    if (differs) throw new Error(text);
    const { explosions, bodies } = game.facts();
    print(`same=${ticks} explosions=${explosions} bodies=${bodies} hash=${game.hash().toString(16).padStart(16, '0')}`);
    game.release();
    recording.release();
}

if (typeof process !== 'undefined' && process.argv[1]?.endsWith('replay_recording.mjs')) {
    const { readFile } = await import('node:fs/promises');
    const [module, recording] = process.argv.slice(2);
    if (recording === undefined) throw new Error('usage: node replay_recording.mjs FIRMA_RECORDINGS.wasm RECORDING.firmarec');
    await replayRecording(module, await readFile(recording), console.log);
}
