// SPDX-License-Identifier: MIT
// What `import ... from 'firma/games'` gives: the module of worlds with all that moves.
import { Games } from './games_library.js';
import { kindOf, loadLibrary } from './load_library.js';

export { Projectiles } from './projectiles.js';
export * from './common.js';

const PLACE = 'loadGames';
const KIND = kindOf("Firma's module of games", 'firma_move_player', PLACE);

export async function loadGames(source = new URL('./firma_games.wasm', import.meta.url), options = undefined) {
    return loadLibrary(source, options, PLACE, KIND, Games);
}
