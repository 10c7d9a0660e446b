// SPDX-License-Identifier: BSD-3-Clause
// When the page is drawn anew: only where something asks for it, and so that drawing leaves the machine time for
// what comes in meanwhile.

/** Of the time, drawing takes at most one part in so many: what changes all the time waits rather than queues. */
const SHARE = 4;
/** At most so long: a crowd of robots is handed over as often. */
const LONGEST_WAIT_MS = 250;

export interface Frames {
  now_ms(): number;
  /** Calls back within the next frame, before it is laid out and painted. */
  before(callback: () => void): void;
  /** Calls back as soon as the frame that is under way has been handed over. */
  behind(callback: () => void): void;
  after(callback: () => void, wait_ms: number): void;
}

/** Those of the browser. */
export function browserFrames(): Frames {
  const { port1, port2 } = new MessageChannel();
  const callbacks: (() => void)[] = [];
  port1.onmessage = () => callbacks.shift()?.();
  return {
    now_ms: () => performance.now(),
    before: (callback) => void requestAnimationFrame(callback),
    behind: (callback) => (callbacks.push(callback), port2.postMessage(0)),
    after: (callback, wait_ms) => void setTimeout(callback, wait_ms),
  };
}

export class Redraw {
  #waits = false;
  /** Until the frame that shows what was drawn last has been handed over. */
  #shows = false;
  /** Something has happened since: it is drawn as soon as that frame is over. */
  #isUrgent = false;
  #next_ms = 0;

  constructor(
    /** `isUrgent`: it is drawn for the very next frame, which waits for nothing else. */
    private readonly draw: (isUrgent: boolean) => void,
    private readonly frames: Frames,
  ) {}

  /** Draws as soon as there is room for it. */
  ask(): void {
    if (this.#waits) return;
    this.#waits = true;
    const wait_ms = this.#next_ms - this.frames.now_ms();
    if (wait_ms > 0) this.frames.after(() => this.frames.before(() => this.#drawWaiting()), wait_ms);
    else this.frames.before(() => this.#drawWaiting());
  }

  /** Draws at once, so that the very next frame has it; no more than once a frame, and then as soon as that is over. */
  askNow(): void {
    if (this.#shows) {
      this.#isUrgent = true;
      return;
    }
    this.#isUrgent = false;
    const began_ms = this.frames.now_ms();
    this.draw(true);
    const drawing_ms = this.frames.now_ms() - began_ms;
    this.#shows = true;
    this.frames.before(() => this.#measure(drawing_ms));
  }

  #drawWaiting(): void {
    this.#waits = false;
    this.#shows = true;
    this.#measure(0, () => this.draw(false));
  }

  #measure(spent_ms: number, draw?: () => void): void {
    const began_ms = this.frames.now_ms();
    draw?.();
    this.frames.behind(() => {
      const cost_ms = spent_ms + this.frames.now_ms() - began_ms;
      this.#next_ms = began_ms + Math.min(cost_ms * SHARE, LONGEST_WAIT_MS);
      this.#shows = false;
      if (this.#isUrgent) this.askNow();
    });
  }
}
