// SPDX-License-Identifier: BSD-3-Clause
// Where the names of a robot's forces stand beside their arrows, in pixels from the robot, y down.
import { ASCENT_PX, type Box, EVERYWHERE, isWithin, overlap, textBox } from "./text_box";

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
const BESIDE_PX = 4;

function boxOf({ x, y, anchor }: ForceName, text: string): Box {
  const width_px = text.length * LETTER_PX;
  return textBox(anchor === "start" ? x : x - width_px, y, width_px);
}

/** Beyond the tip, or where the map ends there, from the tip inwards. */
function beside({ x, y }: Arrow): ForceName[] {
  const outwards = x < 0 ? "end" : "start";
  const line = y + (y > 0 ? ASCENT_PX + 2 : -BESIDE_PX);
  return [
    { x: x + Math.sign(x) * BESIDE_PX, y: line, anchor: outwards },
    { x, y: line, anchor: outwards === "end" ? "start" : "end" },
  ];
}

/**
 * By schema; the stronger first, none over another, and none cut at the edge of the `room` that is seen: a name that finds
 * no place is left out.
 */
export function placeNames(arrows: readonly Arrow[], room: Box = EVERYWHERE): ReadonlyMap<string, ForceName> {
  const names = new Map<string, ForceName>();
  const taken: Box[] = [];
  for (const arrow of [...arrows].sort((a, b) => b.strength - a.strength)) {
    const name = beside(arrow).find((each) => isWithin(boxOf(each, arrow.schema), room));
    if (!name) continue;
    const box = boxOf(name, arrow.schema);
    if (taken.some((other) => overlap(box, other))) continue;
    taken.push(box);
    names.set(arrow.schema, name);
  }
  return names;
}
