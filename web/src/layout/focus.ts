// SPDX-License-Identifier: BSD-3-Clause
import { tick } from "svelte";
import { keys } from "../lib/keys";
import { arrangement } from "./arrangement.svelte";

/** Brings a panel into sight and puts the keyboard on its title, which may have got a new element with its place. */
export async function focusPanel(panel: string): Promise<void> {
  arrangement.reveal(panel);
  await tick();
  document.querySelector<HTMLElement>(`[data-title="${panel}"]`)?.focus();
}

/** Brings a panel into sight that declares this key while it is shown, and presses the key there. */
export async function pressIn(panel: string, key: string): Promise<void> {
  const here = keys.get(key);
  await focusPanel(panel);
  await tick();
  const there = keys.get(key);
  if (there !== here) there?.act();
}

/** The panel that the keyboard is in. */
export function focusedPanel(): string | undefined {
  return document.activeElement?.closest<HTMLElement>("[data-panel]")?.dataset.panel;
}
