// SPDX-License-Identifier: MIT
// What is held goes on firing: how often each weapon does.
export const kWeapons = {
    rocket: { every: 0.4 }, // seconds
    grenade: { every: 0.7 },
};

export class Weapons {
    constructor() {
        this.wait = Object.fromEntries(Object.keys(kWeapons).map((name) => [name, 0]));
    }

    /**
     * Time goes on by dt seconds. @param held  { rocket, grenade }: whether the button of each is down
     * @returns the names of those that fire now; each fires once a step at most
     */
    step(dt, held) {
        return Object.keys(kWeapons).filter((name) => {
            this.wait[name] = Math.max(0, this.wait[name] - dt);
            if (!held[name] || this.wait[name] > 0) return false;
            this.wait[name] = kWeapons[name].every;
            return true;
        });
    }
}
