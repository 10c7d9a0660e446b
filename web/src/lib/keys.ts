// SPDX-License-Identifier: BSD-3-Clause
// The page's keys. A panel declares its own while it is shown; `?` lists those that work now, and those that bring their
// panel into sight first.

import { SvelteMap } from "svelte/reactivity";

interface Key {
  readonly does: string;
  readonly act: () => void;
  /** Works while one types, too. */
  readonly anywhere: boolean;
}

export const keys = new SvelteMap<string, Key>();

/** All that are declared of each key, the newest last. */
const declaredOf = new Map<string, readonly Key[]>();

/** Declares a key such as "f" or "Ctrl+."; the returned function takes it back. What was declared before it is back then. */
export function onKey(key: string, does: string, act: () => void, anywhere = false): () => void {
  const declared = { does, act, anywhere };
  declaredOf.set(key, [...(declaredOf.get(key) ?? []), declared]);
  keys.set(key, declared);
  return () => {
    const left = (declaredOf.get(key) ?? []).filter((other) => other !== declared);
    declaredOf.set(key, left);
    const newest = left.at(-1);
    if (newest) keys.set(key, newest);
    else keys.delete(key);
  };
}

/** A slider takes arrows and the like, and no letters: STOP ALL works on it. */
function isTyping(target: EventTarget | null, key: string): boolean {
  if (target instanceof HTMLInputElement && target.type === "range") return key.length > 1;
  return target instanceof HTMLElement && (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName));
}

/** The space bar presses what has the focus. */
function isPressing(target: EventTarget | null, key: string): boolean {
  return key === " " && target instanceof Element && target.closest("button, a[href], summary, [role=button], [role=tab]") !== null;
}

export function pressed(event: KeyboardEvent): void {
  if (event.altKey) return;
  const chord = event.ctrlKey || event.metaKey ? `Ctrl+${event.key}` : event.key;
  const key = keys.get(chord);
  if (!key || (!key.anywhere && (isTyping(event.target, event.key) || isPressing(event.target, event.key)))) return;
  event.preventDefault();
  key.act();
}
