// SPDX-License-Identifier: BSD-3-Clause
// An arrangement as text, for the address and for what the browser keeps: r(30-c(50-team.50-program~referee).70-map)
// is a row of a column and the map; a stack's tabs stand between "~", the one shown with "*" where it is not the
// first. No character of it needs escaping in an address.

import { isSplit, type Node, type Part, split } from "./tree";

export function textOf(node: Node): string {
  if (!isSplit(node)) return node.panels.map((panel, i) => (panel === node.shown && i > 0 ? `${panel}*` : panel)).join("~");
  const percent = (share: number) => String(Math.round(share * 1000) / 10).replace(".", "'");
  const parts = node.parts.map((part) => `${percent(part.share)}-${textOf(part.node)}`);
  return `${node.across[0]}(${parts.join(".")})`;
}

/** The arrangement that a text tells, of the panels that are known, each once; undefined where it tells none. */
export function treeOf(text: string, known: readonly string[]): Node | undefined {
  const reader = new Reader(text, new Set(known));
  try {
    return reader.whole();
  } catch {
    return undefined;
  }
}

class Reader {
  #at = 0;

  constructor(
    private readonly text: string,
    private readonly known: Set<string>,
  ) {}

  whole(): Node | undefined {
    const node = this.#node();
    if (this.#at < this.text.length) throw new Error("more than one arrangement");
    return node;
  }

  #take(pattern: RegExp): string | undefined {
    const sticky = new RegExp(pattern, "y");
    sticky.lastIndex = this.#at;
    const found = sticky.exec(this.text)?.[0];
    this.#at += found?.length ?? 0;
    return found;
  }

  #node(): Node | undefined {
    const opening = this.#take(/[rc]\(/);
    if (!opening) return this.#stack();
    const parts: Part[] = [];
    do parts.push(...this.#part());
    while (this.#take(/\./));
    if (!this.#take(/\)/)) throw new Error("a row or column does not end");
    return split(opening[0] === "r" ? "row" : "column", parts);
  }

  #part(): Part[] {
    const share = Number(this.#take(/\d+('\d+)?/)?.replace("'", "."));
    if (!(share > 0) || !this.#take(/-/)) throw new Error("a part has no share");
    const node = this.#node();
    return node ? [{ share, node }] : [];
  }

  #stack(): Node | undefined {
    const names: string[] = [];
    let shown: string | undefined;
    do {
      const name = this.#take(/[a-z_]+/);
      if (!name) throw new Error("a panel has no name");
      const marked = this.#take(/\*/) !== undefined;
      if (!this.known.delete(name)) continue;
      names.push(name);
      if (marked) shown = name;
    } while (this.#take(/~/));
    return names[0] === undefined ? undefined : { panels: names, shown: shown ?? names[0] };
  }
}
