// SPDX-License-Identifier: BSD-3-Clause
// Alarms of the same kind of several robots, as one.

import type { Alarm, AlarmKind, PostedAlarm } from "./alarms";

export interface AlarmGroup {
  /** The same as long as it is the same group. */
  readonly key: string;
  readonly kind: AlarmKind;
  /** One stands alone. */
  readonly posted: readonly PostedAlarm[];
  readonly seen: boolean;
  readonly over: boolean;
}

/** What several robots are, and what they were. */
const WORDS: Record<AlarmKind, readonly [now: string, past: string]> = {
  silent: ["silent", "were silent"],
  overrun: ["begin ticks late", "began ticks late"],
  drift: ["run another program than the team", "ran another program than the team"],
  stuck: ["do not move", "did not move"],
  loop: ["go round the same states", "went round the same states"],
  uncertain: ["are not where the map shows them", "were not where the map showed them"],
  problem: ["have problems", "had problems"],
  push: ["did not take a push", "did not take a push"],
  lost: ["did more in a gap than they keep", "did more in a gap than they keep"],
  refused: ["send messages that are not taken", "sent messages that were not taken"],
};
/** What has alarms of a kind, where that need not be robots. */
const NOUNS: Partial<Record<AlarmKind, string>> = { refused: "senders" };

export const robotsOf = ({ posted }: Pick<AlarmGroup, "posted">): string[] => [...new Set(posted.map(({ alarm }) => alarm.robot))];

/** "5 robots silent: io, callisto, europa"; of more robots than `most` the rest is counted: "…, europa and 2 more". */
export function groupWords(group: AlarmGroup, most = Infinity): string {
  const robots = robotsOf(group);
  const left = robots.length > most ? robots.length - most : 0;
  const names = robots.slice(0, robots.length - left).join(", ");
  return `${robots.length} ${NOUNS[group.kind] ?? "robots"} ${WORDS[group.kind][group.over ? 1 : 0]}: ${names}${left > 0 ? ` and ${left} more` : ""}`;
}

/** The board in its order, with the alarms of one kind of several robots together; the seen and those that are over stand apart. */
export function groupedAlarms(board: readonly PostedAlarm[]): AlarmGroup[] {
  const groups = new Map<string, PostedAlarm[]>();
  for (const posted of board) {
    const key = `${posted.alarm.kind}${posted.seen ? " seen" : ""}${posted.over_ms === undefined ? "" : " over"}`;
    groups.set(key, [...(groups.get(key) ?? []), posted]);
  }
  return [...groups].flatMap(([key, posted]) => (robotsOf({ posted }).length > 1 ? [groupOf(key, posted)] : posted.map((one) => groupOf(one.alarm.key, [one]))));
}

function groupOf(key: string, posted: readonly PostedAlarm[]): AlarmGroup {
  const [{ alarm, seen, over_ms }] = posted as readonly [PostedAlarm];
  return { key, kind: alarm.kind, posted, seen, over: over_ms !== undefined };
}

/** What is wrong, in words, of each robot that has an alarm. */
export function wordsByRobot(alarms: readonly Alarm[]): Map<string, string[]> {
  const all = new Map<string, string[]>();
  for (const { robot, words } of alarms) all.set(robot, [...(all.get(robot) ?? []), words]);
  return all;
}
