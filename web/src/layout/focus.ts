// SPDX-License-Identifier: BSD-3-Clause
import { tick } from "svelte";
import { arrangement } from "./arrangement.svelte";

/** Brings a panel into sight and puts the keyboard on its title, which may have got a new element with its place. */
export async function focusPanel(panel: string): Promise<void> {
  arrangement.reveal(panel);
  await tick();
  document.querySelector<HTMLElement>(`[data-title="${panel}"]`)?.focus();
}

/** The panel that the keyboard is in. */
export function focusedPanel(): string | undefined {
  return document.activeElement?.closest<HTMLElement>("[data-panel]")?.dataset.panel;
}
