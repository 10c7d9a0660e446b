// SPDX-License-Identifier: BSD-3-Clause
import { getContext, setContext } from "svelte";
import type { Stack } from "./tree";

/** What a panel's header needs to know of the place where the panel stands. */
export interface Frame {
  readonly panel: string;
  readonly stack: Stack;
  /** Begins to carry a panel by the pointer. */
  grab(event: PointerEvent, panel: string): void;
}

const KEY = Symbol("frame");

export function setFrame(frame: Frame): void {
  setContext(KEY, frame);
}

/** Undefined where panels are not arranged: on a phone. */
export function frameHere(): Frame | undefined {
  return getContext(KEY);
}
