// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { sortOf } from "../../src/program/change_words";

it("a difference is told by its sign", () => {
  expect(["+ state 'spin'", "- state 'wander'", "~ motor schema noise 'n': persistence was 5 s, is 8 s"].map(sortOf)).toEqual([
    { sort: "added", words: "state 'spin'" },
    { sort: "removed", words: "state 'wander'" },
    { sort: "changed", words: "motor schema noise 'n': persistence was 5 s, is 8 s" },
  ]);
});
