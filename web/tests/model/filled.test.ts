// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { FILLED } from "../../src/feed/topics";
import { isFilled } from "../../src/model/filled";
import { emptyTeam } from "../../src/model/model";
import { apply } from "../../src/model/reduce";
import { drawnBars } from "../../src/model/timeline";

const bar = (number: bigint, state: string, from_ms: number) => ({ number, state, from_ms });

it("knows which changes fill a gap, by robot and number", () => {
  const { filled } = apply(emptyTeam, FILLED, { io: [[3, 5], [9, 9]] }, 0);
  for (const number of [3n, 4n, 5n, 9n]) expect(isFilled(filled, "io", number)).toBe(true);
  for (const number of [2n, 6n, 8n, 10n]) expect(isFilled(filled, "io", number)).toBe(false);
  expect(isFilled(filled, "ganymede", 3n)).toBe(false);
  expect(isFilled(undefined, "io", 3n)).toBe(false);
});

it("draws what is known of a silence, and leaves the rest open", () => {
  const silences = [{ from_ms: 1000, to_ms: 5000 }];
  const bars = [bar(1n, "wander", 0), bar(2n, "grab", 2000), bar(3n, "move", 3000), bar(6n, "drop", 6000)];
  const known = (number: bigint) => number === 2n || number === 3n;
  expect(drawnBars(bars, 0, 8000, silences, known)).toEqual([
    { state: "wander", from_ms: 0, to_ms: 2000 },
    { state: "grab", from_ms: 2000, to_ms: 3000, filled: true },
    { state: "move", from_ms: 5000, to_ms: 6000, filled: true },
    { state: "drop", from_ms: 6000, to_ms: 8000 },
  ]);
  expect(drawnBars(bars, 0, 8000, silences).map(({ from_ms }) => from_ms)).toEqual([0, 5000, 6000]);
});
