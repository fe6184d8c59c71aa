// SPDX-License-Identifier: MIT
// Runs replay_recording.mjs in Chromium.
//
//   node replay_recording_browser.mjs FIRMA_RECORDINGS.wasm RECORDING.firmarec      (paths below the repository)
import { runInChromium } from './in_chromium.mjs';

const [module, recording] = process.argv.slice(2);
if (recording === undefined) throw new Error('usage: node replay_recording_browser.mjs FIRMA_RECORDINGS.wasm RECORDING.firmarec');
await runInChromium(`
    const { replayRecording } = await import('/tests/full/replay_recording.mjs');
    await replayRecording(fetch(${JSON.stringify(`/${module}`)}), await bytesOf(${JSON.stringify(`/${recording}`)}), print);`);
