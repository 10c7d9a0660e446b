// SPDX-License-Identifier: BSD-3-Clause
// Whether this viewer may steer, as the monitor says; until it has said so, it may.

import { live } from "./live.svelte";

export const HOW_TO_STEER =
  "You may watch only. Open the operator's link to steer: the monitor prints it when it starts, and its token stands in operator.token in the monitor's data folder.";

class Rights {
  maySteer = $state(true);
}

export const rights = new Rights();

/** For a button that steers: where this viewer may not, it looks so, says where to get the right, and does nothing else. */
export function steers(button: HTMLButtonElement): void {
  $effect(() => {
    const isBarred = !rights.maySteer;
    button.setAttribute("aria-disabled", String(isBarred));
    if (!isBarred) return;
    const { title } = button;
    button.title = HOW_TO_STEER;
    const explain = (event: MouseEvent): void => {
      event.stopImmediatePropagation();
      live.trouble = HOW_TO_STEER;
    };
    button.addEventListener("click", explain, { capture: true });
    return () => {
      button.title = title;
      button.removeEventListener("click", explain, { capture: true });
    };
  });
}
