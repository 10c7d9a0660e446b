// SPDX-License-Identifier: BSD-3-Clause
import { expect, it, vi } from "vitest";
import { alarmBoard } from "../../src/model/alarm_board.svelte";
import { live } from "../fixture/shown_live.svelte";
import { state, T0_MS, told } from "./told";

vi.mock("../../src/model/live.svelte", () => import("../fixture/shown_live.svelte"));

const ofIo = (problems: string[], at_ms: number) => told([["/io/state", state({ at_ms, problems }), at_ms]]);
const words = () => alarmBoard.wordsByRobot.get("io");

it("forgets where a recording goes back what was posted later, and that something was over", () => {
  const at = (s: number, problems: string[]) => {
    [live.present, live.present_ms] = [ofIo(problems, T0_MS + s * 1000), T0_MS + s * 1000];
    alarmBoard.refresh();
  };
  const posted = () => alarmBoard.posted.map(({ alarm: { words: said }, over_ms }) => [said, over_ms !== undefined]);
  at(0, ["no picture"]);
  at(10, []);
  at(20, ["a flat battery"]);
  expect(posted()).toEqual([["io: a flat battery", false], ["io: no picture", true]]);
  live.rewind(T0_MS + 15_000);
  expect(posted()).toEqual([["io: no picture", true]]);
  live.rewind(T0_MS + 5000);
  expect(posted()).toEqual([["io: no picture", false]]);
  live.rewind(T0_MS - 1000);
  expect(posted()).toEqual([]);
});

it("says of each robot what was wrong at the instant that is shown, while its list stays the present's", () => {
  [live.present, live.present_ms] = [ofIo(["no picture"], T0_MS), T0_MS];
  alarmBoard.refresh();
  expect(words()).toEqual(["io: no picture"]);
  [live.past, live.past_ms] = [ofIo([], T0_MS - 60_000), T0_MS - 60_000];
  expect(words()).toBeUndefined();
  expect(alarmBoard.groups.map(({ kind }) => kind)).toEqual(["problem"]);
  live.past = ofIo(["a flat battery"], T0_MS - 60_000);
  expect(words()).toEqual(["io: a flat battery"]);
});
