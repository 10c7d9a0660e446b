// SPDX-License-Identifier: BSD-3-Clause
import { withJoined } from "./gaps";
import type { Robot, Team } from "./model";

/** State comes ten times a second: two seconds without any are no hiccup. */
export const SILENT_AFTER_S = 2;
/** So long a busy page may take until it reads all that it has asked the monitor for. */
const BEGINNING_MS = 2000;

/** Seconds without a word since the page, itself up to date, began to listen: what it is handed first may be minutes old. */
function unheard_s({ heard_ms, watched_ms = heard_ms }: Robot, now_ms: number): number {
  return Math.max((now_ms - Math.max(heard_ms, watched_ms)) / 1000, 0);
}

/** Seconds since the robot was last heard, by us or by the monitor, whichever knows of longer. */
export function age_s(robot: Robot, now_ms: number): number {
  const ours_s = isSilent(robot, now_ms) ? Math.max((now_ms - robot.heard_ms) / 1000, 0) : unheard_s(robot, now_ms);
  return robot.placed?.silent ? Math.max(ours_s, robot.placed.age_s) : ours_s;
}

/** The names of those that are silent. */
export function silentIn(robots: Iterable<Robot>, now_ms: number): ReadonlySet<string> {
  return new Set([...robots].filter((robot) => isSilent(robot, now_ms)).map(({ name }) => name));
}

/** By the monitor's word, or by the page's own, once it has listened for so long. */
export function isSilent(robot: Robot, now_ms: number): boolean {
  return robot.placed?.silent === true || unheard_s(robot, now_ms) > SILENT_AFTER_S;
}

function withRobots(team: Team, changed: readonly Robot[]): Team {
  if (changed.length === 0) return team;
  const robots = new Map(team.robots);
  for (const robot of changed) robots.set(robot.name, robot);
  return { ...team, robots };
}

function withWatched(team: Team, watchedOf: (robot: Robot) => number): Team {
  const changed = [...team.robots.values()].filter((robot) => robot.watched_ms !== watchedOf(robot));
  return withRobots(team, changed.map((robot) => ({ ...robot, watched_ms: watchedOf(robot) })));
}

/** The monitor is heard no more: of those that were silent, it is kept since when. */
export function withSilencesUntil(team: Team, known_ms: number): Team {
  const silent = [...team.robots.values()].filter((robot) => isSilent(robot, known_ms));
  return withRobots(team, silent.map((robot) => ({ ...robot, silences: withJoined(robot.silences ?? [], { from_ms: robot.heard_ms, to_ms: known_ms }) })));
}

/** Another connection begins: how long nobody was heard on it is not known before the page is up to date. */
export function unwatched(team: Team): Team {
  return withWatched(team, () => Infinity);
}

/** The page knows how all stood at `told_ms`; 0: it has not been told all yet. */
export function watched(team: Team, told_ms: number): Team {
  const begins_ms = told_ms > 0 ? told_ms + BEGINNING_MS : Infinity;
  return withWatched(team, ({ watched_ms = Infinity }) => (watched_ms < Infinity ? watched_ms : begins_ms));
}
