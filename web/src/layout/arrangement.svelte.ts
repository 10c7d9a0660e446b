// SPDX-License-Identifier: BSD-3-Clause
// How the reader has arranged the panels: kept by the browser, shared by a link, and back to the standard at any time.

import { ui } from "../lib/ui.svelte";
import { beside, grown, moved, opened, resized, shown, stacked, without } from "./change";
import type { Drop } from "./places";
import { textOf, treeOf } from "./text";
import { type Across, type Node, panelsIn, type Side, stackWith } from "./tree";

/** What can be arranged. */
export interface PanelName {
  readonly id: string;
  readonly title: string;
  /** What it shows, in a sentence or two. */
  readonly about: string;
  /** The panel as a tab of which it appears, where the standard gives it no place of its own. */
  readonly behind?: string;
  /** It stands in no arrangement until somebody opens it. */
  readonly onRequest?: boolean;
  /** Whether it can be opened now; without it, always. */
  readonly isOffered?: () => boolean;
}

interface Kept {
  readonly layout: string;
  /** The panels that there were then: later ones were not closed by anybody. */
  readonly known: readonly string[];
}

const KEY = "galilean.layout";
const PARAMETER = "layout";

class Arrangement {
  /** Undefined: every panel is closed. */
  tree = $state.raw<Node>();
  /** The one panel that fills the page. */
  filling = $state<string>();
  isStandard = $state(true);
  /** The address asks for an arrangement that makes no sense. */
  isLinkBroken = false;
  panels = $state.raw<readonly PanelName[]>([]);
  #standard: Node | undefined;

  /** Those that can be opened, and those that are open. */
  readonly offered: readonly PanelName[] = $derived(this.panels.filter(({ id, isOffered }) => this.open.has(id) || !isOffered || isOffered()));
  readonly open: ReadonlySet<string> = $derived(new Set(this.tree ? panelsIn(this.tree) : []));

  /** What there is to arrange, and how it stands unless somebody arranged it. */
  begin(panels: readonly PanelName[], standard: string): void {
    this.panels = panels;
    this.#standard = this.#withNew(this.#read(standard), []);
    const linked = new URLSearchParams(location.search).get(PARAMETER);
    const kept = keptLayout();
    const own = (linked && this.#read(linked)) || (kept && this.#withNew(this.#read(kept.layout), kept.known));
    this.isLinkBroken = linked !== null && !this.#read(linked);
    this.isStandard = !own;
    this.tree = own || this.#standard;
  }

  aboutOf(panel: string): string {
    return this.panels.find(({ id }) => id === panel)?.about ?? "";
  }

  titleOf(panel: string): string {
    return this.panels.find(({ id }) => id === panel)?.title ?? panel;
  }

  /** Brings a panel into sight, wherever it stands and whatever fills the page. */
  reveal(panel: string): void {
    ui.tab = panel;
    if (this.filling !== panel) this.filling = undefined;
    const behind = this.panels.find(({ id }) => id === panel)?.behind;
    const next = opened(this.tree, panel, behind);
    if (!this.tree || stackWith(this.tree, panel)?.shown !== panel) this.#arrange(next);
  }

  /** Brings a panel to the front for what an address asks for: the arrangement that is kept stays the reader's. */
  bringForward(panel: string): void {
    this.tree = opened(this.tree, panel, this.panels.find(({ id }) => id === panel)?.behind);
  }

  close(panel: string): void {
    if (this.filling === panel) this.filling = undefined;
    this.#arrange(this.tree && without(this.tree, panel));
  }

  show(panel: string): void {
    if (this.filling) this.filling = panel;
    this.#change((tree) => shown(tree, panel));
  }

  fill(panel: string): void {
    this.filling = this.filling === panel ? undefined : panel;
  }

  move(panel: string, side: Side): void {
    this.filling = undefined;
    this.#change((tree) => moved(tree, panel, side));
  }

  put(panel: string, { target, where }: Pick<Drop, "where"> & { target: string }): void {
    this.#change((tree) => (where === "middle" ? stacked(tree, target, panel) : beside(tree, target, panel, where)));
  }

  resize(path: readonly number[], index: number, by: number): void {
    this.#change((tree) => resized(tree, path, index, by));
  }

  grow(panel: string, across: Across, by: number): void {
    this.#change((tree) => grown(tree, panel, across, by));
  }

  toStandard(): void {
    this.filling = undefined;
    this.tree = this.#standard;
    this.isStandard = true;
    localStorage.removeItem(KEY);
    withoutParameter();
  }

  /** The arrangement as a link has it; undefined where every panel is closed. */
  get text(): string | undefined {
    return this.tree && textOf(this.tree);
  }

  #read(text: string): Node | undefined {
    return treeOf(
      text,
      this.panels.map(({ id }) => id),
    );
  }

  /** With the panels that came since, where they belong. */
  #withNew(tree: Node | undefined, known: readonly string[]): Node | undefined {
    return this.panels.reduce((before, { id, behind, onRequest }) => {
      if (!before || behind === undefined || onRequest || known.includes(id) || stackWith(before, id)) return before;
      const in_front = stackWith(before, behind)?.shown;
      const next = opened(before, id, behind);
      return in_front === undefined ? next : shown(next, in_front);
    }, tree);
  }

  #change(change: (tree: Node) => Node): void {
    if (this.tree) this.#arrange(change(this.tree));
  }

  #arrange(tree: Node | undefined): void {
    if (tree === this.tree) return;
    this.tree = tree;
    this.isStandard = false;
    const kept: Kept = { layout: tree ? textOf(tree) : "", known: this.panels.map(({ id }) => id) };
    localStorage.setItem(KEY, JSON.stringify(kept));
    withoutParameter();
  }
}

function keptLayout(): Kept | undefined {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "null") as Kept | null;
    return typeof kept?.layout === "string" && Array.isArray(kept.known) ? kept : undefined;
  } catch {
    return undefined;
  }
}

/** What the reader changed is no longer what the link says. */
function withoutParameter(): void {
  const query = new URLSearchParams(location.search);
  if (!query.has(PARAMETER)) return;
  query.delete(PARAMETER);
  history.replaceState(null, "", location.pathname + `?${query}`.replace(/\?$/, ""));
}

export const arrangement = new Arrangement();
