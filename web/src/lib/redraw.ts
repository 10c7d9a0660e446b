// SPDX-License-Identifier: BSD-3-Clause
// When the page is drawn anew: only where something asks for it, and so that drawing leaves the machine time for
// what comes in meanwhile.

import { ownTasks } from "./tasks";

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
  return {
    now_ms: () => performance.now(),
    before: (callback) => void requestAnimationFrame(callback),
    behind: ownTasks(),
    after: (callback, wait_ms) => void setTimeout(callback, wait_ms),
  };
}

/**
 * Draws in tasks of their own, and not within frames: between what a script draws and what the browser makes of it, a key of
 * the reader has its turn.
 */
export class Redraw {
  #waits = false;
  /** A task is arranged in which what waits is to be drawn. */
  #isArranged = false;
  /** What waits has let one frame pass by that shows something else; it lets no other. */
  #hasYielded = false;
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

  /** Draws as soon as there is room for it, and not in a frame that shows what has just happened. */
  ask(): void {
    if (this.#waits) return;
    this.#waits = true;
    if (!this.#shows) this.#arrange(this.#next_ms - this.frames.now_ms());
  }

  /** Draws at once, so that the very next frame has it; no more than once a frame, and then as soon as that is over. */
  askNow(): void {
    this.#isUrgent = this.#shows;
    if (!this.#shows) this.#begin(true);
  }

  #arrange(wait_ms: number): void {
    if (this.#isArranged) return;
    this.#isArranged = true;
    const draw = () => this.frames.before(() => this.frames.behind(() => this.#drawWaiting()));
    if (wait_ms > 0) this.frames.after(draw, wait_ms);
    else draw();
  }

  #drawWaiting(): void {
    this.#isArranged = false;
    if (this.#shows && !this.#hasYielded) {
      this.#hasYielded = true;
      return;
    }
    this.#waits = this.#hasYielded = false;
    this.#begin(false);
  }

  #begin(isUrgent: boolean): void {
    const began_ms = this.frames.now_ms();
    this.draw(isUrgent);
    const drawn_ms = this.frames.now_ms();
    this.#shows = true;
    this.frames.before(() => this.#measure(began_ms, drawn_ms - began_ms));
  }

  /** What the frame costs that is under way, beside the drawing for it that began at `drew_ms`. */
  #measure(drew_ms: number, drawing_ms: number): void {
    const began_ms = this.frames.now_ms();
    this.frames.behind(() => {
      const cost_ms = drawing_ms + this.frames.now_ms() - began_ms;
      this.#next_ms = drew_ms + Math.min(cost_ms * SHARE, LONGEST_WAIT_MS);
      this.#shows = false;
      if (this.#isUrgent) this.askNow();
      if (this.#waits) this.#arrange(this.#hasYielded ? 0 : this.#next_ms - this.frames.now_ms());
    });
  }
}
