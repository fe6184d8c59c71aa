// SPDX-License-Identifier: MIT
// Runs same_games.mjs and same_everywhere.mjs in Chromium.
//
//   node same_everywhere_browser.mjs FIRMA_GAMES.wasm LEVEL.obj STEPS FIRMA.wasm LEVEL CUTS CASTS      (paths below the repository)
import { runInChromium } from './in_chromium.mjs';

const words = process.argv.slice(2);
if (words.length !== 7) throw new Error('usage: node same_everywhere_browser.mjs FIRMA_GAMES.wasm LEVEL.obj STEPS FIRMA.wasm LEVEL CUTS CASTS');
const [gamesModule, gamesLevel, steps, module, level, cuts, casts] = words;
await runInChromium(`
    const { runGames } = await import('/tests/full/same_games.mjs');
    await runGames(fetch(${JSON.stringify(`/${gamesModule}`)}), await bytesOf(${JSON.stringify(`/${gamesLevel}`)}), ${Number(steps)}, print);
    const { run } = await import('/tests/full/same_everywhere.mjs');
    await run(fetch(${JSON.stringify(`/${module}`)}), await bytesOf(${JSON.stringify(`/${level}`)}), ${Number(cuts)}, ${Number(casts)}, print);`);
