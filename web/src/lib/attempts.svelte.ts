// SPDX-License-Identifier: BSD-3-Clause
/** What the page does at somebody's word: whether something is under way, and what went wrong. */
export class Attempts {
  /** No state, so that an effect may begin an attempt without waiting for others to end. */
  #underWay = 0;
  #busy = $state(false);
  #failures = $state.raw<readonly string[]>([]);

  get busy(): boolean {
    return this.#busy;
  }

  /** What went wrong since the last attempt began, in whole sentences. */
  get failure(): string | undefined {
    return this.#failures.length > 0 ? this.#failures.join(" ") : undefined;
  }

  /** Returns what comes of `work`, or undefined if it failed: then `failure` says so, as `sentence` puts it. */
  async make<T>(work: () => Promise<T>, sentence = (error: Error) => error.message): Promise<T | undefined> {
    this.#underWay += 1;
    this.#busy = true;
    this.#failures = [];
    try {
      return await work();
    } catch (error) {
      const failure = sentence(error as Error);
      if (!this.#failures.includes(failure)) this.#failures = [...this.#failures, failure];
      return undefined;
    } finally {
      this.#underWay -= 1;
      this.#busy = this.#underWay > 0;
    }
  }
}
