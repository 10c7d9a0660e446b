// SPDX-License-Identifier: BSD-3-Clause
// What a reader does to the arrangement, each a function from a tree to the next.

import { type Across, acrossOf, isFirst, isSplit, mapped, type Node, type Part, panelsIn, type Side, split, stackOf, stackWith } from "./tree";

/** Nothing gets smaller than this share of what it stands in. */
const LEAST_SHARE = 0.08;
/** Of a panel that is put at the page's edge. */
const EDGE_SHARE = 0.25;

export function without(root: Node, panel: string): Node | undefined {
  return mapped(root, (stack) => {
    const panels = stack.panels.filter((each) => each !== panel);
    const shown = stack.shown === panel ? panels[0] : stack.shown;
    return shown === undefined ? undefined : { panels, shown };
  });
}

/** With `panel` as a shown tab where `target` stands. */
export function stacked(root: Node, target: string, panel: string): Node {
  const rest = panel === target ? root : without(root, panel);
  if (!rest || panel === target) return root;
  return mapped(rest, (stack) => (stack.panels.includes(target) ? { panels: [...stack.panels, panel], shown: panel } : stack))!;
}

/** With `panel` in half the room of the stack of `target`. */
export function beside(root: Node, target: string, panel: string, side: Side): Node {
  const neighbour = target === panel ? stackWith(root, panel)?.panels.find((each) => each !== panel) : target;
  const rest = without(root, panel);
  if (!rest || neighbour === undefined) return root;
  return mapped(rest, (stack) => (stack.panels.includes(neighbour) ? joined(stack, stackOf(panel), side, 0.5) : stack))!;
}

export function shown(root: Node, panel: string): Node {
  return mapped(root, (stack) => (stack.panels.includes(panel) ? { ...stack, shown: panel } : stack))!;
}

/** With the border behind part `index` of the split at `path` moved by a share of that split. */
export function resized(root: Node, path: readonly number[], index: number, by: number): Node {
  return replacedAt(root, path, (node) => {
    if (!isSplit(node)) return node;
    const [one, other] = [node.parts[index], node.parts[index + 1]];
    if (!one || !other) return node;
    const least = Math.min(LEAST_SHARE, one.share, other.share);
    const step = Math.min(Math.max(by, least - one.share), other.share - least);
    const share = (part: Part, at: number) => (at === index ? part.share + step : at === index + 1 ? part.share - step : part.share);
    return { ...node, parts: node.parts.map((part, at) => ({ ...part, share: share(part, at) })) };
  });
}

/** With `panel` longer or shorter in a direction, by a share of the row or column that it stands in. */
export function grown(root: Node, panel: string, across: Across, by: number): Node {
  const path = pathTo(root, panel) ?? [];
  for (let depth = path.length - 1; depth >= 0; depth -= 1) {
    const node = nodeAt(root, path.slice(0, depth));
    if (!isSplit(node) || node.across !== across) continue;
    const at = path[depth]!;
    const isLast = at === node.parts.length - 1;
    return resized(root, path.slice(0, depth), isLast ? at - 1 : at, isLast ? -by : by);
  }
  return root;
}

/** One step to a side: out of its stack, past its neighbour, out of its row or column, or to the page's edge. */
export function moved(root: Node, panel: string, side: Side): Node {
  if ((stackWith(root, panel)?.panels.length ?? 0) > 1) return beside(root, panel, panel, side);
  const path = pathTo(root, panel);
  if (!path || path.length === 0) return root;
  for (let depth = path.length - 1; depth >= 0; depth -= 1) {
    const at = path[depth]!;
    const node = nodeAt(root, path.slice(0, depth));
    const next = at + (isFirst(side) ? -1 : 1);
    if (!isSplit(node) || node.across !== acrossOf(side)) continue;
    const innermost = depth === path.length - 1;
    if (innermost && !node.parts[next]) continue;
    return innermost
      ? replacedAt(root, path.slice(0, depth), () => ({ ...node, parts: swapped(node.parts, at, next) }))
      : outOf(root, panel, path.slice(0, depth + 1), side);
  }
  const alreadyThere = path.length === 1 && isSplit(root) && root.across === acrossOf(side);
  const rest = without(root, panel);
  return alreadyThere || !rest ? root : joined(rest, stackOf(panel), side, EDGE_SHARE);
}

/** With the panel in reach: shown if it is there, else behind or beside others. */
export function opened(root: Node | undefined, panel: string, behind: string | undefined): Node {
  if (!root) return stackOf(panel);
  if (stackWith(root, panel)) return shown(root, panel);
  const target = behind !== undefined && stackWith(root, behind) ? behind : panelsIn(root).at(-1)!;
  return mapped(root, (stack) => (stack.panels.includes(target) ? { panels: [...stack.panels, panel], shown: panel } : stack))!;
}

/** From its row or column to beside that whole row or column, which stands at `path`. */
function outOf(root: Node, panel: string, path: readonly number[], side: Side): Node {
  const group = without(nodeAt(root, path), panel);
  return group ? replacedAt(root, path, () => joined(group, stackOf(panel), side, EDGE_SHARE)) : root;
}

function joined(node: Node, other: Node, side: Side, share: number): Node {
  const parts = [
    { share: 1 - share, node },
    { share, node: other },
  ];
  return split(acrossOf(side), isFirst(side) ? parts.reverse() : parts)!;
}

function swapped(parts: readonly Part[], one: number, other: number): Part[] {
  return parts.map((part, at) => (at === one ? parts[other]! : at === other ? parts[one]! : part));
}

function pathTo(node: Node, panel: string): number[] | undefined {
  if (!isSplit(node)) return node.panels.includes(panel) ? [] : undefined;
  for (const [at, part] of node.parts.entries()) {
    const rest = pathTo(part.node, panel);
    if (rest) return [at, ...rest];
  }
  return undefined;
}

function nodeAt(node: Node, path: readonly number[]): Node {
  return path.reduce((at, index) => (isSplit(at) ? at.parts[index]!.node : at), node);
}

function replacedAt(node: Node, path: readonly number[], change: (node: Node) => Node): Node {
  const [index, ...rest] = path;
  if (index === undefined || !isSplit(node)) return change(node);
  const parts = node.parts.map((part, at) => (at === index ? { ...part, node: replacedAt(part.node, rest, change) } : part));
  return split(node.across, parts)!;
}
