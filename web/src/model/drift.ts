// SPDX-License-Identifier: BSD-3-Clause
import type { Push, Robot } from "./model";

export interface ProgramShare {
  readonly hash: string;
  readonly name: string;
  readonly robots: readonly string[];
}

/** Which programs run, the one that most robots run first: it is the team's, and the others drift. */
export function programShares(robots: Iterable<Robot>): ProgramShare[] {
  const shares = new Map<string, { hash: string; name: string; robots: string[] }>();
  for (const { name, state } of robots) {
    if (!state?.value.program_hash) continue;
    const { program_hash: hash, program_name } = state.value;
    const share = shares.get(hash) ?? { hash, name: program_name, robots: [] };
    share.robots.push(name);
    shares.set(hash, share);
  }
  return [...shares.values()].sort((a, b) => b.robots.length - a.robots.length);
}

/** A push of which nothing is heard any more is not under way for ever. A probation lasts an hour at most. */
const UNDER_WAY_AT_MOST_MS = 7_200_000;

/** The hashes of the programs that a running push is bringing to the robots: to its canary first, or to one after the other. */
export function hashesUnderWay(pushes: readonly Push[], now_ms: number): ReadonlySet<string> {
  return new Set(pushes.filter(({ state, hash, at_ms }) => state === "running" && hash !== "" && now_ms - at_ms < UNDER_WAY_AT_MOST_MS).map(({ hash }) => hash));
}

/** Whether the robot runs another program than the team. A program that is under way is neither drift nor yet the team's. */
export function drifts(robot: Robot, shares: readonly ProgramShare[], underWay: ReadonlySet<string> = new Set()): boolean {
  const hash = robot.state?.value.program_hash;
  if (!hash || underWay.has(hash) || shares.length < 2) return false;
  return shares.find((share) => !underWay.has(share.hash))?.hash !== hash;
}
