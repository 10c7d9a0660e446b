// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it, vi } from "vitest";
import * as api from "../../src/feed/api";
import type { Program } from "../../src/feed/messages";
import { recorded, recordedCoverageOf } from "../../src/machine/recorded_coverage.svelte";
import { conditionKey } from "../../src/model/coverage";

vi.mock("../../src/feed/api", () => ({ readCoverage: vi.fn() }));

const way = (from_state: string, to_state: string, bit_index = 0) => ({ from_state, to_state, bits_variable: "trash_seen", bit_index, bit_value: true });
const program = {
  hash: "aaaa", states: ["start", "wander", "grab"].map((name) => ({ name })),
  transitions: [way("start", "wander"), way("wander", "grab"), way("wander", "grab", 1)],
} as unknown as Program;
const condition = (from: string, to: string, bit_index: number, taken: number, line = 7) =>
  ({ from, to, file: "office.bhdl", line, bits_variable: "trash_seen", bit_index, bit_value: true, taken, held_behind_another: 0 });
const states = [["start", true, 0], ["wander", true, 2], ["grab", false, 0]].map(([name, visited, entered]) => ({ name, visited, entered })) as api.RecordedProgram["states"];
const conditions = [condition("start", "wander", 0, 2), condition("wander", "grab", 0, 0), condition("wander", "grab", 1, 0)];
const counted = (changes: Partial<api.RecordedCoverage> = {}): api.RecordedCoverage =>
  ({ programs: [{ hash: "aaaa", name: "office.bhdl", described: true, states, conditions }], uncounted: [], ...changes });

describe("what a whole recording exercised", () => {
  it("is drawn and said of the program that runs, and named as the recording's", () => {
    const { counts, fired, sentence } = recordedCoverageOf(program, counted());
    expect([...counts!.states]).toEqual([["start", { never: false, times: 0 }], ["wander", { never: false, times: 2 }], ["grab", { never: true, times: 0 }]]);
    expect([...counts!.arrows]).toEqual([["start → wander", 2], ["wander → grab", 0]]);
    expect(fired!.get(conditionKey(way("start", "wander")))).toBe(2);
    expect(sentence).toBe("2 of 3 states, 1 of 2 transitions, 1 of 3 conditions have happened in the whole of this recording, whichever robot ran this program.");
  });
  it("adds up lines of the program that have the same condition", () => {
    const twice = counted({ programs: [{ ...counted().programs[0]!, conditions: [...conditions, condition("start", "wander", 0, 3, 9)] }] });
    expect(recordedCoverageOf(program, twice).fired!.get(conditionKey(way("start", "wander")))).toBe(5);
  });
  it("says what could not be counted", () => {
    expect(recordedCoverageOf(program, counted({ uncounted: ["it was not closed properly", "3 messages are lost"] })).sentence).toMatch(/ It may be more: it was not closed properly; 3 messages are lost\.$/);
  });
  it("is not known of a program that the count has not", () => {
    const { counts, sentence } = recordedCoverageOf({ ...program, hash: "bbbb" }, counted());
    expect(counts).toBeUndefined();
    expect(sentence).toBe("It cannot be told what has happened of this program in the whole of this recording.");
  });
});

describe("the monitor", () => {
  beforeEach(() => void vi.mocked(api.readCoverage).mockReset());

  it("is asked for the recording, and until it answers that is said", async () => {
    let answer = (_: api.RecordedCoverage) => {};
    vi.mocked(api.readCoverage).mockImplementation(() => new Promise((resolve) => (answer = resolve)));
    const done = recorded.count("office.mcap");
    expect(api.readCoverage).toHaveBeenCalledWith("office.mcap");
    expect(recorded.of(program)).toEqual({ sentence: "What has happened in the whole of this recording is being counted…" });
    answer(counted());
    await done;
    expect(recorded.of(program).sentence).toMatch(/^2 of 3 states/);
  });
  it("may refuse, and is asked again", async () => {
    vi.mocked(api.readCoverage).mockRejectedValueOnce(new Error("The monitor does not answer.")).mockResolvedValueOnce(counted());
    await recorded.count("office.mcap");
    expect(recorded.of(program)).toEqual({ sentence: "What has happened in the whole of this recording cannot be counted: The monitor does not answer; switch Coverage off and on to try again." });
    await recorded.count("office.mcap");
    expect(recorded.of(program).sentence).toMatch(/^2 of 3 states/);
  });
});
