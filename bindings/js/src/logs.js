// SPDX-License-Identifier: MIT
// Edit logs and their replays.
import { number, word } from './arguments.js';
import { Command, unpackHandle } from './commands.js';
import { CORE, Handle, ID, idOf, makeHandle, takeBytes } from './handle.js';
import { LOG_FACTS, REPLAY_FACTS } from './layout.js';
import { World } from './world.js';

export class EditLog extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_log_release');
    }

    static begin(core, level) {
        return new EditLog(core, makeHandle(core, 'firma_log_begin', idOf(level, core, 'beginLog', 'world')));
    }

    static unpack(core, data, name) {
        return new EditLog(core, unpackHandle(core, 'firma_log_unpack', data, name, 'unpackLog'));
    }

    append(command) {
        const core = this[CORE];
        core.run('firma_log_append', this[ID], idOf(command, core, 'append', 'command'));
    }

    checkpoint(world) {
        const core = this[CORE];
        core.run('firma_log_checkpoint', this[ID], idOf(world, core, 'checkpoint', 'world'));
    }

    facts() {
        const core = this[CORE];
        const at = core.at.logFacts;
        core.run('firma_log_get_facts', this[ID], at);
        return {
            levelHash: core.u64[(at + LOG_FACTS.levelHash) >>> 3],
            rulesHash: core.u64[(at + LOG_FACTS.rulesHash) >>> 3],
            levelEdits: core.getU32(at + LOG_FACTS.levelEdits),
            commandCount: core.getCount(at + LOG_FACTS.commandCount),
            checkpointCount: core.getCount(at + LOG_FACTS.checkpointCount),
            patchBytes: core.getCount(at + LOG_FACTS.patchBytes),
            lastNumber: core.getU32(at + LOG_FACTS.lastNumber),
            patchedNumber: core.getU32(at + LOG_FACTS.patchedNumber),
        };
    }

    command(index) {
        const core = this[CORE];
        word(index, 'command', 'the index');
        return new Command(core, makeHandle(core, 'firma_log_command', this[ID], index));
    }

    pack() {
        const core = this[CORE];
        return takeBytes(core, makeHandle(core, 'firma_log_pack', this[ID]));
    }

    compact(level, number) {
        const core = this[CORE];
        const first = idOf(level, core, 'compact', 'world');
        word(number, 'compact', 'the number');
        return new EditLog(core, makeHandle(core, 'firma_log_compact', this[ID], first, number));
    }

    replay(level, lastNumber = 0xffffffff) {
        const core = this[CORE];
        const first = idOf(level, core, 'replay', 'world');
        word(lastNumber, 'replay', 'lastNumber');
        return new Replay(core, makeHandle(core, 'firma_replay_start', first, this[ID], lastNumber));
    }
}

export class Replay extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_replay_release');
    }

    run(microseconds) {
        const core = this[CORE];
        number(microseconds, 'run', 'microseconds');
        core.run('firma_replay_run', this[ID], microseconds, core.at.out);
        return core.getU32(core.at.out) !== 0;
    }

    facts() {
        const core = this[CORE];
        const at = core.at.replayFacts;
        core.run('firma_replay_get_facts', this[ID], at);
        const facts = { finished: core.getU32(at + REPLAY_FACTS.finished) !== 0 };
        const counts = ['commandsBehind', 'commandsInAll', 'applied', 'done', 'nothing', 'refused', 'checkpoints'];
        for (const name of counts) facts[name] = core.getCount(at + REPLAY_FACTS[name]);
        facts.error = core.text(core.getU32(at + REPLAY_FACTS.error)) || null;
        return facts;
    }

    result() {
        const core = this[CORE];
        return new World(core, makeHandle(core, 'firma_replay_result', this[ID]));
    }
}
