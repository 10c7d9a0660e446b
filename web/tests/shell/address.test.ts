// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { searchOf, viewOf } from "../../src/shell/address";

const VIEW = {
  robot: "io",
  at_ms: Date.UTC(2024, 0, 1, 12, 3, 11, 500),
  plots: [["io", "shaft", "turn rate"], ["ganymede", "trash", "certainty"]] as const,
  layout: "r(50-map.50-c(60-team.40-why))",
};

describe("the page's address", () => {
  it("carries robot, instant, plots and arrangement there and back", () => {
    expect(viewOf(searchOf(VIEW))).toEqual({ view: VIEW, faults: [] });
  });
  it("is bare where nothing was chosen", () => {
    expect(searchOf({ plots: [] })).toBe("");
    expect(viewOf("")).toEqual({ view: { plots: [] }, faults: [] });
  });
  it("carries nothing else that stood in it, such as a token", () => {
    expect(searchOf(viewOf("?robot=io&token=secret&x=1").view)).toBe("?robot=io");
  });
  it("leaves out what makes no sense, with a sentence", () => {
    const { view, faults } = viewOf("?robot=&at=yesterday&plots=io:shaft:x,nonsense");
    expect(view).toEqual({ plots: [["io", "shaft", "x"]] });
    expect(faults).toHaveLength(2);
    expect(faults.join()).toMatch(/“yesterday”.*“nonsense”/);
  });
});
