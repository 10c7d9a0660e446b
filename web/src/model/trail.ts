// SPDX-License-Identifier: BSD-3-Clause
import type { Pose, TrailPoint } from "./model";

const STEP_M = 0.04;
const KEPT_MS = 60_000;
/** A robot that jumps farther was put elsewhere, or its place was found to be another. */
const JUMP_M = 0.6;

/** The trail with the point where it moved to; a minute of it is kept. */
export function withPoint(trail: readonly TrailPoint[], point: TrailPoint): readonly TrailPoint[] {
  const last = trail.at(-1);
  if (last && Math.hypot(point.x_m - last.x_m, point.y_m - last.y_m) < STEP_M) return trail;
  const first = trail.findIndex((kept) => kept.at_ms >= point.at_ms - KEPT_MS);
  return [...(first < 0 ? [] : trail.slice(first)), point];
}

/** Whether nobody knows how a robot came from one point of its trail to the next. */
export function unknownSince(before: TrailPoint, point: TrailPoint): boolean {
  return Math.hypot(point.x_m - before.x_m, point.y_m - before.y_m) > JUMP_M;
}

/** The pose with its heading counted on from the one before, by the short way round. */
export function unwound(before: Pose | undefined, next: Pose): Pose {
  if (!before) return { x_m: next.x_m, y_m: next.y_m, heading_rad: next.heading_rad };
  const turn = next.heading_rad - before.heading_rad;
  const heading_rad = before.heading_rad + Math.atan2(Math.sin(turn), Math.cos(turn));
  return { x_m: next.x_m, y_m: next.y_m, heading_rad };
}
