// SPDX-License-Identifier: BSD-3-Clause
// Where an arrangement's stacks and the borders between them stand, in shares of the whole page.

import { type Across, isSplit, type Node, panelsIn, type Side, type Stack } from "./tree";

export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface PlacedStack extends Box {
  readonly stack: Stack;
}

/** Between two neighbours in a split; moving it makes one larger and the other smaller. */
export interface Border extends Box {
  readonly across: Across;
  /** Of the split, and the neighbour before the border. */
  readonly path: readonly number[];
  readonly index: number;
  /** The split's own length, in shares of the page. */
  readonly length: number;
  /** How much of both neighbours the one before it has. */
  readonly value: number;
  readonly between: readonly [string, string];
}

const WHOLE: Box = { x: 0, y: 0, width: 1, height: 1 };

export function placesOf(node: Node, box: Box = WHOLE): PlacedStack[] {
  if (!isSplit(node)) return [{ ...box, stack: node }];
  return boxesOf(node, box).flatMap((part, i) => placesOf(node.parts[i]!.node, part));
}

export function bordersOf(node: Node, box: Box = WHOLE, path: readonly number[] = []): Border[] {
  if (!isSplit(node)) return [];
  const boxes = boxesOf(node, box);
  const inner = node.parts.flatMap((part, i) => bordersOf(part.node, boxes[i]!, [...path, i]));
  const own = boxes.slice(1).map((after, index): Border => {
    const { across } = node;
    const [before, next] = [node.parts[index]!, node.parts[index + 1]!];
    const between = [panelsIn(before.node)[0]!, panelsIn(next.node)[0]!] as const;
    const edge = across === "row" ? { ...after, width: 0 } : { ...after, height: 0 };
    return { ...edge, across, path, index, between, length: across === "row" ? box.width : box.height, value: before.share / (before.share + next.share) };
  });
  return [...own, ...inner];
}

function boxesOf(node: Extract<Node, { parts: unknown }>, box: Box): Box[] {
  let passed = 0;
  return node.parts.map(({ share }) => {
    const from = passed;
    passed += share;
    return node.across === "row"
      ? { ...box, x: box.x + from * box.width, width: share * box.width }
      : { ...box, y: box.y + from * box.height, height: share * box.height };
  });
}

export interface Drop {
  readonly target: PlacedStack;
  /** The half of the target that is taken; "middle": a tab of it. */
  readonly where: Side | "middle";
  /** What of the page would be taken. */
  readonly box: Box;
}

/** How near a stack's side counts as beside it. */
const RIM = 0.26;

/** What letting go at a point of the page would do. */
export function dropAt(places: readonly PlacedStack[], x: number, y: number): Drop | undefined {
  const target = places.find((place) => x >= place.x && x < place.x + place.width && y >= place.y && y < place.y + place.height);
  if (!target) return undefined;
  const [across, down] = [(x - target.x) / target.width, (y - target.y) / target.height];
  const distances: [Side, number][] = [
    ["left", across],
    ["right", 1 - across],
    ["up", down],
    ["down", 1 - down],
  ];
  const [side, distance] = distances.reduce((nearest, each) => (each[1] < nearest[1] ? each : nearest));
  const where = distance < RIM ? side : "middle";
  return { target, where, box: halfOf(target, where) };
}

function halfOf({ x, y, width, height }: Box, where: Side | "middle"): Box {
  const half = { width: width / 2, height: height / 2 };
  if (where === "left") return { x, y, width: half.width, height };
  if (where === "right") return { x: x + half.width, y, width: half.width, height };
  if (where === "up") return { x, y, width, height: half.height };
  if (where === "down") return { x, y: y + half.height, width, height: half.height };
  return { x, y, width, height };
}
