// SPDX-License-Identifier: MIT
// What is seen and heard of what goes off: flash, fire, dust, sparks, a view that shakes, sounds as far away as they are.
import { puff, throwBlast, trail } from './blast_particles.js';
import { felt, Shake } from './shake.js';
import { heard } from './sound.js';
import { along } from './vector.js';

export class BlastShow {
    /** @param reach  (from, path) => the fraction of a path that is free */
    constructor(stage, sound, reach, still = false) {
        this.stage = stage;
        this.sound = sound;
        this.reach = reach;
        this.shake = new Shake(still);
        this.count = 0;
        this.ear = { eye: [0, 0, 0], direction: [1, 0, 0] };
    }

    /** @param what  { point, normal, colour, metal }: see throwBlast() */
    blast(what) {
        throwBlast(this.stage.dust, this.stage.glow, this.reach, { ...what, seed: ++this.count });
        this.stage.blast.flash(what.point, what.normal);
        this.shake.add(felt(Math.hypot(...what.point.map((x, axis) => x - this.ear.eye[axis]))));
        this.hear('blast', what.point);
    }

    /** What a rocket left behind in the last dt seconds. @param at  where it is drawn @param speed  metres a second */
    trail(at, direction, speed, dt) {
        const count = Math.min(8, Math.ceil(dt * 40));
        for (let k = 0; k < count; ++k) trail(this.stage.dust, this.stage.glow, along(at, direction, (-speed * dt * k) / count), direction, ++this.count);
    }

    /** Something heavy came down. */
    puff(at, colour, size) {
        puff(this.stage.dust, at, colour, size, ++this.count);
    }

    hear(name, place, loud = 1) {
        const { loud: near, side } = heard(this.ear.eye, this.ear.direction, place);
        this.sound.play(name, { loud: near * loud, side });
    }

    /** Where the ear is from now on. */
    listen(eye, direction) {
        this.ear = { eye, direction };
    }

    step(dt) {
        this.shake.step(dt);
    }
}
