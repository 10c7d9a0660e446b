// SPDX-License-Identifier: BSD-3-Clause
// Where the labels of the map's items stand, in pixels, y down: beside their item, and none over another or over a robot.
import { ASCENT_PX, type Box, DESCENT_PX, EVERYWHERE, isWithin, overlap, textBox } from "./text_box";

export const sides = ["right", "left", "below", "above"] as const;
export type LabelSide = (typeof sides)[number];

export interface Label {
  readonly key: string;
  readonly text: string;
  /** The middle of its item, and how far the item reaches around it. */
  readonly x: number;
  readonly y: number;
  readonly reach: number;
  /** It is shown whatever lies there: somebody chose its item or points at it. */
  readonly must?: boolean;
  /** It tells of trouble: it is shown whatever lies there, and only those of choice come before it. */
  readonly urgent?: boolean;
  /** Other labels keep clear of its item. */
  readonly solid?: boolean;
}

/** A label's left end and its line. */
export interface LabelPlace {
  readonly dx: number;
  readonly dy: number;
}

const LETTER_PX = 6.4;
const GAP_PX = 3;

const widthOf = (text: string) => text.length * LETTER_PX;

/** Where its text begins, from the middle of its item. */
export function placeOf({ text, reach }: Label, side: LabelSide): LabelPlace {
  const [width, off] = [widthOf(text), reach + GAP_PX];
  if (side === "right") return { dx: off, dy: DESCENT_PX + 1 };
  if (side === "left") return { dx: -off - width, dy: DESCENT_PX + 1 };
  return { dx: -width / 2, dy: side === "below" ? off + ASCENT_PX : -off };
}

function boxOf(label: Label, side: LabelSide): Box {
  const { dx, dy } = placeOf(label, side);
  return textBox(label.x + dx, label.y + dy, widthOf(label.text));
}

/**
 * The side of each label that finds room. Those that must be shown come first, then the urgent, then those that stand
 * already, then the others, each in the order given. One that stands keeps its side while it is free: so nothing flickers.
 * None is cut at the edge of the `room` that is seen, unless it must be shown and is cut wherever it stands.
 */
export function placeLabels(labels: readonly Label[], before: ReadonlyMap<string, LabelSide> = new Map(), room: Box = EVERYWHERE): ReadonlyMap<string, LabelSide> {
  const bodies = labels.filter(({ solid }) => solid).map(({ key, x, y, reach }) => ({ key, left: x - reach, right: x + reach, top: y - reach, bottom: y + reach }));
  const taken: Box[] = [];
  const placed = new Map<string, LabelSide>();
  const rank = ({ key, must, urgent }: Label) => (must ? 0 : urgent ? 1 : before.has(key) ? 2 : 3);
  for (const label of [...labels].sort((a, b) => rank(a) - rank(b))) {
    const stood = before.get(label.key);
    const tried = stood ? [stood, ...sides.filter((side) => side !== stood)] : sides;
    const isSeen = (side: LabelSide) => isWithin(boxOf(label, side), room);
    const isFree = (side: LabelSide) => {
      const box = boxOf(label, side);
      return isSeen(side) && !taken.some((other) => overlap(box, other)) && !bodies.some((body) => body.key !== label.key && overlap(box, body));
    };
    const side = tried.find(isFree) ?? (label.must || label.urgent ? (tried.find(isSeen) ?? tried[0]) : undefined);
    if (!side) continue;
    placed.set(label.key, side);
    taken.push(boxOf(label, side));
  }
  return placed;
}
