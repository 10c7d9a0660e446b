// SPDX-License-Identifier: BSD-3-Clause
// What happened to a robot besides its changes of state, read from how its state differs from the one before.

import type { RefereeCall, RobotState, Score } from "../feed/messages";
import { faultIn } from "./breaks";
import type { Stamped } from "./model";

export interface RobotEvent {
  readonly at_ms: number;
  readonly kind: "held" | "stopped" | "resumed" | "problem" | "well" | "decommissioned" | "commissioned" | "late" | "lease";
  readonly words: string;
  /** Of the message that told it, where that may come again. */
  readonly id?: string;
}

const KEPT = 200;

/** `isStopped`: a break point or a step made it stand, which is told as that. So is a fault, among the problems. */
function differences(before: RobotState, now: RobotState, isStopped: boolean): Omit<RobotEvent, "at_ms">[] {
  const events: Omit<RobotEvent, "at_ms">[] = [];
  if (now.held && !before.held && !isStopped && !faultIn(now)) events.push({ kind: "held", words: "was told to hold, and stands still" });
  if (!now.held && before.held) events.push({ kind: "resumed", words: "was told to go on" });
  if (now.out_of_service !== before.out_of_service) {
    if (now.out_of_service) events.push({ kind: "decommissioned", words: "was taken out of service" });
    else events.push({ kind: "commissioned", words: "was put into service again" });
  }
  for (const problem of now.problems) if (!before.problems.includes(problem)) events.push({ kind: "problem", words: problem });
  if (before.problems.length > 0 && now.problems.length === 0) events.push({ kind: "well", words: "has no problem any more" });
  if (now.overruns > before.overruns) events.push({ kind: "late", words: `a tick began late (${now.overruns} so far)` });
  return events;
}

/** The list with what the newest state tells. */
export function withEvents(list: readonly RobotEvent[], before: RobotState | undefined, now: RobotState, at_ms: number, isStopped = false): readonly RobotEvent[] {
  const news = before ? differences(before, now, isStopped) : [];
  return news.length === 0 ? list : [...list, ...news.map((event) => ({ ...event, at_ms }))].slice(-KEPT);
}

/** A robot's state and why it stands are told by two messages, the later one within this. */
const TOLD_WITHIN_MS = 1500;

/** The list with what stopped the robot, in place of a hold that was the same. */
export function withStopEvent(list: readonly RobotEvent[], words: string, at_ms: number): readonly RobotEvent[] {
  const isSame = ({ kind, at_ms: other_ms }: RobotEvent) => kind === "held" && at_ms - other_ms <= TOLD_WITHIN_MS;
  const others = list.at(-1) && isSame(list.at(-1)!) ? list.slice(0, -1) : list;
  return [...others, { at_ms, kind: "stopped" as const, words }].slice(-KEPT);
}

/** When the contest's clock was at 0, by the page's clock: as the referee told it while the clock ran. */
export function contestBegan_ms(before_ms: number | undefined, { phase, elapsed_s }: Score, received_ms: number): number | undefined {
  if (phase !== "running") return before_ms;
  const now_ms = received_ms - elapsed_s * 1000;
  const jumped = before_ms === undefined || Math.abs(now_ms - before_ms) > 2000;
  return jumped ? now_ms : Math.min(before_ms, now_ms);
}

export interface PlacedCall extends RefereeCall {
  readonly at_ms: number;
}

/** The referee's calls on one robot, in the page's time. */
export function callsOn(robot: string, score: Stamped<Score> | undefined, began_ms: number | undefined): PlacedCall[] {
  if (!score || began_ms === undefined) return [];
  return score.value.calls.filter((call) => call.robot === robot).map((call) => ({ ...call, at_ms: began_ms + call.elapsed_s * 1000 }));
}
