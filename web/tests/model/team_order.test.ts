// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { asListed, byTrouble } from "../../src/model/team_order";

const team = ["robot10", "io", "robot2", "callisto", "europa"].map((name) => ({ name }));
const order = (...troubled: string[]) => byTrouble(team, new Set(troubled)).map(({ name }) => name);

it("has the robots in trouble first, then all by name", () => {
  expect(order()).toEqual(["callisto", "europa", "io", "robot2", "robot10"]);
  expect(order("robot10", "io")).toEqual(["io", "robot10", "callisto", "europa", "robot2"]);
});

it("has the silent ones before all others", () => {
  expect(byTrouble(team, new Set(["europa", "robot10"]), new Set(["robot10"])).map(({ name }) => name)).toEqual(["robot10", "europa", "callisto", "io", "robot2"]);
});

it("leaves few robots in their own order but for trouble, as well", () => {
  const few = ["io", "ganymede", "callisto"].map((name) => ({ name }));
  const listed = (troubled: string[], silent: string[] = []) => asListed(few, new Set(troubled), new Set(silent)).map(({ name }) => name);
  expect(listed([])).toEqual(["io", "ganymede", "callisto"]);
  expect(listed(["ganymede"])).toEqual(["ganymede", "io", "callisto"]);
  expect(listed(["ganymede", "callisto"], ["callisto"])).toEqual(["callisto", "ganymede", "io"]);
});

it("does not depend on the order in which the robots or their alarms came", () => {
  expect(byTrouble([...team].reverse(), new Set(["io", "robot10"])).map(({ name }) => name)).toEqual(order("robot10", "io"));
});

it("leaves the others where they stand to one another as one gets into trouble", () => {
  expect(order("europa").filter((name) => name !== "europa")).toEqual(order().filter((name) => name !== "europa"));
});

it("changes nothing of what it is given", () => {
  byTrouble(team, new Set(["europa"]));
  expect(team[0]!.name).toBe("robot10");
});
