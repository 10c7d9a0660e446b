// SPDX-License-Identifier: BSD-3-Clause
/**
 * Questions whose answers come in any order, of which only the newest still counts. One is out of date as soon as
 * another is asked or `supersede` is called; its answer, or its failure, then changes nothing.
 */
export class Latest {
  #end: (why?: Error) => void = () => {};

  /**
   * Calls `use` with what `asked` comes to, unless it is out of date by then.
   * Returns whether `use` was called. It waits no longer for what is out of date.
   * Errors: `asked` failed while it was the newest, `use` threw, or `supersede` gave a reason.
   */
  take<T>(asked: Promise<T>, use: (answer: T) => void): Promise<boolean> {
    this.supersede();
    let isLatest = true;
    const ended = new Promise<boolean>((resolve, reject) => {
      this.#end = (why) => {
        isLatest = false;
        if (why) reject(why);
        else resolve(false);
      };
    });
    const used = asked.then((answer) => {
      if (!isLatest) return false;
      this.#end = () => {}; // what `use` does comes too late to end it
      use(answer);
      return true;
    });
    return Promise.race([ended, used]);
  }

  /** Makes what was asked out of date. `why` is told to who waits for it; without it, nobody is to know. */
  supersede(why?: Error): void {
    this.#end(why);
  }
}
