// SPDX-License-Identifier: BSD-3-Clause
// Who may steer which robot, as the monitor tells it.

import type { LeaseChange } from "../feed/messages";
import { listed } from "../lib/format";
import type { RobotEvent } from "./events";
import type { Robot, Team } from "./model";

/** An operator: a name with the token that it came with. Its tabs and processes are one. */
export interface OperatorId {
  readonly name: string;
  readonly account: string;
}

/** A robot that somebody holds. */
export interface Lease {
  readonly robot: string;
  readonly holder: OperatorId;
  readonly asker: OperatorId | null;
  /** Then it goes to who asks, unless the holder answers. */
  readonly answer_within_s: number | null;
}

export const isSame = (a: OperatorId | null | undefined, b: OperatorId | null | undefined): boolean =>
  a != null && b != null && a.name === b.name && a.account === b.account;

/** The robots that an order is for; none are named: the team's, but those that a recording plays. */
function meant(team: Team, robots: readonly string[]): readonly string[] {
  return robots.length > 0 ? robots : [...team.robots.keys()].filter((name) => !team.replayed.has(name));
}

/** Why `me` may not steer them, and what to do; undefined: it may, or it is not known who `me` is, and the monitor says. */
export function leaseObjection(team: Team, robots: readonly string[], me: OperatorId | undefined): string | undefined {
  if (!me || !team.leases) return undefined;
  const wanted = new Set(meant(team, robots));
  const others = team.leases.filter(({ robot, holder }) => wanted.has(robot) && !isSame(holder, me));
  if (others.length === 0) return undefined;
  const byHolder = new Map<string, string[]>();
  for (const { robot, holder } of others) byHolder.set(holder.name, [...(byHolder.get(holder.name) ?? []), robot]);
  const who = [...byHolder].map(([holder, theirs]) => `${holder} holds ${listed(theirs)}`).join(", ");
  return `${who}. Ask for ${others.length === 1 ? "it" : "them"} in the panel Team, or take over with a reason.`;
}

const KEPT = 200;

/** The robot with a change of its lease among what happened to it. The same change comes again when the page has connected
 *  anew, and when the monitor tells it for who joined later. */
function withLeaseEvent(robot: Robot, { id, text }: LeaseChange, at_ms: number): Robot {
  if (robot.events.some((each) => each.id === id)) return robot;
  const event: RobotEvent = { at_ms, kind: "lease", words: `lease: ${text}`, id };
  return { ...robot, events: [...robot.events, event].slice(-KEPT) };
}

/** A robot that is not known yet gets no row by a change of its lease alone. */
export function withLeaseChange(team: Team, change: LeaseChange, at_ms: number): Team {
  const robot = team.robots.get(change.robot);
  if (!robot) return team;
  const changed = withLeaseEvent(robot, change, at_ms);
  return changed === robot ? team : { ...team, robots: new Map(team.robots).set(change.robot, changed) };
}
