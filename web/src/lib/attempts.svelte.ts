/** What the page does at somebody's word: whether something is under way, and what went wrong with it. */
export class Attempts {
  busy = $state(false);
  /** What went wrong with the last attempt, until the next. */
  failure = $state<string>();

  async make(work: () => Promise<void>): Promise<void> {
    this.busy = true;
    this.failure = undefined;
    try {
      await work();
    } catch (error) {
      this.failure = (error as Error).message;
    } finally {
      this.busy = false;
    }
  }
}
