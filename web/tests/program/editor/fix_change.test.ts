// SPDX-License-Identifier: BSD-3-Clause
import { ChangeSet, Text } from "@codemirror/state";
import { expect, it } from "vitest";
import { changeOf, offsetOf } from "../../../src/program/editor/fix_change";

const fix = { title: "Change to 'go'", from: { line: 2, column: 3 }, to: { line: 2, column: 5 }, text: "go", of: "state:\n  og" };

it("puts a text right", () => {
  const doc = Text.of(["state:", "  og"]);
  expect(ChangeSet.of(changeOf(fix, doc)!, doc.length).apply(doc).toString()).toBe("state:\n  go");
});

it("leaves a text that was edited since", () => {
  expect(changeOf(fix, Text.of(["; typed meanwhile", "state:", "  og"]))).toBeUndefined();
});

it("finds the nearest place that there is", () => {
  const doc = Text.of(["ab", "c"]);
  expect([offsetOf(doc, { line: 0, column: 0 }), offsetOf(doc, { line: 1, column: 9 }), offsetOf(doc, { line: 9, column: 1 })]).toEqual([0, 2, 3]);
});
