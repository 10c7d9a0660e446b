// SPDX-License-Identifier: BSD-3-Clause

/** How often what only ages (certainty, silence, clocks) is drawn anew. */
const AGEING_MS = 100;
const CALM_AGEING_MS = 1000;
/** It goes along with what is drawn anyway: alone it is drawn where nothing else was for so many times as long. */
const PATIENCE = 1.5;
/** A page that knows no newer time of the monitor's is behind, and says so. */
const BEHIND_MS = 2000;
/** What shows minutes moves on twice a second: finer steps are no pixel wide, and drawing costs. */
const STEP_MS = 500;

/**
 * The time that the page shows, which goes on only when it is drawn, and that of which the monitor has told. What
 * changes seldom is told where it changes, rather than computed by all who read it whenever time goes on.
 */
export class PageClock {
  now_ms = $state(Date.now());
  /** The present in coarse steps. */
  step_ms = $state(Math.ceil(Date.now() / STEP_MS) * STEP_MS);
  /** Whether what is shown as the present is older than an operator may take it for. */
  isBehind = $state(false);
  /** The monitor's time when it told the newest of what is shown; undefined: it has told nothing yet. */
  #told_ms = $state<number>();
  #toldNext_ms: number | undefined;
  #calm = matchMedia("(prefers-reduced-motion: reduce)");

  /** The newest time of which the monitor told how things stood, no later than now. */
  readonly known_ms: number = $derived(Math.min(this.now_ms, this.#told_ms ?? this.now_ms));
  readonly behind_ms: number = $derived(this.now_ms - this.known_ms);

  /** The monitor told its time; it is shown when time goes on. */
  tell(monitor_ms: number): void {
    this.#toldNext_ms = monitor_ms;
  }

  /** Of `at_ms`, what the monitor has told until then, drawn or not. */
  newest_ms(at_ms: number): number {
    return Math.min(at_ms, this.#toldNext_ms ?? at_ms);
  }

  /** Whether time must be drawn though nothing else is. */
  isDue(at_ms: number): boolean {
    return at_ms - this.now_ms >= this.#ageing_ms * PATIENCE;
  }

  /** Time goes on to `at_ms`, if that is far enough to be drawn. */
  advance(at_ms: number): void {
    if (at_ms - this.now_ms >= this.#ageing_ms) [this.now_ms, this.#told_ms] = [at_ms, this.#toldNext_ms];
    this.isBehind = this.behind_ms > BEHIND_MS;
  }

  /** It is `at_ms`, whatever it was before: of a recording all that is shown is known. */
  jump(at_ms: number): void {
    [this.now_ms, this.#told_ms, this.#toldNext_ms] = [at_ms, at_ms, at_ms];
    this.isBehind = false;
  }

  /** The coarse steps go on. */
  step(at_ms: number): void {
    this.step_ms = Math.ceil(at_ms / STEP_MS) * STEP_MS;
  }

  get #ageing_ms(): number {
    return this.#calm.matches ? CALM_AGEING_MS : AGEING_MS;
  }
}

/** How often a page looks whether time must be drawn. */
export const LOOK_MS = AGEING_MS / 2;
