// SPDX-License-Identifier: MIT
// Grenades: projectiles of the engine that fall, bounce off whatever they meet, lie still, and go off when their time is up.
import { along } from './vector.js';

const kSpeed = 15; // metres a second
const kUp = 2.5; // of that, besides where one looks
const kFuse = 2.4; // seconds
const kRadius = 0.07;
const kBounce = { ricochetBelow: 2, restitution: 0.42, friction: 0.35 }; // however steep

export class Grenades {
    /** @param Projectiles  the class of 'firma/recordings' */
    constructor(firma, Projectiles) {
        this.firma = firma;
        this.Projectiles = Projectiles;
        this.all = new Projectiles();
        this.fuses = new Map(); // by the `user` of each: { left: seconds, normal: of what it touched last }
        this.thrown = 0;
    }

    throw(position, direction, velocity = [0, 0, 0]) {
        const user = ++this.thrown;
        this.fuses.set(user, { left: kFuse, normal: null });
        const own = direction.map((x, k) => x * kSpeed + velocity[k]);
        this.all.add({ position, velocity: [own[0], own[1], own[2] + kUp], mass: 0.4, user });
    }

    /**
     * Time goes on. @param bodies  what they bounce off besides the world
     * @returns { blasts: places, bounces: [{ point, speed }] }
     */
    step(world, bodies, dt) {
        if (this.all.count === 0) return { blasts: [], bounces: [] };
        const { events } = this.firma.fly(this.all, world, dt, { bodies, other: kBounce, ofBodies: kBounce, stopSpeed: 0.4, maxAge: 2 * kFuse });
        const bounces = [];
        for (const { kind, projectile, point, normal, velocity, energy } of events) {
            if (kind !== 'ricochet' && kind !== 'stopped') continue;
            this.fuses.get(this.all.get(projectile).user).normal = normal;
            bounces.push({ point, speed: Math.hypot(...velocity) + Math.sqrt(energy) });
        }
        return { blasts: this.#goOff(dt), bounces };
    }

    /** Where each is drawn, not half in the ground. */
    seen() {
        return Array.from({ length: this.all.count }, (_, k) => {
            const { position, velocity, state, user } = this.all.get(k);
            const { normal } = this.fuses.get(user);
            return { at: normal && state !== 'flying' ? along(position, normal, kRadius) : position, direction: state === 'flying' ? velocity : [1, 0, 0] };
        });
    }

    get count() {
        return this.all.count;
    }

    clear() {
        this.all.clear();
        this.fuses.clear();
    }

    #goOff(dt) {
        const blasts = [];
        const left = new this.Projectiles();
        for (let k = 0; k < this.all.count; ++k) {
            const grenade = this.all.get(k);
            const fuse = this.fuses.get(grenade.user);
            fuse.left -= dt;
            if (fuse.left > 0 && grenade.state !== 'expired') left.add(grenade);
            else {
                this.fuses.delete(grenade.user);
                if (grenade.state !== 'expired') blasts.push(grenade.position);
            }
        }
        this.all = left;
        return blasts;
    }
}
