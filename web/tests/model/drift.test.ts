// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { drifts, hashesUnderWay, programShares } from "../../src/model/drift";
import { withInterrupted } from "../../src/model/pushes";
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

const push = (hash: string, progress: string, at_ms = T0_MS): [string, unknown, number] =>
  ["/team/push_progress", { stamp: { sec: 0, nsec: 0 }, id: `push of ${hash}`, author: "operator", program: "new.bhdl", hash, targets: [], state: progress, steps: [] }, at_ms];
const team = (hashes: Record<string, string>, ...more: [string, unknown, number][]) =>
  told([...Object.entries(hashes).map(([robot, program_hash]): [string, unknown, number] => [`/${robot}/state`, state({ robot, program_hash }), T0_MS]), ...more]);
const drifting = (of: ReturnType<typeof team>, now_ms = T0_MS) =>
  [...of.robots.values()].filter((robot) => drifts(robot, programShares(of.robots.values()), hashesUnderWay(of.pushes, now_ms))).map(({ name }) => name);

it("leaves a push's canary alone while the push runs, and calls it apart once the push is over", () => {
  const robots = { io: "new", ganymede: "old", callisto: "old" };
  expect(drifting(team(robots))).toEqual(["io"]);
  expect(drifting(team(robots, push("new", "running")))).toEqual([]);
  expect(drifting(team(robots, push("new", "running"), push("new", "failed")))).toEqual(["io"]);
});

it("leaves the last robots of a rollout alone, which still run what the team ran", () => {
  expect(drifting(team({ io: "new", ganymede: "new", callisto: "old" }, push("new", "running")))).toEqual([]);
});

it("still tells of a third program while a push runs", () => {
  expect(drifting(team({ io: "new", ganymede: "old", callisto: "old", europa: "third" }, push("new", "running")))).toEqual(["europa"]);
});

it("calls a robot apart whose push ended with its monitor", () => {
  const asked = team({ io: "new", ganymede: "old", callisto: "old" }, push("new", "running"));
  expect(drifting({ ...asked, pushes: withInterrupted(asked.pushes) })).toEqual(["io"]);
});

it("takes no push for running of which nothing is heard for two hours", () => {
  const asked = team({ io: "new", ganymede: "old", callisto: "old" }, push("new", "running"));
  expect(drifting(asked, T0_MS + 7_199_000)).toEqual([]);
  expect(drifting(asked, T0_MS + 7_201_000)).toEqual(["io"]);
});
