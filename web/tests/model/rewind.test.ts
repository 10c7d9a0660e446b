// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it } from "vitest";
import { History } from "../../src/model/history";
import type { Team } from "../../src/model/model";
import { rewound } from "../../src/model/rewind";
import { robotOf, state, T0_MS, told, transition } from "./told";

const at = (after_s: number) => T0_MS + after_s * 1000;
let history: History;
let team: Team;

/** A robot that is heard each second until then, and changes its state each ten seconds, in the middle of a second. */
function play(until_s: number): void {
  for (let s = 0; s <= until_s; s += 1) {
    const changes = Math.floor((s + 9.5) / 10);
    if (s > 0 && (s - 1) % 10 === 0) team = told([["/io/transition", transition(changes, `state${changes}`, at(s - 0.5)), at(s - 0.5)]], team);
    const problems = s === 25 ? ["no picture"] : [];
    team = told([["/io/state", state({ at_ms: at(s), state: `state${changes}`, state_since: { sec: at(Math.max(changes * 10 - 9.5, 0)) / 1000, nsec: 0 }, transitions: BigInt(changes), problems }), at(s)]], team);
    history.record(team, at(s));
  }
}
const known = () => robotOf(team);
const numbers = () => known().transitions.map(({ number }) => Number(number));

beforeEach(() => {
  [history, team] = [new History(), told([])];
  play(40);
  expect(numbers()).toEqual([1, 2, 3, 4]);
});

describe("a recording that goes back", () => {
  const back = (to_s: number) => ({ team } = rewound({ team, gaps: [] }, history, at(40), at(to_s)));

  it("knows what happened until then and nothing newer", () => {
    back(24);
    expect(numbers()).toEqual([1, 2, 3]);
    expect(known().bars.at(-1)?.state).toBe("state3");
    expect(known().events).toEqual([]);
    expect(history.instants.every(({ at_ms }) => at_ms <= at(24))).toBe(true);
  });
  it("knows what happened between the instant that was kept and the one that it goes to", () => {
    back(20.6);
    expect(numbers()).toEqual([1, 2, 3]);
    back(20.4);
    expect(numbers()).toEqual([1, 2]);
  });
  it("says nothing of how things stand until that is told anew", () => {
    back(24);
    expect([known().state, known().variables, known().sightings, known().program, team.objects, team.score]).toEqual(Array(6).fill(undefined));
    expect(known().trail).toEqual([]);
  });
  it("knows nothing where it was never heard", () => {
    const before = rewound({ team, gaps: [{ from_ms: at(1), to_ms: at(2) }] }, history, at(40), at(-5));
    expect([before.team.robots.size, before.gaps, history.instants]).toEqual([0, [], []]);
  });
});

describe("a recording that goes on from later", () => {
  it("keeps what happened, with a gap over what was jumped over", () => {
    const { team: then, gaps } = rewound({ team, gaps: [] }, history, at(40), at(90));
    expect(robotOf(then).transitions).toHaveLength(4);
    expect(robotOf(then).state).toBeUndefined();
    expect(gaps).toEqual([{ from_ms: at(40), to_ms: at(90) }]);
  });
  it("has no gap for a step", () => {
    expect(rewound({ team, gaps: [] }, history, at(40), at(40.1)).gaps).toEqual([]);
  });
  it("cuts a gap that it goes back into, and forgets later ones", () => {
    const gaps = [{ from_ms: at(5), to_ms: at(15) }, { from_ms: at(20), to_ms: at(30) }];
    expect(rewound({ team, gaps }, history, at(40), at(10)).gaps).toEqual([{ from_ms: at(5), to_ms: at(10) }]);
  });
});
