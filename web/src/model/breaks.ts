// SPDX-License-Identifier: BSD-3-Clause
// Where a robot stops between states, and in words why it stands.

import { kindOf } from "../feed/break_kinds";
import { type BreakAnswer, type BreakPoint, type Breaks, Breaks_Constants, type RobotState } from "../feed/messages";
import { type BreakKind, seconds, type StateChange } from "../feed/parts";
import { lasting } from "../lib/format";
import type { Robot } from "./model";

/** What a part of a machine's graph is for a break point: a state is entered, an arrow leads from one to another. */
export function changeOf(part: string): StateChange {
  const [from = "", to] = part.split(" → ");
  return to === undefined ? { from: "", to: part } : { from, to };
}

/** "wander → grab", "on entering grab", "on leaving wander" or "at any change of state": robots and tools have the same words. */
export function changeWords({ from, to }: StateChange): string {
  if (!from) return to ? `on entering ${to}` : "at any change of state";
  return to ? `${from} → ${to}` : `on leaving ${from}`;
}

/** The same as a place: "at wander → grab", "on entering grab" */
export const placeWords = (change: StateChange): string => (change.from && change.to ? `at ${changeWords(change)}` : changeWords(change));

export const changeAt = ({ from_state, to_state }: BreakPoint): StateChange => ({ from: from_state, to: to_state });

/** The kind of the break point of just these two states. */
export function kindAt(breaks: Breaks | undefined, { from, to }: StateChange): BreakKind | undefined {
  const point = breaks?.points.find(({ from_state, to_state }) => from_state === from && to_state === to);
  return point && kindOf(point);
}

/** What it answered to the order of that id; undefined: nothing yet. It tells its answers to the newest orders alone, whoever gave them. */
export function answerTo(breaks: Breaks | undefined, order: string): BreakAnswer | undefined {
  return breaks?.answers.find(({ id }) => id === order);
}

/** The locked change that only waits to be let through. */
export function waitOf(breaks: Breaks | undefined): StateChange | undefined {
  if (!breaks || (!breaks.waits_at_from && !breaks.waits_at_to)) return undefined;
  return { from: breaks.waits_at_from, to: breaks.waits_at_to };
}

const isKnown = ({ from_state, to_state }: BreakPoint): boolean => from_state !== "" || to_state !== "";
const breakPointWords = (point: BreakPoint): string => `break point ${changeWords(changeAt(point))}`;

/** What made it stand: "break point wander → grab", "a step", "io's break point wander → grab" */
function stopper({ stopped_by, break_robot, break_point }: Breaks): string {
  switch (stopped_by) {
    case Breaks_Constants.BREAK_POINT:
      return isKnown(break_point) ? breakPointWords(break_point) : "a break point";
    case Breaks_Constants.STEP:
      return "a step";
    case Breaks_Constants.TEAM:
      return `${break_robot}'s ${isKnown(break_point) ? breakPointWords(break_point) : "break point"}`;
    default:
      return "a reason that this release does not know";
  }
}

/** What made it stand, and whose it was: "break point wander → grab, set by operator" */
export function stopperWords(breaks: Breaks): string {
  const { author, stopped_by } = breaks;
  const did = stopped_by === Breaks_Constants.STEP ? "ordered" : "set";
  return stopper(breaks) + (author && `, ${did} by ${author}`);
}

/** Why a break point or a step holds it: "stopped at wander → grab (Anna's break point)", "stepped into grab" */
export function stopReason({ breaks, transitions }: Pick<Robot, "breaks" | "transitions">): string | undefined {
  if (!breaks?.value.stopped) return undefined;
  const { stopped_at, stopped_by, break_point, author } = breaks.value;
  const change = transitions.find(({ number }) => number === stopped_at);
  if (stopped_by === Breaks_Constants.STEP) return change ? `stepped into ${change.to_state}` : "stopped after a step";
  if (stopped_by !== Breaks_Constants.BREAK_POINT) return `stopped by ${stopperWords(breaks.value)}`;
  const place = change ? placeWords({ from: change.from_state, to: change.to_state }) : isKnown(break_point) ? placeWords(changeAt(break_point)) : "at a break point";
  return `stopped ${place}${author && ` (${author}'s break point)`}`;
}

/** What a robot tells about why it stands. */
type Stands = Pick<Robot, "breaks" | "transitions"> & Partial<Pick<Robot, "state">>;

/** After which fault a robot is held, which it says among its problems: "held: the serial line was gone for 3.2 s; …" */
export function faultIn({ held, problems }: RobotState): string | undefined {
  return held ? problems.find((problem) => problem.startsWith("held: ")) : undefined;
}

export const faultReason = ({ state }: Partial<Pick<Robot, "state">>): string | undefined => state && faultIn(state.value);

/** Why it stands, or what it waits for, without for how long; undefined: no fault, break point, step or lock keeps it. */
export function standReason(robot: Stands): string | undefined {
  const wait = waitOf(robot.breaks?.value);
  return faultReason(robot) ?? stopReason(robot) ?? (wait && `waits at the lock ${changeWords(wait)}`);
}

/** The same with for how long it waits, and what a step is that is under way; GET /api/team says it so, too. */
export function breakReason(robot: Stands, now_ms: number): string | undefined {
  const { breaks } = robot;
  const reason = standReason(robot);
  if (!breaks || breaks.value.stopped || faultReason(robot)) return reason;
  if (!reason) return breaks.value.stepping ? "goes on until its next change of state" : undefined;
  const waits_s = seconds(breaks.value.stamp) - seconds(breaks.value.waits_since) + (now_ms - breaks.received_ms) / 1000;
  return `${reason} for ${lasting(waits_s)}`;
}
