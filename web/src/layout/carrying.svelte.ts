// SPDX-License-Identifier: BSD-3-Clause
import { arrangement } from "./arrangement.svelte";
import { type Drop, dropAt, type PlacedStack } from "./places";

/** A pointer that moves less has clicked. */
const SLACK_PX = 5;
const WORDS = { left: "left of", right: "right of", up: "above", down: "below", middle: "as a tab of" } as const;

interface Ground {
  readonly dock: HTMLElement;
  readonly places: readonly PlacedStack[];
}

/** A panel that a pointer carries to another place. */
export class Carrying {
  panel = $state<string>();
  drop = $state.raw<Drop>();
  #cancel = () => {};

  readonly words: string = $derived(
    this.panel && this.drop
      ? `${arrangement.titleOf(this.panel)} ${WORDS[this.drop.where]} ${arrangement.titleOf(this.drop.target.stack.shown)}`
      : "",
  );

  constructor(private readonly ground: () => Ground) {}

  cancel(): void {
    this.#cancel();
  }

  grab = (event: PointerEvent, panel: string): void => {
    if (event.button !== 0 || arrangement.filling) return;
    const ended = new AbortController();
    const from = { x: event.clientX, y: event.clientY };
    this.#cancel = () => {
      ended.abort();
      this.panel = this.drop = undefined;
    };
    const move = (now: PointerEvent) => {
      if (Math.hypot(now.clientX - from.x, now.clientY - from.y) > SLACK_PX) this.panel = panel;
      if (this.panel) this.drop = this.#dropUnder(now);
    };
    const release = () => {
      const { drop } = this;
      if (drop) arrangement.put(panel, { target: drop.target.stack.shown, where: drop.where });
      this.#cancel();
    };
    addEventListener("pointermove", move, { signal: ended.signal });
    addEventListener("pointerup", release, { signal: ended.signal });
    addEventListener("pointercancel", this.#cancel, { signal: ended.signal });
  };

  #dropUnder({ clientX, clientY }: PointerEvent): Drop | undefined {
    const { dock, places } = this.ground();
    const { left, top, width, height } = dock.getBoundingClientRect();
    const drop = dropAt(places, (clientX - left) / width, (clientY - top) / height);
    const { stack } = drop?.target ?? {};
    const nowhere = stack?.panels.includes(this.panel!) && (stack.panels.length === 1 || drop!.where === "middle");
    return nowhere ? undefined : drop;
  }
}
