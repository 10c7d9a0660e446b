// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import type { Score } from "../../src/feed/messages";
import { clockAge_s, rated, remaining_s } from "../../src/referee/contest";

it("strategies are compared by what one robot throws away in a minute, the best first", () => {
  const one = (program_hash: string, robot_seconds: number, deposited: number) => ({ program_name: "a", program_hash, robot_seconds, deposited, collisions: 0, points: 0 });
  const rows = rated([one("wander", 600, 4), one("just begun", 12, 1), one("spin", 300, 5)]);
  expect(rows.map(({ program_hash, pieces_per_min }) => [program_hash, pieces_per_min])).toEqual([["spin", 1], ["wander", 0.4], ["just begun", undefined]]);
});

it("the clock runs on between the referee's messages, and where none comes it stands as it was told and says how old it is", () => {
  const score = (phase: string) => ({ value: { phase, remaining_s: 60 } as Score, received_ms: 10_000 });
  const at = (now_ms: number, phase = "running") => [remaining_s(score(phase), now_ms), clockAge_s(score(phase), now_ms)];
  expect(at(12_000)).toEqual([58, undefined]);
  expect(at(22_000)).toEqual([60, 12]);
  expect(at(22_000, "ended")).toEqual([60, undefined]);
});
