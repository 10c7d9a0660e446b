// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { marksOf, NO_MARKS, stateMarkWords } from "../../src/graph/break_marks";
import type { BreakPoint_Constants } from "../../src/feed/messages";
import { point } from "../model/told";

const OF_THE_FUTURE = { ...point("wander", "rest"), kind: 9 as BreakPoint_Constants };

it("break points are marked where they are: at a state that is entered or left, or on an arrow", () => {
  const marks = marksOf([point("", "grab"), point("grab", "", "lock"), point("wander", "grab", "stop_team"), OF_THE_FUTURE]);
  expect([...marks.entering]).toEqual([["grab", "stop"]]);
  expect([...marks.leaving]).toEqual([["grab", "lock"]]);
  expect([...marks.arrows]).toEqual([["wander → grab", "stop_team"]]);
});

it("a state's marks are told to who hears it", () => {
  const marks = marksOf([point("", "grab"), point("grab", "", "lock")]);
  expect(stateMarkWords(marks, "grab")).toBe("entering it stops the robot, leaving it is locked");
  expect(stateMarkWords(NO_MARKS, "grab")).toBe("");
});
