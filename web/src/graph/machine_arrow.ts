// SPDX-License-Identifier: BSD-3-Clause
// An arrow from one state to another, bent round the states between.

export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

interface Point {
  readonly x: number;
  readonly y: number;
}

/** How far an arrow bends aside, in the order of preference: to its right first, so that two that lead back and forth part. */
const BENDS_PX = [9, 26, -26, 44, -44, 70, -70, 100, -100];
/** Of a self-loop. */
const LOOP_PX = 16;
const CLEARANCE_PX = 3;
const SAMPLES = [0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8];

const middle = ({ x, y, width, height }: Box): Point => ({ x: x + width / 2, y: y + height / 2 });
const round = ({ x, y }: Point): string => `${x.toFixed(1)},${y.toFixed(1)}`;

/** Where the line from a box's middle towards a point leaves the box. */
function border(box: Box, towards: Point): Point {
  const { x, y } = middle(box);
  const [dx, dy] = [towards.x - x, towards.y - y];
  const scale = Math.min(box.width / 2 / Math.max(Math.abs(dx), 1e-6), box.height / 2 / Math.max(Math.abs(dy), 1e-6), 1);
  return { x: x + dx * scale, y: y + dy * scale };
}

function isIn({ x, y, width, height }: Box, point: Point): boolean {
  const c = CLEARANCE_PX;
  return point.x > x - c && point.x < x + width + c && point.y > y - c && point.y < y + height + c;
}

function at(from: Point, control: Point, to: Point, t: number): Point {
  const [a, b, c] = [(1 - t) ** 2, 2 * t * (1 - t), t ** 2];
  return { x: a * from.x + b * control.x + c * to.x, y: a * from.y + b * control.y + c * to.y };
}

/** An SVG path; `all` are the states that it had better not cross. */
export function arrowPath(from: Box, to: Box, all: readonly Box[]): string {
  const [start, end] = [middle(from), middle(to)];
  if (from === to) return loop(from);
  const [dx, dy] = [end.x - start.x, end.y - start.y];
  const length = Math.max(Math.hypot(dx, dy), 1);
  const others = all.filter((box) => box !== from && box !== to);
  let best = { path: "", crossed: Number.POSITIVE_INFINITY };
  for (const bend of BENDS_PX) {
    const control = { x: (start.x + end.x) / 2 - (dy / length) * bend * 2, y: (start.y + end.y) / 2 + (dx / length) * bend * 2 };
    const [leave, arrive] = [border(from, control), border(to, control)];
    const crossed = SAMPLES.filter((t) => others.some((box) => isIn(box, at(leave, control, arrive, t)))).length;
    if (crossed < best.crossed) best = { path: `M${round(leave)} Q${round(control)} ${round(arrive)}`, crossed };
    if (crossed === 0) break;
  }
  return best.path;
}

function loop({ x, y, width, height }: Box): string {
  const right = x + width;
  return `M${round({ x: right - 12, y })} C${round({ x: right - 8, y: y - LOOP_PX })} ${round({ x: right + LOOP_PX, y: y - 4 })} ${round({ x: right, y: y + height / 2 })}`;
}

/** The point of an arrow's path at that share of its way, for what stands on it. */
export function pointOn(path: string, share: number): Point {
  const numbers = (path.match(/-?[\d.]+/g) ?? []).map(Number);
  let points: Point[] = numbers.flatMap((x, i) => (i % 2 === 0 ? [{ x, y: numbers[i + 1]! }] : []));
  // De Casteljau's: between the points, again and again, until one is left.
  while (points.length > 1)
    points = points.slice(1).map(({ x, y }, i) => ({ x: points[i]!.x + (x - points[i]!.x) * share, y: points[i]!.y + (y - points[i]!.y) * share }));
  return points[0]!;
}

/** The middle of an arrow's path. */
export const middleOf = (path: string): Point => pointOn(path, 0.5);
