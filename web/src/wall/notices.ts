// SPDX-License-Identifier: BSD-3-Clause
// What a wall says in its widest letters: what is wrong with the connection, and what is wrong with the robots.

import { lasting, plural } from "../lib/format";
import { groupedAlarms, groupWords } from "../model/alarm_groups";
import { type PostedAlarm, sentenceOf } from "../model/alarms";
import type { Robot } from "../model/model";
import { isSilent } from "../model/silence";

export interface Notice {
  readonly kind: "connection" | "recording" | "alarm" | "held";
  readonly words: string;
}

/** What the page knows of its connection; times in ms. */
export interface Link {
  /** Whether the monitor was heard at all since the page was opened. */
  readonly wasLive: boolean;
  readonly lostFor_ms: number | undefined;
  readonly behind_ms: number;
  readonly isBehind: boolean;
}

/** So many lines of alarms have room; of more, their number is told. */
const LINES = 2;
/** So many names have room in a line. */
const NAMES = 4;

export function linkNotice({ wasLive, lostFor_ms, behind_ms, isBehind }: Link): Notice | undefined {
  const of = (words: string): Notice => ({ kind: "connection", words });
  if (!wasLive) return of(lostFor_ms === undefined ? "Connecting to the monitor…" : `The monitor does not answer, for ${lasting(lostFor_ms / 1000)}.`);
  if (lostFor_ms !== undefined) return of(`Nothing heard for ${lasting(lostFor_ms / 1000)}: this page is ${lasting(behind_ms / 1000)} behind.`);
  return isBehind ? of(`This page is ${lasting(behind_ms / 1000)} behind.`) : undefined;
}

/** What the page tells of the recording that it plays: why it is not shown, or what is wrong with it. */
export function replayNotice(trouble: string | undefined, isOpened: boolean): Notice | undefined {
  return trouble === undefined ? undefined : { kind: isOpened ? "recording" : "connection", words: trouble };
}

/** Those that last, grouped as in the team's panel; nobody is there to say that one was seen. */
export function alarmNotices(posted: readonly PostedAlarm[], now_ms: number): Notice[] {
  const groups = groupedAlarms(posted.filter(({ over_ms }) => over_ms === undefined));
  const told = groups.slice(0, groups.length > LINES ? LINES - 1 : LINES);
  const words = told.map((group) => (group.posted.length > 1 ? groupWords(group, NAMES) : sentenceOf(group.posted[0]!, now_ms)));
  const left = groups.slice(told.length).reduce((count, group) => count + group.posted.length, 0);
  return [...words, ...(left > 0 ? [plural(left, "more alarm")] : [])].map((each) => ({ kind: "alarm", words: `${each}.` }));
}

/** "callisto is silent", "callisto and io are silent", "6 robots are silent" */
function unknownWords(names: readonly string[], one: string, several: string): string[] {
  if (names.length === 0) return [];
  const named = [names.slice(0, -1).join(", "), names.at(-1)].filter(Boolean).join(" and ");
  return [`${names.length > NAMES ? `${names.length} robots` : named} ${names.length === 1 ? one : several}`];
}

/** All that are in service and heard stand still at somebody's word; of the others nobody knows, which is said. */
export function heldNotice(robots: readonly Robot[], known_ms: number): Notice | undefined {
  const silent = robots.filter((robot) => isSilent(robot, known_ms));
  const heard = robots.filter((robot) => !silent.includes(robot) && !robot.state?.value.out_of_service);
  const held = heard.filter(({ state }) => state?.value.held);
  const unheard = heard.filter(({ state }) => !state);
  if (held.length === 0 || held.length + unheard.length < heard.length) return undefined;
  const names = (some: readonly Robot[]) => some.map(({ name }) => name);
  const rest = [...unknownWords(names(silent), "is silent", "are silent"), ...unknownWords(names(unheard), "has told no state yet", "have told no state yet")];
  const all = held.length === 1 ? "The robot is held" : "All robots are held";
  const some = `${plural(held.length, "robot")} ${held.length === 1 ? "is" : "are"} held`;
  return { kind: "held", words: `${[rest.length > 0 ? some : all, ...rest].join("; ")}.` };
}
