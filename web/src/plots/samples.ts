// SPDX-License-Identifier: BSD-3-Clause
/** A line's samples in the order of time; the oldest give way. */
export class Samples {
  readonly times_s: number[] = [];
  readonly values: (number | null)[] = [];

  constructor(private readonly most = 9000) {}

  /** What comes late is dropped: a plot is drawn from left to right. */
  add(at_ms: number, value: number | null): void {
    const at_s = at_ms / 1000;
    if (at_s <= (this.times_s.at(-1) ?? Number.NEGATIVE_INFINITY)) return;
    this.times_s.push(at_s);
    this.values.push(value);
    // Rarely, and many at a time: taking one off the front moves all the others.
    if (this.times_s.length > this.most * 1.2) {
      const surplus = this.times_s.length - this.most;
      this.times_s.splice(0, surplus);
      this.values.splice(0, surplus);
    }
  }

  /** It goes on from `at_ms`, and nothing is known of the time since the sample before that. */
  goOnFrom(at_ms: number): void {
    const kept = this.times_s.findIndex((each_s) => each_s * 1000 > at_ms);
    if (kept >= 0) this.times_s.length = this.values.length = kept;
    this.add(at_ms, null);
  }

  /** The newest value at that instant; undefined before the first. */
  at(at_ms: number): number | null | undefined {
    let [low, high] = [0, this.times_s.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times_s[middle]! * 1000 <= at_ms) low = middle + 1;
      else high = middle;
    }
    return low === 0 ? undefined : this.values[low - 1];
  }
}
