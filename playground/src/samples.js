// SPDX-License-Identifier: MIT
// The last so many measurements of something: their least, their median, the last.
export class Samples {
    constructor(most) {
        this.most = most;
        this.values = [];
        this.next = 0;
        this.last = NaN;
    }

    add(value) {
        this.last = value;
        this.values[this.next] = value;
        this.next = (this.next + 1) % this.most;
    }

    get count() {
        return this.values.length;
    }

    least() {
        return this.count ? Math.min(...this.values) : NaN;
    }

    median() {
        if (!this.count) return NaN;
        const sorted = [...this.values].sort((a, b) => a - b);
        const half = sorted.length >> 1;
        return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    }
}
