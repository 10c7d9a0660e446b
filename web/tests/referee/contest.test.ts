// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { rated } from "../../src/referee/contest";

it("strategies are compared by what one robot throws away in a minute, the best first", () => {
  const one = (program_hash: string, robot_seconds: number, deposited: number) => ({ program_name: "a", program_hash, robot_seconds, deposited, collisions: 0, points: 0 });
  const rows = rated([one("wander", 600, 4), one("just begun", 12, 1), one("spin", 300, 5)]);
  expect(rows.map(({ program_hash, pieces_per_min }) => [program_hash, pieces_per_min])).toEqual([["spin", 1], ["wander", 0.4], ["just begun", undefined]]);
});
