// SPDX-License-Identifier: MIT
// What `import ... from 'firma/recordings'` gives: the module of games with games as one value, recorded and replayed.
import { unpackHandle } from './commands.js';
import { Games } from './games_library.js';
import { kindOf, loadLibrary } from './load_library.js';
import { Game, kindOfBytes, Recording } from './recorded_games.js';

export { Projectiles } from './projectiles.js';
export * from './common.js';

const PLACE = 'loadRecordings';
const KIND = kindOf("Firma's module of recordings", 'firma_game_begin', PLACE);

class Recordings extends Games {
    #core;

    constructor(core, readers) {
        super(core, readers);
        this.#core = core;
    }

    game(level, rate = 60) {
        return Game.begin(this.#core, level, rate);
    }

    unpackGame(data, name) {
        return new Game(this.#core, unpackHandle(this.#core, 'firma_game_unpack', data, name, 'unpackGame'));
    }

    unpackRecording(data, name) {
        const id = unpackHandle(this.#core, 'firma_recording_unpack', data, name, 'unpackRecording');
        return new Recording(this.#core, id);
    }

    kindOfBytes(data) {
        return kindOfBytes(this.#core, data);
    }
}

export async function loadRecordings(source = new URL('./firma_recordings.wasm', import.meta.url), options = undefined) {
    return loadLibrary(source, options, PLACE, KIND, Recordings);
}
