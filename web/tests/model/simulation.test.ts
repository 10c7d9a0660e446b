// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { SimulationEvent, SimulationState } from "../../src/feed/messages";
import { emptyTeam, type Robot } from "../../src/model/model";
import { apply } from "../../src/model/reduce";
import { discrepancyOf, isThere } from "../../src/model/simulation";

const stateOf = (simulation: string) => ({ simulation, bodies: [{ name: "io", kind: "robot", x_m: 3, y_m: 4, heading_rad: 0, held_by: "" }] }) as unknown as SimulationState;
const eventOf = (order_id: string, text: string) => ({ order_id, author: "Ada", order: "move", subject: "io", done: true, text }) as unknown as SimulationEvent;
const heard = (simulation: string, at_ms: number, team = emptyTeam) => apply(team, "/simulation/state", stateOf(simulation), at_ms);

describe("a simulation that is heard", () => {
  it("is no robot", () => {
    const team = apply(heard("office-1", 0), "/simulation/event", eventOf("1", "moved io"), 5);
    expect(team.robots.size).toBe(0);
    expect(team.simulation?.value.simulation).toBe("office-1");
  });
  it("is gone when it was silent for two seconds", () => {
    const { simulation } = heard("office-1", 1000);
    expect(isThere(simulation, 3000)).toBe(true);
    expect(isThere(simulation, 3001)).toBe(false);
    expect(isThere(undefined, 0)).toBe(false);
  });
  it("stays the page's own beside another, until it is gone", () => {
    const both = heard("hall-1", 500, heard("office-1", 0));
    expect(both.simulation?.value.simulation).toBe("office-1");
    expect(heard("hall-1", 2500, both).simulation?.value.simulation).toBe("hall-1");
  });
});

it("an instructor's order stands once on the timeline, when it was heard of", () => {
  const once = apply(emptyTeam, "/simulation/event", eventOf("1", "moved io"), 5);
  const twice = apply(once, "/simulation/event", eventOf("1", "moved io"), 9);
  expect(twice.instructions).toEqual([{ id: "1", author: "Ada", order: "move", subject: "io", done: true, text: "moved io", at_ms: 5 }]);
});

it("a robot's discrepancy is how far the truth is from its belief", () => {
  const robot = { name: "io", pose: { x_m: 0, y_m: 0, heading_rad: 0 } } as unknown as Robot;
  const { bodies } = stateOf("office-1");
  expect(discrepancyOf(robot, bodies)?.far_m).toBe(5);
  expect(discrepancyOf({ ...robot, name: "europa" }, bodies)).toBeUndefined();
  expect(discrepancyOf({ name: "io" } as unknown as Robot, bodies)).toBeUndefined();
});
