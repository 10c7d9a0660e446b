// SPDX-License-Identifier: BSD-3-Clause
// Where the names of a robot's forces stand beside their arrows, in pixels from the robot, y down.

export interface Arrow {
  readonly schema: string;
  /** Its tip. */
  readonly x: number;
  readonly y: number;
  readonly strength: number;
}

export interface ForceName {
  readonly x: number;
  readonly y: number;
  readonly anchor: "start" | "end";
}

const LETTER_PX = 6.2;
const ASCENT_PX = 9;
const DESCENT_PX = 3;
const BESIDE_PX = 4;

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

function boxOf({ x, y, anchor }: ForceName, text: string): Box {
  const left = anchor === "start" ? x : x - text.length * LETTER_PX;
  return { left, right: left + text.length * LETTER_PX, top: y - ASCENT_PX, bottom: y + DESCENT_PX };
}

const overlap = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

function beside({ x, y }: Arrow): ForceName {
  return { x: x + Math.sign(x) * BESIDE_PX, y: y + (y > 0 ? ASCENT_PX + 2 : -BESIDE_PX), anchor: x < 0 ? "end" : "start" };
}

/** By schema; the stronger first, and none over another: a name that finds no room is left out. */
export function placeNames(arrows: readonly Arrow[]): ReadonlyMap<string, ForceName> {
  const names = new Map<string, ForceName>();
  const taken: Box[] = [];
  for (const arrow of [...arrows].sort((a, b) => b.strength - a.strength)) {
    const name = beside(arrow);
    const box = boxOf(name, arrow.schema);
    if (taken.some((other) => overlap(box, other))) continue;
    taken.push(box);
    names.set(arrow.schema, name);
  }
  return names;
}
