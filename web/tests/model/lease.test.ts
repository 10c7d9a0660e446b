// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { LeaseChange } from "../../src/feed/messages";
import { LEASES } from "../../src/feed/topics";
import { isSame, type Lease, leaseObjection } from "../../src/model/lease";
import { emptyTeam, type Robot } from "../../src/model/model";
import { apply } from "../../src/model/reduce";

const ada = { name: "ada", account: "operator" };
const ben = { name: "ben", account: "operator" };
const held = (robot: string, holder = ada): Lease => ({ robot, holder, asker: null, answer_within_s: null });
const robot = (name: string) => [name, { name, events: [] } as unknown as Robot] as const;
const robots = new Map(["io", "ganymede", "callisto"].map(robot));
const team = { ...emptyTeam, robots };
const heldBy = (...leases: Lease[]) => apply(team, LEASES, leases, 0);

it("an operator is a name with its token, from every tab", () => {
  expect(isSame(ada, { ...ada })).toBe(true);
  expect(isSame(ada, { ...ada, account: "adas" })).toBe(false);
  expect(isSame(null, undefined)).toBe(false);
});

describe("what an operator may not steer", () => {
  it("is what another one holds, and it says who does and what to do", () => {
    expect(leaseObjection(heldBy(held("io")), ["io"], ben)).toBe("ada holds io. Ask for it in the panel Team, or take over with a reason.");
    expect(leaseObjection(heldBy(held("io")), ["callisto"], ben)).toBeUndefined();
    expect(leaseObjection(heldBy(held("io")), ["io"], ada)).toBeUndefined();
  });
  it("is the team where one robot of it is held, and all holders are named", () => {
    const all = heldBy(held("io"), held("ganymede"), held("callisto", { name: "carol", account: "carols" }));
    expect(leaseObjection(all, [], ben)).toBe("ada holds io and ganymede, carol holds callisto. Ask for them in the panel Team, or take over with a reason.");
  });
  it("is nothing where nobody knows who holds what: the monitor says then", () => {
    expect(leaseObjection(team, ["io"], ben)).toBeUndefined();
    expect(leaseObjection(heldBy(held("io")), ["io"], undefined)).toBeUndefined();
  });
  it("is nothing of a robot that a recording plays, in an order to the team", () => {
    const played = { ...heldBy(held("io")), replayed: new Set(["io"]) };
    expect(leaseObjection(played, [], ben)).toBeUndefined();
  });
});

describe("a change of a lease", () => {
  const change = { id: "1", robot: "io", kind: "taken_over", author: "ben", other: "ada", text: "ben took it over from ada: it stands in the door" } as unknown as LeaseChange;
  it("stands once among what happened to the robot, also when it is told again", () => {
    const once = apply(team, "/team/lease_change", change, 5000);
    const twice = apply(once, "/team/lease_change", change, 5300);
    expect(twice.robots.get("io")?.events).toEqual([{ at_ms: 5000, kind: "lease", words: "lease: ben took it over from ada: it stands in the door", id: "1" }]);
    expect(apply(twice, "/team/lease_change", change, 60_000).robots.get("io")?.events).toHaveLength(1);
    expect(apply(twice, "/team/lease_change", { ...change, id: "2" }, 60_000).robots.get("io")?.events).toHaveLength(2);
  });
  it("makes no robot of a name alone", () => {
    expect(apply(emptyTeam, "/team/lease_change", change, 5000).robots.size).toBe(0);
  });
});
