// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { instantFault, searchOf, viewOf } from "../../src/shell/address";

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

describe("the address of a recording", () => {
  it("carries which one, and how many seconds from its start, there and back", () => {
    const view = { robot: "io", recording: { name: "my run.mcap", at_s: 12.345 }, plots: [], layout: undefined };
    expect(searchOf(view)).toBe("?recording=my+run.mcap&at=12.345&robot=io");
    expect(viewOf(searchOf(view))).toEqual({ view, faults: [] });
  });
  it("begins at its start where it says no time, or none that makes sense", () => {
    expect(searchOf({ recording: { name: "run.mcap", at_s: 0 }, plots: [] })).toBe("?recording=run.mcap");
    const { view, faults } = viewOf("?recording=run.mcap&at=2024-01-01T12:00:00Z");
    expect(view.recording).toEqual({ name: "run.mcap", at_s: 0 });
    expect(faults).toEqual(["The address asks for “2024-01-01T12:00:00Z” of a recording, which is no number of seconds from its start."]);
  });
});

describe("an instant in the address", () => {
  const heard = { earliest_ms: new Date(2024, 0, 2, 10, 2).getTime(), present_ms: new Date(2024, 0, 2, 10, 5).getTime() };
  const fault = (...time: [number, number, number]) => instantFault(new Date(2024, 0, ...time).getTime(), heard);

  it("is shown where the page has heard it", () => {
    expect(fault(2, 10, 3)).toBeUndefined();
  });
  it("that the page has not heard is told of, with since when it hears and what it shows instead", () => {
    expect(fault(2, 10, 1)).toBe("The address asks for 10:01:00. This page was opened later and has heard nothing from before 10:02:00. It shows the present.");
    expect(fault(1, 10, 3)).toMatch(/asks for 2024-01-01 10:03:00\. This page/);
    expect(fault(2, 10, 6)).toBe("The address asks for 10:06:00, which is yet to come. The page shows the present.");
  });
});
