// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { isAlwaysWanted, robotTopicOf } from "../../src/feed/topics";

it("a robot's topics are told from those of the team, the referee and a simulation", () => {
  expect(robotTopicOf("/io/state")).toEqual({ robot: "io", kind: "state" });
  for (const topic of ["/team/objects", "/referee/score", "/simulation/state", "/simulation/event", "/tf"]) expect(robotTopicOf(topic)).toBeUndefined();
  expect(isAlwaysWanted("/io/breaks")).toBe(true);
  expect(isAlwaysWanted("/simulation/order")).toBe(false);
});
