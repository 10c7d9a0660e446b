// SPDX-License-Identifier: BSD-3-Clause
// How panels share the page: rows and columns of stacks. Plain values, never changed in place.

/** Panels in one place, one of them shown, the others a tab away. */
export interface Stack {
  readonly panels: readonly string[];
  readonly shown: string;
}

export interface Split {
  readonly across: Across;
  readonly parts: readonly Part[];
}

export interface Part {
  /** Of the split's length; all of them add up to 1. */
  readonly share: number;
  readonly node: Node;
}

export type Node = Stack | Split;
export type Across = "row" | "column";
export type Side = "left" | "right" | "up" | "down";

export const acrossOf = (side: Side): Across => (side === "left" || side === "right" ? "row" : "column");
export const isFirst = (side: Side): boolean => side === "left" || side === "up";
export const isSplit = (node: Node): node is Split => "parts" in node;

export function stackOf(panel: string): Stack {
  return { panels: [panel], shown: panel };
}

export function stacksIn(node: Node): Stack[] {
  return isSplit(node) ? node.parts.flatMap((part) => stacksIn(part.node)) : [node];
}

export function panelsIn(node: Node): string[] {
  return stacksIn(node).flatMap((stack) => stack.panels);
}

export function stackWith(node: Node, panel: string): Stack | undefined {
  return stacksIn(node).find((stack) => stack.panels.includes(panel));
}

/** The tree with each stack replaced by what `change` makes of it; nothing removes it. */
export function mapped(node: Node, change: (stack: Stack) => Node | undefined): Node | undefined {
  if (!isSplit(node)) return change(node);
  const parts = node.parts.flatMap((part) => {
    const next = mapped(part.node, change);
    return next ? [{ share: part.share, node: next }] : [];
  });
  return split(node.across, parts);
}

/** A split in its simplest form: none of one part, none inside another of its own direction. */
export function split(across: Across, parts: readonly Part[]): Node | undefined {
  const flat = parts.flatMap(({ share, node }) =>
    isSplit(node) && node.across === across
      ? node.parts.map((part) => ({ share: share * part.share, node: part.node }))
      : [{ share, node }],
  );
  if (flat.length < 2) return flat[0]?.node;
  const whole = flat.reduce((sum, part) => sum + part.share, 0);
  return { across, parts: flat.map(({ share, node }) => ({ share: share / whole, node })) };
}
