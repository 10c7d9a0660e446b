// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { cycleAtEnd } from "../../src/model/cycles";

const of = (text: string, rounds: number, earliest = 0) => cycleAtEnd(text.length, earliest, rounds, (a, b) => text[a] === text[b]);

it("finds the shortest cycle at the end, as far back as it goes", () => {
  expect(of("xyabcabcabc", 3)).toEqual({ length: 3, from: 2 });
  expect(of("xabababab", 2)).toEqual({ length: 2, from: 1 });
  expect(of("aaaa", 4)).toEqual({ length: 1, from: 0 });
});

it("takes a round that has just begun for part of it", () => {
  expect(of("xabcabcab", 2)).toEqual({ length: 3, from: 1 });
});

it("wants enough rounds, to the very end", () => {
  expect(of("abcabc", 3)).toBeUndefined();
  expect(of("abcabcabcx", 3)).toBeUndefined();
  expect(of("", 1)).toBeUndefined();
});

it("does not look beyond the earliest place", () => {
  expect(of("abababab", 4, 2)).toBeUndefined();
  expect(of("abababab", 3, 2)).toEqual({ length: 2, from: 2 });
});
