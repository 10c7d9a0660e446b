// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { drifts, programShares } from "../../src/model/drift";
import { robotOf, state, T0_MS, told } from "./told";

it("shows the robot that runs another program than most", () => {
  const team = told([
    ["/io/state", state({ program_hash: "bbbb" }), T0_MS],
    ["/ganymede/state", state({ program_hash: "aaaa" }), T0_MS],
    ["/callisto/state", state({ program_hash: "aaaa" }), T0_MS],
  ]);
  const shares = programShares(team.robots.values());
  expect(shares.map(({ hash, robots }) => [hash, robots])).toEqual([
    ["aaaa", ["ganymede", "callisto"]],
    ["bbbb", ["io"]],
  ]);
  expect(drifts(robotOf(team, "io"), shares)).toBe(true);
  expect(drifts(robotOf(team, "ganymede"), shares)).toBe(false);
});

it("does not count a robot that has no program yet", () => {
  const team = told([
    ["/io/state", state({ program_hash: "" }), T0_MS],
    ["/ganymede/state", state({ program_hash: "aaaa" }), T0_MS],
    ["/callisto/state", state({ program_hash: "bbbb" }), T0_MS],
    ["/europa/state", state({ program_hash: "bbbb" }), T0_MS],
  ]);
  const shares = programShares(team.robots.values());
  expect(shares.map(({ hash }) => hash)).toEqual(["bbbb", "aaaa"]);
  expect(drifts(robotOf(team, "io"), shares)).toBe(false);
  expect(drifts(robotOf(team, "ganymede"), shares)).toBe(true);
});

it("calls nobody apart where all run one program", () => {
  const team = told([["/io/state", state(), T0_MS], ["/ganymede/state", state(), T0_MS]]);
  const shares = programShares(team.robots.values());
  expect(shares).toEqual([{ hash: "aaaa", name: "office.bhdl", robots: ["io", "ganymede"] }]);
  expect(drifts(robotOf(team, "io"), shares)).toBe(false);
  expect(drifts(robotOf(team, "io"), [{ hash: "bbbb", name: "old", robots: ["europa"] }])).toBe(false);
});
