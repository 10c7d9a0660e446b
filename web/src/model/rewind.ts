// SPDX-License-Identifier: BSD-3-Clause
// What is still known of a team when a recording goes on from another instant: what happened until then. How everything
// stood then is told anew, and what was told of it before is of another instant.

import type { Gap } from "./gaps";
import type { History, Instant } from "./history";
import { emptyTeam, type Robot, type Team } from "./model";
import { apply } from "./reduce";
import { onPageClock_ms } from "./robot_clock";

/** What was jumped over and is shorter is no gap that anybody sees. */
const GAP_MS = 1000;

/** What a robot did, without how it stands. */
function past({ name, identity, heard_ms, clock_offset_ms, catalog, stops, transitions, moments, coverages, bars, silences, programs, events }: Robot): Robot {
  return {
    name, identity, heard_ms, transitions, moments, bars, programs, events, trail: [],
    ...(clock_offset_ms !== undefined && { clock_offset_ms }),
    ...(catalog && { catalog }),
    ...(stops && { stops }),
    ...(silences && { silences }),
    ...(coverages && { coverages }),
  };
}

const pastOf = ({ robots, replayed, pushes, instructions }: Team): Team => ({ replayed, robots: new Map([...robots].map(([name, robot]) => [name, past(robot)])), pushes, instructions });

/** The team that was kept of some instant, with what happened from then until `to_ms`, of which a later team knows. */
function caughtUp({ team, at_ms: kept_ms }: Instant, later: Team, to_ms: number): Team {
  const isBetween = ({ at_ms }: { readonly at_ms: number }) => at_ms > kept_ms && at_ms <= to_ms;
  let next = team;
  for (const robot of later.robots.values()) {
    const last = team.robots.get(robot.name)?.transitions.at(-1)?.number ?? -1n;
    for (const change of robot.transitions) {
      const at_ms = onPageClock_ms(robot, change.stamp);
      if (change.number > last && at_ms <= to_ms) next = apply(next, `/${robot.name}/transition`, change, at_ms);
    }
  }
  const robots = new Map([...next.robots].map(([name, robot]): [string, Robot] => {
    const known = later.robots.get(name);
    const numbers = new Set(robot.transitions.map(({ number }) => number));
    const stops = new Map([...(known?.stops ?? [])].filter(([number]) => numbers.has(number)));
    const events = [...robot.events, ...(known?.events ?? []).filter(isBetween)];
    const programs = [...robot.programs, ...(known?.programs ?? []).filter(isBetween)];
    const silences = gapsUntil(known?.silences ?? [], to_ms, to_ms);
    return [name, { ...robot, events, programs, stops, silences }];
  }));
  const begun = later.pushes.filter(isBetween).map((push) => ({ ...push, replies: new Map(), steps: [], state: "" }));
  return { ...next, robots, pushes: [...team.pushes, ...begun], instructions: later.instructions.filter(({ at_ms }) => at_ms <= to_ms) };
}

export interface Rewound {
  readonly team: Team;
  readonly gaps: readonly Gap[];
}

/**
 * What is known at `to_ms` of a recording that was heard until `from_ms`, when `team` was as it was then; nothing where
 * that instant was not heard. Forgets of `history` what is newer.
 */
export function rewound({ team, gaps }: Rewound, history: History, from_ms: number, to_ms: number): Rewound {
  const kept = (history.earliest_ms ?? Number.POSITIVE_INFINITY) <= to_ms ? history.at(to_ms) : undefined;
  if (!kept) {
    history.clear();
    return { team: emptyTeam, gaps: [] };
  }
  const known = to_ms < from_ms ? caughtUp(kept, team, to_ms) : team;
  history.forgetAfter(to_ms);
  return { team: pastOf(known), gaps: gapsUntil(gaps, from_ms, to_ms) };
}

function gapsUntil(gaps: readonly Gap[], from_ms: number, to_ms: number): readonly Gap[] {
  const cut = gaps.filter((gap) => gap.from_ms < to_ms).map((gap) => (gap.to_ms > to_ms ? { ...gap, to_ms } : gap));
  return to_ms - from_ms > GAP_MS ? [...cut, { from_ms, to_ms }] : cut;
}
