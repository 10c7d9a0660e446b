// SPDX-License-Identifier: BSD-3-Clause
// Whether this viewer may steer, as the monitor says; until it has said so, it may. Nobody steers a recording.

import { RECORDED } from "../feed/recording";
import { leases } from "./leases.svelte";
import { live } from "./live.svelte";

const HOW_TO_STEER =
  "You may watch only. Open the operator's link to steer: the monitor prints it when it starts, and its token stands in operator.token in the monitor's data folder.";

class Rights {
  #granted = $state(true);

  /** What the monitor says of it. */
  told(maySteer: boolean): void {
    this.#granted = maySteer;
  }

  /** Why not, and what to do; undefined: it may. */
  get objection(): string | undefined {
    if (live.playback) return RECORDED;
    return this.#granted ? undefined : HOW_TO_STEER;
  }

  get maySteer(): boolean {
    return this.objection === undefined;
  }

  /** Whether it may; where not, says why. */
  ask(): boolean {
    if (this.objection !== undefined) live.trouble = this.objection;
    return this.maySteer;
  }
}

export const rights = new Rights();

/**
 * For a button that steers: where this viewer may not, it looks so, says why and what to do, and does nothing else. `whom`
 * names the robots whose leases the order needs; no names mean the team. Left out: it needs none, as a stop.
 */
export function steers(button: HTMLButtonElement, whom?: () => readonly string[]): void {
  // It changes seldom, unlike what it is made of: only then is anything drawn.
  const objection = $derived(rights.objection ?? (whom && leases.objection(whom())));
  $effect(() => {
    button.setAttribute("aria-disabled", String(objection !== undefined));
    if (objection === undefined) return;
    const { title } = button;
    button.title = objection;
    const explain = (event: MouseEvent): void => {
      event.stopImmediatePropagation();
      live.trouble = objection;
    };
    button.addEventListener("click", explain, { capture: true });
    return () => {
      button.title = title;
      button.removeEventListener("click", explain, { capture: true });
    };
  });
}

/** What `onKey` is told of a key that steers. In a recording the key says why it does nothing. */
export function steering(does: string, act: () => void): [does: string, act: () => void] {
  return live.playback ? ["off: a recording cannot be stopped", () => void rights.ask()] : [does, act];
}
