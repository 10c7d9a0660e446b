// SPDX-License-Identifier: BSD-3-Clause
import type { Robot } from "./model";

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

export function drifts(robot: Robot, shares: readonly ProgramShare[]): boolean {
  const hash = robot.state?.value.program_hash;
  return Boolean(hash) && shares.length > 1 && shares[0]?.hash !== hash;
}
