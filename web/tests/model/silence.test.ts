// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { age_s, isSilent, SILENT_AFTER_S } from "../../src/model/silence";
import { mapRobot, robotOf, state, T0_MS, told } from "./told";

describe("a robot that goes silent", () => {
  const team = told([["/io/state", state(), T0_MS]]);

  it("is silent after two seconds without a word, and its age goes on", () => {
    expect(isSilent(robotOf(team), T0_MS + SILENT_AFTER_S * 1000)).toBe(false);
    expect(isSilent(robotOf(team), T0_MS + 2100)).toBe(true);
    expect(age_s(robotOf(team), T0_MS + 9000)).toBe(9);
  });
  it("never leaves the team", () => {
    const later = told([["/ganymede/state", state({ robot: "ganymede" }), T0_MS + 600_000]], team);
    expect([...later.robots.keys()]).toEqual(["io", "ganymede"]);
  });
  it("is well again with its next word", () => {
    const back = told([["/io/state", state({ at_ms: T0_MS + 9000 }), T0_MS + 9000]], team);
    expect(isSilent(robotOf(back), T0_MS + 9100)).toBe(false);
  });
  it("is silent when the monitor says so, for as long as it says", () => {
    const objects = { stamp: { sec: 0, nsec: 0 }, objects: [], robots: [mapRobot({ silent: true, age_s: 40 })] };
    const joined = told([["/team/objects", objects, T0_MS]]);
    expect(isSilent(robotOf(joined), T0_MS)).toBe(true);
    expect(age_s(robotOf(joined), T0_MS)).toBe(40);
  });
});
